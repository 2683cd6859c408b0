/* nook_guard.c -- triangles to be, against those that stay and one another. */
#include "edit/nook_guard.h"

#include "edit/nook_inner.h"
#include "query/nook_overlap.h"
#include "query/nook_pair.h"

static bool is_gone(const nook_change *g, uint32_t t) {
    return t == g->gone[0] || t == g->gone[1] || t == g->gone[2];
}

static bool has_vertex(const nook_change *g, uint32_t t, uint32_t v) {
    const nook_index *V = g->view.V + (size_t)3 * t;
    return V[0] == v || V[1] == v || V[2] == v;
}

/* Whether triangle t goes, or changes. */
static bool is_old(const nook_change *g, uint32_t t) {
    uint32_t i, x;
    for (i = 0; i < 2u; i++) {
        nook_star star = g->fan[i];
        if (!has_vertex(g, t, g->v[i])) continue;
        while ((x = nook_star_next(&star)) != NOOK_NONE) {
            if (nook_triangle(x) == t) return true;
        }
    }
    return is_gone(g, t);
}

/* The triangles to be, one after the other: those made, and those of the two fans. */
typedef struct triangles {
    const nook_point *p[3];
    bool moves; /* this one is not where it was */
    uint32_t made, i;
    nook_star star;
} triangles;

static void begin_triangles(triangles *all, const nook_change *g) {
    all->made = all->i = 0;
    all->star = g->fan[0];
}

static bool is_elsewhere(const nook_point *a, const nook_point *b) {
    return a->x != b->x || a->y != b->y || a->z != b->z;
}

/* Triangle t when the edit is done; false where V names no vertex. */
static bool look_ahead(triangles *all, const nook_change *g, uint32_t t) {
    uint32_t k;
    all->moves = false;
    for (k = 0; k < 3u; k++) {
        uint32_t v = g->view.V[3u * t + k];
        if (v >= g->view.nv) return false;
        all->p[k] = v == g->v[0] ? g->to[0] : v == g->v[1] ? g->to[1] : &g->view.G[v];
        if (is_elsewhere(all->p[k], &g->view.G[v])) all->moves = true;
    }
    return true;
}

/* NOOK_TRIANGLE, NOOK_OK after the last, or NOOK_INDEX_OUT_OF_RANGE. */
static nook_status next_triangle(triangles *all, const nook_change *g) {
    if (all->made < g->count) {
        memcpy(all->p, g->made[all->made++], sizeof all->p);
        all->moves = true;
        return NOOK_TRIANGLE;
    }
    for (; all->i < 2u; all->star = g->fan[1], all->i++) {
        uint32_t x;
        while ((x = nook_star_next(&all->star)) != NOOK_NONE) {
            uint32_t t = nook_triangle(x);
            if (is_gone(g, t) || (all->i == 1u && has_vertex(g, t, g->v[0]))) continue;
            return look_ahead(all, g, t) ? NOOK_TRIANGLE : NOOK_INDEX_OUT_OF_RANGE;
        }
    }
    return NOOK_OK;
}

/* A triangle to be against those of the tree that stay. */
NOOK_APART static nook_status look_around(const nook_guard *guard, const nook_change *g,
                                          const nook_point *const p[3]) {
    nook_overlap q;
    nook_status status = nook_overlap_begin(&q, &guard->bvh, nook_low(nook_low(*p[0], *p[1]), *p[2]),
                                            nook_high(nook_high(*p[0], *p[1]), *p[2]));
    while (status == NOOK_OK) {
        uint32_t units = NOOK_NONE;
        const nook_point *other[3], *own[3];
        status = nook_overlap_step(&q, &units);
        if (status != NOOK_TRIANGLE) return status;
        status = NOOK_OK;
        if (is_old(g, q.t)) continue;
        memcpy(own, p, sizeof own);
        (void)nook_points_of(&guard->bvh, q.t, other);
        if (nook_corners_intersect(own, other)) status = NOOK_SELF_INTERSECTION;
    }
    return guard->bvh.view.nt == 0 ? NOOK_OK : status;
}

/* Against those after it. */
NOOK_APART static bool is_clear_of_rest(const triangles *one, const nook_change *g) {
    triangles other = *one;
    while (next_triangle(&other, g) == NOOK_TRIANGLE) {
        const nook_point *own[3];
        memcpy(own, one->p, sizeof own);
        if (!one->moves && !other.moves) continue;
        if (nook_corners_intersect(own, other.p)) return false;
    }
    return true;
}

nook_status nook_guard_look(const nook_guard *guard, const nook_change *g) {
    triangles one;
    nook_status status;
    begin_triangles(&one, g);
    while ((status = next_triangle(&one, g)) == NOOK_TRIANGLE) {
        status = one.moves ? look_around(guard, g, one.p) : NOOK_OK;
        if (status != NOOK_OK) return status;
        if (!is_clear_of_rest(&one, g)) return NOOK_SELF_INTERSECTION;
    }
    return status;
}

static void widen(nook_guard *guard, uint32_t t, const nook_point *const p[3]) {
    nook_bvh_widen(&guard->bvh, guard->boxes, t, p);
}

nook_status nook_guard_begin(nook_guard *guard, const nook_mesh *mesh, nook_boxes *boxes) {
    if (guard == NULL || mesh == NULL || boxes == NULL) return NOOK_NULL_ARGUMENT;
    memset(guard, 0, sizeof *guard);
    guard->bvh.view = nook_view_of(mesh);
    guard->bvh.boxes = guard->boxes = boxes;
    guard->bvh.places = mesh->max_nt;
    guard->look = nook_guard_look;
    guard->intersect = nook_corners_intersect;
    guard->widen = widen;
    return NOOK_OK;
}
