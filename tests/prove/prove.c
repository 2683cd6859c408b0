/* prove.c -- fences and time for prove.h. */
#include "prove.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#if defined(__SANITIZE_ADDRESS__)
#define EXACT 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define EXACT 1
#endif
#endif
#ifndef EXACT
#define EXACT 0
#endif

enum { MOST = 32, FENCE = EXACT ? 0 : 64, PATTERN = 0xA5 };

static struct {
    uint8_t *block;
    size_t bytes;
} made[MOST];
static uint32_t count;

void *fenced(size_t bytes) {
    size_t all = bytes + (size_t)2 * FENCE;
    uint8_t *block = count < MOST ? malloc(all > 0 ? all : 1) : NULL;
    if (block == NULL) {
        (void)fputs("prove: no memory\n", stderr);
        exit(2);
    }
    if (FENCE != 0) memset(block, PATTERN, all);
    if (bytes != 0) memset(block + FENCE, 0, bytes);
    made[count].block = block;
    made[count++].bytes = bytes;
    return block + FENCE;
}

bool fences_hold(void) {
    static const uint64_t whole = UINT64_C(0x0101010101010101) * PATTERN;
    uint32_t i, at;
    for (i = 0; i < count; i++) {
        for (at = 0; at + 8 <= FENCE; at += 8) {
            if (memcmp(made[i].block + at, &whole, 8) != 0) return false;
            if (memcmp(made[i].block + FENCE + made[i].bytes + at, &whole, 8) != 0) return false;
        }
    }
    return true;
}

void drop_fences(void) {
    while (count > 0) free(made[--count].block);
}

uint32_t milliseconds(void) { return (uint32_t)((uint64_t)clock() * 1000u / CLOCKS_PER_SEC); }

void print_figure(const char *label, uint32_t number, const char *things, uint32_t since) {
    uint32_t took = milliseconds() - since;
    (void)printf("%s: %u %s, %u.%03u s\n", label, (unsigned)number, things, (unsigned)(took / 1000u),
                 (unsigned)(took % 1000u));
}
