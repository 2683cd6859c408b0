/* nook_star.c -- turning about a vertex. */
#include "walk/nook_star.h"

nook_status nook_star_begin(nook_star *star, const nook_view *view, uint32_t c, bool clockwise) {
    uint32_t back, x = c, steps = view->nt;
    star->view = view;
    star->next = NOOK_NONE;
    if (c >= 3u * view->nt) return NOOK_INDEX_OUT_OF_RANGE;
    for (back = nook_turn(view, c, !clockwise); back != NOOK_NONE && back != c; steps--) {
        if (steps == 0) return NOOK_BAD_OPPOSITE;
        x = back;
        back = nook_turn(view, x, !clockwise);
    }
    star->open = back == NOOK_NONE;
    star->first = star->next = star->open ? x : c;
    star->left = view->nt;
    star->clockwise = clockwise;
    return NOOK_OK;
}

uint32_t nook_star_next(nook_star *star) {
    uint32_t c = star->next;
    if (c == NOOK_NONE || star->left-- == 0) return star->next = NOOK_NONE;
    star->next = nook_turn(star->view, c, star->clockwise);
    if (star->next == star->first) star->next = NOOK_NONE;
    return c;
}

uint32_t nook_valence(const nook_view *view, uint32_t c) {
    nook_star star;
    uint32_t n = 0;
    if (nook_star_begin(&star, view, c, true) != NOOK_OK) return 0;
    while (nook_star_next(&star) != NOOK_NONE) n++;
    return n;
}

uint32_t nook_corner_after(const nook_view *view, uint32_t v, uint32_t c) {
    for (c = c == NOOK_NONE ? 0 : c + 1u; c < 3u * view->nt; c++) {
        if (view->V[c] == v) return c;
    }
    return NOOK_NONE;
}
