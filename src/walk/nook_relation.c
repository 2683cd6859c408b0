/* nook_relation.c -- lists of what is next to what. */
#include "walk/nook_relation.h"

nook_status nook_related_begin(nook_related *list, const nook_view *view, nook_relation relation,
                               uint32_t element) {
    list->star.view = view;
    list->star.next = NOOK_NONE;
    list->relation = relation;
    list->at = 0;
    list->c = NOOK_NONE;
    if (relation <= NOOK_VF) {
        if (element >= view->nv) return NOOK_INDEX_OUT_OF_RANGE;
        if (nook_corner_of(view, element) == NOOK_NONE) return NOOK_OK; /* of no triangle: an empty list */
        return nook_star_begin(&list->star, view, nook_corner_of(view, element), false);
    }
    if (element >= (relation <= NOOK_EF ? 3u : 1u) * view->nt) return NOOK_INDEX_OUT_OF_RANGE;
    list->c = relation <= NOOK_EF ? element : 3u * element;
    return NOOK_OK;
}

/* About a vertex: what belongs to the edge from which corner c turns, and after the last of an open fan
 * what belongs to the edge it turns to. */
static bool next_about_vertex(nook_related *list, uint32_t *element) {
    const nook_view *m = list->star.view;
    uint32_t c = nook_star_next(&list->star), last = list->c;
    list->c = c;
    if (c != NOOK_NONE) {
        *element = list->relation == NOOK_VF   ? nook_triangle(c)
                   : list->relation == NOOK_VE ? nook_edge(m, nook_prev(c))
                                               : m->V[nook_next(c)];
        return true;
    }
    if (last == NOOK_NONE || !list->star.open || list->relation == NOOK_VF) return false;
    *element = list->relation == NOOK_VE ? nook_edge(m, nook_next(last)) : m->V[nook_prev(last)];
    return true;
}

/* The corner across, or NOOK_NONE at a border and where O names none. */
static uint32_t across(const nook_view *m, uint32_t c) {
    uint32_t o = nook_opposite(m, c);
    return o == c || o >= 3u * m->nt ? NOOK_NONE : o;
}

static uint32_t face_across(const nook_view *m, uint32_t c) {
    uint32_t o = across(m, c);
    return o == NOOK_NONE ? o : nook_triangle(o);
}

static uint32_t next_of_edge(const nook_view *m, nook_relation relation, uint32_t c, uint32_t i) {
    uint32_t o = across(m, c);
    if (relation == NOOK_EV) return m->V[i == 0 ? nook_next(c) : nook_prev(c)];
    if (relation == NOOK_EF) return i == 0 ? nook_triangle(c) : face_across(m, c);
    if (i == 0) return nook_edge(m, nook_prev(c));
    if (i == 2u) return nook_edge(m, nook_next(c));
    if (o == NOOK_NONE) return o;
    return nook_edge(m, i == 1u ? nook_next(o) : nook_prev(o));
}

bool nook_related_next(nook_related *list, uint32_t *element) {
    const nook_view *m = list->star.view;
    uint32_t i, end = list->relation == NOOK_EE ? 4u : list->relation <= NOOK_EF ? 2u : 3u, facing;
    if (list->relation <= NOOK_VF) return next_about_vertex(list, element);
    i = list->at;
    if (i == end) return false;
    list->at++;
    facing = list->c + (i + 2u) % 3u; /* of a face: the corner that faces edge i */
    switch (list->relation) {
    case NOOK_FV: *element = m->V[list->c + i]; break;
    case NOOK_FE: *element = nook_edge(m, facing); break;
    case NOOK_FF: *element = face_across(m, facing); break;
    default: *element = next_of_edge(m, list->relation, list->c, i); break;
    }
    return true;
}
