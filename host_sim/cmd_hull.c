/* cmd_hull.c -- the convex hull of a mesh file as another.
 *
 * Memory: the points, and tables for the 2 nv - 4 triangles that a hull of nv points can have. */
#include "commands.h"

#include <inttypes.h>
#include <stdlib.h>

#include "decimal.h"
#include "heap.h"
#include "json.h"

const char hull_help[] =
    "nook hull [OPTION...] IN OUT        the convex hull of a mesh, exactly\n"
    "\n"
    "Its vertices are those of IN that stick out, unmoved and in their order; triangles face outward.\n"
    "Vertices that no triangle of IN uses are left out, unless IN has no triangle at all: then it is\n"
    "taken for a cloud of points. Says how many vertices and triangles there were and are, and the volume.\n"
    "  --format F          stl obj off ply, whatever OUT is called; OUT may be -\n"
    "  --weld exact|none   join vertices with equal coordinates (default: exact for STL, none else);\n"
    "                      the hull is the same either way\n"
    "  --scale S           multiply every coordinate by S first\n"
    "  --json              the numbers as one JSON object; null if there is no hull\n"
    "\n"
    "Exit status: 0 written, 1 no hull has a volume: the points lie in one plane, 2 unreadable, not\n"
    "written or wrong usage.\n";

typedef struct hulled {
    const char *in, *out;
    uint32_t vertices_in, triangles_in, vertices, triangles;
    float volume;
    bool flat;
} hulled;

/* The points that count: those of triangles, or all if there is no triangle. */
static uint32_t take_points(nook_point *to, const nook_mesh *from) {
    uint8_t *used = take(from->nv, 1);
    uint32_t i, n = 0;
    memset(used, from->nt == 0 ? 1 : 0, from->nv);
    for (i = 0; i < 3u * from->nt; i++) used[from->V[i]] = 1;
    for (i = 0; i < from->nv; i++) {
        if (used[i] != 0) to[n++] = from->G[i];
    }
    free(used);
    return n;
}

/* NOOK_FLAT_SHELL is an answer, not a failure. */
static nook_status make_hull(nook_mesh *hull) {
    nook_marks marks;
    nook_status status;
    marks.max_nt = hull->max_nt;
    marks.max_nv = hull->max_nv;
    marks.Mt = take(NOOK_MT_BYTES(marks.max_nt), 1);
    marks.Mv = take(NOOK_MV_BYTES(marks.max_nv), 1);
    status = nook_hull(hull, &marks, NULL, NULL);
    free(marks.Mt);
    free(marks.Mv);
    return status;
}

/* Tables for the points of m and the largest hull that they can have. */
static bool take_tables(nook_mesh *hull, const nook_mesh *from, failure *f) {
    char what[120];
    uint32_t nv = from->nv < 4u ? 4u : from->nv, nt = 2u * nv - 4u;
    nook_status status;
    if (nt > NOOK_MAX_TRIANGLES) {
        (void)snprintf(what, sizeof what,
                       "%" PRIu32 " points may need %" PRIu32
                       " triangles, but %d-bit indices hold at most %u",
                       nv, nt, NOOK_INDEX_BITS, NOOK_MAX_TRIANGLES);
        return fail(f, NOOK_NO_CAPACITY, what);
    }
    status = nook_mesh_init(hull, take(nv, sizeof *hull->G), take(3 * (size_t)nt, sizeof *hull->V),
                            take(3 * (size_t)nt, sizeof *hull->O), take(nv, sizeof *hull->C), nv, nt);
    if (status != NOOK_OK) return fail(f, status, NULL);
    hull->nv = take_points(hull->G, from);
    return true;
}

static float volume_of(const nook_mesh *hull) {
    nook_view view = nook_view_of(hull);
    nook_geometry_state state;
    nook_geometry geometry;
    uint32_t units = 0;
    nook_status status = nook_geometry_begin(&state, &view, true, NULL, NULL, &geometry);
    if (status == NOOK_OK) status = NOOK_MORE;
    while (status == NOOK_MORE) {
        units = UINT32_MAX;
        status = nook_geometry_step(&state, &units);
    }
    return geometry.signed_volume;
}

static bool compute(hulled *h, nook_mesh *hull, const load_options *load, failure *f) {
    model m;
    nook_status status = NOOK_OK;
    bool good = model_load(&m, h->in, load, 0, f) && take_tables(hull, &m.mesh, f);
    h->vertices_in = m.mesh.nv;
    h->triangles_in = m.triangles_in;
    model_free(&m);
    if (good) status = make_hull(hull);
    h->flat = status == NOOK_FLAT_SHELL;
    if (!good || h->flat) return good;
    if (status != NOOK_OK) return fail(f, status, NULL);
    h->vertices = hull->nv;
    h->triangles = hull->nt;
    h->volume = volume_of(hull);
    return true;
}

static void report_numbers(FILE *to, const hulled *h) {
    (void)fputs("{\"file\":", to);
    put_string(to, h->in);
    put_count(to, "vertices_in", h->vertices_in);
    put_count(to, "triangles_in", h->triangles_in);
    put_count(to, "vertices", h->flat ? NOOK_UNKNOWN : h->vertices);
    put_count(to, "triangles", h->flat ? NOOK_UNKNOWN : h->triangles);
    put_float(to, "volume", !h->flat, h->volume);
    (void)fputs("}\n", to);
}

static void report_line(FILE *to, const hulled *h) {
    print_name(to, h->out);
    (void)fprintf(to,
                  ": hull of %" PRIu32 " vertices, %" PRIu32 " triangles: %" PRIu32 " vertices, %" PRIu32
                  " triangles, volume %s\n",
                  h->vertices_in, h->triangles_in, h->vertices, h->triangles, decimal_of(h->volume).text);
}

/* What is said goes to standard output, unless the mesh does. */
static int finish(const hulled *h, const nook_mesh *hull, file_format format, bool as_json) {
    FILE *to = strcmp(h->out, "-") == 0 ? stderr : stdout;
    if (!h->flat && !write_mesh(hull, h->out, format)) return 2;
    if (h->flat) print_message(stderr, h->in, "no hull has a volume: the points lie in one plane");
    if (as_json) report_numbers(to, h);
    if (!as_json && !h->flat) report_line(to, h);
    return h->flat ? 1 : 0;
}

int cmd_hull(const options *o) {
    load_options load;
    file_format format;
    hulled h;
    nook_mesh hull;
    failure f;
    int status = 2;
    memset(&h, 0, sizeof h);
    memset(&hull, 0, sizeof hull);
    if (o->operands != 3) return usage_error("hull needs IN and OUT (see nook hull --help)", "") ? 0 : 2;
    h.in = o->operand[1];
    h.out = o->operand[2];
    if (!options_for_load(o, &load) || !option_format(o, h.out, &format)) return 2;
    if (compute(&h, &hull, &load, &f)) {
        status = finish(&h, &hull, format, o->given[OPTION_JSON]);
    } else {
        print_failure(stderr, h.in, &f);
    }
    free(hull.G);
    free(hull.V);
    free(hull.O);
    free(hull.C);
    return status;
}
