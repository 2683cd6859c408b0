/* fuzz_file.c -- any bytes as a mesh file of any format, through the host program's import and the library.
 *
 * The bytes lie in a heap block of exactly their size. Must hold: an import that fails says why, in one line,
 * at a place inside the file; one that succeeds has indices in range, coordinates that can be used and, for
 * STL, three vertices a triangle; its arrays take no more than the 24 bytes for a byte of input that import.h
 * states (and what growing begins with); and weld, drop, link and check take what was imported, whatever it
 * is, and call nothing sound that has an edge without two triangles. */
#include "fuzz.h"

#include "heap.h"
#include "import.h"

enum { MOST_LIBRARY_T = 2000 };

static void expect_failure(const failure *f, size_t size) {
    EXPECT(f->code != NULL && f->code[0] != 0);
    EXPECT(memchr(f->what, 0, sizeof f->what) != NULL && f->what[0] != 0 && strchr(f->what, '\n') == NULL);
    EXPECT(memchr(f->element, 0, sizeof f->element) != NULL);
    EXPECT(f->byte == FAILURE_NOWHERE || f->byte <= size);
    EXPECT(f->line == FAILURE_NOWHERE || (f->line >= 1 && f->line <= size + 1));
}

static void expect_memory(const imported *m, size_t size) {
    size_t arrays = m->room_G * sizeof *m->G + m->room_V * sizeof *m->V;
    EXPECT(arrays <= 24 * size + 64 * (sizeof *m->G + sizeof *m->V));
}

static void expect_import(const imported *m) {
    uint32_t i;
    EXPECT(m->format != NULL);
    if (m->nv > NOOK_MAX_VERTICES || m->nt > NOOK_MAX_TRIANGLES) return; /* counted, not stored */
    if (m->soup) EXPECT(m->nv == 3 * m->nt);
    for (i = 0; i < m->nv; i++) EXPECT(nook_point_status(m->G[i]) == NOOK_OK);
    for (i = 0; i < 3 * m->nt; i++) EXPECT(m->V[i] < m->nv);
}

/* Each edge has a corner on its other side. */
static void expect_closed(const nook_mesh *mesh) {
    uint32_t c;
    EXPECT(mesh->nt != 0);
    for (c = 0; c < 3 * mesh->nt; c++) EXPECT(mesh->O[c] != c && mesh->O[mesh->O[c]] == c);
}

static void check(nook_mesh *mesh) {
    nook_marks marks = {take(NOOK_MT_BYTES(mesh->nt), 1), take(NOOK_MV_BYTES(mesh->nv), 1), mesh->nt,
                        mesh->nv};
    nook_report report;
    nook_check_result result;
    nook_view view;
    EXPECT(nook_link(mesh, &marks, NULL, NULL, &report, NULL) == NOOK_OK);
    view = nook_view_of(mesh);
    EXPECT(nook_check(&view, &marks, &report, NULL, NULL, &result) == NOOK_OK);
    EXPECT(result.bad_indices + result.bad_opposites + result.bad_corners + result.bad_coordinates == 0);
    if (nook_is_sound(&result)) expect_closed(mesh);
    free(marks.Mt);
    free(marks.Mv);
}

/* The importer's arrays become the mesh's. */
static void give_to_library(const imported *m) {
    nook_index *O = take(3 * (size_t)m->nt, sizeof *O), *C = take(m->nv, sizeof *C);
    nook_index *map = take(m->nv, sizeof *map), *order = take(NOOK_WELD_SCRATCH(m->nv), sizeof *order);
    nook_mesh mesh;
    EXPECT(nook_mesh_init(&mesh, m->G, m->V, O, C, m->nv, m->nt) == NOOK_OK);
    mesh.nv = m->nv;
    mesh.nt = m->nt;
    if (m->soup) EXPECT(nook_weld(&mesh, map, order, NULL) == NOOK_OK);
    (void)nook_drop_degenerate(&mesh);
    check(&mesh);
    free(O);
    free(C);
    free(map);
    free(order);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bytes file = {exact(data, size), size, size};
    imported m;
    failure f;
    memset(&f, 0x55, sizeof f);
    if (import_mesh(&m, &file, &f)) {
        expect_import(&m);
        if (m.nt <= MOST_LIBRARY_T && m.nv <= 3 * MOST_LIBRARY_T) give_to_library(&m);
    } else {
        expect_failure(&f, size);
    }
    expect_memory(&m, size);
    import_free(&m);
    bytes_free(&file);
    return 0;
}
