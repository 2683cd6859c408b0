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
} nook_list_sort;

#endif
