/* query_bench.h -- one interface to the queries of nook and of its peers, so that one loop asks them all. */
#ifndef QUERY_BENCH_H
#define QUERY_BENCH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct spot {
    float x, y, z;
} spot;

/* A mesh on the heap. G has room for one more point: Embree reads 16 bytes at each. */
typedef struct shape {
    char name[32];
    spot *G;
    uint32_t *V;
    uint32_t nv, nt;
    bool closed; /* every edge has two triangles, which run it in opposite directions */
    spot low, high;
    float size; /* the diagonal of the box */
} shape;

typedef struct line {
    spot from, along; /* along: of length 1, rounded */
} line;

/* A distance and what it is known to lie between. */
typedef struct gap {
    double distance, least, most;
} gap;

typedef struct pair {
    uint32_t t, u; /* t < u */
} pair;

/* A peer, or one of its settings. Functions it does not have are null. */
typedef struct engine {
    const char *name;
    uint32_t max_nt; /* 0: any number */
    uint32_t share;  /* a slow one is timed on this part of the questions; 0 or 1: on all */
    void *(*prepare)(
        const shape *mesh);       /* the mesh in its own form, not timed; null: it cannot take this one */
    void (*release)(void *state); /* after unbuild */
    void (*build)(void *state);   /* the tree */
    void (*unbuild)(void *state); /* and away with it */
    bool builds;                  /* whether build is worth a column */
    size_t (*kept)(void *state,
                   size_t grown); /* bytes of the tree beyond the mesh; grown: what build took of the heap */
    void (*rays)(void *state, const line *rays, uint32_t n, float *t); /* INFINITY: no hit */
    void (*closest)(void *state, const spot *at, uint32_t n, gap *gaps);
    void (*inside)(void *state, const spot *at, uint32_t n, int8_t *side); /* 1 outside, 0 on it, -1 inside */
    bool (*cuts)(void *state);                                             /* does the mesh cut itself? */
    uint32_t (*pairs)(void *state, pair *found, uint32_t room); /* how often, and where; in any order */
} engine;

/* Lists that end with an engine without a name; those not linked are null. */
#ifdef __GNUC__
#define MAY_BE_MISSING __attribute__((weak))
#endif
extern const engine nook32_engines[] MAY_BE_MISSING, nook16_engines[] MAY_BE_MISSING;
extern const engine embree_engines[] MAY_BE_MISSING, bullet_engines[] MAY_BE_MISSING;
extern const engine ode_engines[] MAY_BE_MISSING, fcl_engines[] MAY_BE_MISSING, cgal_engines[] MAY_BE_MISSING;

/* Shapes by name, made or read (binary STL, exactly welded, triangles with repeated vertices dropped). False
 * if there is none of that name, or it cannot be read. */
bool shape_make(shape *s, const char *name);
bool shape_read(shape *s, const char *path);
void shape_free(shape *s);

#ifdef __cplusplus
}
#endif
#endif
