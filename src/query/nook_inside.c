/* nook_inside.c -- crossings of a line along an axis; angles seen from a point. */
#include "query/nook_inside.h"

#include "exact/nook_exact.h"
#include "query/nook_lanes.h"

/* ---- boxes ---------------------------------------------------------------------------------------- */

/* The boxes that may hold a triangle that the line crosses, or the point. */
static inline void visit_group(nook_inside *q) {
    const nook_boxes *g = nook_descent_boxes(&q->descent, q->bvh);
    uint32_t entry[4], bits = 0, u = nook_after(q->axis), v = nook_after(u), i;
    int32_t x = q->cell[q->axis], y = q->cell[u], z = q->cell[v];
    for (i = 0; i < 4u; i += NOOK_LANES) {
        nook_flags out = (nook_load_cells(g->low[u] + i) > y) | (nook_load_cells(g->high[u] + i) < y) |
                         (nook_load_cells(g->low[v] + i) > z) | (nook_load_cells(g->high[v] + i) < z);
        out = out | (q->sign > 0 ? nook_load_cells(g->high[q->axis] + i) < x
                                 : nook_load_cells(g->low[q->axis] + i) > x);
        bits |= nook_set_entries(entry, i, nook_not(out), nook_lanes_of(0));
    }
    nook_descent_push(&q->descent, q->bvh->places, bits, entry);
}

/* ---- triangles ------------------------------------------------------------------------------------ */

/* Whether the point lies on the triangle; it lies in its plane. */
static bool is_on(const nook_point *const p[3], const nook_point *x) {
    uint32_t axis, i;
    int turn = nook_facing(p[0], p[1], p[2], &axis);
    for (i = 0; i < 3u; i++) {
        if (nook_orient2d(p[i], p[nook_after(i)], x, axis) * turn < 0) return false;
    }
    return turn != 0; /* on a triangle without area it is on its neighbours too */
}

/* On which side of edge a b the point is, seen against the axis, if it stood aside by a trifle in u and by a trifle of that in
 * v: never 0 unless the edge is a point there. */
static int side_of(const nook_inside *q, const nook_point *a, const nook_point *b) {
    uint32_t u = nook_after(q->axis), v = nook_after(u);
    int sign = nook_orient2d(a, b, &q->point, q->axis);
    if (sign != 0) return sign;
    if (nook_along(a, v) != nook_along(b, v)) return nook_along(a, v) > nook_along(b, v) ? 1 : -1;
    return (nook_along(b, u) > nook_along(a, u)) - (nook_along(b, u) < nook_along(a, u));
}

/* +1 if the line upward leaves through the triangle, -1 if it enters, 0 if it passes by. */
static int turn_of(const nook_inside *q, const nook_point *const p[3]) {
    int turn = side_of(q, p[0], p[1]);
    if (turn == 0 || turn != side_of(q, p[1], p[2]) || turn != side_of(q, p[2], p[0])) return 0;
    return turn;
}

/* level: the point is between the corners along the axis, so that its side decides; else the triangle is ahead. */
static void look_at(nook_inside *q, uint32_t t, const nook_point *const p[3], bool level) {
    int turn;
    if (q->component != NULL && q->component[t] == q->skip) return;
    turn = turn_of(q, p);
    if (level) {
        int side = nook_orient3d(p[0], p[1], p[2], &q->point);
        if (side == 0 && t < q->on && is_on(p, &q->point)) q->on = t;
        if (side * turn * q->sign >= 0) return;
    }
    q->crossings += turn != 0;
    q->winding += turn * q->sign;
}

/* Which of some triangles, corners as they are along the two other axes, the line passes by for certain: one edge on its
 * left, another on its right. */
static inline nook_flags passed(const nook_vectors at[2], const nook_lanes line[2]) {
    const nook_vectors x = {line[0], line[0], line[0]}, y = {line[1], line[1], line[1]};
    nook_vectors a = nook_vectors_sub(at[0], x), b = nook_vectors_sub(at[1], y),
                 edges = nook_vectors_cross(a, b);
    nook_lanes margin =
        nook_largest(a) * nook_largest(b) * nook_lanes_of(0x1p-20f) + nook_lanes_of(0x1p-120f);
    return (nook_least(edges) < -margin) & (nook_most(edges) > margin);
}

/* Of some triangles, from a place on, those are looked at that lie about the line and are not passed by for certain. */
static inline bool visit_some(nook_inside *q, uint32_t place) {
    uint32_t nt = q->bvh->view.nt, k, axis = q->axis;
    nook_vectors at[3];
    nook_lanes x[3];
    nook_flags about = nook_all_flags(), level = about;
    nook_some some;
    if (!nook_gather(q->bvh, place, &some)) return false;
    for (k = 0; k < 3u; k++) {
        nook_flags below, above;
        axis = nook_after(axis); /* the last is that of the line */
        at[k] = nook_some_along(&some, axis);
        x[k] = nook_lanes_of(nook_along(&q->point, axis));
        below = nook_least(at[k]) <= x[k];
        above = nook_most(at[k]) >= x[k];
        level = below & above;
        about = about & (k < 2u ? level : q->sign > 0 ? above : below);
        if (!nook_any_flag(about)) return true;
    }
    if (NOOK_HAS_FPU) about = about & nook_not(passed(at, x));
    for (k = 0; k < NOOK_LANES && place + k < nt; k++) {
        const nook_point *p[3];
        if (!nook_flag(about, k)) continue;
        nook_corners_of(q->bvh, some.t[k], p);
        look_at(q, some.t[k], p, nook_flag(level, k));
    }
    return true;
}

static bool visit_leaf(nook_inside *q) {
    uint32_t place = 4u * q->descent.node, end = place + 4u, nt = q->bvh->view.nt;
    for (; place < end && place < nt; place += NOOK_LANES) {
        if (!visit_some(q, place)) return false;
    }
    nook_descent_leave(&q->descent);
    return true;
}

/* ---- asking --------------------------------------------------------------------------------------- */

/* The way out of the mesh's box with the fewest cells to cross; false if the point is outside. */
static bool set_line(nook_inside *q) {
    uint32_t axis, least = NOOK_NONE;
    bool inside = true;
    for (axis = 0; axis < 3u; axis++) {
        float slack, at = nook_in_cells(q->bvh, nook_along(&q->point, axis), axis, &slack);
        uint32_t cell = nook_cell(q->bvh, nook_along(&q->point, axis), axis), rest = NOOK_LAST_CELL - cell;
        q->cell[axis] = (nook_bound)cell;
        if (rest < least) least = rest, q->axis = (uint8_t)axis, q->sign = 1;
        if (cell < least) least = cell, q->axis = (uint8_t)axis, q->sign = -1;
        if (at < 0 || at > (float)NOOK_LAST_CELL + slack) inside = false;
    }
    return inside;
}

nook_status nook_inside_begin(nook_inside *q, const nook_bvh *bvh, nook_point point) {
    nook_status status = nook_bvh_status(bvh);
    if (q == NULL) return NOOK_NULL_ARGUMENT;
    if (status != NOOK_OK) return status;
    status = nook_point_status(point);
    if (status != NOOK_OK) return status;
    memset(q, 0, offsetof(nook_inside, descent));
    q->on = NOOK_NONE;
    q->bvh = bvh;
    q->point = point;
    nook_descent_begin(&q->descent, bvh);
    if (!set_line(q)) nook_descent_leave(&q->descent);
    return NOOK_OK;
}

nook_status nook_inside_step(nook_inside *q, uint32_t *units) {
    nook_descent *d = &q->descent;
    while (nook_descent_next(d, q->bvh->places, NOOK_UP)) {
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (d->level != 0) {
            visit_group(q);
        } else if (!visit_leaf(q)) {
            return NOOK_INDEX_OUT_OF_RANGE;
        }
    }
    return NOOK_OK;
}

nook_status nook_side_of(const nook_bvh *bvh, nook_point point, int *side) {
    nook_inside inside;
    uint32_t units = UINT32_MAX; /* more than a tree has nodes */
    nook_status status = nook_inside_begin(&inside, bvh, point);
    if (side == NULL) return NOOK_NULL_ARGUMENT;
    if (status != NOOK_OK) return status;
    status = nook_inside_step(&inside, &units);
    *side = nook_inside_side(&inside);
    return status;
}

nook_status nook_signed_distance(nook_closest *closest, const nook_bvh *bvh, nook_point point) {
    int side = 0;
    nook_status status = nook_closest_point(closest, bvh, point);
    if (status != NOOK_OK) return status;
    status = nook_side_of(bvh, point, &side);
    closest->distance = side < 0 ? -closest->distance : side == 0 ? 0 : closest->distance;
    return status;
}

/* ---- winding number ------------------------------------------------------------------------------- */

nook_status nook_winding_begin(nook_winding *w, const nook_view *view, nook_point point) {
    nook_status status = nook_point_status(point);
    if (w == NULL || view == NULL) return NOOK_NULL_ARGUMENT;
    if (status != NOOK_OK) return status;
    memset(w, 0, sizeof *w);
    w->view = view;
    w->point = point;
    return NOOK_OK;
}

/* Toward p, of length 1. */
static nook_point toward(const nook_winding *w, uint32_t c) {
    nook_point d = nook_sub(nook_point_at(w->view, c), w->point);
    float length = nook_length(d);
    return length > 0x1p-100f ? nook_make(d.x / length, d.y / length, d.z / length) : nook_make(0, 0, 0);
}

/* Half the solid angle of triangle t (Van Oosterom and Strackee 1983). */
static float half_angle(const nook_winding *w, uint32_t t) {
    nook_point a = toward(w, 3u * t), b = toward(w, 3u * t + 1u), c = toward(w, 3u * t + 2u);
    return nook_angle(nook_dot(a, nook_cross(b, c)), 1.0f + nook_dot(a, b) + nook_dot(b, c) + nook_dot(c, a));
}

nook_status nook_winding_step(nook_winding *w, uint32_t *units) {
    const nook_view *m = w->view;
    for (; w->at < m->nt; w->at++, --*units) {
        const nook_index *V = &m->V[3u * w->at];
        float part, sum;
        if (*units == 0) return NOOK_MORE;
        if (V[0] >= m->nv || V[1] >= m->nv || V[2] >= m->nv) return NOOK_INDEX_OUT_OF_RANGE;
        part = half_angle(w, w->at) * 0.159154943f - w->low;
        sum = w->number + part;
        w->low = (sum - w->number) - part;
        w->number = sum;
    }
    return NOOK_OK;
}
