/* nook_port.h -- all that the tests and examples ask of a platform: three functions.
 *
 * The library itself asks for none of them; firmware that only links nook needs no port. To bring
 * the tests to a platform, copy port/template and fill in three bodies. */
#ifndef NOOK_PORT_H
#define NOOK_PORT_H

#include <stddef.h>
#include <stdint.h>

/* Write text[length] to wherever a person reads it: a terminal, a UART, the debugger. */
void nook_port_write(const char *text, size_t length);

/* End the program with an exit status of 0 to 255, or stop for ever where there is nobody to tell. */
void nook_port_exit(int status);

/* A counter that runs by itself and wraps around at 32 bits; its unit is the platform's. */
uint32_t nook_port_ticks(void);

#endif
