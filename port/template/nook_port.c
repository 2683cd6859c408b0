/* An empty port: copy this folder, fill in three bodies. nook_port.h says what each must do. */
#include "nook_port.h"

void nook_port_write(const char *text, size_t length) {
    (void)text;
    (void)length;
}

void nook_port_exit(int status) {
    (void)status;
    for (;;) {
    }
}

uint32_t nook_port_ticks(void) { return 0; }
