/* nook_descent.h -- what the questions of this room share: the way down the tree and back, nearest first, and what a cell is.
 *
 * A level above the leaves has ((places - 1) >> (2 level + 2)) + 1 groups, numbered from 0; level 1 stands first in boxes[],
 * the root last. Child k of group i is 4 i + k, one level down; on level 0 that is a leaf, the triangles at places 4 i
 * to 4 i + 3. So the way back up needs no memory but which children are still to be looked at: an entry of 16 bits
 * each, that is 14 bits of a float, the least that the question can find there, and the child. */
#ifndef NOOK_DESCENT_H
#define NOOK_DESCENT_H

#include "query/nook_bvh.h"

#define NOOK_BVH_LEVELS (NOOK_INDEX_BITS == 16 ? 7 : 14)
#define NOOK_UP 0xFFFFu /* the entry below those of one group */

typedef struct nook_descent {
    uint32_t node;          /* a group, or at level 0 a leaf */
    uint32_t base;          /* where the groups of its level begin */
    uint8_t level, entries; /* the latter, not yet looked at */
    uint16_t now;           /* the entry of the node, until it has been looked at; then NOOK_UP */
    uint16_t entry[4 * NOOK_BVH_LEVELS + 2];
} nook_descent;

static inline uint32_t nook_groups_of_level(uint32_t places, uint32_t level) {
    return ((places - 1u) >> (2u * level + 2u)) + 1u;
}

/* A child worth looking at and the least that can be found there, which is not negative, rounded down. Entries compare as
 * the floats do; none that holds less than bound is above nook_entry(bound, 3). */
static inline uint32_t nook_entry(float least, uint32_t child) {
    return nook_float_bits(least) >> 17 << 2 | child;
}

/* Above the root, which is still to be looked at. */
static inline void nook_descent_begin(nook_descent *d, const nook_bvh *bvh) {
    d->node = 0;
    d->base = bvh->root + 1u;
    d->level = (uint8_t)(bvh->levels + 1u);
    d->entry[0] = 0;
    d->entries = 1;
    d->now = NOOK_UP;
}

/* On to the next node whose entry is at most limit, unless this one has not been looked at; false if there is none. */
static inline bool nook_descent_next(nook_descent *d, uint32_t places, uint32_t limit) {
    if (d->now != NOOK_UP) return true;
    while (d->entries != 0) {
        uint32_t entry = d->entry[--d->entries], node;
        if (entry == NOOK_UP) {
            d->base += nook_groups_of_level(places, d->level++);
            d->node >>= 2;
            continue;
        }
        node = 4u * d->node + (entry & 3u);
        if (entry > limit || node << 2u * d->level >= places) continue; /* the second: boxes of any bits */
        d->node = node;
        d->base -= nook_groups_of_level(places, --d->level);
        d->now = (uint16_t)entry;
        return true;
    }
    return false;
}

/* What the node is: a group of boxes, unless it is a leaf. */
static inline const nook_boxes *nook_descent_boxes(const nook_descent *d, const nook_bvh *bvh) {
    return &bvh->boxes[d->base + d->node];
}

/* The node has been looked at; it is a leaf, or no child of it matters. */
static inline void nook_descent_leave(nook_descent *d) {
    d->entry[d->entries++] = NOOK_UP;
    d->now = NOOK_UP;
}

static inline void nook_sort_entries(uint32_t *a, uint32_t *b) {
    uint32_t less = *a < *b ? *a : *b, more = *a < *b ? *b : *a;
    *a = less;
    *b = more;
}

/* It is a group and these of its children are to be looked at (NOOK_UP: not this one), the least first. */
static inline void nook_descent_push(nook_descent *d, const uint32_t entry[4]) {
    uint32_t i = entry[0], j = entry[1], k = entry[2], l = entry[3];
    uint16_t *to = &d->entry[d->entries];
    *to++ = NOOK_UP;
    nook_sort_entries(&i, &j);
    nook_sort_entries(&k, &l);
    nook_sort_entries(&i, &k);
    nook_sort_entries(&j, &l);
    nook_sort_entries(&j, &k);
    *to = (uint16_t)l, to += l != NOOK_UP;
    *to = (uint16_t)k, to += k != NOOK_UP;
    *to = (uint16_t)j, to += j != NOOK_UP;
    *to = (uint16_t)i, to += i != NOOK_UP;
    d->entries = (uint8_t)(to - d->entry);
    d->now = NOOK_UP;
}

/* Enough has been found. */
static inline void nook_descent_end(nook_descent *d) { d->entries = 0; }

/* The least that can still be found, or bound if that is less. */
float nook_descent_least(const nook_descent *d, float bound);

/* The triangle at a place of the tree. */
static inline uint32_t nook_triangle_at(const nook_bvh *bvh, uint32_t place) {
    return bvh->order == NULL ? place : bvh->order[place];
}

/* Its corners' points; false where order or V name nothing that there is. */
static inline bool nook_points_of(const nook_bvh *bvh, uint32_t t, const nook_point *p[3]) {
    const nook_view *m = &bvh->view;
    uint32_t a, b, c;
    if (t >= m->nt) return false;
    a = m->V[3u * t], b = m->V[3u * t + 1u], c = m->V[3u * t + 2u];
    if (a >= m->nv || b >= m->nv || c >= m->nv) return false;
    p[0] = &m->G[a], p[1] = &m->G[b], p[2] = &m->G[c];
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
    *slack = ((float)NOOK_LAST_CELL + (cell < 0 ? -cell : cell)) * 9.53674316e-7f /* 2^-20 */ + bvh->stray;
    return cell;
}

/* Whether there is anything to ask. */
static inline nook_status nook_bvh_status(const nook_bvh *bvh) {
    if (bvh == NULL) return NOOK_NULL_ARGUMENT;
    return bvh->view.nt == 0 ? NOOK_EMPTY_MESH : NOOK_OK;
}

/* The longest side of the mesh's box. */
static inline float nook_bvh_size(const nook_bvh *bvh) {
    float least = bvh->cells.x < bvh->cells.y ? bvh->cells.x : bvh->cells.y;
    return (float)NOOK_LAST_CELL / (bvh->cells.z < least ? bvh->cells.z : least);
}

#endif
