/* cmd_simplify.c -- a mesh file with fewer triangles as another.
 *
 * Memory: a float a vertex, and the tree of boxes that guards against triangles that cut others. */
#include "commands.h"

#include <float.h>
#include <inttypes.h>
#include <stdlib.h>

#include "decimal.h"
#include "heap.h"
#include "job.h"
#include "json.h"
#include "tree.h"
#include "verdict.h"

const char simplify_help[] =
    "nook simplify [OPTION...] IN OUT (--triangles N | --error E)        the same shape with fewer "
    "triangles\n"
    "\n"
    "Handles, borders and separate parts stay as many as they are, no triangle turns over, and if IN does "
    "not\n"
    "cut itself, neither does OUT. Says how far the surfaces of IN and OUT are from each other at most, in\n"
    "either direction.\n"
    "  --triangles N       stop at N triangles, or one less\n"
    "  --error E           as few as can be while neither surface is farther than E from the other\n"
    "  --outside           nothing of the solid IN is outside OUT, exactly: for collision. IN is closed and "
    "faces outward\n"
    "  --convex            the same with the convex hull of IN, and OUT is convex; distances are from the "
    "hull\n"
    "  --unguarded         OUT may come to cut itself: quicker, and sometimes fewer triangles can be\n"
    "  --format F          stl obj off ply, whatever OUT is called; OUT may be -\n"
    "  --weld exact|none   join vertices with equal coordinates (default: exact for STL, none else)\n"
    "  --scale S           multiply every coordinate by S first\n"
    "  --json              the numbers as one JSON object\n"
    "\n"
    "Exit status: 0 written, 1 no: IN is not a manifold, oriented mesh (nothing is written; nook check says "
    "where), or\n"
    "so few triangles cannot be (what could is written), 2 unreadable, not written or wrong usage.\n";

/* What stands in the way, or null. */
static const char *link_mesh(const job *j, nook_mesh *m) {
    nook_marks marks = marks_take(m);
    nook_report report;
    nook_check_result check;
    nook_view view;
    nook_status status = nook_link(m, &marks, NULL, NULL, &report, NULL);
    memset(&check, 0, sizeof check);
    view = nook_view_of(m);
    if (status == NOOK_OK) status = nook_check(&view, &marks, &report, NULL, NULL, &check);
    marks_free(&marks);
    if (status != NOOK_OK) return nook_status_text(status);
    if (check.border_edges != 0) job_hint(j);
    if (check.manifold != NOOK_YES || check.oriented != NOOK_YES || check.duplicate_triangles != 0)
        return "it is not a manifold, oriented mesh; nook check says where";
    return NULL;
}

/* Whether all shells face out of the solid they bound; each by itself where shells cross. */
static bool faces_outward(const verdict *v) {
    if (v->check.watertight != NOOK_YES || v->check.oriented != NOOK_YES) return false;
    return v->outward == NOOK_MAYBE ? v->check.geometry.inside_out_shells == 0 : v->outward == NOOK_YES;
}

static bool look_for_solid(job *j, failure *f) {
    verdict v;
    bool good = examine(&v, &j->m, 0, f);
    if (good && !faces_outward(&v))
        j->refused = "it has no inside to be kept: it must be closed and face outward; nook check says where "
                     "it does not";
    verdict_free(&v);
    return good;
}

/* A guard over m, whose triangles are put in the order of a search: what is near is then near in the tree. (That of
 * nook_bvh_build() would be better, but is another with other bounds.) Tables that link_mesh() has passed cannot fail. */
static nook_boxes *set_guard(nook_guard *guard, nook_mesh *m) {
    nook_boxes *boxes = take(NOOK_BVH_GROUPS(m->max_nt), sizeof *boxes);
    nook_index *order = take(m->nt, sizeof *order);
    nook_view view = nook_view_of(m);
    nook_marks marks = marks_take(m);
    nook_flood flood;
    nook_reorder reorder;
    uint32_t units = UINT32_MAX, n = 0;
    (void)nook_flood_begin(&flood, &view, &marks, NOOK_NONE);
    while (nook_flood_step(&flood, &units) == NOOK_TRIANGLE)
        order[n++] = nook_store(nook_triangle(flood.corner));
    (void)nook_reorder_begin(&reorder, m, order, NULL);
    (void)nook_reorder_step(&reorder, &units);
    (void)nook_guard_begin(guard, m, boxes);
    (void)nook_bvh_refit(&guard->bvh, boxes, NULL);
    marks_free(&marks);
    free(order);
    return boxes;
}

static bool cuts_itself(const nook_mesh *m) {
    nook_intersections found;
    tree t;
    failure ignored;
    nook_status status = NOOK_MORE;
    (void)tree_build(&t, m, &ignored);
    (void)nook_intersections_begin(&found, &t.bvh);
    while (status == NOOK_MORE) {
        uint32_t units = UINT32_MAX;
        status = nook_intersections_step(&found, &units);
    }
    tree_free(&t);
    return status != NOOK_OK;
}

/* Collapses spoil the order of triangles, which makes a guard slow; so it is built anew after each fortieth of them. */
static nook_status simplify_by_steps(nook_mesh *m, const nook_simplify_goal *goal, bool guarded) {
    nook_simplify_state state;
    nook_guard guard;
    nook_edit edit;
    nook_boxes *boxes = NULL;
    uint32_t units, next = m->nt;
    nook_status status;
    memset(&edit, 0, sizeof edit);
    if (guarded) edit.guard = &guard;
    (void)nook_simplify_begin(&state, m, goal, &edit);
    do {
        if (guarded && m->nt <= next) {
            free(boxes);
            boxes = set_guard(&guard, m);
            next = m->nt - m->nt / 40u - 1u;
        }
        units = 64;
        status = nook_simplify_step(&state, &units);
    } while (status == NOOK_MORE);
    free(boxes);
    return status;
}

/* Says what is in the way of fewer triangles; the largest deviation. */
static nook_status simplify(nook_mesh *m, nook_simplify_goal *goal, bool guarded, float *most) {
    nook_status status;
    uint32_t v;
    goal->deviation = take(m->max_nv, sizeof *goal->deviation);
    for (v = 0; v < m->nv; v++) goal->deviation[v] = 0;
    status = simplify_by_steps(m, goal, guarded && !cuts_itself(m));
    for (*most = 0, v = 0; v < m->nv; v++) {
        if (goal->deviation[v] > *most) *most = goal->deviation[v];
    }
    free(goal->deviation);
    return status;
}

static void print_reason(const job *j, nook_status reason) {
    char what[160];
    (void)snprintf(what, sizeof what, "fewer than %" PRIu32 " triangles cannot be: %s%s", j->m.mesh.nt,
                   nook_status_text(reason),
                   reason == NOOK_SELF_INTERSECTION ? "; --unguarded would let it" : "");
    print_message(stderr, j->in, what);
}

/* What is convex is made so again (nook_simplify.h says why it is no farther away). */
static bool compute(job *j, nook_simplify_goal *goal, const options *o, nook_status *reason,
                    float *deviation) {
    bool flat = false, convex = o->given[OPTION_CONVEX], guarded = !convex && !o->given[OPTION_UNGUARDED];
    failure f;
    if (o->given[OPTION_OUTSIDE] && !look_for_solid(j, &f)) return job_fail(j, &f);
    if (convex && !model_hull(&j->m, &flat, &f)) return job_fail(j, &f);
    if (flat) j->refused = MODEL_FLAT;
    if (j->refused == NULL) j->refused = link_mesh(j, &j->m.mesh);
    if (j->refused != NULL) return true;
    *reason = simplify(&j->m.mesh, goal, guarded, deviation);
    if (*reason != NOOK_OK) print_reason(j, *reason);
    return !convex || model_hull(&j->m, &flat, &f) ? true : job_fail(j, &f);
}

static void report(const job *j, nook_status reason, float deviation) {
    if (j->json) {
        put_float(j->to, "deviation", j->refused == NULL, deviation);
        if (reason == NOOK_OK) put_null(j->to, "reason");
        if (reason != NOOK_OK) put_text(j->to, "reason", nook_status_name(reason));
    } else {
        (void)fprintf(
            j->to,
            ": %" PRIu32 " triangles of %" PRIu32 ", %" PRIu32 " vertices of %" PRIu32 ", no farther than %s",
            j->m.mesh.nt, j->m.triangles_in, j->m.mesh.nv, j->vertices_in, decimal_of(deviation).text);
    }
}

static bool options_for_goal(const options *o, nook_simplify_goal *goal) {
    memset(goal, 0, sizeof *goal);
    goal->error = FLT_MAX;
    goal->outside = o->given[OPTION_OUTSIDE] || o->given[OPTION_CONVEX];
    if (o->given[OPTION_TRIANGLES] == o->given[OPTION_ERROR])
        return usage_error("simplify needs --triangles N or --error E (see nook simplify --help)", "");
    if (o->given[OPTION_OUTSIDE] && o->given[OPTION_CONVEX])
        return usage_error("--convex is outside as well: give one of them", "");
    if (!option_count(o, OPTION_TRIANGLES, &goal->triangles) || !option_length(o, OPTION_ERROR, &goal->error))
        return false;
    return !o->given[OPTION_TRIANGLES] || goal->triangles != 0
               ? true
               : usage_error("--triangles needs a number above 0", "");
}

int cmd_simplify(const options *o) {
    job j;
    nook_simplify_goal goal;
    nook_status reason = NOOK_OK;
    float deviation = 0;
    if (!job_begin(&j, o) || !options_for_goal(o, &goal)) return 2;
    if (job_load(&j) && compute(&j, &goal, o, &reason, &deviation) && job_write(&j)) {
        if (reason != NOOK_OK) j.status = 1;
        report(&j, reason, deviation);
    }
    return job_end(&j);
}
