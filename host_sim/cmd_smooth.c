/* cmd_smooth.c -- a smoothed mesh file as another.
 *
 * Memory: the mesh, its points as they were, a float a vertex, and the tree of boxes over the original. */
#include "commands.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#include "decimal.h"
#include "heap.h"
#include "job.h"
#include "json.h"
#include "tree.h"

const char smooth_help[] =
    "nook smooth [OPTION...] IN OUT      a mesh without its noise\n"
    "\n"
    "Each vertex goes a part of the way to the middle of its neighbours. What is joined to what stays as\n"
    "it is, no triangle turns over, and a border stays unless it may slide. Thin parts may come to cut each\n"
    "other, which nook check finds. Says how far the surfaces of IN and OUT are from each other at most, "
    "which\n"
    "is as far as a vertex went; how far a vertex is from the surface it was on; and how the volume of a\n"
    "closed mesh has changed.\n"
    "  --iterations N      rounds (default 10)\n"
    "  --method taubin     a part of the way and a little more back: the volume of what is many edges\n"
    "                      wide is nearly kept (default)\n"
    "  --method laplace    half of the way, and not back: shrinks\n"
    "  --slide             vertices at a border go to the middle of their two neighbours there\n"
    "  --format F          stl obj off ply, whatever OUT is called; OUT may be -\n"
    "  --weld exact|none   join vertices with equal coordinates first (default: exact for STL, none else)\n"
    "  --scale S           multiply every coordinate by S first\n"
    "  --json              the numbers as one JSON object\n"
    "\n"
    "Exit status: 0 written, 2 unreadable, not written or wrong usage.\n";

typedef struct smoothed {
    nook_smoothing how;
    bool closed; /* and oriented: then there is a volume */
    nook_smoothed told;
    float distance;  /* the most that a vertex is from the original, */
    float deviation; /* and from where it was: any point of either surface has one of the other so near */
} smoothed;

/* Never less. */
static float distance_between(const nook_point *p, const nook_point *q) {
    double x = (double)p->x - (double)q->x, y = (double)p->y - (double)q->y, z = (double)p->z - (double)q->z;
    return nextafterf((float)sqrt(x * x + y * y + z * z), FLT_MAX);
}

/* Vertices that did not move, or are of no triangle, are where they were. */
static bool measure_distance(smoothed *s, const nook_mesh *mesh, nook_point *was, failure *f) {
    nook_mesh original = *mesh;
    tree t;
    nook_closest closest;
    nook_status status = NOOK_OK;
    uint32_t v;
    original.G = was;
    if (!tree_build(&t, &original, f)) {
        tree_free(&t);
        return false;
    }
    for (v = 0; v < mesh->nv && status == NOOK_OK; v++) {
        float went = distance_between(&was[v], &mesh->G[v]);
        if (memcmp(&was[v], &mesh->G[v], sizeof *was) == 0) continue;
        if (went > s->deviation) s->deviation = went;
        status = nook_closest_point(&closest, &t.bvh, mesh->G[v]);
        if (status == NOOK_OK && closest.distance > s->distance) s->distance = closest.distance;
    }
    tree_free(&t);
    return status == NOOK_OK ? true : fail(f, status, NULL);
}

static bool compute(smoothed *s, job *j) {
    nook_mesh *mesh = &j->m.mesh;
    nook_point *was = take(mesh->nv, sizeof *was);
    float *next = take(mesh->nv, sizeof *next);
    nook_report report;
    failure f;
    bool good;
    nook_status status = nook_link(mesh, NULL, NULL, NULL, &report, NULL);
    if (status == NOOK_OK && report.border_edges != 0) job_hint(j);
    memcpy(was, mesh->G, mesh->nv * sizeof *was);
    s->how.reference = was;
    if (status == NOOK_OK) status = nook_smooth(mesh, &s->how, next, &s->told);
    good = status == NOOK_OK ? measure_distance(s, mesh, was, &f) : fail(&f, status, NULL);
    s->closed = report.matched_edges == report.edges;
    free(was);
    free(next);
    return good ? true : job_fail(j, &f);
}

static void report_numbers(FILE *to, const smoothed *s) {
    float volume = s->told.volume < 0 ? -s->told.volume : s->told.volume;
    put_text(to, "method", s->how.mu != 0 ? "taubin" : "laplace");
    put_count(to, "iterations", s->how.rounds);
    put_count(to, "held_triangles", s->told.held);
    put_float(to, "volume_in", s->closed, s->told.volume);
    put_float(to, "volume_gained", s->closed || !s->how.slide, s->told.gained);
    put_float(to, "volume_drift", s->closed, s->told.gained / volume);
    put_float(to, "deviation", true, s->deviation);
    put_float(to, "distance", true, s->distance);
}

static void report_line(const job *j, const smoothed *s) {
    (void)fprintf(j->to, ": %" PRIu32 " vertices, %" PRIu32 " triangles, no farther than %s", j->m.mesh.nv,
                  j->m.mesh.nt, decimal_of(s->deviation).text);
    (void)fprintf(j->to, ", vertices %s", decimal_of(s->distance).text);
    if (s->closed) {
        (void)fprintf(j->to, "; volume %s", decimal_of(s->told.volume).text);
        (void)fprintf(j->to, ", gained %s", decimal_of(s->told.gained).text);
    }
    if (s->told.held > 0)
        (void)fprintf(j->to, "; %" PRIu32 " times a triangle would have turned", s->told.held);
}

static bool option_method(const options *o, nook_smoothing *how) {
    const char *method = o->given[OPTION_METHOD] ? o->value[OPTION_METHOD] : "taubin";
    how->lambda = NOOK_TAUBIN_LAMBDA;
    how->mu = NOOK_TAUBIN_MU;
    if (strcmp(method, "taubin") == 0) return true;
    how->lambda = 0.5f;
    how->mu = 0;
    return strcmp(method, "laplace") == 0 || usage_error("--method is taubin or laplace, not ", method);
}

int cmd_smooth(const options *o) {
    job j;
    smoothed s;
    memset(&s, 0, sizeof s);
    s.how.rounds = 10;
    s.how.slide = o->given[OPTION_SLIDE];
    if (!job_begin(&j, o)) return 2;
    if (!option_count(o, OPTION_ITERATIONS, &s.how.rounds) || !option_method(o, &s.how)) return 2;
    if (job_load(&j) && compute(&s, &j) && job_write(&j)) {
        if (j.json) report_numbers(j.to, &s);
        if (!j.json) report_line(&j, &s);
    }
    return job_end(&j);
}
