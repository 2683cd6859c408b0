/* query_nook.c -- nook for query_bench. Compiled once a width; only its list of engines stays visible. */
#include "query_bench.h"

#include <math.h>
#include <stdlib.h>

#include "nook.h"
#include "query/nook_bvh.h"
#include "query/nook_closest.h"
#include "query/nook_inside.h"
#include "query/nook_intersections.h"
#include "query/nook_ray.h"

typedef struct nook_state {
    nook_mesh mesh;
    nook_view view;
    nook_bvh bvh;
    nook_boxes *boxes;
    nook_index *order;
} nook_state;

static void must(nook_status status) {
    if (status != NOOK_OK) abort();
}

static void *prepare(const shape *s) {
    nook_state *n = calloc(1, sizeof *n);
    nook_point *G = calloc(s->nv, sizeof *G);
    nook_index *V = calloc(3u * (size_t)s->nt, sizeof *V), *O = calloc(3u * (size_t)s->nt, sizeof *O),
               *C = calloc(s->nv, sizeof *C);
    nook_report report;
    if (n == NULL || G == NULL || V == NULL || O == NULL || C == NULL) abort();
    must(nook_mesh_init(&n->mesh, G, V, O, C, s->nv, s->nt));
    for (uint32_t v = 0; v < s->nv; v++) G[v] = nook_make(s->G[v].x, s->G[v].y, s->G[v].z);
    for (uint32_t c = 0; c < 3u * s->nt; c++) V[c] = nook_store(s->V[c]);
    n->mesh.nv = s->nv;
    n->mesh.nt = s->nt;
    must(nook_link(&n->mesh, NULL, NULL, NULL, &report, NULL));
    n->view = nook_view_of(&n->mesh);
    n->boxes = calloc(NOOK_BVH_GROUPS(s->nt), sizeof *n->boxes);
    n->order = calloc(s->nt, sizeof *n->order);
    if (n->boxes == NULL || n->order == NULL) abort();
    return n;
}

static void release(void *state) {
    nook_state *n = state;
    free(n->mesh.G);
    free(n->mesh.V);
    free(n->mesh.O);
    free(n->mesh.C);
    free(n->boxes);
    free(n->order);
    free(n);
}

static void build(void *state) {
    nook_state *n = state;
    must(nook_bvh_build(&n->bvh, &n->view, n->boxes, n->order, NULL));
}

/* The mesh put into the order of its tree, so that none need be kept. O no longer fits. */
static void build_sorted(void *state) {
    nook_state *n = state;
    nook_index *V = calloc(3u * (size_t)n->view.nt, sizeof *V);
    if (V == NULL) abort();
    build(state);
    for (uint32_t t = 0; t < n->view.nt; t++)
        memcpy(V + 3u * t, n->mesh.V + 3u * n->order[t], 3u * sizeof *V);
    memcpy(n->mesh.V, V, 3u * (size_t)n->view.nt * sizeof *V);
    free(V);
    must(nook_bvh_build(&n->bvh, &n->view, n->boxes, NULL, NULL));
}

static void unbuild(void *state) { (void)state; }

static size_t kept(void *state, size_t grown) {
    const nook_state *n = state;
    (void)grown;
    return NOOK_BVH_GROUPS(n->view.nt) * sizeof *n->boxes + n->view.nt * sizeof *n->order;
}

static nook_point at(spot p) { return nook_make(p.x, p.y, p.z); }

static void rays(void *state, const line *lines, uint32_t n, float *t) {
    const nook_bvh *bvh = &((nook_state *)state)->bvh;
    nook_ray ray;
    for (uint32_t i = 0; i < n; i++) {
        must(nook_ray_cast(&ray, bvh, at(lines[i].from), at(lines[i].along), NOOK_MAX_T, NOOK_NEAREST));
        t[i] = ray.triangle == NOOK_NONE ? INFINITY : ray.t;
    }
}

static void closest(void *state, const spot *points, uint32_t n, gap *gaps) {
    const nook_bvh *bvh = &((nook_state *)state)->bvh;
    nook_closest c;
    for (uint32_t i = 0; i < n; i++) {
        must(nook_closest_point(&c, bvh, at(points[i])));
        gaps[i].distance = (double)c.distance;
        gaps[i].least = (double)c.distance_min;
        gaps[i].most = (double)c.distance_max;
    }
}

static void inside(void *state, const spot *points, uint32_t n, int8_t *side) {
    const nook_bvh *bvh = &((nook_state *)state)->bvh;
    int one = 0;
    for (uint32_t i = 0; i < n; i++) {
        must(nook_side_of(bvh, at(points[i]), &one));
        side[i] = (int8_t)one;
    }
}

static uint32_t pairs_of(const nook_bvh *bvh, pair *found, uint32_t room) {
    nook_intersections cut;
    nook_status status;
    uint32_t n = 0;
    must(nook_intersections_begin(&cut, bvh));
    for (;;) {
        uint32_t units = UINT32_MAX;
        status = nook_intersections_step(&cut, &units);
        if (status == NOOK_TRIANGLE) {
            found[n].t = cut.t;
            found[n].u = cut.u;
            if (++n == room) return n;
        } else if (status != NOOK_MORE) {
            must(status);
            return n;
        }
    }
}

static bool cuts_of(const nook_bvh *bvh) {
    pair one;
    return pairs_of(bvh, &one, 1) != 0;
}

/* As the peer does, from the mesh alone ... */
static bool cuts(void *state) {
    build(state);
    return cuts_of(&((nook_state *)state)->bvh);
}

static uint32_t pairs(void *state, pair *found, uint32_t room) {
    build(state);
    return pairs_of(&((nook_state *)state)->bvh, found, room);
}

/* ... and with a tree that is there. */
static bool cuts_there(void *state) { return cuts_of(&((nook_state *)state)->bvh); }

static uint32_t pairs_there(void *state, pair *found, uint32_t room) {
    return pairs_of(&((nook_state *)state)->bvh, found, room);
}

#if NOOK_INDEX_BITS == 16
#define NAME(rest) "nook16" rest
#define MAX_NT 21845
const engine nook16_engines[] = {
#else
#define NAME(rest) "nook32" rest
#define MAX_NT 0
const engine nook32_engines[] = {
#endif
    {NAME(""), MAX_NT, 1, prepare, release, build, unbuild, true, kept, rays, closest, inside, cuts, pairs},
    {NAME("-sort"), MAX_NT, 1, prepare, release, build_sorted, unbuild, false, NULL, rays, closest, inside,
     NULL, NULL},
    {NAME("-tree"), MAX_NT, 1, prepare, release, build, unbuild, false, kept, NULL, NULL, NULL, cuts_there,
     pairs_there},
    {0}};
