/* nook_border.c -- along the border. */
#include "walk/nook_border.h"

/* The corner at the end of the edge turns away from it until a border stops it. */
uint32_t nook_border_next(const nook_view *view, uint32_t c, bool forward) {
    uint32_t x, turned, steps = view->nt;
    if (c >= 3u * view->nt || !nook_is_border(view, c)) return NOOK_NONE;
    x = forward ? nook_prev(c) : nook_next(c);
    while ((turned = nook_turn(view, x, forward)) != NOOK_NONE) {
        if (steps-- == 0) return NOOK_NONE;
        x = turned;
    }
    x = forward ? nook_prev(x) : nook_next(x);
    return nook_is_border(view, x) ? x : NOOK_NONE;
}

uint32_t nook_border_length(const nook_view *view, uint32_t c) {
    uint32_t x = c, n = 0;
    do {
        x = nook_border_next(view, x, true);
        if (x == NOOK_NONE || n == 3u * view->nt) return 0;
        n++;
    } while (x != c);
    return n;
}
