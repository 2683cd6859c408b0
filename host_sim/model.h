/* model.h -- a mesh file loaded into the library's tables: read, scaled, welded, and without the
 * triangles that have a repeated vertex. Memory: what the file needs, on the heap. */
#ifndef MODEL_H
#define MODEL_H

#include "import.h"

typedef enum weld_choice { WELD_DEFAULT, WELD_EXACT, WELD_NONE } weld_choice;

/* The options of every command that reads a mesh. */
typedef struct load_options {
    weld_choice weld; /* default: exact for STL, none for formats with indices */
    float scale;
} load_options;

typedef struct model {
    const char *format;
    nook_mesh mesh; /* G and V filled; O and C have room */
    uint32_t triangles_in;
    uint32_t degenerate;    /* dropped triangles */
    uint32_t *dropped;      /* [dropped_listed] their numbers in the file, */
    nook_point *dropped_at; /* [dropped_listed] and one of their points */
    uint32_t dropped_listed;
    uint32_t short_faces;
    bool trailing, soup, welded;
} model;

/* Load a file ("-": standard input). max_list: how many dropped triangles to remember. False with f
 * filled; model_free() either way. */
bool model_load(model *m, const char *path, const load_options *options, uint32_t max_list, failure *f);
void model_free(model *m);

/* How many vertices an exact weld would join; tried on a copy of the points, n log2 n. */
uint32_t model_joinable(const model *m);

#endif
