/* nook_inner.h -- what the files of this room share: looking at tables of any bits, and changing them. */
#ifndef NOOK_INNER_H
#define NOOK_INNER_H

#include "edit/nook_edit.h"
#include "edit/nook_guard.h"

/* ---- looking -------------------------------------------------------------------------------------- */

/* The corner across, or NOOK_NONE at a border and where O names none. */
static inline uint32_t nook_across(const nook_mesh *m, uint32_t c) {
    return m->O[c] == c || m->O[c] >= 3u * m->max_nt ? NOOK_NONE : m->O[c];
}

/* Whether c is a corner, and the tables of its triangle lead to corners and vertices that exist. */
nook_status nook_triangle_status(const nook_mesh *m, uint32_t c);
/* The same of both triangles at the edge that c faces. */
nook_status nook_edge_status(const nook_mesh *m, uint32_t c);

/* The neighbours of a vertex one by one; at the end of an open fan the last vertex. */
typedef struct nook_ring {
    nook_star star;
    uint32_t c;
} nook_ring;

nook_status nook_ring_begin(nook_ring *ring, const nook_view *m, uint32_t c);
uint32_t nook_ring_next(nook_ring *ring);

/* Whether v(c) and v are joined by an edge of the fan of c; true as well where the tables do not hold. */
bool nook_is_joined(const nook_view *m, uint32_t c, uint32_t v);
bool nook_is_at_border(const nook_view *m, uint32_t c);

/* ---- conditions ----------------------------------------------------------------------------------- */

/* The triangles in the fan of corner c; those beyond four more than the limit are not counted. */
uint32_t nook_count_fan(const nook_view *m, uint32_t c, const nook_edit *edit);
/* Whether a new vertex may have so many triangles. */
static inline bool nook_is_within(const nook_edit *edit, uint32_t triangles) {
    return edit == NULL || edit->max_valence == 0 || triangles <= edit->max_valence;
}
/* Whether v(c) may come to have so many triangles more. */
bool nook_has_room(const nook_view *m, uint32_t c, uint32_t more, const nook_edit *edit);

uint32_t nook_bits_that_differ(const nook_point *a, const nook_point *b);

/* Two vertices at new places. */
typedef struct nook_move {
    uint32_t v[2];
    nook_point to[2];
} nook_move;

/* Whether the condition is set and triangle a b c does not face the way of piece p, or has no area. A piece without area
 * faces every way. */
bool nook_is_turned(const nook_edit *edit, const nook_point *a, const nook_point *b, const nook_point *c,
                    const nook_point *const p[4]);
/* The same of triangle t against itself before a move, if that moves it; and of all in the fan of c but triangles a and b. */
bool nook_move_turns(const nook_mesh *m, uint32_t t, const nook_move *move, const nook_edit *edit);
bool nook_move_turns_fan(const nook_mesh *m, uint32_t c, const nook_move *move, uint32_t a, uint32_t b,
                         const nook_edit *edit);

/* What an edit is about to do to a mesh, for the question whether it cuts itself then. Points say by their addresses what they
 * are of; each triangle is counted once. */
typedef struct nook_change {
    nook_view view;
    const nook_point *made[4][3]; /* triangles that are new */
    uint32_t count;
    uint32_t gone[3]; /* triangles that go, or NOOK_NONE */
    nook_star fan[2]; /* those about a vertex that changes, and what it becomes there */
    uint32_t v[2];
    const nook_point *to[2];
} nook_change;

static inline bool nook_is_guarded(const nook_edit *edit) { return edit != NULL && edit->guard != NULL; }

/* Nothing but that two triangles go, where these are not NOOK_NONE. */
void nook_change_begin(nook_change *change, const nook_mesh *m, uint32_t gone, uint32_t gone_too);
void nook_change_make(nook_change *change, const nook_point *a, const nook_point *b, const nook_point *c);
/* Vertex v(c) moves with all its triangles. */
void nook_change_fan(nook_change *change, uint32_t i, uint32_t c, const nook_point *to);

/* ---- changing -------------------------------------------------------------------------------------- */

static inline void nook_join(nook_mesh *m, uint32_t c, uint32_t o) {
    m->O[c] = nook_store(o == NOOK_NONE ? c : o);
    if (o != NOOK_NONE) m->O[o] = nook_store(c);
}

static inline void nook_set_triangle(nook_mesh *m, uint32_t t, uint32_t v0, uint32_t v1, uint32_t v2) {
    m->V[3u * t] = nook_store(v0);
    m->V[3u * t + 1u] = nook_store(v1);
    m->V[3u * t + 2u] = nook_store(v2);
}

/* The tree learns what mesh there is now; and that triangle t, or all in the fan of c, are new or have changed. */
void nook_follow(const nook_mesh *m, const nook_edit *edit);
void nook_follow_triangle(const nook_mesh *m, uint32_t t, const nook_edit *edit);
void nook_follow_fan(const nook_mesh *m, uint32_t c, const nook_edit *edit);
/* Triangle t, whose tables hold, runs the other way, as all triangles joined to it are to. */
void nook_turn_over(nook_mesh *m, uint32_t t, const nook_edit *edit);

/* Vertex mesh->nv, which is counted from now on. */
void nook_add_vertex(nook_mesh *m, nook_point at, uint32_t c, const nook_edit *edit);
void nook_copied(const nook_edit *edit, uint32_t from, uint32_t to);

/* A triangle, or a vertex with a fan of its own, takes a number that nobody has; what is beside the mesh is exchanged, so that
 * moving it back restores all. */
void nook_move_triangle(nook_mesh *m, uint32_t from, uint32_t to, const nook_edit *edit);
void nook_move_vertex(nook_mesh *m, uint32_t from, uint32_t to, const nook_edit *edit);
/* Triangle t, or vertex v, is joined to nothing any more: the last one takes its number. With two, of either kind, the
 * higher number goes first, so that the other is not the last that moves. */
void nook_drop_triangle(nook_mesh *m, uint32_t t, const nook_edit *edit);
void nook_drop_triangles(nook_mesh *m, uint32_t t, uint32_t u, const nook_edit *edit);
void nook_drop_vertex(nook_mesh *m, uint32_t v, const nook_edit *edit);
void nook_drop_vertices(nook_mesh *m, uint32_t v, uint32_t w, const nook_edit *edit);
/* All corners in the fan of c become corners of v. */
void nook_rename_fan(nook_mesh *m, uint32_t c, uint32_t v);

/* ---- what goes along ------------------------------------------------------------------------------- */

/* Triangle t belongs to no other: color 1 and attributes 0. */
void nook_new_triangle(uint32_t t, const nook_edit *edit);
void nook_copy_color(const nook_edit *edit, uint32_t to, uint32_t from);
void nook_swap_color(const nook_edit *edit, uint32_t t, uint32_t u);
void nook_copy_attributes(const nook_edit *edit, uint32_t to, uint32_t from);
void nook_swap_attributes(const nook_edit *edit, uint32_t c, uint32_t d);
/* Where there are any. */
bool nook_same_attributes(const nook_edit *edit, uint32_t c, uint32_t d);
/* Where there are any: those of corner to become w0 times those of c, w1 of n(c) and w2 of p(c); any of the three may be to. */
void nook_blend_attributes(const nook_edit *edit, uint32_t to, uint32_t c, const float w[3]);
/* Those of corner to grow by weight times those of another. */
void nook_add_attributes(const nook_edit *edit, uint32_t to, uint32_t from, float weight);

#endif
