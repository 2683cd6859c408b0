/* query_bench.c -- nook's queries beside those of its peers, in turn, in one process and one thread.
 *
 * usage: query_bench [only=TASK[:MESH[:ENGINE]]] [rounds=7] [rays=100000] [points=20000] [FILE.stl ...]
 * TASK: build, rays, closest, inside, self (does the mesh cut itself?), pairs (all places where it does).
 * ENGINE: nook32, nook16: 32-bit indices and 16-bit bounds, 16 and 8; -sort: the mesh stands in the order of
 * its tree; -tree: the tree is there and not in the time of self and pairs; a peer's name as in the tables.
 * All that are linked answer the same questions, first once, to be compared, then round by round, A B C,
 * A B C; a figure is the median of the rounds, in CPU time of the process. rounds=0 asks once only.
 * For a profile: valgrind --tool=callgrind --toggle-collect=query_bench_ask build/query/bench \
 *     only=rays:pipe20k:nook32 rounds=0
 * Exit status: 1 where an answer of nook is wrong. */
#define _POSIX_C_SOURCE 200809L
#include "query_bench.h"

#include <malloc.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef enum task { BUILD, RAYS, CLOSEST, INSIDE, SELF, PAIRS, TASKS } task;

static const struct {
    const char *name, *unit;
    double scale; /* of nanoseconds */
} tasks[TASKS] = {{"build", "ns a triangle", 1}, {"rays", "ns a ray", 1}, {"closest", "ns a point", 1},
                  {"inside", "ns a point", 1},   {"self", "ms", 1e-6},    {"pairs", "ms", 1e-6}};

/* The ratio nook / peer that the plan asks for, on meshes from min_nt triangles. */
typedef struct goal {
    task task;
    const char *peer;
    double ratio;
    uint32_t min_nt;
    double logs[2], worst[2]; /* of nook32, nook16: sum of logarithms of what was reached, and the greatest */
    char where[2][32];
    int count[2];
} goal;

static goal goals[] = {{.task = BUILD, .peer = "Embree-med", .ratio = 0.33},
                       {.task = RAYS, .peer = "Embree-med", .ratio = 2.0},
                       {.task = RAYS, .peer = "Bullet", .ratio = 0.1},
                       {.task = RAYS, .peer = "ODE", .ratio = 0.2},
                       {.task = CLOSEST, .peer = "CGAL-double", .ratio = 0.1, .min_nt = 20000},
                       {.task = INSIDE, .peer = "CGAL", .ratio = 0.15},
                       {.task = SELF, .peer = "CGAL", .ratio = 0.25, .min_nt = 20000},
                       {.task = PAIRS, .peer = "CGAL", .ratio = 0.25, .min_nt = 20000}};
enum { GOALS = sizeof goals / sizeof *goals, MOST_COLUMNS = 16, MOST_ROUNDS = 99, MOST_PAIRS = 2000000 };
static const double BYTES_GOAL = 4.0, T_OFF = 1e-4;

typedef struct column {
    const engine *engine;
    void *state;
    double times[MOST_ROUNDS], ns, bytes;
    float *t;
    gap *gaps;
    int8_t *side;
    bool cuts;
    pair *pairs;
    uint32_t found;
} column;

static uint32_t rounds = 7, ray_count = 100000, point_count = 20000;
static const char *only[3]; /* task, mesh, engine */
static const shape *mesh;
static line *rays;
static spot *points;
static column columns[MOST_COLUMNS];
static uint32_t column_count;
static double wrong; /* answers of nook */

static void *room(size_t count, size_t size) {
    void *p = calloc(count + 1u, size);
    if (p == NULL) abort();
    return p;
}

/* ---- questions --------------------------------------------------------------------------------------- */
static const uint64_t SEED = 88172645463325252u;
static uint64_t random_state;

static double random_unit(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (double)(random_state >> 11) * 0x1p-53;
}

static void random_direction(double d[3]) {
    double square;
    do {
        square = 0;
        for (int i = 0; i < 3; i++) {
            d[i] = 2 * random_unit() - 1;
            square += d[i] * d[i];
        }
    } while (square > 1 || square < 0.01);
    for (int i = 0; i < 3; i++) d[i] /= sqrt(square);
}

static spot in_box(double scale) {
    const double x = random_unit() - 0.5, y = random_unit() - 0.5, z = random_unit() - 0.5;
    const double lx = (double)mesh->low.x, hx = (double)mesh->high.x, ly = (double)mesh->low.y,
                 hy = (double)mesh->high.y, lz = (double)mesh->low.z, hz = (double)mesh->high.z;
    const spot p = {(float)((lx + hx) / 2 + scale * x * (hx - lx)),
                    (float)((ly + hy) / 2 + scale * y * (hy - ly)),
                    (float)((lz + hz) / 2 + scale * z * (hz - lz))};
    return p;
}

static spot on_surface(void) {
    const uint32_t *v = mesh->V + 3u * (size_t)(random_unit() * mesh->nt);
    const spot a = mesh->G[v[0]], b = mesh->G[v[1]], c = mesh->G[v[2]];
    float s = (float)random_unit(), t = (float)random_unit();
    if (s + t > 1) {
        s = 1 - s;
        t = 1 - t;
    }
    const spot p = {a.x + s * (b.x - a.x) + t * (c.x - a.x), a.y + s * (b.y - a.y) + t * (c.y - a.y),
                    a.z + s * (b.z - a.z) + t * (c.z - a.z)};
    return p;
}

/* Rays from a sphere around the box to places in it; points in a box 1.25 times as large and, every other
 * one, within 1 % of the surface. The same ones whatever was asked before. */
static void make_questions(void) {
    double d[3];
    random_state = SEED;
    for (uint32_t i = 0; i < ray_count; i++) {
        const spot middle = in_box(0), to = in_box(1);
        random_direction(d);
        const spot from = {middle.x + (float)d[0] * mesh->size, middle.y + (float)d[1] * mesh->size,
                           middle.z + (float)d[2] * mesh->size};
        spot along = {to.x - from.x, to.y - from.y, to.z - from.z};
        const float length = sqrtf(along.x * along.x + along.y * along.y + along.z * along.z);
        along.x /= length;
        along.y /= length;
        along.z /= length;
        rays[i].from = from;
        rays[i].along = along;
    }
    random_state = SEED;
    for (uint32_t i = 0; i < point_count; i++) {
        points[i] = i % 2u == 0 ? in_box(1.25) : on_surface();
        if (i % 2u == 0) continue;
        random_direction(d);
        const float off = (float)random_unit() * 0.01f * mesh->size;
        points[i].x += (float)d[0] * off;
        points[i].y += (float)d[1] * off;
        points[i].z += (float)d[2] * off;
    }
}

/* ---- asking ------------------------------------------------------------------------------------------ */
static bool has(const engine *e, task what) {
    return what == BUILD     ? e->builds
           : what == RAYS    ? e->rays != NULL
           : what == CLOSEST ? e->closest != NULL
           : what == INSIDE  ? e->inside != NULL
           : what == SELF    ? e->cuts != NULL
                             : e->pairs != NULL;
}

static uint32_t questions(task what) {
    return what == RAYS ? ray_count : what == CLOSEST || what == INSIDE ? point_count : 1u;
}

/* The part that is timed. */
void query_bench_ask(column *k, task what, uint32_t n);
#ifdef __GNUC__
__attribute__((noinline))
#endif
void query_bench_ask(column *k, task what, uint32_t n) {
    const engine *e = k->engine;
    switch (what) {
    case BUILD: e->build(k->state); break;
    case RAYS: e->rays(k->state, rays, n, k->t); break;
    case CLOSEST: e->closest(k->state, points, n, k->gaps); break;
    case INSIDE: e->inside(k->state, points, n, k->side); break;
    case SELF: k->cuts = e->cuts(k->state); break;
    case PAIRS: k->found = e->pairs(k->state, k->pairs, MOST_PAIRS); break;
    case TASKS:
    default: break;
    }
}

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static double timed(column *k, task what, uint32_t n) {
    if (what == BUILD) k->engine->unbuild(k->state);
    const double begin = now();
    query_bench_ask(k, what, n);
    return (now() - begin) / (what == BUILD ? (double)mesh->nt : (double)n);
}

static int by_time(const void *a, const void *b) {
    const double p = *(const double *)a, q = *(const double *)b;
    return p < q ? -1 : p > q;
}

static int by_pair(const void *a, const void *b) {
    const pair *p = a, *q = b;
    if (p->t != q->t) return p->t < q->t ? -1 : 1;
    return p->u < q->u ? -1 : p->u > q->u;
}

static size_t heap_in_use(void) {
    const struct mallinfo2 all = mallinfo2();
    return all.uordblks + all.hblkhd;
}

static void open_column(const engine *e, task what) {
    column *k = &columns[column_count];
    const uint32_t n = questions(what);
    memset(k, 0, sizeof *k);
    k->engine = e;
    if (e->max_nt != 0 && mesh->nt > e->max_nt) return;
    k->state = e->prepare(mesh);
    if (k->state == NULL) return;
    column_count++;
    k->t = room(n, sizeof *k->t);
    k->gaps = room(n, sizeof *k->gaps);
    k->side = room(n, sizeof *k->side);
    k->pairs = room(what == PAIRS ? MOST_PAIRS : 0, sizeof *k->pairs);
    if (e->build != NULL) {
        const size_t before = heap_in_use();
        e->build(k->state);
        const size_t grown = heap_in_use() - before;
        k->bytes = (double)(e->kept == NULL ? grown : e->kept(k->state, grown)) / mesh->nt;
    }
}

static void close_column(column *k) {
    if (k->engine->unbuild != NULL) k->engine->unbuild(k->state);
    k->engine->release(k->state);
    free(k->t);
    free(k->gaps);
    free(k->side);
    free(k->pairs);
}

static void open_columns(task what) {
    const engine *const lists[] = {nook32_engines, nook16_engines, embree_engines, bullet_engines,
                                   ode_engines,    fcl_engines,    cgal_engines};
    column_count = 0;
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
        for (const engine *e = lists[i]; e != NULL && e->name != NULL; e++)
            if (has(e, what) && column_count < MOST_COLUMNS &&
                (only[2] == NULL || strcmp(only[2], e->name) == 0))
                open_column(e, what);
}

static void ask_all(task what) {
    const uint32_t n = questions(what);
    for (uint32_t i = 0; i < column_count; i++) columns[i].ns = timed(&columns[i], what, n);
    if (rounds == 0) return;
    for (uint32_t round = 0; round < rounds; round++)
        for (uint32_t i = 0; i < column_count; i++) {
            const uint32_t share = columns[i].engine->share;
            columns[i].times[round] = timed(&columns[i], what, share > 1 && n > share ? n / share : n);
        }
    for (uint32_t i = 0; i < column_count; i++) {
        qsort(columns[i].times, rounds, sizeof(double), by_time);
        columns[i].ns = columns[i].times[rounds / 2u];
    }
}

/* ---- agreement --------------------------------------------------------------------------------------- */
static double hits_differ(const column *k, const column *peer) {
    double n = 0;
    for (uint32_t i = 0; i < ray_count; i++) n += !isinf(k->t[i]) != !isinf(peer->t[i]);
    return n;
}

static double t_differs(const column *k, const column *peer) {
    double n = 0;
    for (uint32_t i = 0; i < ray_count; i++)
        if (!isinf(k->t[i]) && !isinf(peer->t[i]))
            n += fabs((double)(k->t[i] - peer->t[i])) > T_OFF * (double)mesh->size;
    return n;
}

static double t_off(const column *k, const column *peer) {
    double most = 0;
    for (uint32_t i = 0; i < ray_count; i++)
        if (!isinf(k->t[i]) && !isinf(peer->t[i]))
            most = fmax(most, fabs((double)(k->t[i] - peer->t[i])) / (double)mesh->size);
    return most;
}

static double distance_off(const column *k, const column *peer) {
    double most = 0;
    for (uint32_t i = 0; i < point_count; i++)
        most = fmax(most, fabs(k->gaps[i].distance - peer->gaps[i].distance) / peer->gaps[i].distance);
    return most;
}

static double distance_off_size(const column *k, const column *peer) {
    double most = 0;
    for (uint32_t i = 0; i < point_count; i++)
        most = fmax(most, fabs(k->gaps[i].distance - peer->gaps[i].distance) / (double)mesh->size);
    return most;
}

/* How often the true distance is not between those claimed; doubles err by less than 1e-9. */
static double distance_outside(const column *k, const column *peer) {
    double n = 0;
    for (uint32_t i = 0; i < point_count; i++)
        n += peer->gaps[i].distance < k->gaps[i].least * (1 - 1e-9) ||
             peer->gaps[i].distance > k->gaps[i].most * (1 + 1e-9);
    return n;
}

static double sides_differ(const column *k, const column *peer) {
    double n = 0;
    for (uint32_t i = 0; i < point_count; i++) n += k->side[i] != peer->side[i];
    return n;
}

static double cut_found(const column *k, const column *peer) {
    (void)peer;
    return k->cuts;
}

static double cut_differs(const column *k, const column *peer) { return k->cuts != peer->cuts; }

static double pairs_found(const column *k, const column *peer) {
    (void)peer;
    return k->found;
}

static double pairs_differ(const column *k, const column *peer) {
    uint32_t i = 0, j = 0, same = 0;
    if (k->found > MOST_PAIRS || peer->found > MOST_PAIRS) return MOST_PAIRS;
    qsort(k->pairs, k->found, sizeof *k->pairs, by_pair);
    qsort(peer->pairs, peer->found, sizeof *k->pairs, by_pair);
    while (i < k->found && j < peer->found) {
        const int order = by_pair(&k->pairs[i], &peer->pairs[j]);
        same += order == 0;
        i += order <= 0;
        j += order >= 0;
    }
    return (double)k->found + peer->found - 2.0 * same;
}

static const struct {
    task task;
    bool counts; /* as a wrong answer of nook */
    const char *peer, *what;
    double (*of)(const column *, const column *);
} checks[] = {{RAYS, true, "Embree-rob", "hits differ, Embree-rob", hits_differ},
              {RAYS, true, "CGAL-epick", "hits differ, CGAL", hits_differ},
              {RAYS, true, "CGAL-epick", "t off by > 1e-4, CGAL", t_differs},
              {RAYS, false, "CGAL-epick", "t off at most, of size", t_off},
              {CLOSEST, false, "CGAL-double", "off at most, relative", distance_off},
              {CLOSEST, false, "CGAL-double", "off at most, of size", distance_off_size},
              {CLOSEST, true, "CGAL-double", "not within min, max", distance_outside},
              {INSIDE, true, "CGAL", "differ from CGAL", sides_differ},
              {SELF, false, "CGAL", "cuts itself", cut_found},
              {SELF, true, "CGAL", "differs from CGAL", cut_differs},
              {PAIRS, false, "CGAL", "pairs", pairs_found},
              {PAIRS, true, "CGAL", "pairs differ from CGAL", pairs_differ}};

static const column *named(const char *name) {
    for (uint32_t i = 0; i < column_count; i++)
        if (strcmp(columns[i].engine->name, name) == 0) return &columns[i];
    return NULL;
}

/* ---- tables ------------------------------------------------------------------------------------------ */
/* A value that should be at most limit: ok, or by how much it is missed, or how many times too large. */
static void print_goal(const char *what, double value, double limit) {
    char text[32];
    if (value <= limit)
        snprintf(text, sizeof text, "%.3g ok", value);
    else if (value < 10 * limit)
        snprintf(text, sizeof text, "%.3g +%.0f%%", value, 100 * (value / limit - 1));
    else
        snprintf(text, sizeof text, "%.3g x%.0f", value, value / limit);
    printf(what, text);
}

static void print_ratios(task what, int form) {
    static const char *const forms[] = {"nook32", "nook16"};
    const column *nook = named(forms[form]);
    if (nook == NULL || strncmp(columns[column_count - 1u].engine->name, "nook", 4) == 0) return;
    printf("  %-22s", form == 0 ? "nook32 / it" : "nook16 / it");
    for (uint32_t i = 0; i < column_count; i++) {
        const column *k = &columns[i];
        const double ratio = nook->ns / k->ns;
        goal *g = goals;
        while (g < goals + GOALS &&
               (g->task != what || strcmp(g->peer, k->engine->name) != 0 || mesh->nt < g->min_nt))
            g++;
        if (strncmp(k->engine->name, "nook", 4) == 0) {
            printf("%13s", "");
        } else if (g == goals + GOALS ||
                   (what == SELF && k->cuts)) { /* no goal: who stumbles first on a pair */
            printf("%13.3g", ratio);
        } else {
            print_goal("%13s", ratio, g->ratio);
            g->logs[form] += log(ratio);
            g->count[form]++;
            if (ratio > g->worst[form]) {
                g->worst[form] = ratio;
                snprintf(g->where[form], sizeof g->where[form], "%s", mesh->name);
            }
        }
    }
    printf("\n");
}

static void print_row(task what) {
    printf("%-15.14s%9u", mesh->name, mesh->nt);
    for (uint32_t i = 0; i < column_count; i++) printf("%13.4g", columns[i].ns * tasks[what].scale);
    printf("\n");
    print_ratios(what, 0);
    print_ratios(what, 1);
    if (what == BUILD) {
        printf("  %-22s", "bytes a triangle");
        for (uint32_t i = 0; i < column_count; i++)
            if (strncmp(columns[i].engine->name, "nook", 4) == 0)
                print_goal("%13s", columns[i].bytes, BYTES_GOAL * 1.01);
            else
                printf("%13.1f", columns[i].bytes);
        printf("\n");
    }
    for (size_t c = 0; c < sizeof checks / sizeof *checks; c++) {
        const column *peer = named(checks[c].peer);
        if (checks[c].task != what || peer == NULL) continue;
        printf("  %-22s", checks[c].what);
        for (uint32_t i = 0; i < column_count; i++) {
            const double value = checks[c].of(&columns[i], peer);
            printf(value == floor(value) ? "%13.0f" : "%13.2g", value);
            if (checks[c].counts && strncmp(columns[i].engine->name, "nook", 4) == 0) wrong += value;
        }
        printf("\n");
    }
    fflush(stdout);
}

static void print_head(task what) {
    printf("\n%s, %s", tasks[what].name, tasks[what].unit);
    for (const goal *g = goals; g < goals + GOALS; g++)
        if (g->task == what) printf("; goal %g of %s", g->ratio, g->peer);
    printf("\n%24s", "");
    for (uint32_t i = 0; i < column_count; i++) printf("%13s", columns[i].engine->name);
    printf("\n");
}

static void print_goals(void) {
    printf("\ngoals\n");
    for (const goal *g = goals; g < goals + GOALS; g++)
        for (int form = 0; form < 2; form++) {
            if (g->count[form] == 0) continue;
            printf("  %-8s%s <= %-5g of %-12s", tasks[g->task].name, form == 0 ? "nook32" : "nook16",
                   g->ratio, g->peer);
            print_goal(" mean %-14s", exp(g->logs[form] / g->count[form]), g->ratio);
            print_goal(" worst %-14s", g->worst[form], g->ratio);
            printf(" %s\n", g->where[form]);
        }
    printf("%.0f wrong answers of nook\n", wrong);
}

static bool wanted(int which, const char *name) {
    return only[which] == NULL || strcmp(only[which], name) == 0;
}

static void bench(task what, const shape *s, bool *headed) {
    mesh = s;
    open_columns(what);
    if (column_count != 0) {
        if (!*headed) print_head(what);
        *headed = true;
        make_questions();
        ask_all(what);
        print_row(what);
    }
    for (uint32_t i = 0; i < column_count; i++) close_column(&columns[i]);
}

/* Meshes for a task: all; the one that cuts itself only for the last two, and for them those of one size. */
static bool fits(task what, const char *name) {
    const bool thick = strcmp(name, "thick20k") == 0;
    if (only[1] != NULL) return strcmp(only[1], name) == 0;
    return what == SELF || what == PAIRS ? strstr(name, "20k") != NULL : !thick;
}

static void option(char *text) {
    if (strncmp(text, "only=", 5) == 0) {
        only[0] = text + 5;
        for (int i = 1; i < 3 && strchr(only[i - 1], ':') != NULL; i++) {
            char *colon = strchr(only[i - 1], ':');
            *colon = 0;
            only[i] = colon + 1;
        }
        for (int i = 0; i < 3; i++)
            if (only[i] != NULL && *only[i] == 0) only[i] = NULL;
    } else if (strncmp(text, "rounds=", 7) == 0) {
        rounds = (uint32_t)strtoul(text + 7, NULL, 10);
    } else if (strncmp(text, "rays=", 5) == 0) {
        ray_count = (uint32_t)strtoul(text + 5, NULL, 10);
    } else if (strncmp(text, "points=", 7) == 0) {
        point_count = (uint32_t)strtoul(text + 7, NULL, 10);
    }
    if (rounds > MOST_ROUNDS) rounds = MOST_ROUNDS;
}

int main(int argc, char **argv) {
    static const char *const names[] = {"pipe1k",     "gear5k",    "pipe20k",  "gear20k", "knot20k",
                                        "capsule20k", "sphere20k", "pipe100k", "thick20k"};
    for (int i = 1; i < argc; i++)
        if (strchr(argv[i], '=') != NULL) option(argv[i]);
    rays = room(ray_count, sizeof *rays);
    points = room(point_count, sizeof *points);
    for (task what = BUILD; what < TASKS; what++) {
        bool headed = false;
        if (!wanted(0, tasks[what].name)) continue;
        for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
            shape s;
            if (!fits(what, names[i])) continue;
            if (!shape_make(&s, names[i])) abort();
            if (!s.closed) printf("%s is not closed\n", s.name);
            bench(what, &s, &headed);
            shape_free(&s);
        }
        for (int i = 1; i < argc; i++) {
            shape s;
            if (strchr(argv[i], '=') != NULL) continue;
            if (!shape_read(&s, argv[i])) {
                printf("%s cannot be read\n", argv[i]);
                continue;
            }
            bench(what, &s, &headed);
            shape_free(&s);
        }
    }
    print_goals();
    free(rays);
    free(points);
    return wrong > 0;
}
