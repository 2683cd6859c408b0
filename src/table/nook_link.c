/* nook_link.c -- find the opposite corner of every corner.
 *
 * Insert. Each edge hangs on a list kept at the smaller of its two vertices; C holds the heads. The
 * lists are threaded through O, so there is no other memory. The first corner met on an edge, its
 * leader, stays in the list; every later one leaves it and points at the leader:
 *
 *     O[leader] > leader   the next leader in the list, a later corner      (or itself: the end)
 *     O[member] < member   the leader of its edge
 *
 * so that one look tells which is which. (Tails, below, are brought into this order before pairing.) A hub with thousands of edges must not make this quadratic:
 * after LOOKS leaders an edge is put behind them unsearched, and such tails are merge-sorted in
 * their own links afterwards, O(n log n) whatever the labels and valences.
 *
 * Pair. Going through the corners in ascending order, each member joins the ring of its leader:
 * a border edge is a ring of one, a matched edge a ring of two, and that is O. A sound mesh is
 * finished here, its edges counted on the way.
 *
 * Only if some edge is incoherent or non-manifold, two triangles are twins, or somebody wants to hear of
 * border edges: a
 * census of the rings, the survey while O still pairs incoherent edges, and a last pass that cuts
 * all but the matched ones. */
#include "table/nook_link.h"

#include <string.h>

enum { LOOKS = 16 };
enum flags { SUSPECT = 1, LONG_LIST = 2 };
enum phase { HEADS, INSERT, TAILS, PAIR, MARKS, CENSUS, SURVEY, CUT, FINISHED, FAILED };
enum inner { SORT_TAIL = FAILED + 1, SPLIT_TAIL, RING, RING_AGAIN }; /* inside TAILS and CENSUS */

static nook_status fail(nook_link_state *s, nook_status status, nook_kind kind, uint32_t index) {
    s->where = nook_at(kind, index);
    s->phase = FAILED;
    s->at = (uint32_t)status;
    return status;
}

/* The sum of the ends of the edge that c faces: of the triangle's vertices less that of c. */
static inline uint32_t edge_sum(const nook_index *V, uint32_t c) {
    const nook_index *t = V + (size_t)3u * nook_triangle(c);
    return (uint32_t)t[0] + t[1] + t[2] - V[c];
}

/* Whether two corners that face the same edge run it in opposite directions. */
static inline bool coherent(const nook_index *V, uint32_t c, uint32_t o) {
    return V[nook_next(c)] == V[nook_prev(o)];
}

/* Whether c is at the largest vertex of its triangle. */
static inline bool is_highest(const nook_index *V, uint32_t c) {
    return V[c] > V[nook_next(c)] && V[c] > V[nook_prev(c)];
}

/* ---- insert ----------------------------------------------------------------------------------- */

/* The tables and counts of a pass, where the compiler can keep them in registers. */
typedef struct tally {
    const nook_index *V;
    nook_index *O, *head;
    uint32_t edges, flags;
} tally;

static tally tally_of(const nook_link_state *s) {
    tally n = {s->mesh->V, s->mesh->O, s->mesh->C, 0, 0};
    return n;
}

static void keep(nook_link_state *s, const tally *n) {
    if (s->report != NULL) s->report->edges += n->edges;
    s->flags |= n->flags;
}

/* c lies on the edge of leader x: it leaves the lists and points at x. What a sound mesh does not
 * have makes the mesh suspect: an edge run twice in the same direction, twins with the same tip. */
static inline void join(tally *n, uint32_t c, uint32_t x, uint32_t from) {
    n->O[c] = nook_store(x);
    n->flags |= (uint32_t)(n->V[nook_next(x)] == from) | (uint32_t)(n->V[c] == n->V[x]);
}

/* c leads an edge and is the end of its list, or stands alone. */
static inline void lead(tally *n, uint32_t c) {
    n->O[c] = nook_store(c);
    n->edges++;
}

/* Hang corner c, which faces the edge from -> to, on the list of the smaller vertex. At most LOOKS
 * looks, since a tail is not searched. All edges of a list have that vertex, so two are equal if the
 * sums of their ends are. */
static inline void insert(tally *n, uint32_t c, uint32_t from, uint32_t to) {
    uint32_t low = from < to ? from : to, ends = from + to;
    uint32_t x = n->head[low], looks = LOOKS, next;
    if (x == NOOK_STORED_NONE) {
        n->head[low] = nook_store(c);
        lead(n, c);
        return;
    }
    for (;;) {
        if (edge_sum(n->V, x) == ends) {
            join(n, c, x, from);
            return;
        }
        next = n->O[x];
        if (--looks == 0) break;
        if (next == x) {
            n->O[x] = nook_store(c);
            lead(n, c);
            return;
        }
        x = next;
    }
    n->O[x] = nook_store(c);
    n->O[c] = nook_store(next == x ? c : next);
    n->flags |= LONG_LIST;
}

/* The corner of t that cannot be used, or the triangle itself. */
static nook_status bad_triangle(nook_link_state *s, uint32_t t) {
    uint32_t c;
    for (c = 3u * t; c < 3u * t + 3u; c++) {
        if (s->mesh->V[c] >= s->mesh->nv) return fail(s, NOOK_INDEX_OUT_OF_RANGE, NOOK_AT_CORNER, c);
    }
    return fail(s, NOOK_REPEATED_VERTEX, NOOK_AT_TRIANGLE, t);
}

static nook_status insert_triangles(nook_link_state *s, uint32_t t, uint32_t end) {
    tally n = tally_of(s);
    uint32_t nv = s->mesh->nv, c, last, from;
    for (; t < end; t++) {
        uint32_t v0 = n.V[3u * t], v1 = n.V[3u * t + 1u], v2 = n.V[3u * t + 2u];
        if (v0 >= nv || v1 >= nv || v2 >= nv || v0 == v1 || v1 == v2 || v2 == v0) return bad_triangle(s, t);
        for (c = 3u * t, last = c + 2u; c <= last; c++) {
            insert(&n, c, v1, v2);
            from = v1; /* turn the triangle, so that the next corner is the first */
            v1 = v2;
            v2 = v0;
            v0 = from;
        }
    }
    keep(s, &n);
    return NOOK_OK;
}

/* ---- tails ------------------------------------------------------------------------------------ */

/* If the list of vertex v is longer than was searched, cut off its tail to have it sorted. */
static void find_tail(nook_link_state *s, uint32_t v) {
    nook_index *O = s->mesh->O, x = s->mesh->C[v];
    uint32_t i;
    if (x == NOOK_STORED_NONE) return;
    for (i = 1; i < LOOKS && O[x] != x; i++) x = O[x];
    if (O[x] == x) return;
    nook_sort_begin(&s->in.sort, O[x]);
    O[x] = x;
    s->phase = SORT_TAIL;
}

/* Whether y must come before x: by the other end of the edge, then by corner. */
static inline bool edge_before(const void *vertices, uint32_t y, uint32_t x) {
    const nook_index *V = vertices;
    uint32_t a = edge_sum(V, y), b = edge_sum(V, x);
    return a != b ? a < b : y < x;
}

static void sort_tail(nook_link_state *s, uint32_t *units) {
    bool sorted = false;
    for (; *units != 0 && !sorted; --*units) {
        sorted = nook_sort_step(&s->in.sort, s->mesh->O, s->mesh->V, edge_before);
    }
    if (!sorted) return;
    s->list = s->in.sort.head;
    s->leader = NOOK_NONE;
    s->phase = SPLIT_TAIL;
}

/* In a sorted tail equal edges are neighbours and the smallest corner comes first: it leads. */
static void split_tail(nook_link_state *s) {
    tally n = tally_of(s);
    uint32_t x = s->list;
    s->list = nook_list_next(n.O, x);
    if (s->leader != NOOK_NONE && edge_sum(n.V, s->leader) == edge_sum(n.V, x)) {
        join(&n, x, s->leader, n.V[nook_next(x)]);
    } else {
        lead(&n, x);
        s->leader = x;
    }
    keep(s, &n);
    if (s->list == NOOK_NONE) s->phase = TAILS;
}

/* ---- pair ------------------------------------------------------------------------------------- */

/* A leader stands alone; a member takes its place in its leader's ring. C gets its corners. */
static void pair_corners(nook_link_state *s, uint32_t b, uint32_t end) {
    tally n = tally_of(s);
    uint32_t thirds = 0;
    for (; b < end; b++) {
        uint32_t x = n.O[b], y;
        n.head[n.V[b]] = nook_store(b);
        if (x >= b) {
            n.O[b] = nook_store(b);
            continue;
        }
        y = n.O[x];
        n.O[b] = nook_store(y);
        n.O[x] = nook_store(b);
        thirds |= y ^ x;
    }
    if (thirds != 0) s->flags |= SUSPECT;
}

/* Edges were counted when inserted. If none has a third corner or runs one way twice, the corners
 * that do not lead were all matched, and the report is complete. */
static void pairs_done(nook_link_state *s) {
    nook_report *r = s->report;
    uint32_t members;
    bool wants_to_hear = s->finder != NULL && s->finder->found != NULL;
    if (r == NULL) {
        s->phase = FINISHED;
        return;
    }
    members = 3u * s->mesh->nt - r->edges;
    if ((s->flags & SUSPECT) || (wants_to_hear && r->edges != members)) return;
    r->border_edges = r->odd_edges = r->edges - members;
    r->matched_edges = members;
    s->phase = FINISHED;
}

/* ---- census ----------------------------------------------------------------------------------- */

static void duplicate(nook_link_state *s, uint32_t c) {
    s->report->duplicate_triangles++;
    nook_tell(s->finder, NOOK_DUPLICATE_TRIANGLE, NOOK_AT_TRIANGLE, nook_triangle(c));
}

static void count_edge(nook_link_state *s, uint32_t *counter, nook_status defect, uint32_t c) {
    ++*counter;
    nook_tell(s->finder, defect, NOOK_AT_CORNER, c);
}

static void count_pair(nook_link_state *s, uint32_t c, uint32_t o) {
    const nook_index *V = s->mesh->V;
    if (V[c] == V[o] && is_highest(V, c)) duplicate(s, o); /* once, at one of its three edges */
    if (coherent(V, c, o)) {
        s->report->matched_edges++;
    } else {
        count_edge(s, &s->report->incoherent_edges, NOOK_INCOHERENT_EDGE, c);
    }
}

/* The ring of corner c, if c leads it: leaders alone point forward, or at themselves. */
static void count_ring(nook_link_state *s, uint32_t c) {
    nook_report *r = s->report;
    const nook_index *O = s->mesh->O;
    uint32_t o = O[c];
    if (o < c) return;
    if (o == c) {
        r->odd_edges++;
        count_edge(s, &r->border_edges, NOOK_BORDER_EDGE, c);
    } else if (O[o] == c) {
        count_pair(s, c, o);
    } else {
        count_edge(s, &r->nonmanifold_edges, NOOK_NONMANIFOLD_EDGE, c);
        s->phase = RING;
        s->list = s->leader = c;
        s->corners = 0;
    }
}

/* One corner of a ring of three or more. First round: its tip is marked, and a tip met again is a
 * duplicate triangle; only tips beyond the edge, so that a set of vertices counts at one of its
 * edges. Second round: the marks are wiped. */
static void walk_ring(nook_link_state *s) {
    uint32_t c = s->list, tip = s->mesh->V[c];
    bool again = s->phase == RING_AGAIN;
    s->corners++;
    if (s->marks.Mv != NULL && again) {
        nook_clear_bit(s->marks.Mv, tip);
    } else if (s->marks.Mv != NULL && is_highest(s->mesh->V, c)) {
        if (nook_bit(s->marks.Mv, tip)) duplicate(s, c);
        nook_set_bit(s->marks.Mv, tip);
    }
    s->list = s->mesh->O[c];
    if (s->list != s->leader) return;
    if (!again) s->report->odd_edges += s->corners & 1u;
    s->phase = again ? CENSUS : RING_AGAIN;
}

/* A mesh with other defects than borders is surveyed before it is cut. */
static nook_status begin_survey(nook_link_state *s) {
    nook_report *r = s->report;
    nook_view view = nook_view_of(s->mesh);
    nook_index *rings = r->nonmanifold_edges != 0 ? s->mesh->O : NULL;
    if (rings == NULL && r->incoherent_edges == 0) {
        s->phase = FINISHED;
    } else if (s->marks.Mt != NULL) {
        return nook_survey_begin(&s->in.survey, &view, rings, &s->marks, s->shells, s->finder, &r->survey);
    } else {
        if (rings != NULL) r->duplicate_triangles = NOOK_UNKNOWN;
        s->phase = CUT;
    }
    return NOOK_OK;
}

static nook_status survey(nook_link_state *s, uint32_t *units) {
    nook_status status = nook_survey_step(&s->in.survey, units);
    if (status == NOOK_OK) s->phase = CUT;
    return status == NOOK_OK || status == NOOK_MORE ? NOOK_OK : fail(s, status, NOOK_NOWHERE, 0);
}

/* Everything but a coherent pair becomes its own opposite. Corners of an edge with three triangles
 * or more are never mutual, in their rings or as the survey leaves them. */
static void cut(nook_link_state *s, uint32_t c) {
    nook_index *O = s->mesh->O;
    uint32_t o = O[c];
    if (O[o] == c && coherent(s->mesh->V, c, o)) return;
    if (O[o] == c) O[o] = nook_store(o);
    O[c] = nook_store(c);
}

/* ---- passes ----------------------------------------------------------------------------------- */

/* How many items the pass has. */
static uint32_t length(const nook_link_state *s) {
    switch (s->phase) {
    case HEADS:
    case TAILS: return s->mesh->nv;
    case INSERT: return s->mesh->nt;
    case MARKS: return s->marks.Mv != NULL ? (uint32_t)NOOK_MV_BYTES(s->mesh->nv) : 0;
    case PAIR:
    case CENSUS:
    case CUT: return 3u * s->mesh->nt;
    default: return NOOK_NONE;
    }
}

static nook_status next_pass(nook_link_state *s) {
    s->at = 0;
    s->phase++;
    if (s->phase == TAILS && !(s->flags & LONG_LIST)) s->phase = PAIR;
    if (s->phase == MARKS) pairs_done(s);
    return s->phase == SURVEY ? begin_survey(s) : NOOK_OK;
}

static void work(nook_link_state *s) {
    switch (s->phase) {
    case TAILS: find_tail(s, s->at++); return;
    case SPLIT_TAIL: split_tail(s); return;
    case MARKS: s->marks.Mv[s->at++] = 0; return;
    case CENSUS: count_ring(s, s->at++); return;
    case CUT: cut(s, s->at++); return;
    default: walk_ring(s); return;
    }
}

/* Up to *units items of one pass; the passes that every mesh goes through have loops of their own. */
static nook_status advance(nook_link_state *s, uint32_t *units) {
    uint32_t at = s->at, left = length(s) - at, count = *units < left ? *units : left;
    if (left == 0) return next_pass(s);
    if (s->phase == SURVEY) return survey(s, units);
    if (s->phase == SORT_TAIL) {
        sort_tail(s, units);
        return NOOK_OK;
    }
    if (s->phase != HEADS && s->phase != INSERT && s->phase != PAIR) {
        --*units;
        work(s);
        return NOOK_OK;
    }
    *units -= count;
    s->at += count;
    if (s->phase == INSERT) return insert_triangles(s, at, s->at);
    if (s->phase == PAIR) {
        pair_corners(s, at, s->at);
    } else {
        memset(s->mesh->C + at, 0xFF, count * sizeof *s->mesh->C);
    }
    return NOOK_OK;
}

nook_status nook_link_step(nook_link_state *s, uint32_t *units) {
    while (s->phase != FINISHED) {
        nook_status status;
        if (s->phase == FAILED) return (nook_status)s->at;
        if (*units == 0) return NOOK_MORE;
        status = advance(s, units);
        if (status != NOOK_OK) return status;
    }
    return NOOK_OK;
}

nook_status nook_link_rings_begin(nook_link_state *s, nook_mesh *mesh) {
    if (s == NULL || mesh == NULL) return NOOK_NULL_ARGUMENT;
    memset(s, 0, sizeof *s);
    s->mesh = mesh;
    s->phase = HEADS;
    return NOOK_OK;
}

nook_status nook_link_begin(nook_link_state *s, nook_mesh *mesh, const nook_marks *marks, nook_shells *shells,
                            const nook_finder *finder, nook_report *report) {
    if (s == NULL || mesh == NULL || report == NULL) return NOOK_NULL_ARGUMENT;
    memset(s, 0, sizeof *s);
    fail(s, NOOK_NULL_ARGUMENT, NOOK_NOWHERE, 0);
    if (marks != NULL) {
        if (marks->Mt == NULL || marks->Mv == NULL) return NOOK_NULL_ARGUMENT;
        if (marks->max_nt < mesh->nt || marks->max_nv < mesh->nv) return NOOK_NO_CAPACITY;
        s->marks = *marks;
    }
    if (nook_shells_status(shells, mesh->nt) != NOOK_OK) return NOOK_NULL_ARGUMENT;
    if (shells != NULL) shells->count = 0;
    memset(report, 0, sizeof *report);
    report->triangles = mesh->nt;
    nook_survey_unknown(&report->survey);
    s->mesh = mesh;
    s->report = report;
    s->finder = finder;
    s->shells = shells;
    s->phase = HEADS;
    s->at = 0;
    return NOOK_OK;
}

nook_status nook_link(nook_mesh *mesh, const nook_marks *marks, nook_shells *shells,
                      const nook_finder *finder, nook_report *report, nook_where *where) {
    nook_link_state state;
    uint32_t units;
    nook_status status = nook_link_begin(&state, mesh, marks, shells, finder, report);
    if (where != NULL) *where = nook_at(NOOK_NOWHERE, 0);
    if (status != NOOK_OK) return status;
    do {
        units = 1u << 12; /* any number gives the same */
        status = nook_link_step(&state, &units);
    } while (status == NOOK_MORE);
    if (where != NULL) *where = state.where;
    return status;
}
