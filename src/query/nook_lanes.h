/* nook_lanes.h -- several floats side by side, where the core computes so; else one. Same operations, same bits. */
#ifndef NOOK_LANES_H
#define NOOK_LANES_H

#include "query/nook_descent.h"

#if NOOK_LANES == 4
typedef float nook_lanes __attribute__((vector_size(16)));
typedef int32_t nook_flags __attribute__((vector_size(16))); /* 0 or -1 */

static inline nook_lanes nook_lanes_of(float x) {
    nook_lanes a = {x, x, x, x};
    return a;
}

static inline nook_lanes nook_larger(nook_lanes a, nook_lanes b) {
    nook_lanes c = a;
    uint32_t k;
    for (k = 0; k < NOOK_LANES; k++) c[k] = a[k] > b[k] ? a[k] : b[k];
    return c;
}

static inline nook_lanes nook_smaller(nook_lanes a, nook_lanes b) {
    nook_lanes c = a;
    uint32_t k;
    for (k = 0; k < NOOK_LANES; k++) c[k] = a[k] < b[k] ? a[k] : b[k];
    return c;
}

static inline nook_lanes nook_magnitude(nook_lanes a) { return (nook_lanes)((nook_flags)a & INT32_MAX); }

/* Bounds, as integers. */
static inline nook_flags nook_load_cells(const nook_bound *from) {
#if NOOK_BOUND_BITS == 8
    typedef uint8_t four __attribute__((vector_size(4)));
#else
    typedef uint16_t four __attribute__((vector_size(8)));
#endif
    four bounds;
    memcpy(&bounds, from, sizeof bounds);
    return __builtin_convertvector(bounds, nook_flags);
}

/* And as floats. */
static inline nook_lanes nook_load(const nook_bound *from) {
    return __builtin_convertvector(nook_load_cells(from), nook_lanes);
}

/* The entries of the children from child on that are flagged, by the least that can be found in them. */
static inline void nook_set_entries(uint32_t *entry, uint32_t child, nook_flags some, nook_lanes least) {
    const nook_flags number = {0, 1, 2, 3};
    nook_flags all = ((((nook_flags)least >> 17 << 2) | number) & some) | (~some & (int32_t)NOOK_UP);
    memcpy(entry + child, &all, sizeof all);
}

static inline bool nook_flag(nook_flags flags, uint32_t k) { return flags[k] != 0; }
#else
typedef float nook_lanes;
typedef int nook_flags;

static inline nook_lanes nook_lanes_of(float x) { return x; }
static inline nook_lanes nook_larger(nook_lanes a, nook_lanes b) { return a > b ? a : b; }
static inline nook_lanes nook_smaller(nook_lanes a, nook_lanes b) { return a < b ? a : b; }
static inline nook_lanes nook_magnitude(nook_lanes a) { return a < 0 ? -a : a; }
static inline nook_flags nook_load_cells(const nook_bound *from) { return *from; }
static inline nook_lanes nook_load(const nook_bound *from) { return (float)*from; }
static inline void nook_set_entries(uint32_t *entry, uint32_t child, nook_flags some, nook_lanes least) {
    entry[child] = some ? nook_entry(least, child) : NOOK_UP;
}
static inline bool nook_flag(nook_flags flags, uint32_t k) { return flags != 0 && k == 0; }
#endif

/* From memory, as many as there are lanes. */
static inline nook_lanes nook_lanes_at(const float *from) {
    nook_lanes a;
    memcpy(&a, from, sizeof a);
    return a;
}

#endif
