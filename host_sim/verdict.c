/* verdict.c -- link and check with a collector for what they find.
 *
 * Memory beside the tables: marks, one shell at most a triangle, and max_list places a kind. */
#include "verdict.h"

#include <stdlib.h>

#include "heap.h"

static void collect(void *user, nook_status kind, nook_where where) {
    verdict *v = user;
    defect *d = &v->defects[kind];
    d->count++;
    if (d->listed == v->max_list) return;
    d->where = grow(d->where, &d->room, d->listed + 1u, sizeof *d->where);
    d->where[d->listed++] = where;
}

static void list_dropped(verdict *v, const model *m) {
    uint32_t i;
    for (i = 0; i < m->dropped_listed; i++)
        collect(v, NOOK_REPEATED_VERTEX, nook_at(NOOK_AT_TRIANGLE, m->dropped[i]));
    v->defects[NOOK_REPEATED_VERTEX].count = m->degenerate;
}

static nook_truth outward(const nook_check_result *r) {
    if (r->watertight != NOOK_YES || r->oriented != NOOK_YES) return NOOK_MAYBE;
    return r->geometry.inside_out_shells == 0 && r->geometry.flat_shells == 0 ? NOOK_YES : NOOK_NO;
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

bool examine(verdict *v, model *m, uint32_t max_list, failure *f) {
    nook_mesh *mesh = &m->mesh;
    nook_marks marks;
    nook_status status;
    memset(v, 0, sizeof *v);
    v->max_list = max_list;
    list_dropped(v, m);
    marks.Mt = take(NOOK_MT_BYTES(mesh->nt), 1);
    marks.Mv = take(NOOK_MV_BYTES(mesh->nv), 1);
    marks.max_nt = mesh->nt;
    marks.max_nv = mesh->nv;
    v->shells.shell = take(mesh->nt, sizeof *v->shells.shell);
    v->shells.component = take(mesh->nt, sizeof *v->shells.component);
    v->shells.stamp = take(mesh->nv, sizeof *v->shells.stamp);
    v->shells.max_shells = mesh->nt;
    status = link_and_check(v, mesh, &marks);
    v->outward = outward(&v->check);
    free(marks.Mt);
    free(marks.Mv);
    return status == NOOK_OK ? true : fail(f, status, NULL);
}

void verdict_free(verdict *v) {
    int kind;
    for (kind = 0; kind < NOOK_STATUS_COUNT; kind++) free(v->defects[kind].where);
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
    default: return r->geometry.folded_edges != 0 ? NOOK_NO : NOOK_MAYBE; /* all that is known yet */
    }
}

bool is_computed(uint32_t property) { return property != CONSISTENT && property != NO_SELF_INTERSECTION; }

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
        nook_truth holds = property_of(v, m, i);
        if ((required >> i & 1u) == 0 || (i == NO_SELF_INTERSECTION && holds == NOOK_MAYBE)) continue;
        if (holds != NOOK_YES) return false;
    }
    return true;
}

/* ---- defects ------------------------------------------------------------------------------- */

bool is_error(nook_status kind) { return kind != NOOK_ISOLATED_VERTEX; }

nook_point place_of(const verdict *v, const model *m, nook_status kind, uint32_t i) {
    nook_view view = nook_view_of(&m->mesh);
    nook_where where = v->defects[kind].where[i];
    nook_point a, b, c;
    if (kind == NOOK_REPEATED_VERTEX) return m->dropped_at[i];
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
