/* imported.c -- where importers put what they read: points, and polygons cut into triangles. */
#include "import.h"

#include <stdlib.h>

#include "heap.h"

void import_vertex(imported *m, nook_point p) {
    if (m->nv < NOOK_MAX_VERTICES) {
        m->G = grow(m->G, &m->room_G, (size_t)m->nv + 1, sizeof *m->G);
        m->G[m->nv] = p;
    }
    m->nv++;
}

bool import_text_vertex(imported *m, const float x[3], nook_status status, uint32_t line, failure *f) {
    nook_point p = nook_make(0, 0, 0);
    if (status == NOOK_OK) {
        p = nook_make(x[0], x[1], x[2]);
        status = nook_point_status(p);
    }
    if (status != NOOK_OK) {
        (void)fail_at_line(f, status, NULL, line);
        return fail_element(f, "vertex", m->nv);
    }
    import_vertex(m, p);
    return true;
}

static void add_triangle(imported *m, uint32_t a, uint32_t b, uint32_t c) {
    if (m->nt < NOOK_MAX_TRIANGLES) {
        m->V = grow(m->V, &m->room_V, 3 * (size_t)m->nt + 3, sizeof *m->V);
        m->V[3 * (size_t)m->nt] = nook_store(a);
        m->V[3 * (size_t)m->nt + 1] = nook_store(b);
        m->V[3 * (size_t)m->nt + 2] = nook_store(c);
    }
    m->nt++;
}

void polygon_begin(imported *m) { m->corners = 0; }

void polygon_corner(imported *m, uint32_t v) {
    if (m->corners == 0) m->first = v;
    if (m->corners >= 2u) add_triangle(m, m->first, m->last, v);
    m->last = v;
    m->corners++;
}

void polygon_end(imported *m) {
    if (m->corners < 3u) m->short_faces++;
}

void import_free(imported *m) {
    free(m->G);
    free(m->V);
    memset(m, 0, sizeof *m);
}
