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

/* Bounds, as integers: each between zeros. */
static inline nook_flags nook_load_cells(const nook_bound *from) {
    typedef uint16_t eight __attribute__((vector_size(16)));
    typedef uint64_t two __attribute__((vector_size(16)));
    eight zero = {0, 0, 0, 0, 0, 0, 0, 0};
#if NOOK_BOUND_BITS == 8
    typedef uint8_t sixteen __attribute__((vector_size(16)));
    uint32_t word;
    two all = {0, 0};
    memcpy(&word, from, sizeof word);
    all[0] = word;
    all = (two)__builtin_shufflevector((sixteen)all, (sixteen)zero, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21,
                                       6, 22, 7, 23);
#else
    uint64_t word;
    two all = {0, 0};
    memcpy(&word, from, sizeof word);
    all[0] = word;
#endif
    return (nook_flags)__builtin_shufflevector((eight)all, zero, 0, 8, 1, 9, 2, 10, 3, 11);
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
static inline nook_flags nook_not(nook_flags flags) { return ~flags; }
/* a where flagged, else 0. */
static inline nook_lanes nook_if(nook_flags flags, nook_lanes a) {
    return (nook_lanes)((nook_flags)a & flags);
}
static inline bool nook_any_flag(nook_flags flags) {
    return (flags[0] | flags[1] | flags[2] | flags[3]) != 0;
}
static inline nook_flags nook_all_flags(void) {
    nook_flags all = {-1, -1, -1, -1};
    return all;
}
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
static inline bool nook_flag(nook_flags flags, uint32_t k) {
    (void)k;
    return flags != 0;
}
static inline nook_flags nook_all_flags(void) { return -1; }
#endif

/* The cells of a box. */
static inline void nook_set_cells(const nook_bvh *bvh, nook_point low, nook_point high, nook_bound from[3],
                                  nook_bound to[3]) {
    uint32_t axis;
    for (axis = 0; axis < 3u; axis++) {
        from[axis] = (nook_bound)nook_cell(bvh, nook_along(&low, axis), axis);
        to[axis] = (nook_bound)nook_cell(bvh, nook_along(&high, axis), axis);
    }
}

/* Which children's boxes overlap one in cells, along an axis. */
static inline nook_flags nook_overlap_along(const nook_boxes *g, uint32_t child, uint32_t axis,
                                            const nook_bound low[3], const nook_bound high[3]) {
    return (nook_load_cells(&g->low[axis][child]) <= high[axis]) &
           (nook_load_cells(&g->high[axis][child]) >= low[axis]);
}

/* Flag k as bit k. */
static inline uint32_t nook_bits_of(nook_flags flags) {
#if NOOK_LANES > 1
    typedef uint64_t two __attribute__((vector_size(16)));
    const nook_flags bit = {1, 2, 4, 8};
    two bits = (two)(flags & bit);
    uint64_t all = bits[0] | bits[1];
    return (uint32_t)(all | all >> 32);
#else
    return flags != 0;
#endif
}

/* On to the children whose boxes overlap one in cells, from number first of their level on. */
static inline void nook_visit_overlap(nook_descent *d, const nook_bvh *bvh, const nook_bound low[3],
                                      const nook_bound high[3], uint32_t first) {
    const nook_boxes *g = nook_descent_boxes(d, bvh);
    uint32_t i, some = 0;
    for (i = 0; i < 4u; i += NOOK_LANES)
        some |= nook_bits_of(nook_overlap_along(g, i, 0, low, high) & nook_overlap_along(g, i, 1, low, high) &
                             nook_overlap_along(g, i, 2, low, high))
                << i;
    nook_descent_leave(d);
    for (i = 4; i-- > 0;) {
        d->entry[d->entries] = (uint16_t)i;
        d->entries = (uint8_t)(d->entries + (some >> i & (4u * d->node + i >= first)));
    }
}

/* From memory, as many as there are lanes. */
static inline nook_lanes nook_lanes_at(const float *from) {
    nook_lanes a;
    memcpy(&a, from, sizeof a);
    return a;
}

typedef struct nook_vectors {
    nook_lanes x, y, z;
} nook_vectors;

static inline nook_vectors nook_vectors_sub(nook_vectors a, nook_vectors b) {
    nook_vectors d = {a.x - b.x, a.y - b.y, a.z - b.z};
    return d;
}

static inline nook_vectors nook_vectors_of(nook_point p) {
    nook_vectors v = {nook_lanes_of(p.x), nook_lanes_of(p.y), nook_lanes_of(p.z)};
    return v;
}

static inline nook_vectors nook_vectors_smaller(nook_vectors a, nook_vectors b) {
    nook_vectors c = {nook_smaller(a.x, b.x), nook_smaller(a.y, b.y), nook_smaller(a.z, b.z)};
    return c;
}

static inline nook_vectors nook_vectors_larger(nook_vectors a, nook_vectors b) {
    nook_vectors c = {nook_larger(a.x, b.x), nook_larger(a.y, b.y), nook_larger(a.z, b.z)};
    return c;
}

static inline nook_vectors nook_vectors_scaled(nook_vectors a, float s) {
    nook_vectors b = {a.x * nook_lanes_of(s), a.y * nook_lanes_of(s), a.z * nook_lanes_of(s)};
    return b;
}

static inline nook_lanes nook_vectors_dot(nook_vectors a, nook_vectors b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline nook_vectors nook_vectors_cross(nook_vectors a, nook_vectors b) {
    nook_vectors c = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return c;
}

static inline nook_lanes nook_largest(nook_vectors a) {
    return nook_larger(nook_larger(nook_magnitude(a.x), nook_magnitude(a.y)), nook_magnitude(a.z));
}

static inline nook_vectors nook_lowest(const nook_vectors p[3]) {
    return nook_vectors_smaller(nook_vectors_smaller(p[0], p[1]), p[2]);
}

static inline nook_vectors nook_highest(const nook_vectors p[3]) {
    return nook_vectors_larger(nook_vectors_larger(p[0], p[1]), p[2]);
}

/* Points in memory, coordinate by coordinate. */
typedef struct nook_points {
    float x[NOOK_LANES], y[NOOK_LANES], z[NOOK_LANES];
} nook_points;

static inline void nook_set_point(nook_points *to, uint32_t k, const nook_point *p) {
    to->x[k] = p->x;
    to->y[k] = p->y;
    to->z[k] = p->z;
}

static inline nook_vectors nook_vectors_at(const nook_points *p) {
    nook_vectors v = {nook_lanes_at(p->x), nook_lanes_at(p->y), nook_lanes_at(p->z)};
    return v;
}

/* Some triangles, from a place of the tree on, and beyond the end the last one again: their corners each, and side by side. */
typedef struct nook_some {
    uint32_t t[NOOK_LANES];
    const nook_point *at[NOOK_LANES][3];
    nook_vectors p[3];
} nook_some;

/* False where order or V name nothing that there is. */
static inline bool nook_gather(const nook_bvh *bvh, uint32_t place, nook_some *to) {
    uint32_t last = bvh->view.nt - 1u, k;
    nook_points points[3];
    for (k = 0; k < NOOK_LANES; k++) {
        to->t[k] = nook_triangle_at(bvh, place + k < last ? place + k : last);
        if (!nook_points_of(bvh, to->t[k], to->at[k])) return false;
        nook_set_point(&points[0], k, to->at[k][0]);
        nook_set_point(&points[1], k, to->at[k][1]);
        nook_set_point(&points[2], k, to->at[k][2]);
    }
    to->p[0] = nook_vectors_at(&points[0]);
    to->p[1] = nook_vectors_at(&points[1]);
    to->p[2] = nook_vectors_at(&points[2]);
    return true;
}

#endif
