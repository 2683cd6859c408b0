/* cmd_query.c -- questions on standard input, one a line; answers on standard output, in the same order.
 *
 * Memory: the mesh, its tree, and one line of at most LONGEST_LINE bytes. */
#define _POSIX_C_SOURCE 200809L
#include "commands.h"

#include <errno.h>
#include <stdlib.h>
#include <sys/stat.h>

#include "bytes.h"
#include "decimal.h"
#include "heap.h"
#include "json.h"
#include "question.h"
#include "tree.h"

#define LONGEST_LINE ((size_t)1 << 20)

const char query_help[] =
    "nook query [OPTION...] FILE         where is this point, how far is it, what does this ray hit?\n"
    "\n"
    "Reads one JSON object a line from standard input and answers each with one line, in order.\n"
    "  {\"point\":[x,y,z]}                                  answer: side, distance, closest, triangle\n"
    "      side: -1 inside, 0 on the surface, 1 outside, exactly; null where no inside is defined (some\n"
    "      edge has an odd number of triangles)\n"
    "  {\"ray\":{\"origin\":[x,y,z],\"direction\":[x,y,z]}}     answer: hit, t, triangle, normal, "
    "barycentric\n"
    "      the first hit, at origin + t direction with t >= 0\n"
    "  {\"segment\":[[x,y,z],[x,y,z]],\"radius\":r}           answer: distance, closest, on, triangle, "
    "touches\n"
    "      distance of the segment from the surface, between the points closest (of the mesh) and on (of\n"
    "      the segment); touches: whether the capsule of this radius meets the surface, true unless it\n"
    "      is surely clear; a segment of two equal points is a sphere\n"
    "  --weld exact|none   join vertices with equal coordinates (default: exact for STL, none else)\n"
    "  --scale S           multiply every coordinate of the mesh by S first, not those of the questions\n"
    "  --budget N          at most N steps for each question. What is not finished then says \"complete\":\n"
    "                      false, and distance_min and distance_max for distance, t_min for what is before\n"
    "                      any hit; what is not decided is null\n"
    "  --json              changes nothing: answers are JSON anyway\n"
    "\n"
    "Triangles are numbered as left when degenerate ones are dropped, from 0. Empty lines are skipped,\n"
    "keys of no meaning ignored. Answers are flushed one by one unless standard input is a file.\n"
    "Exit status: 0 all answered, 2 unreadable mesh, malformed line (which ends it) or wrong usage.\n";

typedef struct asker {
    tree tree;
    bool even; /* an inside is defined */
    uint32_t budget;
    bool flush;
} asker;

/* ---- answers ----------------------------------------------------------------------------------- */

static void put_bounds(const nook_closest *c) {
    put_float(stdout, "distance_min", true, c->distance_min);
    put_float(stdout, "distance_max", true, c->distance_max);
}

static nook_status ask_side(nook_inside *inside, nook_status status, uint32_t *units) {
    return status == NOOK_MORE ? nook_inside_step(inside, units) : status;
}

/* Half of the budget is for the side, the rest for the distance; what either leaves is for the other. */
static nook_status answer_point(const asker *a, const question *q) {
    static const char *const sides[] = {"-1", "0", "1"};
    nook_inside inside;
    nook_closest closest;
    uint32_t units = a->even ? a->budget / 2u : 0, rest = a->budget - units;
    nook_status known = NOOK_MORE,
                status = nook_closest_begin(&closest, &a->tree.bvh, q->a, q->a, NOOK_FAR, 0);
    if (status == NOOK_OK) status = nook_inside_begin(&inside, &a->tree.bvh, q->a);
    if (status != NOOK_OK) return status;
    if (a->even) known = ask_side(&inside, known, &units);
    units += rest;
    status = nook_closest_step(&closest, &units);
    if (a->even) known = ask_side(&inside, known, &units);
    if (status == NOOK_OK && a->even) status = known;
    if (status != NOOK_OK && status != NOOK_MORE) return status;
    (void)printf("{\"side\":%s", known == NOOK_OK ? sides[nook_inside_side(&inside) + 1] : "null");
    if (status == NOOK_OK) {
        put_float(stdout, "distance", true, closest.distance);
    } else {
        put_truth(stdout, "complete", NOOK_NO);
        put_bounds(&closest);
    }
    put_point(stdout, "closest", closest.triangle != NOOK_NONE, closest.point);
    put_count(stdout, "triangle", closest.triangle);
    return NOOK_OK;
}

static nook_status answer_ray(const asker *a, const question *q) {
    nook_ray ray;
    uint32_t units = a->budget;
    float w[3];
    bool hit;
    nook_point normal;
    nook_status status = nook_ray_begin(&ray, &a->tree.bvh, q->a, q->b, NOOK_MAX_T, NOOK_NEAREST);
    if (status == NOOK_OK) status = nook_ray_step(&ray, &units);
    if (status != NOOK_OK && status != NOOK_MORE) return status;
    hit = ray.triangle != NOOK_NONE;
    (void)printf("{\"hit\":%s", hit ? "true" : status == NOOK_OK ? "false" : "null");
    if (status == NOOK_MORE) {
        put_truth(stdout, "complete", NOOK_NO);
        put_float(stdout, "t_min", true, ray.t_min);
    }
    put_float(stdout, "t", hit, ray.t);
    put_count(stdout, "triangle", ray.triangle);
    if (!hit) return NOOK_OK;
    normal = nook_ray_normal(&ray);
    put_point(stdout, "normal", normal.x != 0 || normal.y != 0 || normal.z != 0, normal);
    nook_ray_weights(&ray, w);
    put_floats(stdout, "barycentric", true, w, 3);
    return NOOK_OK;
}

static nook_point on_segment(nook_point a, nook_point b, float at) {
    nook_point along = nook_scaled(nook_sub(b, a), at);
    return nook_make(a.x + along.x, a.y + along.y, a.z + along.z);
}

/* By the bounds, so that what is not surely clear touches; undecided only while there is more to look at. */
static nook_truth touches(const nook_closest *c, float radius, bool complete) {
    if (c->distance_min > radius) return NOOK_NO;
    return complete || c->distance_max <= radius ? NOOK_YES : NOOK_MAYBE;
}

static nook_status answer_segment(const asker *a, const question *q) {
    nook_closest closest;
    uint32_t units = a->budget;
    bool found;
    nook_status status = nook_closest_begin(&closest, &a->tree.bvh, q->a, q->b, NOOK_FAR, 0);
    if (status == NOOK_OK) status = nook_closest_step(&closest, &units);
    if (status != NOOK_OK && status != NOOK_MORE) return status;
    found = closest.triangle != NOOK_NONE;
    if (status == NOOK_OK) {
        (void)printf("{\"distance\":%s", decimal_of(closest.distance).text);
    } else {
        (void)fputs("{\"complete\":false", stdout);
        put_bounds(&closest);
    }
    put_point(stdout, "closest", found, closest.point);
    put_point(stdout, "on", found, on_segment(q->a, q->b, closest.at));
    put_count(stdout, "triangle", closest.triangle);
    put_truth(stdout, "touches", touches(&closest, q->radius, status == NOOK_OK));
    return NOOK_OK;
}

static nook_status answer(const asker *a, const question *q) {
    nook_status status = q->kind == ASK_POINT ? answer_point(a, q)
                         : q->kind == ASK_RAY ? answer_ray(a, q)
                                              : answer_segment(a, q);
    if (status != NOOK_OK) return status;
    (void)fputs("}\n", stdout);
    if (a->flush) (void)fflush(stdout);
    return NOOK_OK;
}

/* ---- lines ------------------------------------------------------------------------------------- */

static bool is_blank(const bytes *line) {
    size_t i;
    for (i = 0; i < line->size; i++) {
        if (line->data[i] != ' ' && line->data[i] != '\t' && line->data[i] != '\r') return false;
    }
    return true;
}

/* The next line without its end; false if there is none. It is longer than LONGEST_LINE if more follows. */
static bool next_line(bytes *line) {
    int c = getchar();
    line->size = 0;
    if (c == EOF) return false;
    for (; c != EOF && c != '\n' && line->size <= LONGEST_LINE; c = getchar()) {
        line->data = grow(line->data, &line->room, line->size + 1, 1);
        line->data[line->size++] = (uint8_t)c;
    }
    return true;
}

static bool answer_line(const asker *a, const bytes *line, uint64_t number, failure *f) {
    question q;
    const char *wrong = "the line is longer than 1 MiB";
    nook_status status;
    if (is_blank(line)) return true;
    if (line->size > LONGEST_LINE || !question_read(&q, (const char *)line->data, line->size, &wrong))
        return fail_at_line(f, NOOK_BAD_SYNTAX, wrong, number);
    status = answer(a, &q);
    return status == NOOK_OK ? true : fail_at_line(f, status, NULL, number);
}

/* Nobody may be left to read the answers: then there is no point in going on, and main() says why. */
static bool answer_all(const asker *a, failure *f) {
    bytes line;
    uint64_t number = 0;
    bool good = true;
    memset(&line, 0, sizeof line);
    errno = 0;
    while (good && !ferror(stdout) && next_line(&line)) good = answer_line(a, &line, ++number, f);
    if (good && ferror(stdin)) good = fail(f, NOOK_OK, errno == 0 ? "input error" : strerror(errno));
    bytes_free(&line);
    return good;
}

/* ---- the command ------------------------------------------------------------------------------- */

/* A pipe or a terminal may have someone at the other end who waits for an answer before asking again. */
static bool somebody_waits(void) {
    struct stat input;
    return fstat(0, &input) != 0 || !S_ISREG(input.st_mode);
}

static bool prepare(asker *a, model *m, const char *path, const load_options *load, failure *f) {
    nook_report report;
    nook_status status;
    if (!model_load(m, path, load, 0, f)) return false;
    status = nook_link(&m->mesh, NULL, NULL, NULL, &report, NULL);
    if (status != NOOK_OK) return fail(f, status, NULL);
    a->even = report.odd_edges == 0;
    a->flush = somebody_waits();
    return tree_build(&a->tree, &m->mesh, f);
}

int cmd_query(const options *o) {
    load_options load;
    asker a;
    model m;
    failure f;
    bool ready, good;
    memset(&a, 0, sizeof a);
    a.budget = UINT32_MAX;
    if (!options_for_load(o, &load) || !option_count(o, OPTION_BUDGET, &a.budget)) return 2;
    if (o->operands != 2) return usage_error("query needs one file (see nook query --help)", "") ? 0 : 2;
    if (strcmp(o->operand[1], "-") == 0)
        return usage_error("the mesh of a query must be a file: the questions are on standard input", "") ? 0
                                                                                                          : 2;
    ready = prepare(&a, &m, o->operand[1], &load, &f);
    good = ready && answer_all(&a, &f);
    if (!good) {
        (void)fflush(stdout); /* the answers so far, before what went wrong */
        print_failure(stderr, ready ? "<stdin>" : o->operand[1], &f);
    }
    tree_free(&a.tree);
    model_free(&m);
    return good ? 0 : 2;
}
