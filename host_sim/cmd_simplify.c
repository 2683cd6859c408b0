/* cmd_simplify.c -- a mesh file with fewer triangles as another.
 *
 * Memory: the tables of the mesh and a float a vertex; for --convex those that its hull may need. */
#include "commands.h"

#include <float.h>
#include <inttypes.h>
#include <stdlib.h>

#include "decimal.h"
#include "heap.h"
#include "json.h"
#include "verdict.h"

const char simplify_help[] =
    "nook simplify [OPTION...] IN OUT (--triangles N | --error E)        the same shape with fewer "
    "triangles\n"
    "\n"
    "Handles, borders and separate parts stay as many as they are, and no triangle turns over. Says how far "
    "the\n"
    "surfaces of IN and OUT are from each other at most, in either direction.\n"
    "  --triangles N       stop at N triangles, or one less\n"
    "  --error E           as few as can be while neither surface is farther than E from the other\n"
    "  --outside           nothing of the solid IN is outside OUT, exactly: for collision. IN is closed and "
    "faces outward\n"
    "  --convex            the same with the convex hull of IN, and OUT is convex; distances are from the "
    "hull\n"
    "  --format F          stl obj off ply, whatever OUT is called; OUT may be -\n"
    "  --weld exact|none   join vertices with equal coordinates (default: exact for STL, none else)\n"
    "  --scale S           multiply every coordinate by S first\n"
    "  --json              the numbers as one JSON object\n"
    "\n"
    "Exit status: 0 written, 1 no: IN is not a manifold, oriented mesh (nothing is written; nook check says "
    "where), or\n"
    "so few triangles cannot be (what could is written), 2 unreadable, not written or wrong usage.\n";

typedef struct simplified {
    const char *in, *out;
    uint32_t vertices_in, triangles_in, vertices, triangles;
    float deviation;
    nook_status reason;  /* why there are more triangles than asked for */
    const char *refused; /* why there is nothing */
} simplified;

static bool take_tables(nook_mesh *m, uint32_t nv, uint32_t nt, failure *f) {
    nook_status status =
        nt > NOOK_MAX_TRIANGLES
            ? NOOK_NO_CAPACITY
            : nook_mesh_init(m, take(nv, sizeof *m->G), take(3 * (size_t)nt, sizeof *m->V),
                             take(3 * (size_t)nt, sizeof *m->O), take(nv, sizeof *m->C), nv, nt);
    return status == NOOK_OK ? true : fail(f, status, NULL);
}

/* The mesh, or the points of its triangles for their hull. */
static bool take_mesh(nook_mesh *m, const nook_mesh *from, bool convex, failure *f) {
    uint32_t i, nv = from->nv, hull = nv < 4u ? 4u : 2u * nv - 4u;
    if (!take_tables(m, nv, convex ? hull : from->nt, f)) return false;
    m->nv = nv;
    for (i = 0; i < nv; i++) m->G[i] = from->G[i];
    if (!convex) {
        m->nt = from->nt;
        for (i = 0; i < 3u * m->nt; i++) m->V[i] = from->V[i];
        return true;
    }
    for (i = 0; i < nv; i++) m->C[i] = NOOK_STORED_NONE;
    for (i = 0; i < 3u * from->nt; i++) m->C[from->V[i]] = 0;
    for (m->nv = i = 0; i < nv; i++) {
        if (m->C[i] == 0) m->G[m->nv++] = from->G[i];
    }
    return true;
}

static nook_status make_hull(nook_mesh *m) {
    nook_marks marks = {take(NOOK_MT_BYTES(m->max_nt), 1), take(NOOK_MV_BYTES(m->max_nv), 1), m->max_nt,
                        m->max_nv};
    nook_status status = nook_hull(m, &marks, NULL, NULL);
    free(marks.Mt);
    free(marks.Mv);
    return status;
}

/* What stands in the way, or null. */
static const char *link_mesh(nook_mesh *m) {
    nook_marks marks = {take(NOOK_MT_BYTES(m->max_nt), 1), take(NOOK_MV_BYTES(m->max_nv), 1), m->max_nt,
                        m->max_nv};
    nook_report report;
    nook_check_result check;
    nook_view view;
    nook_status status = nook_link(m, &marks, NULL, NULL, &report, NULL);
    memset(&check, 0, sizeof check);
    view = nook_view_of(m);
    if (status == NOOK_OK) status = nook_check(&view, &marks, &report, NULL, NULL, &check);
    free(marks.Mt);
    free(marks.Mv);
    if (status != NOOK_OK) return nook_status_text(status);
    if (check.manifold != NOOK_YES || check.oriented != NOOK_YES || check.duplicate_triangles != 0)
        return "it is not a manifold, oriented mesh; nook check says where";
    return NULL;
}

/* Whether all shells face out of the solid they bound; each by itself where shells cross. */
static bool faces_outward(const verdict *v) {
    if (v->check.watertight != NOOK_YES || v->check.oriented != NOOK_YES) return false;
    return v->outward == NOOK_MAYBE ? v->check.geometry.inside_out_shells == 0 : v->outward == NOOK_YES;
}

static bool look_for_solid(simplified *s, model *m, failure *f) {
    verdict v;
    bool good = examine(&v, m, 0, f);
    if (good && !faces_outward(&v))
        s->refused = "it has no inside to be kept: it must be closed and face outward; nook check says where "
                     "it does not";
    verdict_free(&v);
    return good;
}

/* What is convex is made so again (nook_simplify.h says why it is no farther away). */
static void simplify(simplified *s, nook_mesh *m, nook_simplify_goal *goal, bool convex) {
    nook_simplify_state state;
    uint32_t v;
    if (convex && make_hull(m) != NOOK_OK) {
        s->refused = "no hull has a volume: the points lie in one plane";
        return;
    }
    if (s->refused == NULL) s->refused = link_mesh(m);
    if (s->refused != NULL) return;
    goal->deviation = take(m->nv, sizeof *goal->deviation);
    for (v = 0; v < m->nv; v++) goal->deviation[v] = 0;
    s->reason = nook_simplify(&state, m, goal, NULL);
    for (v = 0; v < m->nv; v++) {
        if (goal->deviation[v] > s->deviation) s->deviation = goal->deviation[v];
    }
    free(goal->deviation);
    if (convex) (void)make_hull(m);
    s->vertices = m->nv;
    s->triangles = m->nt;
}

static void report_numbers(FILE *to, const simplified *s) {
    bool none = s->refused != NULL;
    (void)fputs("{\"file\":", to);
    put_string(to, s->in);
    put_count(to, "vertices_in", s->vertices_in);
    put_count(to, "triangles_in", s->triangles_in);
    put_count(to, "vertices", none ? NOOK_UNKNOWN : s->vertices);
    put_count(to, "triangles", none ? NOOK_UNKNOWN : s->triangles);
    put_float(to, "deviation", !none, s->deviation);
    if (s->reason == NOOK_OK) {
        put_null(to, "reason");
    } else {
        put_text(to, "reason", nook_status_name(s->reason));
    }
    (void)fputs("}\n", to);
}

static void report_line(FILE *to, const simplified *s) {
    print_name(to, s->out);
    (void)fprintf(to,
                  ": %" PRIu32 " triangles of %" PRIu32 ", %" PRIu32 " vertices of %" PRIu32
                  ", no farther than %s\n",
                  s->triangles, s->triangles_in, s->vertices, s->vertices_in, decimal_of(s->deviation).text);
}

/* What is said goes to standard output, unless the mesh does. */
static int finish(const simplified *s, const nook_mesh *m, file_format format, bool as_json) {
    FILE *to = strcmp(s->out, "-") == 0 ? stderr : stdout;
    char what[160];
    if (s->refused == NULL && !write_mesh(m, s->out, format)) return 2;
    if (s->refused != NULL) print_message(stderr, s->in, s->refused);
    if (s->reason != NOOK_OK) {
        (void)snprintf(what, sizeof what, "fewer than %" PRIu32 " triangles cannot be: %s", s->triangles,
                       nook_status_text(s->reason));
        print_message(stderr, s->in, what);
    }
    if (as_json) report_numbers(to, s);
    if (!as_json && s->refused == NULL) report_line(to, s);
    return s->refused != NULL || s->reason != NOOK_OK ? 1 : 0;
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
    load_options load;
    file_format format;
    simplified s;
    nook_simplify_goal goal;
    nook_mesh mesh;
    model m;
    failure f;
    int status = 2;
    memset(&s, 0, sizeof s);
    memset(&mesh, 0, sizeof mesh);
    if (o->operands != 3)
        return usage_error("simplify needs IN and OUT (see nook simplify --help)", "") ? 0 : 2;
    s.in = o->operand[1];
    s.out = o->operand[2];
    if (!options_for_goal(o, &goal) || !options_for_load(o, &load) || !option_format(o, s.out, &format))
        return 2;
    if (model_load(&m, s.in, &load, 0, &f) && take_mesh(&mesh, &m.mesh, o->given[OPTION_CONVEX], &f) &&
        (!o->given[OPTION_OUTSIDE] || look_for_solid(&s, &m, &f))) {
        s.vertices_in = m.mesh.nv;
        s.triangles_in = m.triangles_in;
        simplify(&s, &mesh, &goal, o->given[OPTION_CONVEX]);
        status = finish(&s, &mesh, format, o->given[OPTION_JSON]);
    } else {
        print_failure(stderr, s.in, &f);
    }
    model_free(&m);
    free(mesh.G);
    free(mesh.V);
    free(mesh.O);
    free(mesh.C);
    return status;
}
