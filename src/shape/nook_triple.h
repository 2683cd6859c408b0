/* nook_triple.h -- three floats in one register where the core has such, else side by side. Same operations, same bits. */
#ifndef NOOK_TRIPLE_H
#define NOOK_TRIPLE_H

#include "core/nook_vector.h"

#if NOOK_LANES == 4
typedef float nook_triple __attribute__((vector_size(16))); /* the fourth is 0 */

static inline nook_triple nook_triple_of(float x, float y, float z) {
    nook_triple a = {x, y, z, 0};
    return a;
}
static inline nook_triple nook_plus(nook_triple a, nook_triple b) { return a + b; }
static inline nook_triple nook_minus(nook_triple a, nook_triple b) { return a - b; }
static inline nook_triple nook_times(nook_triple a, nook_triple b) { return a * b; }
static inline nook_triple nook_yzx(nook_triple a) { return __builtin_shufflevector(a, a, 1, 2, 0, 3); }
static inline nook_triple nook_zxy(nook_triple a) { return __builtin_shufflevector(a, a, 2, 0, 1, 3); }
static inline float nook_sum(nook_triple a) { return a[0] + a[1] + a[2]; }
static inline nook_point nook_point_of(nook_triple a) { return nook_make(a[0], a[1], a[2]); }
#else
typedef nook_point nook_triple;

static inline nook_triple nook_triple_of(float x, float y, float z) { return nook_make(x, y, z); }
static inline nook_triple nook_plus(nook_triple a, nook_triple b) {
    return nook_make(a.x + b.x, a.y + b.y, a.z + b.z);
}
static inline nook_triple nook_minus(nook_triple a, nook_triple b) { return nook_sub(a, b); }
static inline nook_triple nook_times(nook_triple a, nook_triple b) {
    return nook_make(a.x * b.x, a.y * b.y, a.z * b.z);
}
static inline nook_triple nook_yzx(nook_triple a) { return nook_make(a.y, a.z, a.x); }
static inline nook_triple nook_zxy(nook_triple a) { return nook_make(a.z, a.x, a.y); }
static inline float nook_sum(nook_triple a) { return a.x + a.y + a.z; }
static inline nook_point nook_point_of(nook_triple a) { return a; }
#endif

static inline nook_triple nook_triple_at(const nook_point *p) { return nook_triple_of(p->x, p->y, p->z); }
static inline nook_triple nook_by(nook_triple a, float s) { return nook_times(a, nook_triple_of(s, s, s)); }
static inline float nook_inner(nook_triple a, nook_triple b) { return nook_sum(nook_times(a, b)); }
static inline nook_triple nook_outer(nook_triple a, nook_triple b) {
    return nook_yzx(nook_minus(nook_times(a, nook_yzx(b)), nook_times(nook_yzx(a), b)));
}

#endif
