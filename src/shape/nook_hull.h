/* nook_hull.h -- the convex hull of points, as a mesh.
 *
 * Quickhull (Barber, Dobkin, Huhdanpaa 1996) on the corner table. Every point outside is on the list of one face that it
 * sees. A face with a list takes the farthest of it: all faces that this point sees go, it is joined to their horizon, and
 * the points of their lists are shared out among the new faces; who sees none of those is inside for good. Floats only
 * choose which point is next; who sees what is exact (nook_orient3d).
 *
 * A point also sees a face whose plane it is in. That is our own, and is what makes the result a mesh: moved a little away
 * from the hull, the point would see exactly these, so they form a disk, whose rim is one loop. Faces at the rim on
 * the other side have the point strictly behind them, so no edge of the rim is in line with it: every new triangle has
 * area, and a vertex stays on the rim only if it is still extreme. So no vertex lies within a face, or on an edge.
 * Why a list may be shared among the new faces alone: a point q that saw a face that is gone, and is outside, sees a connected
 * part of the new hull. If that had only old faces in it, somewhere at the rim q would see both the face A that is gone
 * and the face B that stays. The new face there has the plane w A + u B, with w = -B(p) > 0 and u = A(p) >= 0, as A sees p
 * and B does not; so q sees it too.
 *
 * No memory but marks: C holds the links of the lists, and once a point is a vertex of the hull, the rim. The list of a
 * face hangs in the place of the first of its vertices, and that vertex is at its end. */
#ifndef NOOK_HULL_H
#define NOOK_HULL_H

#include "core/nook_marks.h"
#include "edit/nook_edit.h"

typedef struct nook_hull_state {
    nook_mesh *mesh;
    const nook_edit *edit;
    nook_marks marks;
    nook_where where; /* of an error */
    uint32_t nv;      /* how many points were given */
    uint32_t phase, at;
    uint32_t four[4], found; /* the first four vertices */
    nook_point normal;       /* of the face of which the farthest is sought, */
    float most;              /* and how high above it that is */
    uint32_t p, waiting;     /* the point that is added; the points of faces that are gone, p at their end */
    uint32_t t, apex, last;  /* a face that is looked at; its first vertex, and the last point of its list */
    uint32_t c, tail;        /* the queue of faces that are gone: whose neighbours are looked at; its end */
    uint32_t x;              /* the corner across from which one of them is */
    uint32_t rim, a;         /* where the rim begins, and the vertex that is joined next */
    uint32_t first, latest;  /* new faces */
    uint32_t spare, spares;  /* numbers of faces that are gone, and how many */
    uint32_t scan, quiet;    /* the face last looked at for a list; how many in a row had none */
} nook_hull_state;

/* Make mesh the convex hull of its points. Of the mesh only nv and G[nv] are read; V, O, C and nt are made anew, triangles
 * counter-clockwise as seen from outside. Vertices are the extreme points, in the order they came in: where several points
 * are equal, one of them. Faces of more than three vertices are in triangles.
 *   marks  for nv vertices and 2 nv - 4 triangles; what they hold is overwritten
 *   edit   its renamed() hears which vertices have new numbers, in an order in which data beside them can be moved
 *          along; colors become 1 and attributes 0, for all is new. Its conditions are not asked. Or null
 *   NOOK_NULL_ARGUMENT  mesh, marks
 *   NOOK_NO_CAPACITY    mesh->max_nt or marks for less than 2 nv - 4 triangles, or marks for less than nv vertices
 *   NOOK_NOT_FINITE, NOOK_COORDINATE_TOO_LARGE  state->where: the vertex. Nothing was changed
 *   NOOK_FLAT_SHELL     no four points span a volume: there are less than four, or all are equal, on one line or in one
 *                       plane. The mesh is then without triangles: G and nv as they were, nt is 0 and C says so
 * G must hold still; given up, the mesh keeps its points and nothing else.
 * Steps: about 20 nv + 60 h if h of them are vertices; but a flat face of w vertices is made anew with each, which takes
 * 3 w^2. Never more than nv^3 / 6 + 8 nv^2 + 30 nv + 30: each point is added once; when m are vertices they have 2 m - 4 faces,
 * which it may take away, and there are nv - m more, which may have to be held against m new faces. A step is one
 * nook_orient3d() or nook_facing(), or 16 looks along a list: at most 1,100 instructions on M4F and 3,200 on M0 where floats and
 * integers decide. */
nook_status nook_hull_begin(nook_hull_state *state, nook_mesh *mesh, const nook_marks *marks,
                            const nook_edit *edit);
nook_status nook_hull_step(nook_hull_state *state, uint32_t *units);
/* where may be null. */
nook_status nook_hull(nook_mesh *mesh, const nook_marks *marks, const nook_edit *edit, nook_where *where);

#endif
