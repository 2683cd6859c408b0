/* nook_halfedge.c -- on around a face or along a hole. */
#include "walk/nook_halfedge.h"

/* Hole side of border c: it runs against the triangle, so the loop is followed backwards. */
static uint32_t along_hole(const nook_view *m, uint32_t h, bool forward) {
    uint32_t c = nook_border_next(m, h >> 1, !forward);
    return c == NOOK_NONE ? NOOK_NONE : nook_pair(nook_halfedge(m, c));
}

uint32_t nook_next_halfedge(const nook_view *m, uint32_t h) {
    uint32_t c = nook_halfedge_corner(m, h);
    return c == NOOK_NONE ? along_hole(m, h, true) : nook_halfedge(m, nook_next(c));
}

uint32_t nook_prev_halfedge(const nook_view *m, uint32_t h) {
    uint32_t c = nook_halfedge_corner(m, h);
    return c == NOOK_NONE ? along_hole(m, h, false) : nook_halfedge(m, nook_prev(c));
}
