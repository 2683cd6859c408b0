/* nook_weld.c -- equal vertices become one, by sorting.
 *
 * The vertices are sorted as a linked list, first by coordinates and then by number, so that equal
 * ones are neighbours and the first of them is the one to keep: n log2 n comparisons whatever the
 * file holds, where a hash could be made slow by a hostile one. Everything is looked at before
 * anything is changed. */
#include "table/nook_weld.h"

#include "core/nook_vector.h"

enum phase { POINTS, CORNERS, RENUMBER, RELABEL, FINISHED, FAILED, SORT, RUNS };

/* Any total order will do as long as -0 equals +0: the bits as an integer. */
static uint32_t key(float x) { return nook_float_bits(x == 0 ? 0.0f : x); }

static int32_t compare(const nook_point *a, const nook_point *b) {
    uint32_t p = key(a->x), q = key(b->x);
    if (p == q) {
        p = key(a->y);
        q = key(b->y);
    }
    if (p == q) {
        p = key(a->z);
        q = key(b->z);
    }
    return p < q ? -1 : p > q;
}

static bool point_before(const void *points, uint32_t y, uint32_t x) {
    const nook_point *G = points;
    return compare(&G[y], &G[x]) < 0;
}

static nook_status fail(nook_weld_state *s, nook_status status, nook_kind kind, uint32_t index) {
    s->where = nook_at(kind, index);
    s->phase = FAILED;
    s->kept = (uint32_t)status;
    return status;
}

/* The list to sort links each vertex to the next. */
static nook_status look_at_point(nook_weld_state *s, uint32_t v) {
    nook_status status = nook_point_status(s->mesh->G[v]);
    s->order[v] = nook_store(v + 1u < s->mesh->nv ? v + 1u : v);
    return status == NOOK_OK ? NOOK_OK : fail(s, status, NOOK_AT_VERTEX, v);
}

static nook_status look_at_corner(nook_weld_state *s, uint32_t c) {
    return s->mesh->V[c] < s->mesh->nv ? NOOK_OK : fail(s, NOOK_INDEX_OUT_OF_RANGE, NOOK_AT_CORNER, c);
}

static void sort(nook_weld_state *s) {
    if (!nook_sort_step(&s->sort, s->order, s->mesh->G, point_before)) return;
    s->at = s->sort.head;
    s->kept = NOOK_NONE;
    s->phase = RUNS;
}

/* Along the sorted list: map each vertex to the first of its run, s->kept. Merging is stable, so
 * that one has the smallest number. */
static void follow_runs(nook_weld_state *s) {
    uint32_t v = s->at;
    if (s->kept == NOOK_NONE || compare(&s->mesh->G[s->kept], &s->mesh->G[v]) != 0) s->kept = v;
    s->map[v] = nook_store(s->kept);
    s->at = nook_list_next(s->order, v);
    if (s->at != NOOK_NONE) return;
    s->at = s->kept = 0;
    s->phase = RENUMBER;
}

/* In ascending order: a kept vertex moves down to the next free place, and any other already finds
 * the new number of the one that replaces it. */
static void renumber(nook_weld_state *s, uint32_t v) {
    if (s->map[v] == v) {
        s->mesh->G[s->kept] = s->mesh->G[v];
        s->map[v] = nook_store(s->kept++);
    } else {
        s->map[v] = s->map[s->map[v]];
    }
}

static uint32_t length(const nook_weld_state *s) {
    switch (s->phase) {
    case POINTS:
    case RENUMBER: return s->mesh->nv;
    case CORNERS:
    case RELABEL: return 3u * s->mesh->nt;
    default: return NOOK_NONE;
    }
}

static void next_pass(nook_weld_state *s) {
    s->at = 0;
    s->phase++;
    if (s->phase == RENUMBER && s->mesh->nv != 0) {
        nook_sort_begin(&s->sort, 0);
        s->phase = SORT;
    }
    if (s->phase == FINISHED) s->mesh->nv = s->kept;
}

static nook_status work(nook_weld_state *s) {
    switch (s->phase) {
    case POINTS: return look_at_point(s, s->at++);
    case CORNERS: return look_at_corner(s, s->at++);
    case SORT: sort(s); return NOOK_OK;
    case RUNS: follow_runs(s); return NOOK_OK;
    case RENUMBER: renumber(s, s->at++); return NOOK_OK;
    default:
        s->mesh->V[s->at] = s->map[s->mesh->V[s->at]];
        s->at++;
        return NOOK_OK;
    }
}

nook_status nook_weld_step(nook_weld_state *s, uint32_t *units) {
    while (s->phase != FINISHED) {
        if (s->phase == FAILED) return (nook_status)s->kept;
        if (s->at == length(s)) {
            next_pass(s);
        } else if (*units == 0) {
            return NOOK_MORE;
        } else {
            --*units;
            work(s);
        }
    }
    return NOOK_OK;
}

nook_status nook_weld_begin(nook_weld_state *s, nook_mesh *mesh, nook_index *map, nook_index *order) {
    if (s == NULL || mesh == NULL) return NOOK_NULL_ARGUMENT;
    memset(s, 0, sizeof *s);
    fail(s, NOOK_NULL_ARGUMENT, NOOK_NOWHERE, 0);
    if (mesh->nv != 0 && (map == NULL || order == NULL)) return NOOK_NULL_ARGUMENT;
    s->mesh = mesh;
    s->map = map;
    s->order = order;
    s->kept = 0;
    s->phase = POINTS;
    return NOOK_OK;
}

nook_status nook_weld(nook_mesh *mesh, nook_index *map, nook_index *order, nook_where *where) {
    nook_weld_state state;
    uint32_t units;
    nook_status status = nook_weld_begin(&state, mesh, map, order);
    if (where != NULL) *where = nook_at(NOOK_NOWHERE, 0);
    if (status != NOOK_OK) return status;
    do {
        units = 1u << 12; /* any number gives the same */
        status = nook_weld_step(&state, &units);
    } while (status == NOOK_MORE);
    if (where != NULL) *where = state.where;
    return status;
}

uint32_t nook_drop_degenerate(nook_mesh *mesh) {
    nook_index *V = mesh->V;
    uint32_t t, kept = 0, dropped;
    NOOK_REQUIRE(mesh != NULL);
    for (t = 0; t < mesh->nt; t++) {
        nook_index a = V[3u * t], b = V[3u * t + 1u], c = V[3u * t + 2u];
        if (a == b || b == c || c == a) continue;
        V[3u * kept] = a;
        V[3u * kept + 1u] = b;
        V[3u * kept + 2u] = c;
        kept++;
    }
    dropped = mesh->nt - kept;
    mesh->nt = kept;
    return dropped;
}
