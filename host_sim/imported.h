/* imported.h -- what a mesh file held: points and triangles, before anything is welded or linked. */
#ifndef IMPORTED_H
#define IMPORTED_H

#include "nook.h"

typedef struct imported {
    const char *format; /* "STL binary" */
    bool soup;          /* three vertices of its own for each triangle */
    nook_point *G;
    nook_index *V;
    uint32_t nv, nt; /* in the file; beyond what the index width can hold they are counted, not stored */
    size_t room_G, room_V;
    uint32_t short_faces;          /* faces of fewer than 3 corners, skipped */
    bool trailing;                 /* bytes after the announced facets, ignored */
    uint32_t first, last, corners; /* of the polygon being cut */
} imported;

void import_free(imported *m);
void import_vertex(imported *m, nook_point p);
/* A polygon, corner by corner, cut into the fan (p0, pk, pk+1). */
void polygon_begin(imported *m);
void polygon_corner(imported *m, uint32_t v);
void polygon_end(imported *m);

#endif
