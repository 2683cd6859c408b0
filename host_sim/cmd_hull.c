/* cmd_hull.c -- the convex hull of a mesh file as another. */
#include "commands.h"

#include <inttypes.h>

#include "decimal.h"
#include "job.h"
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

static bool compute(job *j) {
    bool flat;
    failure f;
    if (!model_hull(&j->m, &flat, &f)) return job_fail(j, &f);
    if (flat) j->refused = MODEL_FLAT;
    return true;
}

static void report(const job *j) {
    const nook_mesh *hull = &j->m.mesh;
    float volume = j->refused == NULL ? volume_of(hull) : 0;
    if (j->json) {
        put_float(j->to, "volume", j->refused == NULL, volume);
    } else {
        (void)fprintf(j->to,
                      ": hull of %" PRIu32 " vertices, %" PRIu32 " triangles: %" PRIu32 " vertices, %" PRIu32
                      " triangles, volume %s",
                      j->vertices_in, j->m.triangles_in, hull->nv, hull->nt, decimal_of(volume).text);
    }
}

int cmd_hull(const options *o) {
    job j;
    if (!job_begin(&j, o)) return 2;
    if (job_load(&j) && compute(&j) && job_write(&j)) report(&j);
    return job_end(&j);
}
