/* verdict.c -- link and check with a collector for what they find.
 *
 * Memory beside the tables: marks, one shell at most a triangle, and max_list places a kind. */
#include "verdict.h"

#include <stdlib.h>

#include "heap.h"
#include "tree.h"

static void collect_pair(verdict *v, nook_status kind, nook_where where, uint32_t other) {
    defect *d = &v->defects[kind];
    d->count++;
    if (d->listed == v->max_list) return;
    d->place = grow(d->place, &d->room, d->listed + 1u, sizeof *d->place);
    d->place[d->listed].where = where;
    d->place[d->listed++].other = other;
}

static void collect(void *user, nook_status kind, nook_where where) {
    collect_pair(user, kind, where, NOOK_NONE);
}

static void list_dropped(verdict *v, const model *m) {
    uint32_t i;
    for (i = 0; i < m->dropped_listed; i++)
        collect(v, NOOK_REPEATED_VERTEX, nook_at(NOOK_AT_TRIANGLE, m->dropped[i]));
    v->defects[NOOK_REPEATED_VERTEX].count = m->degenerate;
}

static nook_status link_and_check(verdict *v, nook_mesh *mesh, const nook_marks *marks) {
    nook_finder finder = {collect, NULL};
    nook_where where;
    nook_view view;
    nook_status status;
    finder.user = v;
    status = nook_link(mesh, marks, &v->shells, &finder, &v->report, &where);
    if (status != NOOK_OK) return status;
    view = nook_view_of(mesh);
    status = nook_check(&view, marks, &v->report, &v->shells, &finder, &v->check);
    v->digest = nook_digest(&view);
    return status;
}

/* ---- what meets what -------------------------------------------------------------------------- */

static nook_status find_intersections(verdict *v, const nook_bvh *bvh) {
    nook_intersections found;
    uint32_t units = 0;
    nook_status status = nook_intersections_begin(&found, bvh);
    if (status != NOOK_OK) return status;
    for (;;) {
        if (units == 0) units = UINT32_MAX;
        status = nook_intersections_step(&found, &units);
        if (status == NOOK_OK) break;
        if (status == NOOK_MORE) continue;
        if (status != NOOK_TRIANGLE) return status;
        collect_pair(v, NOOK_SELF_INTERSECTION, nook_at(NOOK_AT_TRIANGLE, found.t), found.u);
    }
    v->self_intersections = found.count;
    return NOOK_OK;
}

static float larger(float a, float b) {
    float size = b < 0 ? -b : b;
    return a > size ? a : size;
}

/* What rounding to float32 can do to a point on an edge of this mesh. */
static float tolerance_of(const nook_geometry *g) {
    float most = larger(larger(larger(0, g->box_min.x), g->box_min.y), g->box_min.z);
    most = larger(larger(larger(most, g->box_max.x), g->box_max.y), g->box_max.z);
    return most * 0x1p-22f;
}

static nook_status find_t_junctions(verdict *v, const nook_bvh *bvh) {
    nook_t_junctions found;
    uint32_t units = 0;
    nook_status status = nook_t_junctions_begin(&found, bvh, tolerance_of(&v->check.geometry));
    if (status != NOOK_OK) return status;
    for (;;) {
        if (units == 0) units = UINT32_MAX;
        status = nook_t_junctions_step(&found, &units);
        if (status == NOOK_OK) break;
        if (status == NOOK_MORE) continue;
        if (status != NOOK_TRIANGLE) return status;
        collect_pair(v, NOOK_T_JUNCTION, nook_at(NOOK_AT_VERTEX, found.vertex), found.corner);
    }
    v->t_junctions = found.count;
    return NOOK_OK;
}

static void collect_inside_out(void *user, nook_status kind, nook_where where) {
    if (kind == NOOK_INSIDE_OUT) collect(user, kind, where);
}

/* Where all is closed and oriented and no shells cross, what is inside out is known of cavities too, and replaces what check
 * has said of shells by themselves. */
static nook_status find_nesting(verdict *v, const nook_bvh *bvh) {
    defect *d = &v->defects[NOOK_INSIDE_OUT], before = *d;
    nook_finder finder = {collect_inside_out, NULL};
    nook_orient_shells_state state;
    nook_status status;
    finder.user = v;
    if (v->check.watertight != NOOK_YES || v->check.oriented != NOOK_YES) return NOOK_OK;
    d->count = d->listed = 0;
    status = nook_orient_shells(&state, NULL, bvh, &v->shells, NULL, &finder);
    if (status == NOOK_OK) {
        v->outward = state.inside_out + state.flat == 0 ? NOOK_YES : NOOK_NO;
    } else {
        *d = before;
    }
    return status == NOOK_SELF_INTERSECTION ? NOOK_OK : status;
}

/* All three need a linked mesh whose tables and coordinates are good. */
static bool find_meetings(verdict *v, const nook_mesh *mesh, failure *f) {
    tree t;
    nook_status status;
    if (mesh->nt == 0) return true;
    v->self_intersections = v->t_junctions = NOOK_UNKNOWN;
    if (!v->check.geometry.known) return true;
    if (!tree_build(&t, mesh, f)) {
        tree_free(&t);
        return false;
    }
    status = find_intersections(v, &t.bvh);
    if (status == NOOK_OK) status = find_t_junctions(v, &t.bvh);
    if (status == NOOK_OK) status = find_nesting(v, &t.bvh);
    tree_free(&t);
    return status == NOOK_OK ? true : fail(f, status, NULL);
}

bool examine(verdict *v, model *m, uint32_t max_list, failure *f) {
    nook_mesh *mesh = &m->mesh;
    nook_marks marks;
    nook_status status;
    memset(v, 0, sizeof *v);
    v->max_list = max_list;
    v->outward = NOOK_MAYBE;
    list_dropped(v, m);
    marks = marks_take(mesh);
    v->shells.shell = take(mesh->nt, sizeof *v->shells.shell);
    v->shells.component = take(mesh->nt, sizeof *v->shells.component);
    v->shells.stamp = take(mesh->nv, sizeof *v->shells.stamp);
    v->shells.max_shells = mesh->nt;
    status = link_and_check(v, mesh, &marks);
    marks_free(&marks);
    if (status != NOOK_OK) return fail(f, status, NULL);
    return find_meetings(v, mesh, f);
}

void verdict_free(verdict *v) {
    int kind;
    for (kind = 0; kind < NOOK_STATUS_COUNT; kind++) free(v->defects[kind].place);
    free(v->shells.shell);
    free(v->shells.component);
    free(v->shells.stamp);
    memset(v, 0, sizeof *v);
}

/* ---- properties ---------------------------------------------------------------------------- */

enum property {
    EDGE_MANIFOLD,
    MANIFOLD,
    EVEN,
    WATERTIGHT,
    ORIENTABLE,
    ORIENTED,
    OUTWARD,
    INSIDE_OUT,
    CLEAN,
    CONSISTENT,
    SIMPLE,
    CONVEX,
    NO_DEGENERATE,
    NO_DUPLICATE,
    NO_ISOLATED,
    NO_SELF_INTERSECTION
};

static const char *const names[PROPERTY_COUNT] = {
    "edge_manifold", "manifold",     "even",        "watertight",           "orientable", "oriented",
    "outward",       "inside_out",   "clean",       "consistent",           "simple",     "convex",
    "no-degenerate", "no-duplicate", "no-isolated", "no-self-intersection",
};

const char *property_name(uint32_t property) { return names[property]; }

/* A count that must be 0. */
static nook_truth none(uint32_t count) {
    if (count == NOOK_UNKNOWN) return NOOK_MAYBE;
    return count == 0 ? NOOK_YES : NOOK_NO;
}

nook_truth property_of(const verdict *v, const model *m, uint32_t property) {
    const nook_check_result *r = &v->check;
    switch (property) {
    case EDGE_MANIFOLD: return r->edge_manifold;
    case MANIFOLD: return r->manifold;
    case EVEN: return r->even;
    case WATERTIGHT: return r->watertight;
    case ORIENTABLE: return r->survey.orientable;
    case ORIENTED: return r->oriented;
    case OUTWARD: return v->outward;
    case INSIDE_OUT: return r->inside_out;
    case CLEAN: return m->degenerate != 0 ? NOOK_NO : r->clean;
    case SIMPLE: return r->simple;
    case CONVEX: return r->geometry.convex;
    case NO_DEGENERATE: return none(m->degenerate + r->geometry.zero_area_triangles);
    case NO_DUPLICATE: return none(r->duplicate_triangles);
    case NO_ISOLATED: return none(r->isolated_vertices);
    default: return none(v->self_intersections);
    }
}

static bool parse_one(const char *name, size_t length, uint32_t *bits) {
    uint32_t i;
    for (i = 0; i < PROPERTY_COUNT; i++) {
        if (strlen(names[i]) == length && memcmp(names[i], name, length) == 0) {
            *bits |= (uint32_t)1 << i;
            return true;
        }
    }
    return false;
}

bool properties_parse(const char *list, uint32_t *bits) {
    *bits = 0;
    for (;;) {
        size_t length = strcspn(list, ",");
        if (!parse_one(list, length, bits)) return false;
        if (list[length] == 0) return true;
        list += length + 1;
    }
}

bool is_sound(const verdict *v, const model *m, uint32_t required) {
    uint32_t i;
    if (m->mesh.nt == 0) return false;
    for (i = 0; i < PROPERTY_COUNT; i++) {
        if ((required >> i & 1u) != 0 && property_of(v, m, i) != NOOK_YES) return false;
    }
    return true;
}

/* ---- defects ------------------------------------------------------------------------------- */

bool is_error(nook_status kind) { return kind != NOOK_ISOLATED_VERTEX && kind != NOOK_T_JUNCTION; }

static float least(float a, float b) { return a < b ? a : b; }
static float most(float a, float b) { return a > b ? a : b; }

/* The middle of what the boxes of two triangles have in common along one axis. */
static float middle(const float t[3], const float u[3]) {
    float low = most(least(least(t[0], t[1]), t[2]), least(least(u[0], u[1]), u[2]));
    float high = least(most(most(t[0], t[1]), t[2]), most(most(u[0], u[1]), u[2]));
    return 0.5f * (low + high);
}

static nook_point place_of_pair(const nook_view *view, uint32_t t, uint32_t u) {
    float x[3][2][3]; /* axis, triangle, corner */
    uint32_t i;
    for (i = 0; i < 6u; i++) {
        nook_point p = nook_point_at(view, 3u * (i < 3u ? t : u) + i % 3u);
        x[0][i / 3u][i % 3u] = p.x;
        x[1][i / 3u][i % 3u] = p.y;
        x[2][i / 3u][i % 3u] = p.z;
    }
    return nook_make(middle(x[0][0], x[0][1]), middle(x[1][0], x[1][1]), middle(x[2][0], x[2][1]));
}

nook_point place_of(const verdict *v, const model *m, nook_status kind, uint32_t i) {
    nook_view view = nook_view_of(&m->mesh);
    nook_where where = v->defects[kind].place[i].where;
    nook_point a, b, c;
    if (kind == NOOK_REPEATED_VERTEX) return m->dropped_at[i];
    if (kind == NOOK_SELF_INTERSECTION)
        return place_of_pair(&view, where.index, v->defects[kind].place[i].other);
    if (where.kind == NOOK_AT_VERTEX) return view.G[where.index];
    if (where.kind == NOOK_AT_CORNER) {
        a = nook_point_at(&view, nook_next(where.index));
        b = nook_point_at(&view, nook_prev(where.index));
        return nook_make(0.5f * (a.x + b.x), 0.5f * (a.y + b.y), 0.5f * (a.z + b.z));
    }
    if (where.kind != NOOK_AT_TRIANGLE) return nook_make(0, 0, 0);
    a = nook_point_at(&view, 3u * where.index);
    b = nook_point_at(&view, 3u * where.index + 1u);
    c = nook_point_at(&view, 3u * where.index + 2u);
    return nook_make((a.x + b.x + c.x) / 3.0f, (a.y + b.y + c.y) / 3.0f, (a.z + b.z + c.z) / 3.0f);
}
