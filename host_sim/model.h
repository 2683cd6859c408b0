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
    bool soup, welded;
} model;

/* Load a file ("-": standard input), with notes on stderr about what of it is ignored. max_list: how many dropped
 * triangles to remember. False with f filled; model_free() either way. */
bool model_load(model *m, const char *path, const load_options *options, uint32_t max_list, failure *f);
void model_free(model *m);

/* What to say about a mesh with a border that may be none: that an exact weld would join vertices. False if it was
 * welded, or none are equal; tried on a copy of the points, n log2 n. */
bool model_hint(const model *m, char *text, size_t room);

/* The mesh becomes the convex hull of the points of its triangles, or of all its points if it has no triangle; flat: there
 * is none, and it has no triangle now. False with f filled. Memory: tables for the 2 nv - 4 triangles that a hull of
 * nv points can have. */
bool model_hull(model *m, bool *flat, failure *f);
#define MODEL_FLAT "no hull has a volume: the points lie in one plane"

/* Marks for all that a mesh has room for, on the heap. */
nook_marks marks_take(const nook_mesh *mesh);
void marks_free(nook_marks *marks);

#endif
