/* nook_sort.h -- sort a linked list in place: bottom-up merge sort, stable, n log2 n comparisons
 * whatever the order, no memory but the links themselves, and a pause after any element.
 *
 * Runs of 1, 2, 4 ... elements are merged along the list. A list ends at an element that links to
 * itself, so that no index need be set aside for "end". Used by weld (links in scratch) and by link
 * (lists of edges threaded through O). */
#ifndef NOOK_SORT_H
#define NOOK_SORT_H

#include "core/nook_config.h"

typedef struct nook_list_sort {
    uint32_t head, tail; /* of the list rebuilt by this pass */
    uint32_t p, q;       /* next element of the left and of the right run */
    uint32_t p_left, q_left;
    uint32_t run, merges; /* length of runs; merges done in this pass */
    bool merging;         /* or still looking for the right run */
} nook_list_sort;

/* The rest sorts the list that begins at head. before(context, y, x) says whether y of the right run must
 * come before x of the left one; sort->head is the result. Private to nook's own files; they pass a
 * function that the compiler sees, so that nothing is called through a pointer. */
static inline uint32_t nook_list_next(const nook_index *link, uint32_t x) {
    return link[x] == x ? NOOK_NONE : (uint32_t)link[x];
}

static inline void nook_sort_pair_of_runs(nook_list_sort *s) {
    s->q = s->p;
    s->p_left = 0;
    s->merging = false;
    s->merges++;
}

static inline void nook_sort_begin(nook_list_sort *s, uint32_t head) {
    s->head = s->tail = NOOK_NONE;
    s->p = head;
    s->run = 1;
    s->merges = 0;
    nook_sort_pair_of_runs(s);
}

/* Both runs are used up: on to the next two, or the next pass, or the end. */
static inline bool nook_sort_next_runs(nook_list_sort *s, nook_index *link) {
    s->p = s->q;
    if (s->p == NOOK_NONE) {
        link[s->tail] = (nook_index)s->tail;
        if (s->merges <= 1u) return true;
        s->p = s->head;
        s->head = s->tail = NOOK_NONE;
        s->run *= 2u;
        s->merges = 0;
    }
    nook_sort_pair_of_runs(s);
    return false;
}

/* One element further; true when the list is sorted. */
static inline bool nook_sort_step(nook_list_sort *s, nook_index *link, const void *context,
                                  bool (*before)(const void *context, uint32_t y, uint32_t x)) {
    bool q_has = s->q != NOOK_NONE;
    uint32_t taken;
    if (!s->merging) {
        s->p_left++;
        s->q = nook_list_next(link, s->q);
        s->merging = s->p_left == s->run || s->q == NOOK_NONE;
        s->q_left = s->run;
        return false;
    }
    q_has = q_has && s->q_left != 0;
    if (s->p_left == 0 && !q_has) return nook_sort_next_runs(s, link);
    if (s->p_left == 0 || (q_has && before(context, s->q, s->p))) {
        taken = s->q;
        s->q = nook_list_next(link, taken);
        s->q_left--;
    } else {
        taken = s->p;
        s->p = nook_list_next(link, taken);
        s->p_left--;
    }
    if (s->tail == NOOK_NONE) {
        s->head = taken;
    } else {
        link[s->tail] = (nook_index)taken;
    }
    s->tail = taken;
    return false;
}

#endif
