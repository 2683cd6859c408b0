/* main.c -- all rooms' tests, one after the other; or those of NOOK_TEST_ROOM, where RAM is small. */
#include "check.h"
#include "rooms.h"

#include "nook_port.h"

int main(void) {
    int status;
#ifdef NOOK_TEST_ROOM
    NOOK_TEST_ROOM();
#else
    test_core();
    test_exact();
    test_number();
    test_stl();
    test_weld();
    test_link();
    test_geometry();
    test_check();
    test_walk();
    test_trees();
    test_normals();
    test_edit();
    test_sew();
    test_hull();
    test_levels();
    test_smooth();
    test_orient();
    test_simplify();
    test_query();
    test_bvh();
    test_meet();
    test_conditions();
    test_verdict();
    test_worlds();
    test_corrupt();
#endif
    status = finish_tests();
    nook_port_exit(status);
    return status;
}
