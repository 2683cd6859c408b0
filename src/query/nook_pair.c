/* nook_pair.c -- two triangles, by signs alone. */
#include "query/nook_pair.h"

typedef const nook_point *const *corners;

/* The sides of a triangle's plane on which three points lie. Those without area have no sides: all 0. */
typedef struct sides {
    int of[3];
} sides;

static sides sides_of(corners plane, corners p) {
    sides s;
    uint32_t i;
    for (i = 0; i < 3u; i++) s.of[i] = nook_orient3d(plane[0], plane[1], plane[2], p[i]);
    return s;
}

static bool all_beyond(const sides *s) {
    return s->of[0] != 0 && s->of[0] == s->of[1] && s->of[0] == s->of[2];
}

static bool all_on(const sides *s) { return s->of[0] == 0 && s->of[1] == 0 && s->of[2] == 0; }

/* ---- through -------------------------------------------------------------------------------------- */

/* Whether segment p q, whose ends lie on different sides of the plane of a triangle or one of them on it, meets
 * the triangle: its line passes all edges on one side. */
static bool pierces(const nook_point *p, const nook_point *q, corners a) {
    int one = nook_orient3d(p, q, a[0], a[1]), other = nook_orient3d(p, q, a[1], a[2]), last;
    if (one * other < 0) return false;
    last = nook_orient3d(p, q, a[2], a[0]);
    return one * last >= 0 && other * last >= 0;
}

/* Whether an edge of b meets a; edges in the plane of a are left out, for then edges of a meet b, or b's others a. */
static bool any_pierces(corners b, const sides *s, corners a) {
    uint32_t i, j;
    for (i = 0; i < 3u; i++) {
        j = nook_after(i);
        if (s->of[i] * s->of[j] > 0 || (s->of[i] == 0 && s->of[j] == 0)) continue;
        if (pierces(b[i], b[j], a)) return true;
    }
    return false;
}

/* ---- in one plane --------------------------------------------------------------------------------- */

/* Whether b lies clear of a, beyond the line of one of a's edges, seen along an axis. */
static bool edge_parts(corners a, corners b, uint32_t axis) {
    uint32_t i, j;
    int turn = nook_orient2d(a[0], a[1], a[2], axis);
    for (i = 0; i < 3u; i++) {
        int side[3];
        for (j = 0; j < 3u; j++) side[j] = nook_orient2d(a[i], a[nook_after(i)], b[j], axis);
        if (side[0] == 0 || side[0] != side[1] || side[0] != side[2]) continue;
        if (side[0] != turn) return true; /* a segment has two such sides */
    }
    return false;
}

static bool is_below(corners a, corners b, uint32_t axis) {
    uint32_t i, j;
    for (i = 0; i < 3u; i++) {
        for (j = 0; j < 3u; j++) {
            if (nook_along(a[i], axis) >= nook_along(b[j], axis)) return false;
        }
    }
    return true;
}

static bool interval_parts(corners a, corners b, uint32_t axis) {
    return is_below(a, b, axis) || is_below(b, a, axis);
}

/* Two triangles in one plane meet if no line parts them along any axis: along one of them at least the plane does not
 * become a line, and there a line that parts convex pieces is parallel to an edge, or both lie on one line. */
static bool meet_in_plane(corners a, corners b) {
    uint32_t axis;
    for (axis = 0; axis < 3u; axis++) {
        if (interval_parts(a, b, axis) || edge_parts(a, b, axis) || edge_parts(b, a, axis)) return false;
    }
    return true;
}

/* Two triangles without area, on which no plane stands: whether their lines lie in one. */
static bool share_plane(corners a, corners b) {
    uint32_t i, j;
    for (i = 0; i < 3u; i++) {
        for (j = 0; j < 3u; j++) {
            if (nook_orient3d(a[i], a[nook_after(i)], b[j], b[nook_after(j)]) != 0) return false;
        }
    }
    return true;
}

/* Along which axis the triangle is seen largest, by floats. */
static uint32_t broadest(corners p) {
    nook_point n = nook_cross(nook_sub(*p[1], *p[0]), nook_sub(*p[2], *p[0]));
    float x = n.x < 0 ? -n.x : n.x, y = n.y < 0 ? -n.y : n.y, z = n.z < 0 ? -n.z : n.z;
    return x > y ? (x > z ? 0 : 2u) : (y > z ? 1u : 2u);
}

/* Whether all corners of b from one on lie on one side of a for certain. */
static bool is_clear(corners a, corners b, uint32_t i) {
    int side = nook_orient3d_fast(a[0], a[1], a[2], b[2]);
    while (side != NOOK_UNDECIDED && i < 2u && side == nook_orient3d_fast(a[0], a[1], a[2], b[i])) i++;
    return side != NOOK_UNDECIDED && i == 2u;
}

/* What is cheap and settles most: they are apart along an axis, or on one side, or seen along one axis beside one another. */
static bool are_apart(corners a, corners b) {
    uint32_t axis;
    for (axis = 0; axis < 3u; axis++) {
        if (interval_parts(a, b, axis)) return true;
    }
    if (is_clear(a, b, 0) || is_clear(b, a, 0)) return true;
    axis = broadest(a);
    return edge_parts(a, b, axis) || edge_parts(b, a, axis);
}

bool nook_triangles_meet(const nook_point *const a[3], const nook_point *const b[3]) {
    sides of_b, of_a;
    if (are_apart(a, b)) return false;
    of_b = sides_of(a, b);
    if (all_beyond(&of_b)) return false;
    of_a = sides_of(b, a);
    if (all_beyond(&of_a)) return false;
    if (all_on(&of_a) && all_on(&of_b)) return share_plane(a, b) && meet_in_plane(a, b);
    return any_pierces(b, &of_b, a) || any_pierces(a, &of_a, b);
}

/* ---- of one mesh ---------------------------------------------------------------------------------- */

static bool has_area(corners p) {
    uint32_t axis;
    return nook_facing(p[0], p[1], p[2], &axis) != 0;
}

/* a and b share their first corners. Whether nothing else of b can be on a, for, seen along an axis, it lies beyond one of
 * the two edges that meet there. */
static bool is_beside(corners a, corners b, uint32_t axis) {
    int turn = nook_orient2d(a[0], a[1], a[2], axis);
    if (turn == 0) return false;
    if (nook_orient2d(a[0], a[1], b[1], axis) == -turn && nook_orient2d(a[0], a[1], b[2], axis) == -turn)
        return true;
    return nook_orient2d(a[2], a[0], b[1], axis) == -turn && nook_orient2d(a[2], a[0], b[2], axis) == -turn;
}

/* Whether the edge of b that faces the shared corner meets a. */
static bool facing_edge_meets(corners a, corners b) {
    const nook_point *const edge[3] = {b[1], b[2], b[2]};
    int one = nook_orient3d(a[0], a[1], a[2], b[1]), other = nook_orient3d(a[0], a[1], a[2], b[2]);
    if (one == 0 && other == 0) return meet_in_plane(a, edge);
    return one * other <= 0 && pierces(b[1], b[2], a);
}

static bool meet_beyond_corner(corners a, corners b) {
    uint32_t axis;
    if (is_clear(a, b, 1) || is_clear(b, a, 1)) return false;
    axis = broadest(a);
    if (is_beside(a, b, axis) || is_beside(b, a, axis)) return false;
    return facing_edge_meets(a, b) || facing_edge_meets(b, a);
}

/* a and b share their first two corners: whether one is folded upon the other. */
static bool is_folded(corners a, corners b) {
    uint32_t axis;
    int side;
    if (nook_orient3d(a[0], a[1], a[2], b[2]) != 0) return false;
    side = nook_facing(a[0], a[1], a[2], &axis);
    return side != 0 && side == nook_orient2d(a[0], a[1], b[2], axis);
}

static bool intersect(corners a, corners b, uint32_t shared) {
    switch (shared) {
    case 0: return nook_triangles_meet(a, b);
    case 1: return meet_beyond_corner(a, b);
    case 2: return is_folded(a, b);
    default: return true;
    }
}

/* The corners of a with those first that b has too, and those of b in the same order. */
static uint32_t match(const nook_point *a[3], const nook_point *b[3]) {
    uint32_t i, j, shared = 0;
    const nook_point *keep;
    for (i = 0; i < 3u; i++) {
        for (j = shared; j < 3u; j++) {
            if (a[i] != b[j]) continue;
            keep = a[i], a[i] = a[shared], a[shared] = keep;
            keep = b[j], b[j] = b[shared], b[shared] = keep;
            shared++;
            break;
        }
    }
    return shared;
}

bool nook_corners_intersect(const nook_point *a[3], const nook_point *b[3]) {
    return intersect(a, b, match(a, b)) && has_area(a) && has_area(b);
}

bool nook_triangles_intersect(const nook_view *m, uint32_t t, uint32_t u) {
    const nook_point *a[3], *b[3];
    uint32_t i;
    for (i = 0; i < 3u; i++) {
        a[i] = &m->G[m->V[3u * t + i]];
        b[i] = &m->G[m->V[3u * u + i]];
    }
    return nook_corners_intersect(a, b);
}
