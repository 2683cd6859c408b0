/* main.c -- all rooms' tests, one after the other. */
#include "check.h"
#include "rooms.h"

#include "nook_port.h"

int main(void) {
    int status;
    test_core();
    test_number();
    test_stl();
    test_weld();
    test_link();
    test_check();
    test_verdict();
    test_worlds();
    test_corrupt();
    status = finish_tests();
    nook_port_exit(status);
    return status;
}
