/* nook_bvh.c -- the order of the triangles from the top down, then the boxes from the bottom up. */
#include "query/nook_bvh.h"

#include "query/nook_descent.h"

/* While the order is made the boxes hold a key a triangle: the cell of its centre in a cube around what is being cut, a
 * few bits along each axis. */
enum {
    KEY_BYTES = NOOK_BOUND_BITS / 4,
    KEY_BITS = NOOK_BOUND_BITS == 8 ? 5 : 10,
    KEY_MOST = (1 << KEY_BITS) - 1
};
/* What spans fewer cells gets keys of its own. */
enum { NARROW = 6 };

enum { LOOK, CUT, MEASURE, ASSIGN, EXTENT, PART, LEAVES, GROUPS, BUILT };

static inline uint32_t key_at(const uint8_t *keys, uint32_t i) {
    const uint8_t *at = keys + (size_t)KEY_BYTES * i;
    uint32_t key = at[0] | (uint32_t)at[1] << 8;
#if NOOK_BOUND_BITS == 16
    key |= (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
#endif
    return key;
}

static inline void set_key(uint8_t *keys, uint32_t i, uint32_t key) {
    uint8_t *at = keys + (size_t)KEY_BYTES * i;
    at[0] = (uint8_t)key;
    at[1] = (uint8_t)(key >> 8);
#if NOOK_BOUND_BITS == 16
    at[2] = (uint8_t)(key >> 16);
    at[3] = (uint8_t)(key >> 24);
#endif
}

static inline uint32_t part_of(uint32_t key, uint32_t axis) { return key >> axis * KEY_BITS & KEY_MOST; }

/* ---- looking -------------------------------------------------------------------------------------- */

static nook_status refuse(const nook_bvh_state *s, nook_status status, nook_kind kind, uint32_t index) {
    if (s->where != NULL) *s->where = nook_at(kind, index);
    return status;
}

/* No extent yet, of points and of keys. */
static void nothing(nook_bvh_state *s) {
    uint32_t axis;
    for (axis = 0; axis < 3u; axis++) s->least[axis] = KEY_MOST, s->most[axis] = 0;
    s->low = nook_make(0x1p32f, 0x1p32f, 0x1p32f);
    s->high = nook_make(-0x1p32f, -0x1p32f, -0x1p32f);
}

static void widen(nook_bvh_state *s, nook_point low, nook_point high) {
    s->low = nook_low(s->low, low);
    s->high = nook_high(s->high, high);
}

/* Whether a coordinate is finite and in range, by its bits. */
static inline bool is_good(float x) { return (nook_float_bits(x) & 0x7FFFFFFFu) <= 0x4E800000u; }

/* Whether triangle t can be used, and place t of the order. */
static nook_status look_at(nook_bvh_state *s, uint32_t t) {
    const nook_view *m = &s->bvh->view;
    uint32_t i;
    nook_point low, high;
    for (i = 0; i < 3u; i++) {
        uint32_t v = m->V[3u * t + i];
        const nook_point *p = &m->G[v];
        if (v >= m->nv) return refuse(s, NOOK_INDEX_OUT_OF_RANGE, NOOK_AT_CORNER, 3u * t + i);
        if (is_good(p->x) && is_good(p->y) && is_good(p->z)) continue;
        return refuse(s, nook_point_status(*p), NOOK_AT_VERTEX, v);
    }
    if (s->order != NULL) s->order[t] = nook_store(t);
    if (nook_triangle_at(s->bvh, t) >= m->nt) return refuse(s, NOOK_INDEX_OUT_OF_RANGE, NOOK_AT_TRIANGLE, t);
    nook_box(m, t, &low, &high);
    widen(s, low, high);
    return NOOK_OK;
}

static nook_status look(nook_bvh_state *s, uint32_t end) {
    for (; s->at < end; s->at++) {
        nook_status status = look_at(s, s->at);
        if (status != NOOK_OK) return status;
    }
    return NOOK_OK;
}

static float longest(const nook_bvh_state *s) {
    nook_point d = nook_sub(s->high, s->low);
    float xy = d.x > d.y ? d.x : d.y;
    return xy > d.z ? xy : d.z;
}

/* Cells a unit of length: so many along extent, which is not so short that they could overflow. */
static float cells_along(float extent, float least) {
    return (float)NOOK_LAST_CELL / (extent > least ? extent : least);
}

static void set_grid(nook_bvh_state *s) {
    nook_point d = nook_sub(s->high, s->low);
    float least = longest(s) * 0x1p-20f + 0x1p-80f;
    s->bvh->origin = s->low;
    s->bvh->cells = nook_make(cells_along(d.x, least), cells_along(d.y, least), cells_along(d.z, least));
}

/* ---- order ---------------------------------------------------------------------------------------- */

/* On to the leaves after those from start, 2^height of them: they were the left half of something, or the right half, and
 * its right half, and so on, as high as their number is even. */
static void go_after(nook_bvh_state *s) {
    s->start += (uint32_t)1 << s->height;
    s->height = 0;
    while ((s->start >> s->height & 1u) == 0) s->height++;
}

/* The leaves from start, 2^height of them or as many as there are, are to be cut in halves, down to one leaf. */
static void begin_cut(nook_bvh_state *s) {
    uint32_t nt = s->bvh->view.nt, end = (s->start + ((uint32_t)1 << s->height)) * 4u;
    s->from = s->at = s->start * 4u;
    s->to = end < nt ? end : nt;
    s->middle = (s->start + ((uint32_t)1 << s->height >> 1)) * 4u;
    if (s->from >= nt) {
        s->phase = LEAVES;
        s->at = 0;
        s->end = nt;
    } else if (s->height == 0) {
        go_after(s);
    } else if (s->middle >= s->to) {
        s->height--;
    } else {
        s->phase = s->fresh ? MEASURE : EXTENT; /* fresh: the very first */
        s->end = s->to;
        nothing(s);
    }
}

/* Twice the centre of the box of a triangle. */
static nook_point centre_of(const nook_bvh_state *s, uint32_t t) {
    nook_point low, high;
    nook_box(&s->bvh->view, t, &low, &high);
    return nook_make(low.x + high.x, low.y + high.y, low.z + high.z);
}

static void measure(nook_bvh_state *s, uint32_t end) {
    for (; s->at < end; s->at++) {
        nook_point centre = centre_of(s, s->order[s->at]);
        widen(s, centre, centre);
    }
}

static void assign(nook_bvh_state *s, uint32_t end) {
    uint8_t *keys = (uint8_t *)s->boxes;
    nook_point low = s->low;
    float cells = (float)KEY_MOST / (longest(s) + 0x1p-80f);
    for (; s->at < end; s->at++) {
        nook_point d = nook_sub(centre_of(s, s->order[s->at]), low);
        uint32_t x = (uint32_t)(d.x * cells + 0.5f), y = (uint32_t)(d.y * cells + 0.5f);
        set_key(keys, s->at, x | y << KEY_BITS | (uint32_t)(d.z * cells + 0.5f) << 2 * KEY_BITS);
    }
}

static inline void widen_span(uint32_t part, uint32_t *least, uint32_t *most) {
    *least = part < *least ? part : *least;
    *most = part > *most ? part : *most;
}

static void extent(nook_bvh_state *s, uint32_t end) {
    const uint8_t *keys = (const uint8_t *)s->boxes;
    uint32_t i, x = s->least[0], y = s->least[1], z = s->least[2], u = s->most[0], v = s->most[1],
                w = s->most[2];
    for (i = s->at; i < end; i++) {
        uint32_t key = key_at(keys, i);
        widen_span(part_of(key, 0), &x, &u);
        widen_span(part_of(key, 1), &y, &v);
        widen_span(part_of(key, 2), &z, &w);
    }
    s->least[0] = x, s->least[1] = y, s->least[2] = z;
    s->most[0] = u, s->most[1] = v, s->most[2] = w;
    s->at = end;
}

/* The triangles whose keys are at most pivot come first. */
static void part(nook_bvh_state *s, uint32_t end) {
    uint8_t *keys = (uint8_t *)s->boxes;
    uint32_t i, left = s->left, axis = s->axis, pivot = s->pivot;
    for (i = s->at; i < end; i++) {
        uint32_t key = key_at(keys, i);
        nook_index t = s->order[i];
        set_key(keys, i, key_at(keys, left));
        s->order[i] = s->order[left];
        set_key(keys, left, key);
        s->order[left] = t;
        left += part_of(key, axis) <= pivot;
    }
    s->at = end;
    s->left = left;
}

static void begin_part(nook_bvh_state *s) {
    s->pivot = (s->least[s->axis] + s->most[s->axis]) >> 1;
    s->at = s->left = s->first;
    s->end = s->last;
    s->phase = PART;
}

/* Along the axis of the largest extent, unless that has too few cells to tell much. */
static void after_extent(nook_bvh_state *s) {
    uint32_t axis, most = 0;
    for (axis = 0; axis < 3u; axis++) {
        uint32_t span = s->most[axis] - s->least[axis];
        if (axis == 0 || span > most) most = span, s->axis = axis;
    }
    if (most < NARROW && !s->fresh) {
        nothing(s);
        s->phase = MEASURE;
        s->at = s->from;
    } else if (most == 0) { /* all in one place */
        go_after(s);
        s->phase = CUT;
    } else {
        s->first = s->from;
        s->last = s->to;
        begin_part(s);
    }
    s->fresh = false;
}

/* Keep to the side that holds the place of the cut, until it lies between the two or among equals. */
static void after_part(nook_bvh_state *s) {
    if (s->left > s->middle) {
        s->last = s->left;
        s->most[s->axis] = s->pivot;
    } else {
        s->first = s->left;
        s->least[s->axis] = s->pivot + 1u;
    }
    if (s->left != s->middle && s->least[s->axis] != s->most[s->axis]) {
        begin_part(s);
    } else {
        s->height--;
        s->phase = CUT;
    }
}

/* ---- boxes ---------------------------------------------------------------------------------------- */

static void clear_group(nook_boxes *group) {
    memset(group->low, 0xFF, sizeof group->low);
    memset(group->high, 0, sizeof group->high);
}

static void widen_bound(nook_boxes *group, uint32_t child, uint32_t axis, uint32_t low, uint32_t high) {
    if (low < group->low[axis][child]) group->low[axis][child] = (nook_bound)low;
    if (high > group->high[axis][child]) group->high[axis][child] = (nook_bound)high;
}

static void leaves(nook_bvh_state *s, uint32_t end) {
    const nook_bvh *bvh = s->bvh;
    for (; s->at < end; s->at++) {
        nook_boxes *group = &s->boxes[s->at >> 4];
        nook_point low, high;
        uint32_t axis;
        if ((s->at & 15u) == 0) clear_group(group);
        nook_box(&bvh->view, nook_triangle_at(bvh, s->at), &low, &high);
        for (axis = 0; axis < 3u; axis++) {
            widen_bound(group, s->at >> 2 & 3u, axis, nook_cell(bvh, nook_along(&low, axis), axis),
                        nook_cell(bvh, nook_along(&high, axis), axis));
        }
    }
}

/* The groups of one level, from base on, make the children of the next, which stand after them. */
static void groups(nook_bvh_state *s, uint32_t end) {
    for (; s->at < end; s->at++) {
        const nook_boxes *from = &s->boxes[s->base + s->at];
        nook_boxes *group = &s->boxes[s->base + s->end + (s->at >> 2)];
        uint32_t axis, i;
        if ((s->at & 3u) == 0) clear_group(group);
        for (axis = 0; axis < 3u; axis++) {
            for (i = 0; i < 4u; i++)
                widen_bound(group, s->at & 3u, axis, from->low[axis][i], from->high[axis][i]);
        }
    }
}

/* ---- steps ---------------------------------------------------------------------------------------- */

static nook_status begin(nook_bvh_state *s, nook_bvh *bvh, nook_boxes *boxes, nook_index *order,
                         nook_where *where) {
    uint32_t nt = bvh->view.nt;
    memset(s, 0, sizeof *s);
    s->bvh = bvh;
    s->boxes = boxes;
    bvh->boxes = boxes;
    s->order = order;
    s->where = where;
    s->end = nt;
    if (nt == 0) return refuse(s, NOOK_EMPTY_MESH, NOOK_NOWHERE, 0);
    bvh->root = 0;
    for (bvh->levels = 1; nook_groups_of_level(nt, bvh->levels) > 1u; bvh->levels++)
        bvh->root += nook_groups_of_level(nt, bvh->levels);
    while ((uint32_t)4 << s->height < nt) s->height++;
    nothing(s);
    s->fresh = true;
    return NOOK_OK;
}
nook_status nook_bvh_begin(nook_bvh_state *s, nook_bvh *bvh, const nook_view *view, nook_boxes *boxes,
                           nook_index *order, nook_where *where) {
    if (s == NULL || bvh == NULL || view == NULL || boxes == NULL) return NOOK_NULL_ARGUMENT;
    memset(bvh, 0, sizeof *bvh);
    bvh->view = *view;
    bvh->order = order;
    return begin(s, bvh, boxes, order, where);
}

nook_status nook_bvh_refit_begin(nook_bvh_state *s, nook_bvh *bvh, nook_boxes *boxes, nook_where *where) {
    if (s == NULL || bvh == NULL || boxes == NULL) return NOOK_NULL_ARGUMENT;
    return begin(s, bvh, boxes, NULL, where);
}

static void begin_phase(nook_bvh_state *s, uint32_t phase, uint32_t at, uint32_t end) {
    s->phase = end == 1u && phase == GROUPS ? BUILT : phase;
    s->at = at;
    s->end = end;
}

/* What comes when a phase has gone through all of its elements. */
static void after(nook_bvh_state *s) {
    uint32_t nt = s->bvh->view.nt;
    switch (s->phase) {
    case LOOK:
        set_grid(s);
        begin_phase(s, s->order != NULL ? CUT : LEAVES, 0, nt);
        break;
    case MEASURE: begin_phase(s, ASSIGN, s->from, s->to); break;
    case ASSIGN:
        nothing(s);
        begin_phase(s, EXTENT, s->from, s->to);
        s->fresh = true;
        break;
    case EXTENT: after_extent(s); break;
    case PART: after_part(s); break;
    case LEAVES: begin_phase(s, GROUPS, 0, (nt + 15u) / 16u); break;
    default:
        s->base += s->end;
        begin_phase(s, GROUPS, 0, (s->end + 3u) / 4u);
        break;
    }
}

static nook_status work(nook_bvh_state *s, uint32_t end) {
    switch (s->phase) {
    case LOOK: return look(s, end);
    case MEASURE: measure(s, end); break;
    case ASSIGN: assign(s, end); break;
    case EXTENT: extent(s, end); break;
    case PART: part(s, end); break;
    case LEAVES: leaves(s, end); break;
    default: groups(s, end); break;
    }
    return NOOK_OK;
}

nook_status nook_bvh_step(nook_bvh_state *s, uint32_t *units) {
    while (s->phase != BUILT) {
        uint32_t some = s->phase == CUT ? 1u : s->end - s->at;
        nook_status status = NOOK_OK;
        if (*units == 0) return NOOK_MORE;
        if (some > *units) some = *units;
        *units -= some;
        if (s->phase == CUT) {
            begin_cut(s);
            continue;
        }
        status = work(s, s->at + some);
        if (status != NOOK_OK) return status;
        if (s->at == s->end) after(s);
    }
    return NOOK_OK;
}

nook_status nook_bvh_build(nook_bvh *bvh, const nook_view *view, nook_boxes *boxes, nook_index *order,
                           nook_where *where) {
    nook_bvh_state state;
    nook_status status = nook_bvh_begin(&state, bvh, view, boxes, order, where);
    if (status != NOOK_OK) return status;
    do {
        uint32_t units = 1u << 10;
        status = nook_bvh_step(&state, &units);
    } while (status == NOOK_MORE);
    return status;
}

/* ---- descent -------------------------------------------------------------------------------------- */

float nook_descent_least(const nook_descent *d, const nook_bvh *bvh, float bound) {
    uint32_t most = d->now, level = d->level;
    float found;
    for (level += d->now != NOOK_UP; level <= bvh->levels; level++) {
        uint32_t entry = d->rest[level][0] & 0xFFFFu;
        if (entry > most) most = entry;
    }
    found = nook_float_from((0xFFFFu - most) >> 2 << 17);
    return found < bound ? found : bound;
}
