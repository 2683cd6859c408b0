/* The port to a Cortex-M under a debugger or an emulator that answers semihosting calls. */
#include "nook_port.h"

enum { SYS_WRITE0 = 0x04, SYS_EXIT_EXTENDED = 0x20, APPLICATION_EXIT = 0x20026 };

static volatile uint32_t *const systick = (volatile uint32_t *)0xE000E010u; /* control, reload, value */

static int call(int operation, const void *argument) {
    register int r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

/* The call takes text that ends in a zero, so it goes in pieces through a buffer. */
void nook_port_write(const char *text, size_t length) {
    char piece[65];
    while (length > 0) {
        size_t n = 0;
        while (n < length && n < sizeof piece - 1) {
            piece[n] = text[n];
            n++;
        }
        piece[n] = 0;
        call(SYS_WRITE0, piece);
        text += n;
        length -= n;
    }
}

void nook_port_exit(int status) {
    const uint32_t block[2] = {APPLICATION_EXIT, (uint32_t)status};
    call(SYS_EXIT_EXTENDED, block);
    for (;;) {
    }
}

/* SysTick counts core clocks down in 24 bits; with instruction counting in the emulator that is a
 * count of instructions. */
uint32_t nook_port_ticks(void) {
    if ((systick[0] & 1u) == 0) {
        systick[1] = 0xFFFFFFu;
        systick[2] = 0;
        systick[0] = 5u;
    }
    return 0xFFFFFFu - systick[2];
}
