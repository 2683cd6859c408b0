/* nook_bvh.c -- the order of the triangles from the top down, then the boxes from the bottom up. */
#include "query/nook_bvh.h"

#include "query/nook_descent.h"

/* While the order is made the boxes hold a key a triangle: the cell of its centre in a cube around what is being cut, a
 * few bits along each axis. */
enum { KEY_BITS = NOOK_BOUND_BITS == 8 ? 5 : 10, KEY_MOST = (1 << KEY_BITS) - 1 };
/* What spans fewer cells gets keys of its own. */
enum { NARROW = 6 };

enum { LOOK, CUT, MEASURE, ASSIGN, EXTENT, PART, LEAVES, GROUPS, BUILT };

static inline uint32_t key_at(const nook_bound *keys, uint32_t i) {
    const nook_bound *at = keys + (size_t)2 * i;
    return at[0] | (uint32_t)at[1] << NOOK_BOUND_BITS;
}

static inline void set_key(nook_bound *keys, uint32_t i, uint32_t key) {
    nook_bound *at = keys + (size_t)2 * i;
    at[0] = (nook_bound)key;
    at[1] = (nook_bound)(key >> NOOK_BOUND_BITS);
}

static void begin_phase(nook_bvh_state *s, uint32_t phase, uint32_t at, uint32_t end) {
    s->phase = end == 1u && phase == GROUPS ? BUILT : phase;
    s->at = at;
    s->end = end;
}

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

/* Whether the triangles can be used, their places in the order, and their box. */
static nook_status look(nook_bvh_state *s, uint32_t end) {
    const nook_view *m = &s->bvh->view;
    nook_point low = s->low, high = s->high;
    for (; s->at < end; s->at++) {
        uint32_t t = s->at, c;
        for (c = 3u * t; c < 3u * t + 3u; c++) {
            uint32_t v = m->V[c];
            const nook_point *p = &m->G[v];
            if (v >= m->nv) return refuse(s, NOOK_INDEX_OUT_OF_RANGE, NOOK_AT_CORNER, c);
            low = nook_low(low, *p), high = nook_high(high, *p);
            if (is_good(p->x) && is_good(p->y) && is_good(p->z)) continue;
            return refuse(s, nook_point_status(*p), NOOK_AT_VERTEX, v);
        }
        if (s->order != NULL) s->order[t] = nook_store(t);
        if (nook_triangle_at(s->bvh, t) >= m->nt)
            return refuse(s, NOOK_INDEX_OUT_OF_RANGE, NOOK_AT_TRIANGLE, t);
    }
    s->low = low, s->high = high;
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
    s->low = nook_scaled(s->low, 2.0f); /* of twice the centres, to begin with */
    s->high = nook_scaled(s->high, 2.0f);
}

/* ---- order ---------------------------------------------------------------------------------------- */

/* On to the leaves after those from start, 2^height of them: they were the left half of something, or the right half, and
 * its right half, and so on, as high as their number is even. */
static void go_after(nook_bvh_state *s) {
    s->start += (uint32_t)1 << s->height;
    s->height = 0;
    while ((s->start >> s->height & 1u) == 0) s->height++;
}

/* Every 2^so many-th key tells the extent of what is to be cut: at most 64 keys do. */
static uint32_t stride(const nook_bvh_state *s) { return s->height > 4u ? s->height - 4u : 0; }

/* The leaves from start, 2^height of them or as many as there are, are to be cut in halves, down to one leaf. */
static void begin_cut(nook_bvh_state *s) {
    uint32_t nt = s->bvh->view.nt, end = (s->start + ((uint32_t)1 << s->height)) * 4u;
    s->from = s->at = s->start * 4u;
    s->to = end < nt ? end : nt;
    s->middle = (s->start + ((uint32_t)1 << s->height >> 1)) * 4u;
    if (s->from >= nt) {
        nothing(s);
        begin_phase(s, LEAVES, 0, nt);
    } else if (s->height == 0) {
        go_after(s);
    } else if (s->middle >= s->to) {
        s->height--;
    } else if (s->fresh) { /* the very first */
        begin_phase(s, ASSIGN, s->from, s->to);
        s->fresh = false;
    } else {
        nothing(s);
        begin_phase(s, EXTENT, 0, ((s->to - s->from - 1u) >> stride(s)) + 1u);
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

/* Cells a unit of length in the cube. */
static float key_cells(const nook_bvh_state *s) { return (float)KEY_MOST / (longest(s) + 0x1p-80f); }

static uint32_t key_part(float x, float low, float cells) { return (uint32_t)((x - low) * cells + 0.5f); }

static void assign(nook_bvh_state *s, uint32_t end) {
    nook_bound *keys = (nook_bound *)s->boxes;
    nook_point low = s->low;
    float cells = key_cells(s);
    uint32_t i;
    for (i = s->at; i < end; i++) {
        nook_point p = centre_of(s, s->order[i]);
        set_key(keys, i,
                key_part(p.x, low.x, cells) | key_part(p.y, low.y, cells) << KEY_BITS |
                    key_part(p.z, low.z, cells) << 2 * KEY_BITS);
    }
    s->at = end;
}

static inline void widen_span(uint32_t part, uint32_t *least, uint32_t *most) {
    *least = part < *least ? part : *least;
    *most = part > *most ? part : *most;
}

static void extent(nook_bvh_state *s, uint32_t end) {
    const nook_bound *keys = (const nook_bound *)s->boxes;
    const uint32_t mask = KEY_MOST << KEY_BITS;
    uint32_t step = stride(s), i, x = s->least[0], y = s->least[1] << KEY_BITS, z = s->least[2],
             u = s->most[0], v = s->most[1] << KEY_BITS, w = s->most[2];
    for (i = s->at; i < end; i++) {
        uint32_t key = key_at(keys, s->from + (i << step));
        widen_span(key & KEY_MOST, &x, &u);
        widen_span(key & mask, &y, &v);
        widen_span(key >> 2 * KEY_BITS, &z, &w);
    }
    s->least[0] = x, s->least[1] = y >> KEY_BITS, s->least[2] = z;
    s->most[0] = u, s->most[1] = v >> KEY_BITS, s->most[2] = w;
    s->at = end;
}

/* The triangles whose keys are at most pivot come first. */
static void part(nook_bvh_state *s, uint32_t end) {
    nook_bound *keys = (nook_bound *)s->boxes;
    nook_index *order = s->order;
    uint32_t i, left = s->left, shift = s->axis * KEY_BITS, mask = (uint32_t)KEY_MOST << shift,
                pivot = s->pivot << shift;
    for (i = s->at; i < end; i++) {
        uint32_t key = key_at(keys, i);
        nook_index t = order[i];
        set_key(keys, i, key_at(keys, left));
        order[i] = order[left];
        set_key(keys, left, key);
        order[left] = t;
        left += (key & mask) <= pivot;
    }
    s->at = end;
    s->left = left;
}

/* At the middle of the cells that are left, or at a quarter of them if the place of the cut is near that end. */
static void begin_part(nook_bvh_state *s) {
    uint32_t least = s->least[s->axis], most = s->most[s->axis], some = (s->last - s->first) >> 2;
    s->pivot = (least + most) >> 1;
    if (s->middle - s->first < some) s->pivot = least + ((most - least) >> 2);
    if (s->last - s->middle < some) s->pivot = most - ((most - least) >> 2) - 1u;
    s->left = s->first;
    begin_phase(s, PART, s->first, s->last);
}

/* What is to be cut is to be parted along the axis of the largest extent, which is returned. */
static uint32_t choose_axis(nook_bvh_state *s) {
    uint32_t axis, most = 0;
    s->axis = 0;
    for (axis = 0; axis < 3u; axis++) {
        uint32_t span = s->most[axis] - s->least[axis];
        if (span > most) most = span, s->axis = axis;
    }
    s->first = s->from;
    s->last = s->to;
    return most;
}

/* Keys in a cube are known to reach from one end to the other. */
static void after_assign(nook_bvh_state *s) {
    float cells = key_cells(s);
    uint32_t axis;
    for (axis = 0; axis < 3u; axis++) {
        s->least[axis] = 0;
        s->most[axis] = key_part(nook_along(&s->high, axis), nook_along(&s->low, axis), cells);
    }
    if (choose_axis(s) != 0) {
        begin_part(s);
    } else { /* all in one place */
        go_after(s);
        s->phase = CUT;
    }
}

/* Too few cells do not tell much. */
static void after_extent(nook_bvh_state *s) {
    if (choose_axis(s) < NARROW) {
        nothing(s);
        begin_phase(s, MEASURE, s->from, s->to);
    } else {
        begin_part(s);
    }
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

static void end_leaf(nook_bvh_state *s, uint32_t leaf) {
    nook_boxes *group = &s->boxes[leaf >> 2];
    uint32_t axis;
    if ((leaf & 3u) == 0) clear_group(group);
    for (axis = 0; axis < 3u; axis++) {
        group->low[axis][leaf & 3u] = (nook_bound)nook_cell(s->bvh, nook_along(&s->low, axis), axis);
        group->high[axis][leaf & 3u] = (nook_bound)nook_cell(s->bvh, nook_along(&s->high, axis), axis);
    }
    nothing(s);
}

static void leaves(nook_bvh_state *s, uint32_t end) {
    const nook_bvh *bvh = s->bvh;
    for (; s->at < end; s->at++) {
        nook_point low, high;
        if (s->at < bvh->view.nt) { /* else there is room for more */
            nook_box(&bvh->view, nook_triangle_at(bvh, s->at), &low, &high);
            widen(s, low, high);
        }
        if ((s->at & 3u) == 3u || s->at + 1u == bvh->places) end_leaf(s, s->at >> 2);
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
            nook_bound low = from->low[axis][0], high = from->high[axis][0];
            for (i = 1; i < 4u; i++) {
                low = from->low[axis][i] < low ? from->low[axis][i] : low;
                high = from->high[axis][i] > high ? from->high[axis][i] : high;
            }
            group->low[axis][s->at & 3u] = low;
            group->high[axis][s->at & 3u] = high;
        }
    }
}

/* ---- steps ---------------------------------------------------------------------------------------- */

static nook_status begin(nook_bvh_state *s, nook_bvh *bvh, nook_boxes *boxes, nook_index *order,
                         nook_where *where) {
    uint32_t nt = bvh->view.nt, places = bvh->places;
    memset(s, 0, sizeof *s);
    s->bvh = bvh;
    s->boxes = boxes;
    bvh->boxes = boxes;
    s->order = order;
    s->where = where;
    s->end = nt;
    if (nt == 0) return refuse(s, NOOK_EMPTY_MESH, NOOK_NOWHERE, 0);
    bvh->stray = 0;
    for (bvh->levels = 1; nook_groups_of_level(places, bvh->levels) > 1u; bvh->levels++)
        bvh->base[bvh->levels + 1u] =
            nook_store(bvh->base[bvh->levels] + nook_groups_of_level(places, bvh->levels));
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
    bvh->places = view->nt;
    return begin(s, bvh, boxes, order, where);
}

nook_status nook_bvh_refit_begin(nook_bvh_state *s, nook_bvh *bvh, nook_boxes *boxes, nook_where *where) {
    if (s == NULL || bvh == NULL || boxes == NULL) return NOOK_NULL_ARGUMENT;
    return begin(s, bvh, boxes, NULL, where);
}

/* What comes when a phase has gone through all of its elements. */
static void after(nook_bvh_state *s) {
    uint32_t places = s->bvh->places;
    switch (s->phase) {
    case LOOK:
        set_grid(s);
        if (s->order == NULL) nothing(s);
        begin_phase(s, s->order != NULL ? CUT : LEAVES, 0, places);
        break;
    case MEASURE: begin_phase(s, ASSIGN, s->from, s->to); break;
    case ASSIGN: after_assign(s); break;
    case EXTENT: after_extent(s); break;
    case PART: after_part(s); break;
    case LEAVES: begin_phase(s, GROUPS, 0, (places + 15u) / 16u); break;
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

static nook_status finish(nook_bvh_state *s) {
    nook_status status;
    do {
        uint32_t units = 1u << 10;
        status = nook_bvh_step(s, &units);
    } while (status == NOOK_MORE);
    return status;
}

nook_status nook_bvh_build(nook_bvh *bvh, const nook_view *view, nook_boxes *boxes, nook_index *order,
                           nook_where *where) {
    nook_bvh_state state;
    nook_status status = nook_bvh_begin(&state, bvh, view, boxes, order, where);
    return status == NOOK_OK ? finish(&state) : status;
}

nook_status nook_bvh_refit(nook_bvh *bvh, nook_boxes *boxes, nook_where *where) {
    nook_bvh_state state;
    nook_status status = nook_bvh_refit_begin(&state, bvh, boxes, where);
    return status == NOOK_OK ? finish(&state) : status;
}

/* ---- widening -------------------------------------------------------------------------------------- */

static bool is_on_grid(const nook_bvh *bvh, float x, uint32_t axis) {
    float cell = (x - nook_along(&bvh->origin, axis)) * nook_along(&bvh->cells, axis);
    return cell >= 0 && cell < (float)NOOK_LAST_CELL + 1.0f;
}

void nook_bvh_widen(nook_bvh *bvh, nook_boxes *boxes, uint32_t t, const nook_point *const p[3]) {
    nook_point low = nook_low(nook_low(*p[0], *p[1]), *p[2]),
               high = nook_high(nook_high(*p[0], *p[1]), *p[2]);
    uint32_t level, axis, from[3], to[3];
    for (axis = 0; axis < 3u; axis++) {
        float least = nook_along(&low, axis), most = nook_along(&high, axis);
        from[axis] = nook_cell(bvh, least, axis);
        to[axis] = nook_cell(bvh, most, axis);
        if (!is_on_grid(bvh, least, axis) || !is_on_grid(bvh, most, axis)) bvh->stray = 0x1p100f;
    }
    for (level = 1; level <= bvh->levels; level++) {
        nook_boxes *group = &boxes[bvh->base[level] + (t >> 4)];
        t >>= 2;
        for (axis = 0; axis < 3u; axis++) {
            nook_bound *least = &group->low[axis][t & 3u], *most = &group->high[axis][t & 3u];
            *least = from[axis] < *least ? (nook_bound)from[axis] : *least;
            *most = to[axis] > *most ? (nook_bound)to[axis] : *most;
        }
    }
}

/* ---- descent -------------------------------------------------------------------------------------- */

float nook_descent_least(const nook_descent *d, float bound) {
    uint32_t most = d->now, level;
    float found;
    for (level = 1; d->open >> level != 0; level++) {
        uint32_t entry = d->rest[level - 1u][0] & 0xFFFFu;
        if ((d->open >> level & 1u) != 0 && entry > most) most = entry;
    }
    found = nook_float_from((0xFFFFu - most) >> 2 << 17);
    return found < bound ? found : bound;
}
