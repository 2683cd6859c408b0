/* heap.c -- malloc and realloc with the multiplication checked and failure ending the program. */
#include "heap.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static void *resize(void *array, size_t count, size_t element) {
    void *bigger = NULL;
    if (count == 0) count = 1;
    if (count <= SIZE_MAX / element) bigger = realloc(array, count * element);
    if (bigger == NULL) {
        (void)fputs("nook: out of memory\n", stderr);
        exit(2);
    }
    return bigger;
}

void *take(size_t count, size_t element) { return resize(NULL, count, element); }

void *grow(void *array, size_t *room, size_t need, size_t element) {
    size_t bigger = *room < 32 ? 64 : *room;
    if (array != NULL && need <= *room) return array;
    while (bigger < need) bigger = bigger > SIZE_MAX / 2 ? need : 2 * bigger;
    if (array != NULL && bigger == *room) bigger = need;
    *room = bigger;
    return resize(array, bigger, element);
}
