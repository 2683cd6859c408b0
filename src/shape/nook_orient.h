/* nook_orient.h -- which way triangles run: neighbours the same way, and solids outward.
 *
 *   nook_orient         turns triangles over until any two with an edge to themselves agree; says where none can
 *   nook_orient_shells  turns shells over until those of a solid face out of it, cavities in it included
 * From triangles that run anyhow:
 *     nook_orient(&mesh, &marks, NULL, NULL, &where);
 *     nook_link(&mesh, &marks, &shells, NULL, &report, &where);
 *     nook_check(&view, &marks, &report, &shells, NULL, &result);
 *     nook_bvh_build(&bvh, &view, tree.boxes, tree.order, &where);
 *     nook_orient_shells(&state, &mesh, &bvh, &shells, NULL, NULL);
 * Points and names of vertices and triangles stay; a triangle is turned by exchanging its corners 3 t + 1 and 3 t + 2. */
#ifndef NOOK_ORIENT_H
#define NOOK_ORIENT_H

#include "edit/nook_edit.h"
#include "query/nook_inside.h"
#include "query/nook_intersections.h"
#include "table/nook_link.h"

/* ---- triangles --------------------------------------------------------------------------------------
 *
 * Depth-first twice through what hangs together, without a stack (nook_flood.h): once to learn who runs against the first
 * triangle, once to turn over the fewer. */

typedef struct nook_orient_state {
    nook_link_state link;  /* first the edges; it keeps mesh, marks, finder and, of an error, where */
    const nook_edit *edit; /* attributes of corners go along */
    uint32_t turned;       /* out: triangles turned over */
    uint32_t at, c;        /* byte of marks, or first triangle; the corner to look across */
    uint32_t left;         /* hops that there can be */
    int32_t balance;       /* triangles that run with the first less those that run against it */
    uint8_t phase;
    bool mixed, odd; /* some run against it; some cannot agree */
} nook_orient_state;

/* Orient the triangles of mesh, of which only V is read, whichever way they run. Afterwards link it: O and C were worked in.
 * Two triangles that share an edge with no third must run it in opposite directions. An edge of three or more binds nobody:
 * where solids touch along an edge, each is oriented by itself. What hangs together runs as most of its triangles did; of
 * two halves as the first triangle did.
 *   marks   Mt for nt triangles; what it holds is overwritten
 *   edit    attributes are exchanged with corners; or null
 *   finder  hears of NOOK_NOT_ORIENTABLE once for each part that cannot be oriented; or null
 *   NOOK_NULL_ARGUMENT, NOOK_NO_CAPACITY (marks)
 *   NOOK_INDEX_OUT_OF_RANGE, NOOK_REPEATED_VERTEX  as of nook_link; nothing was turned
 *   NOOK_NOT_ORIENTABLE  in the end: all is oriented but parts that cannot be, such as a Moebius strip, which are as they
 *                        came. where: of the first of them, the corner that faces an edge at which it shows
 *   NOOK_BAD_OPPOSITE    somebody else has written O or the marks since the edges were linked
 * where is state->link.where. Steps: those of linking a sound mesh, and 7.5 nt, or 4.5 nt where nothing is turned. One unit is
 * at most 910 instructions on M4F, 1,400 on M0. */
nook_status nook_orient_begin(nook_orient_state *state, nook_mesh *mesh, const nook_marks *marks,
                              const nook_edit *edit, const nook_finder *finder);
nook_status nook_orient_step(nook_orient_state *state, uint32_t *units);
/* where may be null. */
nook_status nook_orient(nook_mesh *mesh, const nook_marks *marks, const nook_edit *edit,
                        const nook_finder *finder, nook_where *where);

/* ---- shells -----------------------------------------------------------------------------------------
 *
 * A shell inside an even number of others bounds the solid from outside and has a positive volume; inside an odd number it
 * bounds a cavity and has a negative one. How many is asked, exactly, of a vertex of it that lies on no other shell: by how
 * often a line from there crosses others (nook_inside). The sign of a volume is exact as well.
 *
 * Any vertex gives the same answer if shells do not cross. Triangles of different shells that meet (nook_intersections) are
 * taken for a crossing, unless they have one point in common, and that is a corner of one of them: a shell without a
 * finite number of points is still in one piece, which meets no other shell, and so it is inside or outside as a whole. So
 * shells may stand on each other with corners, whether or not these share a vertex. Where they share more (an edge across an
 * edge, a part of an edge or of a face) it would need more than signs to say who is inside whom. How a shell meets itself is not
 * asked. Nor do triangles without area meet anything: two parts of a shell that hang together by such alone may lie on both
 * sides of another unseen. nook_check() finds them. */

typedef struct nook_orient_shells_state {
    uint32_t inside_out; /* out: shells that ran the wrong way */
    uint32_t flat;       /* out: shells without a volume, which have no way to run */
    nook_where where;    /* of an error */
    nook_mesh *mesh;
    const nook_bvh *bvh;
    nook_shells *shells;
    const nook_edit *edit;
    const nook_finder *finder;
    uint32_t phase, at;
    union {
        nook_intersections pairs;
        nook_inside inside;
    } in;
} nook_orient_shells_state;

/* Orient the shells of a linked mesh.
 *   mesh    is written; null: then everything is said and nothing turned
 *   bvh     over the same tables; it stays right
 *   shells  as nook_check() has filled them, with all shells described. cavity is told here
 *   edit    attributes are exchanged with corners; or null
 *   finder  hears of NOOK_SELF_INTERSECTION (where shells touch without sharing a vertex: each pair, by its first triangle) and
 *           in the end of NOOK_INSIDE_OUT (each shell that ran the wrong way, by its first triangle); or null
 *   NOOK_NULL_ARGUMENT   bvh, shells
 *   NOOK_EMPTY_MESH      nothing was built
 *   NOOK_NO_CAPACITY     mesh and bvh differ in size, or a shell is not described
 *   NOOK_NONMANIFOLD_EDGE, NOOK_BORDER_EDGE, NOOK_INCOHERENT_EDGE  a shell is not closed, or not oriented. where: its first triangle
 *   NOOK_SELF_INTERSECTION  shells cross, or touch in more than corners; or all corners of a shell lie on others.
 *                           where: a triangle of it
 *   NOOK_INDEX_OUT_OF_RANGE, NOOK_BAD_OPPOSITE, NOOK_NOT_FINITE, NOOK_COORDINATE_TOO_LARGE  the tables do not hold
 * After an error nothing has been turned.
 * Volumes are as they were: check again before asking again. To have nook_is_sound() speak of cavities, ask without mesh
 * and put inside_out into result.geometry.inside_out_shells.
 * Steps: 6 nt; if there are several shells, those of nook_intersections and 1 a pair that touches; and for each shell those of
 * nook_inside, again for each corner that lies on another shell before one is found that does not. A unit is theirs; or one pair
 * that touches, at most 230,000 instructions on M4F and 400,000 on M0 where floats and integers decide, and three times that
 * for the one at which it gives up. */
nook_status nook_orient_shells_begin(nook_orient_shells_state *state, nook_mesh *mesh, const nook_bvh *bvh,
                                     nook_shells *shells, const nook_edit *edit, const nook_finder *finder);
nook_status nook_orient_shells_step(nook_orient_shells_state *state, uint32_t *units);
/* Both in a loop; what is out stays in *state. */
nook_status nook_orient_shells(nook_orient_shells_state *state, nook_mesh *mesh, const nook_bvh *bvh,
                               nook_shells *shells, const nook_edit *edit, const nook_finder *finder);

#endif
