/* nook_deviation.h -- how far a collapse moves the surface; what nook_simplify.h says of it. Not for others. */
#ifndef NOOK_DEVIATION_H
#define NOOK_DEVIATION_H

#include "shape/nook_ring.h"

/* The number of the new vertex, at that place, times scale. Steps: the square of the triangles around the edge. */
float nook_deviation_at(const nook_mesh *mesh, const nook_edge_ring *r, const float *deviation, float scale,
                        nook_point at);

#endif
