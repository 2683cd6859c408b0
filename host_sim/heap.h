/* heap.h -- heap arrays that grow by doubling.
 *
 * Only the host program allocates; the library never does. When memory runs out the program says so
 * and exits 2, so that callers need not look. */
#ifndef HEAP_H
#define HEAP_H

#include <stddef.h>

/* count elements of the given size; never null, also for count 0. */
void *take(size_t count, size_t element);

/* Make room for at least need elements in an array that has *room; returns the array. */
void *grow(void *array, size_t *room, size_t need, size_t element);

#endif
