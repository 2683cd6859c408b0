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

/* Words from begin to end. Both are names that the linker script gives to addresses, not parts of one
 * array, so they are compared as numbers. */
static uint32_t words(const uint32_t *begin, const uint32_t *end) {
    return (uint32_t)((uintptr_t)end - (uintptr_t)begin) / 4u;
}

void board_reset(void) {
    uint32_t i;
#ifdef __ARM_FP
    *(volatile uint32_t *)0xE000ED88u |= 0xFu << 20; /* CPACR: full access to the FPU */
    __asm__ volatile("dsb\n\tisb" ::: "memory");
#endif
    for (i = words(board_data, board_data_end); i-- > 0;) board_data[i] = board_data_load[i];
    for (i = words(board_bss, board_bss_end); i-- > 0;) board_bss[i] = 0;
    nook_port_exit(main());
}
