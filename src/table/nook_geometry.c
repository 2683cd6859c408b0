/* nook_geometry.c -- measures and exact shape, pass by pass.
 *
 * The volume comes first, because its sign says which side is outside; then edges, and only if none of
 * them is concave the search for anything else that is not convex. */
#include "table/nook_geometry.h"

#include <string.h>

enum phase {
    BOX,
    CLEAR,
    SURFACE,
    SHELLS,
    MASS,
    INERTIA,
    AREAS,
    EDGES,
    SPAN,
    SIDES,
    LAYERS,
    DOUBTFUL,
    LONELY,
    CONVEX, /* nothing is outside */
    FINISHED
};

/* Units for one exact sign at its worst. */
enum { ORIENT2D = 4, ORIENT3D = 9 };

static const nook_point *point(const nook_geometry_state *s, uint32_t c) { return &s->view.G[s->view.V[c]]; }

void nook_add(nook_sum *sum, float term) {
    float total = sum->total + term;
    float big = sum->total < 0 ? -sum->total : sum->total;
    if (big >= (term < 0 ? -term : term)) {
        sum->lost += (sum->total - total) + term;
    } else {
        sum->lost += (term - total) + sum->total;
    }
    sum->total = total;
}

/* +1 where the triangles face outwards, -1 where inwards. */
static int facing(const nook_geometry_state *s) { return s->result->volume_sign < 0 ? -1 : 1; }

/* ---- box, area, volume ---------------------------------------------------------------------------- */

static void widen(float *low, float *high, float x) {
    if (x < *low) *low = x;
    if (x > *high) *high = x;
}

NOOK_APART static void extend_box(nook_geometry_state *s, uint32_t v) {
    nook_geometry *r = s->result;
    nook_point p = s->view.G[v];
    if (s->view.C[v] == NOOK_STORED_NONE) return;
    if (!r->known) r->box_min = r->box_max = p;
    r->known = true;
    widen(&r->box_min.x, &r->box_max.x, p.x);
    widen(&r->box_min.y, &r->box_max.y, p.y);
    widen(&r->box_min.z, &r->box_max.z, p.z);
}

/* A power of two that scales the box to about 1, so that neither tiny nor huge meshes lose digits. */
static uint32_t size_exponent(const nook_geometry_state *s) {
    nook_point size = nook_sub(s->result->box_max, s->result->box_min);
    float most = size.x > size.y ? size.x : size.y;
    return nook_exponent(most > size.z ? most : size.z);
}

static nook_point middle(const nook_geometry *r) {
    nook_point half = nook_scaled(nook_sub(r->box_max, r->box_min), 0.5f);
    return nook_make(r->box_min.x + half.x, r->box_min.y + half.y, r->box_min.z + half.z);
}

static nook_point relative(const nook_geometry_state *s, uint32_t c, nook_point origin, float scale) {
    return nook_scaled(nook_sub(*point(s, c), origin), scale);
}

NOOK_APART static void measure_surface(nook_geometry_state *s, uint32_t t) {
    float scale = s->in.mass.scale;
    nook_point ab = relative(s, 3u * t + 1u, *point(s, 3u * t), scale);
    nook_point ac = relative(s, 3u * t + 2u, *point(s, 3u * t), scale);
    nook_shell *shell = nook_shell_of(s->shells, t);
    nook_add(&s->in.mass.sum[0], 0.5f * nook_length(nook_cross(ab, ac)));
    nook_volume_add(shell != NULL ? &shell->volume : &s->result->volume, point(s, 3u * t),
                    point(s, 3u * t + 1u), point(s, 3u * t + 2u));
}

static void tell_sign(nook_geometry_state *s, int sign, uint32_t t) {
    if (sign > 0) return;
    ++*(sign < 0 ? &s->result->inside_out_shells : &s->result->flat_shells);
    nook_tell(s->finder, sign < 0 ? NOOK_INSIDE_OUT : NOOK_FLAT_SHELL, NOOK_AT_TRIANGLE, t);
}

/* The volume of all is that of the shells together. */
NOOK_APART static void finish_shell(nook_geometry_state *s, uint32_t k) {
    nook_shell *shell = &s->shells->shell[k];
    nook_volume_merge(&s->result->volume, &shell->volume);
    shell->signed_volume = 0;
    if (shell->has_nonmanifold_edge || shell->border_edges != 0 || shell->incoherent_edges != 0) return;
    shell->signed_volume = nook_volume_value(&shell->volume);
    tell_sign(s, nook_volume_sign(&shell->volume), shell->first_triangle);
}

NOOK_APART static void finish_volume(nook_geometry_state *s) {
    nook_geometry *r = s->result;
    if (!s->closed) nook_volume_clear(&r->volume);
    if (!s->closed) return;
    r->volume_sign = nook_volume_sign(&r->volume);
    r->signed_volume = nook_volume_value(&r->volume);
    r->convex = NOOK_NO; /* until shown */
    if (s->shells == NULL) tell_sign(s, r->volume_sign, 0);
}

/* ---- mass ------------------------------------------------------------------------------------------- */

/* The tetrahedron over triangle t from the middle of the box and beyond that from an offset, all scaled: its
 * volume; its corners in p. */
static float tetrahedron(const nook_geometry_state *s, uint32_t t, nook_point p[3]) {
    uint32_t i;
    for (i = 0; i < 3u; i++)
        p[i] = nook_sub(relative(s, 3u * t + i, middle(s->result), s->in.mass.scale), s->in.mass.offset);
    return nook_dot(p[0], nook_cross(nook_sub(p[1], p[0]), nook_sub(p[2], p[0]))) / 6.0f;
}

NOOK_APART static void add_mass(nook_geometry_state *s, uint32_t t) {
    nook_point p[3];
    float volume = tetrahedron(s, t, p), quarter = 0.25f * volume;
    nook_add(&s->in.mass.sum[0], volume);
    nook_add(&s->in.mass.sum[1], quarter * (p[0].x + p[1].x + p[2].x));
    nook_add(&s->in.mass.sum[2], quarter * (p[0].y + p[1].y + p[2].y));
    nook_add(&s->in.mass.sum[3], quarter * (p[0].z + p[1].z + p[2].z));
}

/* Only if the sum of floats is near the exact volume, and the body on the whole not thinner than a 4096th of its
 * size: of thinner ones rounding makes noise, and so would the mass be. */
NOOK_APART static void finish_mass(nook_geometry_state *s) {
    nook_geometry *r = s->result;
    float scale = s->in.mass.scale, volume = nook_sum_value(&s->in.mass.sum[0]), exact, error;
    nook_point centre;
    exact = r->signed_volume * scale * scale * scale;
    error = volume - exact;
    r->mass_known = error * error < exact * exact * 1e-6f &&
                    exact * exact > 0x1p-24f * (r->area * scale * scale) * (r->area * scale * scale);
    if (!r->mass_known) return;
    s->in.mass.offset =
        nook_make(nook_sum_value(&s->in.mass.sum[1]) / volume, nook_sum_value(&s->in.mass.sum[2]) / volume,
                  nook_sum_value(&s->in.mass.sum[3]) / volume);
    centre = nook_scaled(s->in.mass.offset, nook_power_of_two(size_exponent(s)));
    r->centroid = nook_sub(middle(r), nook_scaled(centre, -1.0f));
}

/* Over a tetrahedron with one corner at the origin, the integral of x y is a twentieth of its volume
 * times the sum of x y over the corners and over the sum of the corners. */
NOOK_APART static void add_inertia(nook_geometry_state *s, uint32_t t) {
    nook_point p[3], sum;
    float part = tetrahedron(s, t, p) / 20.0f;
    nook_sum *moment = s->in.mass.sum;
    sum = nook_make(p[0].x + p[1].x + p[2].x, p[0].y + p[1].y + p[2].y, p[0].z + p[1].z + p[2].z);
    nook_add(&moment[0], part * (sum.x * sum.x + p[0].x * p[0].x + p[1].x * p[1].x + p[2].x * p[2].x));
    nook_add(&moment[1], part * (sum.x * sum.y + p[0].x * p[0].y + p[1].x * p[1].y + p[2].x * p[2].y));
    nook_add(&moment[2], part * (sum.x * sum.z + p[0].x * p[0].z + p[1].x * p[1].z + p[2].x * p[2].z));
    nook_add(&moment[3], part * (sum.y * sum.y + p[0].y * p[0].y + p[1].y * p[1].y + p[2].y * p[2].y));
    nook_add(&moment[4], part * (sum.y * sum.z + p[0].y * p[0].z + p[1].y * p[1].z + p[2].y * p[2].z));
    nook_add(&moment[5], part * (sum.z * sum.z + p[0].z * p[0].z + p[1].z * p[1].z + p[2].z * p[2].z));
}

NOOK_APART static void finish_inertia(nook_geometry_state *s) {
    float back = nook_power_of_two(size_exponent(s)), m[6];
    uint32_t i;
    for (i = 0; i < 6u; i++) {
        m[i] = nook_sum_value(&s->in.mass.sum[i]) * back * back * back * back * back;
        if (s->result->volume_sign < 0) m[i] = -m[i];
    }
    s->result->inertia[0] = m[3] + m[5];
    s->result->inertia[1] = -m[1];
    s->result->inertia[2] = -m[2];
    s->result->inertia[3] = m[0] + m[5];
    s->result->inertia[4] = -m[4];
    s->result->inertia[5] = m[0] + m[3];
}

/* ---- triangles and edges ------------------------------------------------------------------------------ */

static int turn(const nook_geometry_state *s, uint32_t t, uint32_t axis) {
    return nook_orient2d(point(s, 3u * t), point(s, 3u * t + 1u), point(s, 3u * t + 2u), axis);
}

static int area_sign(const nook_geometry_state *s, uint32_t t, uint32_t *axis) {
    return nook_facing(point(s, 3u * t), point(s, 3u * t + 1u), point(s, 3u * t + 2u), axis);
}

/* +1 if p is outside the plane of triangle t, -1 inside, 0 in it. */
static int side(const nook_geometry_state *s, uint32_t t, const nook_point *p) {
    return facing(s) * nook_orient3d(point(s, 3u * t), point(s, 3u * t + 1u), point(s, 3u * t + 2u), p);
}

static void look_at_area(nook_geometry_state *s, uint32_t t) {
    uint32_t axis;
    if (area_sign(s, t, &axis) != 0) return;
    s->result->zero_area_triangles++;
    nook_tell(s->finder, NOOK_ZERO_AREA_TRIANGLE, NOOK_AT_TRIANGLE, t);
}

static void found_outside(nook_geometry_state *s, uint32_t v, uint32_t t) {
    if (!s->closed || s->result->witness_vertex != NOOK_NONE) return;
    s->result->witness_vertex = v;
    s->result->witness_triangle = t;
}

/* The two triangles are in one plane, so both are seen against the same axis, if they have an area. */
static void look_at_coplanar(nook_geometry_state *s, uint32_t c, uint32_t o) {
    uint32_t axis;
    int one = area_sign(s, nook_triangle(c), &axis), other = turn(s, nook_triangle(o), axis);
    if (one == 0 || other == 0) return;
    if (one == other) {
        s->result->flat_edges++;
    } else {
        s->result->folded_edges++;
        nook_tell(s->finder, NOOK_FOLDED_EDGE, NOOK_AT_CORNER, c);
    }
}

static uint32_t look_at_edge(nook_geometry_state *s, uint32_t c) {
    uint32_t o = s->view.O[c], t = nook_triangle(c);
    int above;
    if (o <= c || o >= 3u * s->view.nt) return 1;
    above = side(s, t, point(s, o));
    if (above == 0) {
        look_at_coplanar(s, c, o);
        return ORIENT3D + 4 * ORIENT2D;
    }
    ++*(above > 0 ? &s->result->concave_edges : &s->result->convex_edges);
    if (above > 0) found_outside(s, s->view.V[o], t);
    return ORIENT3D;
}

/* ---- convexity ---------------------------------------------------------------------------------------- */

static bool same_place(const nook_point *a, const nook_point *b) {
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

/* Take v if it is not on the point, the line, the plane of those found so far. */
static uint32_t span(nook_geometry_state *s, uint32_t v) {
    const nook_point *G = s->view.G;
    const uint32_t *known = s->in.hull.vertex;
    uint32_t found = s->in.hull.found, price = 1;
    bool further = true;
    if (found == 4u || s->view.C[v] == NOOK_STORED_NONE) return 1;
    if (found == 1u) further = !same_place(&G[known[0]], &G[v]);
    if (found == 2u) {
        further = nook_facing(&G[known[0]], &G[known[1]], &G[v], &s->in.hull.axis) != 0;
        price = 3 * ORIENT2D;
    }
    if (found == 3u) {
        further = nook_orient3d(&G[known[0]], &G[known[1]], &G[known[2]], &G[v]) != 0;
        price = ORIENT3D;
    }
    if (further) s->in.hull.vertex[s->in.hull.found++] = v;
    return price;
}

static uint32_t look_at_side(nook_geometry_state *s, uint32_t i) {
    uint32_t v = s->in.hull.vertex[i & 3u];
    if (side(s, i >> 2, &s->view.G[v]) > 0) found_outside(s, v, i >> 2);
    return ORIENT3D;
}

/* Whether the line along the axis, through a point of the triangle of the first three vertices that is as near
 * as you like to the first and in general position, passes triangle t, which is seen turning to the left. */
NOOK_APART static bool passes(const nook_geometry_state *s, uint32_t t, uint32_t *price) {
    uint32_t i, k;
    for (i = 0; i < 3u; i++) {
        int left = 0;
        for (k = 0; k < 3u && left == 0; k++) {
            const nook_point *p = &s->view.G[s->in.hull.vertex[k]];
            left = nook_orient2d(point(s, 3u * t + i), point(s, 3u * t + (i + 1u) % 3u), p, s->in.hull.axis);
            *price += ORIENT2D;
        }
        if (left * facing(s) <= 0) return false;
    }
    return true;
}

static uint32_t look_at_layer(nook_geometry_state *s, uint32_t t) {
    uint32_t price = ORIENT2D;
    if (turn(s, t, s->in.hull.axis) * facing(s) > 0 && passes(s, t, &price)) s->in.hull.layers++;
    return price;
}

/* Whether every vertex that is inside of triangle t is inside of u: they share their plane and face the same way. */
static bool same_side(const nook_geometry_state *s, uint32_t t, uint32_t u) {
    uint32_t i, axis;
    for (i = 0; i < 3u; i++) {
        if (side(s, t, point(s, 3u * u + i)) != 0) return false;
    }
    return area_sign(s, t, &axis) == turn(s, u, axis);
}

static bool is_sliver(const nook_geometry_state *s, uint32_t c) {
    uint32_t axis;
    return c < 3u * s->view.nt && area_sign(s, nook_triangle(c), &axis) == 0;
}

/* A triangle with an area of which edges and layers do not tell: beside one without, or on a surface that goes
 * round more than once. Those in the plane of the last one held are as good as held. */
static bool is_doubtful(const nook_geometry_state *s, uint32_t t) {
    uint32_t i;
    bool doubtful = s->in.hull.layers != 1u;
    if (is_sliver(s, 3u * t)) return false;
    for (i = 0; i < 3u && !doubtful; i++) doubtful = is_sliver(s, s->view.O[3u * t + i]);
    return doubtful && (s->in.hull.held == NOOK_NONE || !same_side(s, s->in.hull.held, t));
}

/* A vertex that may be one of slivers only: one at least, and both beside it. */
static bool is_lonely(const nook_geometry_state *s, uint32_t v) {
    uint32_t c = s->view.C[v];
    if (!is_sliver(s, c)) return false;
    return is_sliver(s, s->view.O[nook_next(c)]) && is_sliver(s, s->view.O[nook_prev(c)]);
}

/* Hold a doubtful triangle against the next vertex, or a lonely vertex against the next triangle; s->at stays
 * until all have been. */
static uint32_t hold(nook_geometry_state *s, uint32_t i) {
    bool lonely = s->phase == LONELY;
    uint32_t k = s->in.hull.against++, t = lonely ? k : i, v = lonely ? i : k;
    if (k == 0 && !(lonely ? is_lonely(s, v) : is_doubtful(s, t))) {
        s->in.hull.against = 0;
        return 13 * ORIENT2D + 3 * ORIENT3D;
    }
    if (s->view.C[v] != NOOK_STORED_NONE && side(s, t, &s->view.G[v]) > 0) found_outside(s, v, t);
    if (s->in.hull.against != (lonely ? s->view.nt : s->view.nv)) {
        s->at--;
    } else {
        s->in.hull.against = 0;
        s->in.hull.held = t;
    }
    return k == 0 ? 13 * ORIENT2D + 4 * ORIENT3D : ORIENT3D;
}

/* ---- passes --------------------------------------------------------------------------------------------- */

/* How many items the pass has. */
static uint32_t length(const nook_geometry_state *s) {
    switch (s->phase) {
    case BOX:
    case SPAN:
    case LONELY: return s->view.nv;
    case CLEAR:
    case SHELLS: return s->shells != NULL ? s->shells->count : 0;
    case EDGES: return 3u * s->view.nt;
    case SIDES: return 4u * s->view.nt;
    default: return s->view.nt;
    }
}

static uint32_t visit(nook_geometry_state *s, uint32_t i) {
    switch (s->phase) {
    case BOX: extend_box(s, i); return 1;
    case CLEAR: nook_volume_clear(&s->shells->shell[i].volume); return 1;
    case SURFACE: measure_surface(s, i); return 3;
    case SHELLS: finish_shell(s, i); return 3;
    case MASS: add_mass(s, i); return 2;
    case INERTIA: add_inertia(s, i); return 3;
    case AREAS: look_at_area(s, i); return 3 * ORIENT2D;
    case EDGES: return look_at_edge(s, i);
    case SPAN: return span(s, i);
    case SIDES: return look_at_side(s, i);
    case LAYERS: return look_at_layer(s, i);
    default: return hold(s, i);
    }
}

/* Nothing more to ask once a vertex is outside, or where there is no inside. */
static bool is_decided(const nook_geometry_state *s) {
    return s->result->volume_sign == 0 || s->result->witness_vertex != NOOK_NONE;
}

static bool is_over(const nook_geometry_state *s) {
    return s->at == length(s) || (s->phase > EDGES && is_decided(s));
}

NOOK_APART static void finish_surface(nook_geometry_state *s) {
    float back = nook_power_of_two(size_exponent(s));
    s->result->area = nook_sum_value(&s->in.mass.sum[0]) * back * back;
}

/* After the layers: is there anything left that may be outside? With several shells the answer is no already. */
static uint32_t after_layers(const nook_geometry_state *s) {
    if (s->shells != NULL && s->shells->count > 1u) return FINISHED;
    return s->result->zero_area_triangles == 0 && s->in.hull.layers == 1u ? CONVEX : DOUBTFUL;
}

static void next_pass(nook_geometry_state *s) {
    s->at = 0;
    s->debt = 2;
    switch (s->phase++) {
    case SURFACE: finish_surface(s); break;
    case SHELLS: finish_volume(s); break;
    case MASS: finish_mass(s); break;
    case INERTIA: finish_inertia(s); break;
    case LAYERS: s->phase = after_layers(s); break;
    default: break;
    }
    if (s->phase == MASS && s->result->volume_sign == 0) s->phase = AREAS;
    if (s->phase == INERTIA && !s->result->mass_known) s->phase = AREAS;
    if (s->phase > EDGES && is_decided(s)) s->phase = FINISHED;
    if (s->phase == CONVEX) {
        s->result->convex = NOOK_YES;
        s->phase = FINISHED;
    }
    if (s->phase == SURFACE) s->in.mass.scale = nook_power_of_two(254u - size_exponent(s));
    if (s->phase == MASS || s->phase == INERTIA) memset(s->in.mass.sum, 0, sizeof s->in.mass.sum);
    if (s->phase == SPAN) {
        memset(&s->in, 0, sizeof s->in);
        s->in.hull.held = NOOK_NONE;
    }
}

nook_status nook_geometry_step(nook_geometry_state *s, uint32_t *units) {
    for (;;) {
        uint32_t paid = s->debt < *units ? s->debt : *units;
        s->debt -= paid;
        *units -= paid;
        if (s->debt != 0) return NOOK_MORE;
        if (s->phase == FINISHED) return NOOK_OK;
        if (is_over(s)) {
            next_pass(s);
        } else if (*units == 0) {
            return NOOK_MORE;
        } else {
            s->debt = visit(s, s->at++);
        }
    }
}

nook_status nook_geometry_begin(nook_geometry_state *s, const nook_view *view, bool closed,
                                nook_shells *shells, const nook_finder *finder, nook_geometry *result) {
    if (s == NULL || view == NULL || result == NULL) return NOOK_NULL_ARGUMENT;
    if (nook_shells_status(shells, view->nt) != NOOK_OK) return NOOK_NULL_ARGUMENT;
    memset(s, 0, sizeof *s);
    memset(result, 0, sizeof *result);
    s->view = *view;
    s->shells = shells;
    s->finder = finder;
    s->result = result;
    s->closed = closed;
    s->debt = 2;
    result->convex = NOOK_MAYBE;
    result->witness_vertex = result->witness_triangle = NOOK_NONE;
    nook_volume_clear(&result->volume);
    return NOOK_OK;
}
