/* nook_inside.h -- is this point inside?
 *
 * nook_inside counts, exactly, how often a line from the point along an axis crosses the surface: for meshes whose
 * edges all have an even number of triangles (watertight ones have two) an odd count is inside, whatever is nested in
 * what. If the mesh is oriented, winding says how often the surface winds around the point: 1 inside a solid, 0 in its
 * cavities and outside, 2 where two shells overlap, -1 inside a shell that is inside out.
 * nook_winding is for meshes with holes: the generalised winding number (Jacobson 2013), a float near 1 well inside and
 * near 0 well outside. It looks at all triangles. */
#ifndef NOOK_INSIDE_H
#define NOOK_INSIDE_H

#include "query/nook_closest.h"

typedef struct nook_inside {
    /* The answer, valid when step has said NOOK_OK. */
    uint32_t
        on; /* the triangle of the lowest number with an area that the point lies on, exactly; or NOOK_NONE */
    uint32_t crossings; /* odd: inside */
    int32_t winding;

    /* May be set after begin: triangles t with component[t] == skip are left out. */
    uint32_t skip;
    const nook_index *component; /* [nt]; null: none is */

    const nook_bvh *bvh;
    nook_point point;
    nook_bound cell[3];
    uint8_t axis; /* 0 1 2: x y z */
    int8_t sign;  /* up or down that axis */
    nook_descent descent;
} nook_inside;

/* The line goes along the axis on which the point is nearest to the side of the mesh's box.
 *   NOOK_NULL_ARGUMENT, NOOK_EMPTY_MESH (nothing was built), NOOK_NOT_FINITE, NOOK_COORDINATE_TOO_LARGE */
nook_status nook_inside_begin(nook_inside *inside, const nook_bvh *bvh, nook_point point);
/* Statuses as of nook_ray_step. Steps: 1 a node, at most nt / 3 + 10. One unit is at most 1,600 instructions on M4F and 9,700 on M0
 * where floats and integers decide. */
nook_status nook_inside_step(nook_inside *inside, uint32_t *units);

/* +1 outside, 0 on the surface, -1 inside: by the parity of crossings. */
static inline int nook_inside_side(const nook_inside *inside) {
    return inside->on != NOOK_NONE ? 0 : (inside->crossings & 1u) != 0 ? -1 : 1;
}

/* +1, 0, -1 in *side, without a budget. */
nook_status nook_side_of(const nook_bvh *bvh, nook_point point, int *side);

/* The distance of a point, negative inside, in closest->distance with all else of nook_closest_point. For meshes whose edges all
 * have an even number of triangles; the sign is exact. */
nook_status nook_signed_distance(nook_closest *closest, const nook_bvh *bvh, nook_point point);

typedef struct nook_winding {
    float number; /* out */
    const nook_view *view;
    nook_point point;
    float low; /* what number has lost to rounding */
    uint32_t at;
} nook_winding;

/* The view stays until the end. Statuses as above. Steps: nt. Within 1e-6 for meshes larger than 1e-15 and points off the surface. */
nook_status nook_winding_begin(nook_winding *winding, const nook_view *view, nook_point point);
nook_status nook_winding_step(nook_winding *winding, uint32_t *units);

#endif
