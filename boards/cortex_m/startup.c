/* startup.c -- from reset to main() on any Cortex-M, for tests and examples.
 *
 * Vector table, FPU on where there is one, .data copied, .bss cleared. Any fault ends the run with
 * status 3, so that a bad access in a test is a failure and never a hang. */
#include <stdint.h>

#include "nook_port.h"

extern uint32_t board_stack_top[], board_data_load[], board_data[], board_data_end[], board_bss[],
    board_bss_end[];
int main(void);
void board_reset(void);

static void board_fault(void) {
    static const char text[] = "fault\n";
    nook_port_write(text, sizeof text - 1);
    nook_port_exit(3);
}

__attribute__((section(".vectors"), used)) static void (*const vectors[16])(void) = {
    (void (*)(void))(uintptr_t)board_stack_top,
    board_reset,
    board_fault,
    board_fault,
    board_fault,
    board_fault,
    board_fault,
    board_fault,
    board_fault,
    board_fault,
    board_fault,
    board_fault,
    board_fault,
    board_fault,
    board_fault,
    board_fault,
};

void board_reset(void) {
    uint32_t *to;
    const uint32_t *from = board_data_load;
#ifdef __ARM_FP
    *(volatile uint32_t *)0xE000ED88u |= 0xFu << 20; /* CPACR: full access to the FPU */
    __asm__ volatile("dsb\n\tisb" ::: "memory");
#endif
    for (to = board_data; to < board_data_end;) *to++ = *from++;
    for (to = board_bss; to < board_bss_end;) *to++ = 0;
    nook_port_exit(main());
}
