/* nook_check.c -- every defect of a mesh, with its place, over const tables.
 *
 * The order makes each pass safe: coordinates; V in range; then O and C, which need V; then the
 * survey and the geometry, which need all of them. */
#include "table/nook_check.h"

#include <string.h>

enum phase { POINTS, INDICES, MARKS, CORNERS, VERTICES, SURVEY, GEOMETRY, FINISHED, FAILED };

/* ---- tables ----------------------------------------------------------------------------------- */

static void count(const nook_check_state *s, uint32_t *counter, nook_status defect, nook_kind kind,
                  uint32_t index) {
    ++*counter;
    nook_tell(s->finder, defect, kind, index);
}

static void look_at_point(nook_check_state *s, uint32_t v) {
    nook_status status = nook_point_status(s->view.G[v]);
    if (status != NOOK_OK) count(s, &s->result->bad_coordinates, status, NOOK_AT_VERTEX, v);
}

static void look_at_index(nook_check_state *s, uint32_t c) {
    if (s->view.V[c] < s->view.nv) return;
    count(s, &s->result->bad_indices, NOOK_INDEX_OUT_OF_RANGE, NOOK_AT_CORNER, c);
}

/* O[c] names c itself, or a corner that names c and faces the same two vertices in the opposite
 * direction. */
static bool opposite_is_good(const nook_view *m, uint32_t c) {
    uint32_t o = m->O[c];
    if (o == c) return true;
    if (o >= 3u * m->nt || m->O[o] != c) return false;
    return m->V[nook_next(c)] == m->V[nook_prev(o)] && m->V[nook_prev(c)] == m->V[nook_next(o)];
}

NOOK_APART static void look_at_corner(nook_check_state *s, uint32_t c) {
    const nook_index *V = s->view.V;
    nook_set_bit(s->marks.Mv, V[c]);
    s->loose += s->view.O[c] == c;
    if (!opposite_is_good(&s->view, c)) {
        count(s, &s->result->bad_opposites, NOOK_BAD_OPPOSITE, NOOK_AT_CORNER, c);
    }
    if (c != 3u * nook_triangle(c) || (V[c] != V[c + 1u] && V[c + 1u] != V[c + 2u] && V[c + 2u] != V[c]))
        return;
    count(s, &s->result->repeated_vertex_triangles, NOOK_REPEATED_VERTEX, NOOK_AT_TRIANGLE, nook_triangle(c));
}

static void look_at_vertex(nook_check_state *s, uint32_t v) {
    uint32_t c = nook_corner_of(&s->view, v);
    bool used = nook_bit(s->marks.Mv, v),
         good = c == NOOK_NONE ? !used : c < 3u * s->view.nt && s->view.V[c] == v;
    if (!used) count(s, &s->result->isolated_vertices, NOOK_ISOLATED_VERTEX, NOOK_AT_VERTEX, v);
    if (!good) count(s, &s->result->bad_corners, NOOK_BAD_VERTEX_CORNER, NOOK_AT_VERTEX, v);
}

static bool tables_are_good(const nook_check_result *r) {
    return r->bad_indices == 0 && r->bad_opposites == 0 && r->bad_corners == 0 &&
           r->repeated_vertex_triangles == 0;
}

/* ---- what follows from counts ------------------------------------------------------------------ */

static nook_truth truth(bool value) { return value ? NOOK_YES : NOOK_NO; }

static uint32_t handles_of(const nook_check_result *r) {
    int64_t two_g = 2 * (int64_t)r->survey.components - r->survey.border_loops;
    two_g -= (int64_t)r->survey.fans - r->edges + r->triangles;
    return r->survey.orientable != NOOK_YES || two_g < 0 || two_g % 2 != 0 ? NOOK_UNKNOWN
                                                                           : (uint32_t)(two_g / 2);
}

static void copy_report(nook_check_result *r, const nook_report *report) {
    r->edges = report->edges;
    r->border_edges = report->border_edges;
    r->matched_edges = report->matched_edges;
    r->incoherent_edges = report->incoherent_edges;
    r->nonmanifold_edges = report->nonmanifold_edges;
    r->duplicate_triangles = report->duplicate_triangles;
    r->edge_manifold = truth(r->nonmanifold_edges == 0);
    r->even = truth(report->odd_edges == 0);
    r->oriented = truth(r->incoherent_edges == 0);
    r->watertight = truth(r->triangles != 0 && r->border_edges == 0 && r->nonmanifold_edges == 0);
    r->euler = (int32_t)(r->vertices - r->isolated_vertices - r->edges + r->triangles);
    r->euler_known = true;
    if (r->survey.nonmanifold_vertices == NOOK_UNKNOWN) return;
    r->manifold =
        truth(r->edge_manifold == NOOK_YES && r->triangles != 0 && r->survey.nonmanifold_vertices == 0);
    r->simple = truth(r->manifold == NOOK_YES && r->watertight == NOOK_YES &&
                      r->survey.orientable == NOOK_YES && r->survey.components == 1u && r->euler == 2);
    r->handles = handles_of(r);
    r->patch = truth(r->manifold == NOOK_YES && r->survey.components == 1u && r->survey.border_loops == 1u &&
                     r->handles == 0);
}

/* Whether the report can be of these tables: a matched edge takes two corners, and those that O leaves
 * alone are on edges of the other kinds, one, two, and three or more to an edge. */
static bool report_fits(const nook_check_state *s) {
    const nook_report *r = s->report;
    uint32_t nc = 3u * s->view.nt,
             cut = r->border_edges + 2u * r->incoherent_edges + 3u * r->nonmanifold_edges;
    /* With no count above 3T, which is below 2^30, none of the sums wraps around. */
    if (r->border_edges > nc || r->matched_edges > nc || r->incoherent_edges > nc ||
        r->nonmanifold_edges > nc)
        return false;
    if (r->edges > nc ||
        r->border_edges + r->matched_edges + r->incoherent_edges + r->nonmanifold_edges != r->edges)
        return false;
    if (2u * r->matched_edges + s->loose != nc) return false;
    return r->nonmanifold_edges != 0 ? cut <= s->loose : cut == s->loose && r->odd_edges == r->border_edges;
}

/* After the survey, or without it: conclude, and go on to what can be measured. */
static nook_status conclude(nook_check_state *s) {
    nook_check_result *r = s->result;
    bool good = tables_are_good(r), closed;
    s->phase = good && r->bad_coordinates == 0 ? GEOMETRY : FINISHED;
    if (s->report != NULL && good) copy_report(r, s->report);
    if (s->phase == FINISHED) return NOOK_OK;
    /* With every corner paired there is an inside, whether or not some edge has two pairs. */
    closed = s->report != NULL ? r->watertight == NOOK_YES && r->oriented == NOOK_YES
                               : s->loose == 0 && r->triangles != 0;
    return nook_geometry_begin(&s->in.geometry, &s->view, closed, s->shells, s->finder, &r->geometry);
}

/* The survey is taken from the report, or done where O tells all: link cut no edge but borders. */
NOOK_APART static nook_status begin_survey(nook_check_state *s) {
    nook_check_result *r = s->result;
    const nook_report *report = s->report;
    bool whole, done;
    if (report != NULL && tables_are_good(r) && !report_fits(s)) s->report = report = NULL;
    whole = report == NULL || (report->incoherent_edges == 0 && report->nonmanifold_edges == 0);
    done = !whole && report->survey.components != NOOK_UNKNOWN;
    r->clean = truth(r->isolated_vertices == 0 && r->repeated_vertex_triangles == 0);
    if (tables_are_good(r) && whole) {
        return nook_survey_begin(&s->in.survey, &s->view, NULL, &s->marks, s->shells, s->finder, &r->survey);
    }
    if (tables_are_good(r) && done) {
        r->survey = report->survey;
    } else if (s->shells != NULL) {
        s->shells->count = 0; /* nothing is known of single shells */
    }
    return conclude(s);
}

static void conclude_solid(nook_check_result *r) {
    if (r->watertight == NOOK_YES) r->inside_out = truth(r->geometry.volume_sign < 0);
    if (r->survey.components != 1u) r->geometry.convex = NOOK_NO;
}

/* The survey or the geometry: NOOK_OK while there is more to do. */
static nook_status inner(nook_check_state *s, uint32_t *units) {
    nook_status status = s->phase == SURVEY ? nook_survey_step(&s->in.survey, units)
                                            : nook_geometry_step(&s->in.geometry, units);
    if (status == NOOK_MORE) return NOOK_OK;
    if (status != NOOK_OK) {
        s->phase = FAILED;
        return status;
    }
    if (s->phase == SURVEY) return conclude(s);
    if (s->in.geometry.closed) conclude_solid(s->result);
    s->phase = FINISHED;
    return NOOK_OK;
}

/* ---- passes ----------------------------------------------------------------------------------- */

/* How many items the pass has. */
static uint32_t length(const nook_check_state *s) {
    switch (s->phase) {
    case POINTS:
    case VERTICES: return s->view.nv;
    case MARKS: return (uint32_t)NOOK_MV_BYTES(s->view.nv);
    default: return 3u * s->view.nt;
    }
}

NOOK_APART static nook_status next_pass(nook_check_state *s) {
    s->at = 0;
    switch (s->phase++) {
    case INDICES:
        if (s->result->bad_indices == 0) return NOOK_OK;
        s->phase = FINISHED;
        if (s->shells != NULL) s->shells->count = 0;
        return NOOK_OK;
    case VERTICES: return begin_survey(s);
    default: return NOOK_OK;
    }
}

NOOK_APART static void visit(nook_check_state *s, uint32_t i) {
    switch (s->phase) {
    case POINTS: look_at_point(s, i); return;
    case INDICES: look_at_index(s, i); return;
    case MARKS: s->marks.Mv[i] = 0; return;
    case CORNERS: look_at_corner(s, i); return;
    default: look_at_vertex(s, i); return;
    }
}

nook_status nook_check_step(nook_check_state *s, uint32_t *units) {
    while (s->phase < FINISHED) {
        nook_status status = NOOK_OK;
        if (s->phase < SURVEY && s->at == length(s)) {
            status = next_pass(s);
        } else if (*units == 0) {
            return NOOK_MORE;
        } else if (s->phase >= SURVEY) {
            status = inner(s, units);
        } else {
            --*units;
            visit(s, s->at++);
        }
        if (status != NOOK_OK) return status;
    }
    return s->phase == FINISHED ? NOOK_OK : NOOK_BAD_OPPOSITE;
}

static void all_unknown(nook_check_result *r) {
    memset(r, 0, sizeof *r);
    r->edges = r->border_edges = r->matched_edges = r->incoherent_edges = NOOK_UNKNOWN;
    r->nonmanifold_edges = r->duplicate_triangles = NOOK_UNKNOWN;
    nook_survey_unknown(&r->survey);
    r->edge_manifold = r->manifold = r->even = r->watertight = NOOK_MAYBE;
    r->handles = NOOK_UNKNOWN;
    r->oriented = r->clean = r->simple = r->patch = r->inside_out = r->geometry.convex = NOOK_MAYBE;
    r->geometry.witness_vertex = r->geometry.witness_triangle = NOOK_NONE;
}

nook_status nook_check_begin(nook_check_state *s, const nook_view *view, const nook_marks *marks,
                             const nook_report *report, nook_shells *shells, const nook_finder *finder,
                             nook_check_result *result) {
    if (s == NULL || view == NULL || marks == NULL || result == NULL) return NOOK_NULL_ARGUMENT;
    memset(s, 0, sizeof *s);
    s->phase = FAILED;
    if (marks->Mt == NULL || marks->Mv == NULL) return NOOK_NULL_ARGUMENT;
    if (marks->max_nt < view->nt || marks->max_nv < view->nv) return NOOK_NO_CAPACITY;
    if (report != NULL && report->triangles != view->nt) return NOOK_NO_CAPACITY;
    if (nook_shells_status(shells, view->nt) != NOOK_OK) return NOOK_NULL_ARGUMENT;
    if (shells != NULL && shells->count > shells->max_shells) shells->count = shells->max_shells;
    all_unknown(result);
    result->vertices = view->nv;
    result->triangles = view->nt;
    s->view = *view;
    s->marks = *marks;
    s->report = report;
    s->shells = shells;
    s->finder = finder;
    s->result = result;
    s->phase = POINTS;
    if (view->nt == 0) nook_tell(finder, NOOK_EMPTY_MESH, NOOK_NOWHERE, 0);
    return NOOK_OK;
}

nook_status nook_check(const nook_view *view, const nook_marks *marks, const nook_report *report,
                       nook_shells *shells, const nook_finder *finder, nook_check_result *result) {
    nook_check_state state;
    uint32_t units;
    nook_status status = nook_check_begin(&state, view, marks, report, shells, finder, result);
    if (status != NOOK_OK) return status;
    do {
        units = 1u << 12;
        status = nook_check_step(&state, &units);
    } while (status == NOOK_MORE);
    return status;
}

bool nook_is_sound(const nook_check_result *r) {
    const nook_geometry *g = &r->geometry;
    return tables_are_good(r) && r->manifold == NOOK_YES && r->watertight == NOOK_YES &&
           r->oriented == NOOK_YES && r->duplicate_triangles == 0 && r->bad_coordinates == 0 && g->known &&
           g->volume_sign > 0 && g->inside_out_shells == 0 && g->flat_shells == 0 &&
           g->zero_area_triangles == 0 && g->folded_edges == 0;
}
