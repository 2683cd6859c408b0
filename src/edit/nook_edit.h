/* nook_edit.h -- what all edits respect, and what they take along.
 *
 * Every edit looks first and then changes the mesh whole; a refusal says why and leaves every table as it was. What
 * must never happen (two edges on the same vertices, a vertex of two fans, two triangles on the same vertices) is
 * always asked; what need not is asked for here. An edit takes a pointer to this, or null for none of it. */
#ifndef NOOK_EDIT_H
#define NOOK_EDIT_H

#include "exact/nook_exact.h"
#include "walk/nook_star.h"

typedef struct nook_guard nook_guard;

typedef struct nook_edit {
    /* Conditions. */
    bool no_turn; /* no triangle may turn over or lose its area: NOOK_TURNED_TRIANGLE. Exact */
    /* No vertex may come to have more triangles: NOOK_TOO_MANY_TRIANGLES. 0: no limit. It also bounds the steps, as no fan
     * beyond it is walked round. */
    uint32_t max_valence;
    /* No triangle that is made or moves may intersect another: NOOK_SELF_INTERSECTION. nook_guard.h */
    nook_guard *guard;
    /* Data beside the mesh, each array null or kept in step with it. */
    /* [max_nt], 0 is invisible: a new triangle takes that of the one it is cut from or joined to. */
    uint8_t *color;
    float *attributes; /* [3 max_nt][width], of corners: a new vertex has them by barycentric coordinates */
    uint32_t width;
    /* Told after vertex (NOOK_AT_VERTEX) or triangle (NOOK_AT_TRIANGLE) from has taken the number of one that is
     * gone; and after vertex to, which is new, has become a copy of from. Either may be null. */
    void (*renamed)(void *user, nook_kind kind, uint32_t from, uint32_t to);
    void (*copied)(void *user, uint32_t from, uint32_t to);
    void *user;
} nook_edit;

/* What no_turn asks: a triangle that is moved must come to less than a right angle from where it faced, pieces from what
 * they are cut from, the two of a flip from the vector area of their quadrilateral, those that open a vertex from both
 * triangles at their edge; one that had no area must have some. What takes the place of a removed vertex, and a triangle
 * made, must have area; one filled faces as the loop does. What does not move is not asked.
 * Attributes of a place off an edge are those of the nearest on it; off the triangles of a vertex that is split, of the
 * nearest triangle's plane. A vertex over the limit can be made smaller by nook_collapse() or nook_split_vertex() only if
 * what comes of it is within the limit. */

#endif
