/* shapes.h -- generated meshes: known shapes of any fineness, and every kind of defect.
 *
 * A shape is made as separate triangles whose shared points are computed by the same operations,
 * hence equal in every bit; the library's own weld then joins them. No libm: the same bits on every
 * machine. */
#ifndef SHAPES_H
#define SHAPES_H

#include "nook.h"

typedef struct drawing {
    nook_point *G;
    uint32_t *V; /* [3 nt] */
    uint32_t nv, nt;
    size_t room_G, room_V;
} drawing;

/* Draw a shape by name with the nearest reachable number of triangles. False if no shape has this
 * name. At most SHAPE_MOST triangles are drawn. */
#define SHAPE_MOST (NOOK_MAX_TRIANGLES < 4000000u ? NOOK_MAX_TRIANGLES : 4000000u)
bool draw_shape(drawing *d, const char *name, uint32_t triangles);

/* Spoil a drawing. False if no defect has this name. */
bool spoil(drawing *d, const char *name);

void drawing_free(drawing *d);
uint32_t drawing_vertex(drawing *d, nook_point p);
void drawing_triangle(drawing *d, uint32_t a, uint32_t b, uint32_t c);

/* Names for messages, separated by blanks. */
extern const char shape_names[];
extern const char defect_names[];

#endif
