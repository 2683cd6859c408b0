/* nook_pair.h -- do two triangles meet? Exact for every finite float, the same for (a, b) and (b, a). */
#ifndef NOOK_PAIR_H
#define NOOK_PAIR_H

#include "exact/nook_exact.h"

/* Whether two closed triangles have a point in common: crossing, touching at a point, in one plane, or
 * without area (a segment or a point): all of it. Steps: constant. (Guigue and Devillers 2003 ask the same signs.) */
bool nook_triangles_meet(const nook_point *const a[3], const nook_point *const b[3]);

/* Whether triangles t and u of one mesh intersect elsewhere than in the vertices that they share:
 *   nothing shared     the closed triangles meet
 *   a vertex           one meets the opposite edge of the other
 *   an edge            they lie in one plane, one folded upon the other
 *   all three          always
 * Triangles without area intersect nothing. Vertices are told apart by number: weld first. V must be in range. */
bool nook_triangles_intersect(const nook_view *view, uint32_t t, uint32_t u);
/* The same of two triangles by their points: a vertex is shared where the addresses are the same. Both lists are reordered. */
bool nook_corners_intersect(const nook_point *a[3], const nook_point *b[3]);

#endif
