/* import_stl.c -- STL through the library's own push parser, in one piece. */
#include <inttypes.h>

#include "import.h"

/* size: of the file. A binary one that is too short is refused before any facet is read; the first
 * facet that is missing is named. */
static bool stl_failure(const nook_stl *stl, nook_status status, size_t size, failure *f) {
    char what[120];
    uint64_t facet = stl->triangles;
    (void)fail(f, status, NULL);
    if (status == NOOK_TRUNCATED && !stl->ascii) {
        facet = size < 84 ? 0 : (size - 84) / 50;
        (void)snprintf(what, sizeof what,
                       "truncated: as a binary STL it declares %" PRIu32 " facets and holds %" PRIu64,
                       stl->declared, facet);
        (void)fail(f, status, what);
    } else if (status == NOOK_TRUNCATED) {
        (void)fail(f, status, "truncated inside a facet");
    } else if (status == NOOK_UNKNOWN_FORMAT) {
        (void)fail(f, status, "not a mesh: neither binary STL (84 bytes at least) nor a known text format");
    }
    if (stl->where.kind == NOOK_AT_BYTE) f->byte = stl->where.index;
    if (stl->where.kind == NOOK_AT_LINE) f->line = stl->where.index;
    if (status != NOOK_UNKNOWN_FORMAT) (void)fail_element(f, "triangle", facet);
    return false;
}

static void add_facet(imported *m, const nook_point corners[3]) {
    uint32_t i, v = m->nv;
    polygon_begin(m);
    for (i = 0; i < 3u; i++) {
        import_vertex(m, corners[i]);
        polygon_corner(m, v + i);
    }
}

bool import_stl(imported *m, const uint8_t *data, size_t size, failure *f) {
    nook_stl stl;
    nook_point corners[3];
    nook_status status;
    size_t left = size;
    m->soup = true;
    nook_stl_begin(&stl, (uint32_t)size);
    while ((status = nook_stl_push(&stl, &data, &left, corners)) == NOOK_TRIANGLE) add_facet(m, corners);
    if (status == NOOK_MORE) status = nook_stl_end(&stl);
    m->format = stl.ascii ? "STL text" : "STL binary";
    m->trailing = stl.trailing;
    return status == NOOK_OK ? true : stl_failure(&stl, status, size, f);
}
