/* bytes.h -- a whole file in memory; reading one, building one, and writing one whole or not at all. */
#ifndef BYTES_H
#define BYTES_H

#include "failure.h"

typedef struct bytes {
    uint8_t *data; /* heap */
    size_t size, room;
} bytes;

/* Read all of a file, or of standard input for "-". Files of 4 GiB or more are refused, so that
 * every position fits 32 bits. On failure b is empty. */
bool bytes_read(bytes *b, const char *path, failure *f);

/* Write to path: a temporary file beside it takes the bytes and is renamed when complete, so that
 * no reader ever sees half a file. "-" is standard output. */
bool bytes_write(const bytes *b, const char *path, failure *f);

void bytes_add(bytes *b, const void *data, size_t size);
void bytes_add_text(bytes *b, const char *text);
void bytes_add_u32(bytes *b, uint32_t word); /* little-endian */
void bytes_free(bytes *b);

#endif
