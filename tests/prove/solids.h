/* solids.h -- meshes to ask about places: closed ones, open ones, thin ones, ones that cut themselves;
 * small, large, far away.
 *
 * They are made of whole numbers that are multiples of 6, so that midpoints of edges and centres of
 * triangles are whole too, and of a unit that is a power of two: all of them are floats, and what lies on
 * what is exact. A skewed solid is turned and scaled in floats instead: then only its vertices are on it,
 * and nothing lies along an axis. Its arrays are fenced (prove.h). */
#ifndef SOLIDS_H
#define SOLIDS_H

#include "weights.h"

#include "query/nook_bvh.h"

enum { MOST_NT = 1100, MOST_NV = 3 * MOST_NT };

typedef struct solid {
    const char *name;
    void (*make)(void);
    bool closed; /* every edge has two triangles, or four; oriented */
} solid;
extern const solid solids[];
extern const uint32_t solid_count;

/* How a solid is placed: its unit is 2^place, its origin offset units from 0. */
typedef struct variant {
    int place;
    int offset;
    bool skew;
} variant;
extern const variant variants[];
extern const uint32_t variant_count;

/* The mesh that is asked about. */
typedef struct world {
    nook_point *G;
    nook_index *V, *O, *C;
    nook_view view;
    bool closed;
    float size;         /* of the largest coordinate without the offset */
    lattice lattice;    /* for points up to 4096 times as far as the farthest vertex */
    vector at[MOST_NV]; /* the vertices on it */

    nook_bvh bvh; /* over all triangles, in an order of its own */
    nook_boxes *boxes;
    nook_index *order;
    nook_bvh
        alone[MOST_NT]; /* over each: the naive way to ask a question is to ask it of each triangle alone */
    nook_boxes *boxes_of_one; /* those of each */
} world;
extern world here;

void make_solid(const solid *s, const variant *v);
/* nt triangles of vertices of their own. */
void make_soup(uint32_t nt, const variant *v);
/* Build all trees. */
void build_trees(void);
/* After vertices have been moved: the lattice and at[]. */
void measure_world(void);
void drop_world(void);

/* The corners of a triangle. */
void take_triangle(uint32_t t, vector p[3]);
/* s a + (1 - s) b and its like of three, in floats: exact for quarters, halves and thirds of a solid that
 * is not skewed. */
nook_point between(nook_point a, nook_point b, float s);
nook_point centre_of(uint32_t t);

/* A number from -1 to 1. */
float throw_unit(dice *d);

#endif
