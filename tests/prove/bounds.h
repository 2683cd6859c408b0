/* bounds.h -- the most units that each header states, for the programs that hold runs against them. */
#ifndef BOUNDS_H
#define BOUNDS_H

#include "nook.h"

/* nook_survey.h: less than 25 nt + 3 nv + 20. */
static inline uint32_t survey_bound(uint32_t nv, uint32_t nt) { return 25 * nt + 3 * nv + 19; }

/* nook_geometry.h: less than 140 nt + 13 nv + 30, and for k doubtful elements (90 + 10 k) (nt + nv) more. */
static inline uint32_t geometry_bound(uint32_t nv, uint32_t nt, uint32_t doubtful) {
    return 140 * nt + 13 * nv + 29 + (doubtful != 0 ? (90 + 10 * doubtful) * (nt + nv) : 0);
}

static inline uint32_t check_bound(uint32_t nv, uint32_t nt, uint32_t doubtful) {
    return (uint32_t)NOOK_CHECK_UNITS(nt, nv, doubtful);
}

/* nook_link.h: nv + 4 nt for a sound mesh with at most 16 edges on a list, */
static inline uint32_t link_bound(uint32_t nv, uint32_t nt) { return 4 * nt + nv; }
/* and this much more for a mesh with defects, with the survey if edges are incoherent or non-manifold. */
static inline uint32_t link_bound_of_defects(uint32_t nv, uint32_t nt, bool surveyed) {
    return 15 * nt + nv + (surveyed ? survey_bound(nv, nt) + 1 : 0);
}

static inline uint32_t log2_rounded_up(uint32_t n) {
    uint32_t power = 0;
    while ((uint64_t)1 << power < n) power++;
    return power;
}

/* nook_weld.h: less than 2 nv (log2 nv + 4) + 6 nt; with the logarithm rounded up. */
static inline uint32_t weld_bound(uint32_t nv, uint32_t nt) {
    return 2 * nv * (log2_rounded_up(nv) + 4) + 6 * nt;
}

/* nook_link.h: 2 n (log2 n + 3) for n edges of one vertex beyond the 16th. */
static inline uint32_t tail_bound(uint32_t n) { return n == 0 ? 0 : 2 * n * (log2_rounded_up(n) + 3); }

#endif
