/* nook_descent.h -- what the questions of this room share: the way down the tree and back, nearest first, and what a cell is.
 *
 * A level above the leaves has ((places - 1) >> (2 level + 2)) + 1 groups, numbered from 0; level 1 stands first in boxes[],
 * the root last. Child k of group i is 4 i + k, one level down; on level 0 that is a leaf, the triangles at places 4 i
 * to 4 i + 3. So the way back up needs no memory but which children of each group are still to be looked at: an entry of 16
 * bits each, that is 14 bits of a float, the least that the question can find there, and the child; the less, the larger. */
#ifndef NOOK_DESCENT_H
#define NOOK_DESCENT_H

#include "exact/nook_exact.h"
#include "query/nook_bvh.h"

#define NOOK_UP 0u /* no entry */

typedef struct nook_descent {
    uint32_t node; /* a group, or at level 0 a leaf */
    uint32_t level;
    uint32_t now;  /* the entry of the node, until it has been looked at; then NOOK_UP */
    uint32_t open; /* bit l: of the group on level l that is this one or one above it, children are left */
    /* The entries of those, the largest in the lowest bits, then NOOK_UP; from level 1 on. */
    uint32_t rest[NOOK_BVH_LEVELS][2];
} nook_descent;

static inline uint32_t nook_groups_of_level(uint32_t places, uint32_t level) {
    return ((places - 1u) >> (2u * level + 2u)) + 1u;
}

/* A child worth looking at and the least that can be found there, which is not negative, rounded down. */
static inline uint32_t nook_entry(float least, uint32_t child) {
    return 0xFFFFu - (nook_float_bits(least) >> 17 << 2 | child);
}

/* The entry of a child that can hold bound or less is above this; no number bounds nothing. */
static inline uint32_t nook_limit(float bound) {
    uint32_t least = nook_float_bits(bound) << 1 >> 18;
    return 0xFFFBu - 4u * (least - (least == 0x3FFFu));
}

/* At the root, which is still to be looked at. */
static inline void nook_descent_begin(nook_descent *d, const nook_bvh *bvh) {
    d->node = d->open = 0;
    d->level = bvh->levels;
    d->now = nook_entry(0, 0);
}

/* Down to a child of the group, if there is one. */
static inline bool nook_descent_down(nook_descent *d, uint32_t places, uint32_t child, uint32_t entry) {
    uint32_t node = 4u * d->node + child;
    if (node << 2u * d->level >= places) return false; /* boxes of any bits */
    d->node = node;
    d->level--;
    d->now = entry;
    return true;
}

/* On to the next node whose entry is above limit, unless this one has not been looked at; false if there is none. */
static inline bool nook_descent_next(nook_descent *d, uint32_t places, uint32_t limit) {
    if (d->now != NOOK_UP) return true;
    while (d->open != 0) {
        uint32_t *rest, entry;
        for (; (d->open >> d->level & 1u) == 0; d->level++) d->node >>= 2u;
        rest = d->rest[d->level - 1u];
        entry = rest[0] & 0xFFFFu;
        rest[0] = rest[0] >> 16 | rest[1] << 16;
        rest[1] >>= 16;
        if (entry <= limit || (rest[0] & 0xFFFFu) == NOOK_UP) d->open &= d->open - 1u; /* nor is any other */
        if (entry > limit && nook_descent_down(d, places, ~entry & 3u, entry)) return true;
    }
    return false;
}

/* What the node is: a group of boxes, unless it is a leaf. */
static inline const nook_boxes *nook_descent_boxes(const nook_descent *d, const nook_bvh *bvh) {
    return &bvh->boxes[bvh->base[d->level] + d->node];
}

/* The node has been looked at; it is a leaf, or no child of it matters. */
static inline void nook_descent_leave(nook_descent *d) { d->now = NOOK_UP; }

/* The least that can still be found, or bound if that is less. */
float nook_descent_least(const nook_descent *d, float bound);

/* The triangle at a place of the tree. */
static inline uint32_t nook_triangle_at(const nook_bvh *bvh, uint32_t place) {
    return bvh->order == NULL ? place : bvh->order[place];
}

/* The points of its corners, if they are known to be in range. */
static inline void nook_corners_of(const nook_bvh *bvh, uint32_t t, const nook_point *p[3]) {
    const nook_view *m = &bvh->view;
    p[0] = &m->G[m->V[3u * t]], p[1] = &m->G[m->V[3u * t + 1u]], p[2] = &m->G[m->V[3u * t + 2u]];
}

/* The same; false where order or V name nothing that there is. */
static inline bool nook_points_of(const nook_bvh *bvh, uint32_t t, const nook_point *p[3]) {
    const nook_view *m = &bvh->view;
    if (t >= m->nt || m->V[3u * t] >= m->nv) return false;
    if (m->V[3u * t + 1u] >= m->nv || m->V[3u * t + 2u] >= m->nv) return false;
    nook_corners_of(bvh, t, p);
    return true;
}

static inline nook_point nook_low(nook_point a, nook_point b) {
    return nook_make(a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z);
}

static inline nook_point nook_high(nook_point a, nook_point b) {
    return nook_make(a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z);
}

/* The box of triangle t. */
static inline void nook_box(const nook_view *m, uint32_t t, nook_point *low, nook_point *high) {
    nook_point a = nook_point_at(m, 3u * t), b = nook_point_at(m, 3u * t + 1u),
               c = nook_point_at(m, 3u * t + 2u);
    *low = nook_low(nook_low(a, b), c);
    *high = nook_high(nook_high(a, b), c);
}

/* The cell of a coordinate along an axis. It never falls as the coordinate grows, so what overlaps in floats overlaps in
 * cells. */
#define NOOK_LAST_CELL ((1u << NOOK_BOUND_BITS) - 1u)
static inline uint32_t nook_cell(const nook_bvh *bvh, float x, uint32_t axis) {
    float cell = (x - nook_along(&bvh->origin, axis)) * nook_along(&bvh->cells, axis);
    if (!(cell > 0)) return 0;
    return cell < (float)NOOK_LAST_CELL ? (uint32_t)cell : NOOK_LAST_CELL;
}

/* The same as a number of cells that is not cut off, and how far that may be off: by rounding here, in the bounds, and in
 * a product and a difference with it. */
static inline float nook_in_cells(const nook_bvh *bvh, float x, uint32_t axis, float *slack) {
    float cell = (x - nook_along(&bvh->origin, axis)) * nook_along(&bvh->cells, axis);
    *slack = ((float)NOOK_LAST_CELL + nook_abs(cell)) * 9.53674316e-7f /* 2^-20 */ + bvh->stray;
    return cell;
}

/* Whether there is anything to ask. */
static inline nook_status nook_bvh_status(const nook_bvh *bvh) {
    if (bvh == NULL) return NOOK_NULL_ARGUMENT;
    return bvh->view.nt == 0 || bvh->levels == 0 ? NOOK_EMPTY_MESH : NOOK_OK;
}

/* The longest side of the mesh's box. */
static inline float nook_bvh_size(const nook_bvh *bvh) {
    float least = bvh->cells.x < bvh->cells.y ? bvh->cells.x : bvh->cells.y;
    return (float)NOOK_LAST_CELL / (bvh->cells.z < least ? bvh->cells.z : least);
}

#endif
