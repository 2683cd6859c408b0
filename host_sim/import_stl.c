/* import_stl.c -- STL through the library's own push parser, in one piece. */
#include <inttypes.h>

#include "import.h"

static bool stl_failure(const nook_stl *stl, nook_status status, failure *f)
{
    char what[120];
    (void)fail(f, status, NULL);
    if (status == NOOK_TRUNCATED && !stl->ascii) {
        (void)snprintf(what, sizeof what, "truncated: the header declares %" PRIu32 " facets, the file is too short for them", stl->declared);
        (void)fail(f, status, what);
    } else if (status == NOOK_TRUNCATED) {
        (void)fail(f, status, "truncated inside a facet");
    } else if (status == NOOK_UNKNOWN_FORMAT) {
        (void)fail(f, status, "not a mesh: neither binary STL (84 bytes at least) nor a known text format");
    }
    if (stl->where.kind == NOOK_AT_BYTE) f->byte = stl->where.index;
    if (stl->where.kind == NOOK_AT_LINE) f->line = stl->where.index;
    if (status != NOOK_UNKNOWN_FORMAT) (void)fail_element(f, "triangle", stl->triangles);
    return false;
}

static void add_facet(imported *m, const nook_point corners[3])
{
    uint32_t i, v = m->nv;
    polygon_begin(m);
    for (i = 0; i < 3u; i++) {
        import_vertex(m, corners[i]);
        polygon_corner(m, v + i);
    }
}

bool import_stl(imported *m, const uint8_t *data, size_t size, failure *f)
{
    nook_stl stl;
    nook_point corners[3];
    nook_status status;
    m->soup = true;
    nook_stl_begin(&stl, (uint32_t)size);
    while ((status = nook_stl_push(&stl, &data, &size, corners)) == NOOK_TRIANGLE) add_facet(m, corners);
    if (status == NOOK_MORE) status = nook_stl_end(&stl);
    m->format = stl.ascii ? "STL text" : "STL binary";
    m->trailing = stl.trailing;
    return status == NOOK_OK ? true : stl_failure(&stl, status, f);
}
