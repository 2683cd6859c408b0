/* The port to a PC: standard output, exit, and microseconds. */
#define _POSIX_C_SOURCE 200809L
#include "nook_port.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

void nook_port_write(const char *text, size_t length) { (void)fwrite(text, 1, length, stdout); }

void nook_port_exit(int status) { exit(fflush(stdout) == 0 ? status : 1); }

uint32_t nook_port_ticks(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint32_t)now.tv_sec * 1000000u + (uint32_t)(now.tv_nsec / 1000);
}
