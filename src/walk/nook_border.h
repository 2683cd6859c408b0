/* nook_border.h -- border edges and the loops they form around holes.
 *
 * A border edge is named by the corner that faces it. Going on along a loop turns about the vertex at the end of
 * the edge, inside one fan; so where two loops touch at a vertex each stays itself. The hole lies to the right of
 * every border edge as its triangle runs it, from v(n(c)) to v(p(c)). Loops are counted by nook_survey(). */
#ifndef NOOK_BORDER_H
#define NOOK_BORDER_H

#include "walk/nook_star.h"

/* The border edge that begins where border edge c ends (forward), or ends where c begins; NOOK_NONE if c faces no
 * border, or where the tables do not hold. Steps: the triangles of one fan. */
uint32_t nook_border_next(const nook_view *view, uint32_t c, bool forward);

/* How many edges the loop of border edge c has; 0 if c faces no border or the tables do not hold.
 * Steps: the triangles at the loop. */
uint32_t nook_border_length(const nook_view *view, uint32_t c);

#endif
