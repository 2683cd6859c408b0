/* model.c -- from a file to tables, through the library's weld and drop.
 *
 * Steps: those of the importer, n log2 n for the weld. */
#include "model.h"

#include <inttypes.h>
#include <stdlib.h>

#include "heap.h"

static bool fits(const imported *in, failure *f) {
    char what[150];
    if (in->nt > NOOK_MAX_TRIANGLES) {
        (void)snprintf(what, sizeof what, "%" PRIu32 " triangles, but %d-bit indices hold at most %u", in->nt,
                       NOOK_INDEX_BITS, NOOK_MAX_TRIANGLES);
        return fail(f, NOOK_NO_CAPACITY, what);
    }
    if (in->nv > NOOK_MAX_VERTICES) {
        (void)snprintf(what, sizeof what, "%" PRIu32 " vertices, but %d-bit indices hold at most %u", in->nv,
                       NOOK_INDEX_BITS, NOOK_MAX_VERTICES);
        return fail(f, NOOK_NO_CAPACITY, what);
    }
    return true;
}

/* The tables take over what was imported; O and C are added at their size. */
static bool make_mesh(model *m, imported *in, failure *f) {
    nook_point *G = in->G != NULL ? in->G : take(1, sizeof *G);
    nook_index *V = in->V != NULL ? in->V : take(1, sizeof *V);
    nook_index *O = take(3 * (size_t)in->nt, sizeof *O), *C = take(in->nv, sizeof *C);
    nook_status status = nook_mesh_init(&m->mesh, G, V, O, C, in->nv, in->nt);
    m->mesh.nv = in->nv;
    m->mesh.nt = in->nt;
    m->format = in->format;
    m->triangles_in = in->nt;
    m->soup = in->soup;
    in->G = NULL;
    in->V = NULL;
    return status == NOOK_OK ? true : fail(f, status, NULL);
}

static bool scale(nook_mesh *mesh, float factor, failure *f) {
    uint32_t v;
    nook_status status;
    for (v = 0; v < mesh->nv && factor != 1.0f; v++) {
        mesh->G[v] = nook_scaled(mesh->G[v], factor);
        status = nook_point_status(mesh->G[v]);
        if (status != NOOK_OK) {
            (void)fail(f, status, "after scaling, a coordinate is larger than 2^30");
            return fail_element(f, "vertex", v);
        }
    }
    return true;
}

static bool weld(nook_mesh *mesh, failure *f) {
    nook_index *map = take(mesh->nv, sizeof *map), *order = take(NOOK_WELD_SCRATCH(mesh->nv), sizeof *order);
    nook_where where = nook_at(NOOK_NOWHERE, 0);
    nook_status status = nook_weld(mesh, map, order, &where);
    free(map);
    free(order);
    if (status == NOOK_OK) return true;
    (void)fail(f, status, NULL);
    if (where.kind == NOOK_AT_VERTEX) (void)fail_element(f, "vertex", where.index);
    if (where.kind == NOOK_AT_CORNER) (void)fail_element(f, "corner", where.index);
    return false;
}

bool model_hint(const model *m, char *text, size_t room) {
    nook_mesh copy = m->mesh;
    failure ignored;
    if (m->welded) return false;
    copy.G = take(m->mesh.nv, sizeof *copy.G);
    copy.nt = 0;
    memcpy(copy.G, m->mesh.G, m->mesh.nv * sizeof *copy.G);
    (void)weld(&copy, &ignored);
    free(copy.G);
    (void)snprintf(
        text, room,
        "hint: %" PRIu32
        " vertices repeat the coordinates of another; --weld exact joins them and may close the surface",
        m->mesh.nv - copy.nv);
    return copy.nv < m->mesh.nv;
}

static bool is_degenerate(const nook_mesh *mesh, uint32_t t) {
    uint32_t a = mesh->V[3u * t], b = mesh->V[3u * t + 1u], c = mesh->V[3u * t + 2u];
    return a == b || b == c || c == a;
}

static void drop(model *m, uint32_t max_list) {
    uint32_t t;
    size_t room = 0, room_at = 0;
    for (t = 0; t < m->mesh.nt && m->dropped_listed < max_list; t++) {
        if (!is_degenerate(&m->mesh, t)) continue;
        m->dropped = grow(m->dropped, &room, m->dropped_listed + 1u, sizeof *m->dropped);
        m->dropped_at = grow(m->dropped_at, &room_at, m->dropped_listed + 1u, sizeof *m->dropped_at);
        m->dropped_at[m->dropped_listed] = m->mesh.G[m->mesh.V[3u * t]];
        m->dropped[m->dropped_listed++] = t;
    }
    m->degenerate = nook_drop_degenerate(&m->mesh);
}

static bool fill(model *m, imported *in, const load_options *options, uint32_t max_list, failure *f) {
    if (!fits(in, f) || !make_mesh(m, in, f) || !scale(&m->mesh, options->scale, f)) return false;
    m->welded = options->weld == WELD_EXACT || (options->weld == WELD_DEFAULT && m->soup);
    if (m->welded && !weld(&m->mesh, f)) return false;
    drop(m, max_list);
    return true;
}

static void print_notes(const imported *in, const char *file) {
    char note[100];
    if (in->trailing) print_message(stderr, file, "note: bytes after the declared facets are ignored");
    if (in->short_faces == 0) return;
    (void)snprintf(note, sizeof note, "note: %" PRIu32 " %s of fewer than 3 corners skipped", in->short_faces,
                   in->short_faces == 1u ? "face" : "faces");
    print_message(stderr, file, note);
}

bool model_load(model *m, const char *path, const load_options *options, uint32_t max_list, failure *f) {
    bytes file;
    imported in;
    bool good;
    memset(m, 0, sizeof *m);
    if (!bytes_read(&file, path, f)) return false;
    good = import_mesh(&in, &file, f);
    m->format = in.format;
    bytes_free(&file);
    good = good && fill(m, &in, options, max_list, f);
    if (good) print_notes(&in, path);
    import_free(&in);
    return good;
}

void model_free(model *m) {
    free(m->mesh.G);
    free(m->mesh.V);
    free(m->mesh.O);
    free(m->mesh.C);
    free(m->dropped);
    free(m->dropped_at);
    memset(m, 0, sizeof *m);
}

/* ---- hull -------------------------------------------------------------------------------------- */

nook_marks marks_take(const nook_mesh *mesh) {
    nook_marks marks = {take(NOOK_MT_BYTES(mesh->max_nt), 1), take(NOOK_MV_BYTES(mesh->max_nv), 1),
                        mesh->max_nt, mesh->max_nv};
    return marks;
}

void marks_free(nook_marks *marks) {
    free(marks->Mt);
    free(marks->Mv);
}

/* The points that count: those of triangles, or all if there is no triangle. */
static void keep_points(nook_mesh *mesh) {
    uint8_t *used = take(mesh->nv, 1);
    uint32_t i, n = 0;
    memset(used, mesh->nt == 0 ? 1 : 0, mesh->nv);
    for (i = 0; i < 3u * mesh->nt; i++) used[mesh->V[i]] = 1;
    for (i = 0; i < mesh->nv; i++) {
        if (used[i] != 0) mesh->G[n++] = mesh->G[i];
    }
    mesh->nv = n;
    mesh->nt = 0;
    free(used);
}

/* Room for the largest hull that the points can have. */
static bool take_tables(nook_mesh *mesh, failure *f) {
    char what[120];
    uint32_t nt = mesh->nv < 4u ? 4u : 2u * mesh->nv - 4u;
    if (nt > NOOK_MAX_TRIANGLES) {
        (void)snprintf(what, sizeof what,
                       "%" PRIu32 " points may need %" PRIu32
                       " triangles, but %d-bit indices hold at most %u",
                       mesh->nv, nt, NOOK_INDEX_BITS, NOOK_MAX_TRIANGLES);
        return fail(f, NOOK_NO_CAPACITY, what);
    }
    free(mesh->V);
    free(mesh->O);
    mesh->V = take(3 * (size_t)nt, sizeof *mesh->V);
    mesh->O = take(3 * (size_t)nt, sizeof *mesh->O);
    mesh->max_nt = nt;
    return true;
}

bool model_hull(model *m, bool *flat, failure *f) {
    nook_marks marks;
    nook_status status;
    keep_points(&m->mesh);
    if (!take_tables(&m->mesh, f)) return false;
    marks = marks_take(&m->mesh);
    status = nook_hull(&m->mesh, &marks, NULL, NULL);
    marks_free(&marks);
    *flat = status == NOOK_FLAT_SHELL;
    return status == NOOK_OK || *flat ? true : fail(f, status, NULL);
}
