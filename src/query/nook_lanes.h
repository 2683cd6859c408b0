/* nook_lanes.h -- several floats side by side, where the core computes so; else one. Same operations, same bits. */
#ifndef NOOK_LANES_H
#define NOOK_LANES_H

#include "exact/nook_exact.h"
#include "query/nook_descent.h"

/* Vectors are passed in registers only where there is no call. */
#if NOOK_LANES == 4
#define NOOK_WIDE static inline __attribute__((always_inline))
#else
#define NOOK_WIDE static inline
#endif

#if NOOK_LANES == 4
typedef float nook_lanes __attribute__((vector_size(16)));
typedef int32_t nook_flags __attribute__((vector_size(16))); /* 0 or -1 */

static inline nook_lanes nook_lanes_of(float x) {
    nook_lanes a = {x, x, x, x};
    return a;
}

static inline nook_lanes nook_magnitude(nook_lanes a) { return (nook_lanes)((nook_flags)a & INT32_MAX); }

/* Bounds, as integers: each between zeros. */
static inline nook_flags nook_load_cells(const nook_bound *from) {
    typedef uint16_t eight __attribute__((vector_size(16)));
    typedef uint64_t two __attribute__((vector_size(16)));
    eight zero = {0, 0, 0, 0, 0, 0, 0, 0};
    two all = {0, 0};
#if NOOK_BOUND_BITS == 8
    typedef uint8_t sixteen __attribute__((vector_size(16)));
    uint32_t word;
    memcpy(&word, from, sizeof word);
    all[0] = word;
    all = (two)__builtin_shufflevector((sixteen)all, (sixteen)zero, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21,
                                       6, 22, 7, 23);
#else
    uint64_t word;
    memcpy(&word, from, sizeof word);
    all[0] = word;
#endif
    return (nook_flags)__builtin_shufflevector((eight)all, zero, 0, 8, 1, 9, 2, 10, 3, 11);
}

/* And as floats. */
static inline nook_lanes nook_load(const nook_bound *from) {
    return __builtin_convertvector(nook_load_cells(from), nook_lanes);
}

/* Bit k: whether lane k is flagged. */
static inline uint32_t nook_bits(nook_flags flags) {
#ifdef __SSE__
    return (uint32_t)__builtin_ia32_movmskps((nook_lanes)flags);
#else
    return (uint32_t)((flags[0] & 1) | (flags[1] & 2) | (flags[2] & 4) | (flags[3] & 8));
#endif
}

/* Entries of the children from child on that are flagged, by the least that can be found in them; bits, which they are. */
static inline uint32_t nook_set_entries(uint32_t *entry, uint32_t child, nook_flags some, nook_lanes least) {
    const nook_flags number = {0, 1, 2, 3};
    nook_flags all = ~((nook_flags)least >> 17 << 2 | number) & some & 0xFFFF;
    memcpy(entry + child, &all, sizeof all);
    return nook_bits(some);
}

static inline nook_flags nook_not(nook_flags flags) { return ~flags; }
/* a where flagged, else 0. */
static inline nook_lanes nook_if(nook_flags flags, nook_lanes a) {
    return (nook_lanes)((nook_flags)a & flags);
}
/* a where flagged, else b. */
static inline nook_lanes nook_choose(nook_flags flags, nook_lanes a, nook_lanes b) {
    return (nook_lanes)(((nook_flags)a & flags) | ((nook_flags)b & ~flags));
}
static inline nook_flags nook_all_flags(void) {
    nook_flags all = {-1, -1, -1, -1};
    return all;
}
static inline float nook_lane(nook_lanes a, uint32_t k) { return a[k]; }
#else
typedef float nook_lanes;
typedef int nook_flags;

static inline nook_lanes nook_lanes_of(float x) { return x; }
static inline nook_lanes nook_magnitude(nook_lanes a) { return nook_abs(a); }
static inline nook_flags nook_load_cells(const nook_bound *from) { return *from; }
static inline nook_lanes nook_load(const nook_bound *from) { return (float)*from; }
static inline uint32_t nook_set_entries(uint32_t *entry, uint32_t child, nook_flags some, nook_lanes least) {
    entry[child] = some ? nook_entry(least, child) : NOOK_UP;
    return (uint32_t)(some != 0) << child;
}

static inline float nook_lane(nook_lanes a, uint32_t k) {
    (void)k;
    return a;
}
static inline nook_flags nook_all_flags(void) { return -1; }
static inline nook_lanes nook_choose(nook_flags flags, nook_lanes a, nook_lanes b) { return flags ? a : b; }
static inline nook_flags nook_not(nook_flags flags) { return !flags; }
static inline uint32_t nook_bits(nook_flags flags) { return flags != 0; }
#endif

static inline bool nook_flag(nook_flags flags, uint32_t k) { return (nook_bits(flags) >> k & 1u) != 0; }
static inline bool nook_any_flag(nook_flags flags) { return nook_bits(flags) != 0; }

/* a > b ? a : b, and a < b ? a : b, also where one is no number. */
#if NOOK_LANES == 4 && defined(__SSE__)
static inline nook_lanes nook_larger(nook_lanes a, nook_lanes b) { return __builtin_ia32_maxps(a, b); }
static inline nook_lanes nook_smaller(nook_lanes a, nook_lanes b) { return __builtin_ia32_minps(a, b); }
#else
static inline nook_lanes nook_larger(nook_lanes a, nook_lanes b) { return nook_choose(a > b, a, b); }
static inline nook_lanes nook_smaller(nook_lanes a, nook_lanes b) { return nook_choose(a < b, a, b); }
#endif

static inline void nook_sort_entries(uint32_t *a, uint32_t *b) {
    uint32_t more = *a > *b ? *a : *b, less = *a > *b ? *b : *a;
    *a = more;
    *b = less;
}

/* The node is a group, and some of its children, those with their bits set, are to be looked at, the largest entry first. */
static inline void nook_descent_push(nook_descent *d, uint32_t places, uint32_t some,
                                     const uint32_t entry[4]) {
    uint32_t *rest = d->rest[d->level - 1u], i = entry[0], j = entry[1], k = entry[2], l = entry[3];
    nook_sort_entries(&i, &j);
    nook_sort_entries(&k, &l);
    nook_sort_entries(&i, &k);
    nook_sort_entries(&j, &l);
    nook_sort_entries(&j, &k);
    rest[0] = j | k << 16;
    rest[1] = l;
    d->now = NOOK_UP;
    d->open |= (uint32_t)(j != NOOK_UP) << d->level;
    if (some != 0) (void)nook_descent_down(d, places, ~i & 3u, i);
}

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

/* On to the children whose boxes overlap one in cells, from number first of their level on. */
static inline void nook_visit_overlap(nook_descent *d, const nook_bvh *bvh, const nook_bound low[3],
                                      const nook_bound high[3], uint32_t first) {
    const nook_boxes *g = nook_descent_boxes(d, bvh);
    uint32_t entry[4], some = 0, i, skip = first > 4u * d->node ? first - 4u * d->node : 0;
    for (i = 0; i < 4u; i += NOOK_LANES)
        some |= nook_bits(nook_overlap_along(g, i, 0, low, high) & nook_overlap_along(g, i, 1, low, high) &
                          nook_overlap_along(g, i, 2, low, high))
                << i;
    some = some >> skip << skip;
    for (i = 0; i < 4u; i++) entry[i] = (some >> i & 1u) != 0 ? nook_entry(0, i) : NOOK_UP;
    nook_descent_push(d, bvh->places, some, entry);
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

static inline nook_vectors nook_vectors_choose(nook_flags flags, nook_vectors a, nook_vectors b) {
    nook_vectors c = {nook_choose(flags, a.x, b.x), nook_choose(flags, a.y, b.y),
                      nook_choose(flags, a.z, b.z)};
    return c;
}

static inline nook_lanes nook_vectors_dot(nook_vectors a, nook_vectors b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline nook_vectors nook_vectors_cross(nook_vectors a, nook_vectors b) {
    nook_vectors c = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return c;
}

static inline nook_lanes nook_least(nook_vectors a) { return nook_smaller(nook_smaller(a.x, a.y), a.z); }
static inline nook_lanes nook_most(nook_vectors a) { return nook_larger(nook_larger(a.x, a.y), a.z); }

static inline nook_lanes nook_largest(nook_vectors a) {
    return nook_larger(nook_larger(nook_magnitude(a.x), nook_magnitude(a.y)), nook_magnitude(a.z));
}

static inline nook_vectors nook_lowest(const nook_vectors p[3]) {
    return nook_vectors_smaller(nook_vectors_smaller(p[0], p[1]), p[2]);
}

static inline nook_vectors nook_highest(const nook_vectors p[3]) {
    return nook_vectors_larger(nook_vectors_larger(p[0], p[1]), p[2]);
}

/* Some triangles, from a place of the tree on, and beyond the end the last one again: first, second and third corners. */
typedef struct nook_some {
    uint32_t t[NOOK_LANES];
    const nook_point *p[3][NOOK_LANES];
} nook_some;

NOOK_WIDE nook_lanes nook_side_by_side(const nook_point *const p[NOOK_LANES], uint32_t axis) {
#if NOOK_LANES == 4
    nook_lanes all = {nook_along(p[0], axis), nook_along(p[1], axis), nook_along(p[2], axis),
                      nook_along(p[3], axis)};
    return all;
#else
    return nook_along(p[0], axis);
#endif
}

/* Corners i. */
NOOK_WIDE nook_vectors nook_some_corners(const nook_some *s, uint32_t i) {
    nook_vectors all = {nook_side_by_side(s->p[i], 0), nook_side_by_side(s->p[i], 1),
                        nook_side_by_side(s->p[i], 2)};
    return all;
}

/* Where the three corners are along an axis. */
NOOK_WIDE nook_vectors nook_some_along(const nook_some *s, uint32_t axis) {
    nook_vectors all = {nook_side_by_side(s->p[0], axis), nook_side_by_side(s->p[1], axis),
                        nook_side_by_side(s->p[2], axis)};
    return all;
}

/* False where order or V name nothing that there is. */
static inline bool nook_gather(const nook_bvh *bvh, uint32_t place, nook_some *to) {
    const nook_view *m = &bvh->view;
    uint32_t last = m->nt - 1u, nv = m->nv, k;
    for (k = 0; k < NOOK_LANES; k++) {
        uint32_t t = nook_triangle_at(bvh, place + k < last ? place + k : last);
        const nook_index *v;
        if (t > last) return false;
        v = &m->V[3u * (size_t)t];
        if (v[0] >= nv || v[1] >= nv || v[2] >= nv) return false;
        to->t[k] = t;
        to->p[0][k] = &m->G[v[0]], to->p[1][k] = &m->G[v[1]], to->p[2][k] = &m->G[v[2]];
    }
    return true;
}

#endif
