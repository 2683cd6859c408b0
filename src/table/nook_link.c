/* nook_link.c -- find the opposite corner of every corner.
 *
 * Insert. Each edge hangs on a list kept at the smaller of its two vertices; C holds the heads. The
 * lists are threaded through O, so there is no other memory. The first corner met on an edge, its
 * leader, stays in the list; every later one leaves it and points at the leader:
 *
 *     O[leader] > leader   the next leader in the list, a later corner      (or itself: the end)
 *     O[member] < member   the leader of its edge
 *
 * so that one look tells which is which. A hub with thousands of edges must not make this quadratic:
 * after LOOKS leaders an edge is put behind them unsearched, and such tails are merge-sorted in
 * their own links afterwards, O(n log n) whatever the labels and valences.
 *
 * Pair. Going through the corners in ascending order, each member joins the ring of its leader:
 * a border edge is a ring of one, a matched edge a ring of two, and that is O. A sound mesh is
 * finished here, its edges counted on the way.
 *
 * Only if some edge is incoherent or non-manifold, or somebody wants to hear of border edges: a
 * census of the rings, the survey while O still pairs incoherent edges, and a last pass that cuts
 * all but the matched ones. */
#include "table/nook_link.h"

#include <string.h>

enum { LOOKS = 16 };

enum phase {
    CLEAR_HEADS,
    INSERT,
    FIND_TAIL,
    SORT_TAIL,
    SPLIT_TAIL,
    PAIR,
    CLEAR_MARKS,
    CENSUS,
    MARK_RING,
    UNMARK_RING,
    FIND_RING,
    OPEN_RING,
    SURVEY,
    CUT,
    FINISHED,
    FAILED
};

static nook_status fail(nook_link_state *s, nook_status status, nook_where where)
{
    s->where = where;
    s->phase = FAILED;
    s->at = (uint32_t)status;
    return status;
}

static void tell(const nook_link_state *s, nook_status defect, nook_kind kind, uint32_t index)
{
    if (s->finder != NULL && s->finder->found != NULL) {
        s->finder->found(s->finder->user, defect, nook_at(kind, index));
    }
}

/* The two ends of the edge that c faces: from v(n(c)) to v(p(c)). */
static inline uint32_t edge_from(const nook_index *V, uint32_t c)
{
    return V[nook_next(c)];
}

static inline uint32_t edge_to(const nook_index *V, uint32_t c)
{
    return V[nook_prev(c)];
}

/* The sum of the ends of the edge that c faces: of the triangle's vertices less that of c. */
static inline uint32_t edge_sum(const nook_index *V, uint32_t c)
{
    const nook_index *t = V + (size_t)3u * nook_triangle(c);
    return (uint32_t)t[0] + t[1] + t[2] - V[c];
}

/* The larger vertex of the edge that c faces. */
static inline uint32_t edge_high(const nook_index *V, uint32_t c)
{
    uint32_t a = edge_from(V, c), b = edge_to(V, c);
    return a > b ? a : b;
}

/* The tables and counts of a pass, where the compiler can keep them in registers. */
typedef struct tally {
    const nook_index *V;
    nook_index *O, *head;
    uint32_t edges, flags;
} tally;

enum { SUSPECT = 1, LONG_LIST = 2 };

/* c lies on the edge of leader x: it leaves the lists and points at x. What a sound mesh does not
 * have makes the mesh suspect: an edge run twice in the same direction, twins with the same tip. */
static inline void join(tally *n, uint32_t c, uint32_t x, uint32_t from)
{
    n->O[c] = nook_store(x);
    n->flags |= (uint32_t)(edge_from(n->V, x) == from) | (uint32_t)(n->V[c] == n->V[x]);
}

/* c leads an edge and is the end of its list, or stands alone. */
static inline void lead(tally *n, uint32_t c)
{
    n->O[c] = nook_store(c);
    n->edges++;
}

/* Hang corner c, which faces the edge from -> to, on the list of the smaller vertex. At most LOOKS
 * looks, since a tail is not searched. All edges of a list have that vertex, so two are equal if the
 * sums of their ends are. */
static inline void insert(tally *n, uint32_t c, uint32_t from, uint32_t to)
{
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

static void clear_heads(nook_link_state *s, uint32_t count)
{
    memset(s->mesh->C + s->at, 0xFF, count * sizeof *s->mesh->C);
    s->at += count;
}

static nook_status bad_triangle(nook_link_state *s, uint32_t t)
{
    const nook_index *V = s->mesh->V;
    uint32_t c;
    for (c = 3u * t; c < 3u * t + 3u; c++) {
        if (V[c] >= s->mesh->nv) return fail(s, NOOK_INDEX_OUT_OF_RANGE, nook_at(NOOK_AT_CORNER, c));
    }
    return fail(s, NOOK_REPEATED_VERTEX, nook_at(NOOK_AT_TRIANGLE, t));
}

static tally tally_of(const nook_link_state *s)
{
    tally n = {s->mesh->V, s->mesh->O, s->mesh->C, 0, 0};
    return n;
}

static void keep(nook_link_state *s, const tally *n)
{
    s->report->edges += n->edges;
    s->flags |= n->flags;
}

static nook_status insert_triangles(nook_link_state *s, uint32_t count)
{
    tally n = tally_of(s);
    uint32_t t, from, end_c, end = s->at + count, nv = s->mesh->nv;
    for (t = s->at; t < end; t++) {
        uint32_t first = 3u * t, a = n.V[first], b = n.V[first + 1u], c = n.V[first + 2u];
        if (a >= nv || b >= nv || c >= nv || a == b || b == c || c == a) return bad_triangle(s, t);
        for (end_c = first + 3u; first < end_c; first++) {
            insert(&n, first, b, c);
            from = b; /* the next corner's triangle begins with its own vertex */
            b = c;
            c = a;
            a = from;
        }
    }
    s->at = end;
    keep(s, &n);
    return NOOK_OK;
}

/* If the list of vertex v is longer than was searched, cut off its tail to have it sorted. */
static void find_tail(nook_link_state *s)
{
    nook_index *O = s->mesh->O;
    nook_index x = s->mesh->C[s->at++];
    uint32_t i;
    if (x == NOOK_STORED_NONE) return;
    for (i = 1; i < LOOKS && O[x] != x; i++) x = O[x];
    if (O[x] == x) return;
    nook_sort_begin(&s->in.sort, O[x]);
    O[x] = x;
    s->phase = SORT_TAIL;
}

/* Whether y must come before x: by the other end of the edge, then by corner. */
static inline bool edge_before(const void *vertices, uint32_t y, uint32_t x)
{
    const nook_index *V = vertices;
    uint32_t a = edge_sum(V, y), b = edge_sum(V, x);
    return a != b ? a < b : y < x;
}

static void sort_tail(nook_link_state *s, uint32_t *units)
{
    while (*units != 0) {
        --*units;
        if (!nook_sort_step(&s->in.sort, s->mesh->O, s->mesh->V, edge_before)) continue;
        s->list = s->in.sort.head;
        s->leader = NOOK_NONE;
        s->phase = SPLIT_TAIL;
        return;
    }
}

/* In a sorted tail equal edges are neighbours and the smallest corner comes first: it leads. */
static void split_tail(nook_link_state *s)
{
    tally n = tally_of(s);
    uint32_t x = s->list, next = nook_list_next(n.O, x);
    if (s->leader == NOOK_NONE || edge_sum(n.V, s->leader) != edge_sum(n.V, x)) {
        lead(&n, x);
        s->leader = x;
    } else {
        join(&n, x, s->leader, edge_from(n.V, x));
    }
    keep(s, &n);
    s->list = next;
    if (next == NOOK_NONE) s->phase = FIND_TAIL;
}

/* A leader stands alone; a member takes its place in its leader's ring. C gets its corners. */
static void pair_corners(nook_link_state *s, uint32_t count)
{
    tally n = tally_of(s);
    uint32_t b, end = s->at + count;
    uint32_t thirds = 0;
    for (b = s->at; b < end; b++) {
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
    s->at = end;
    if (thirds != 0) s->flags |= SUSPECT;
}

static bool coherent(const nook_index *V, uint32_t c, uint32_t o)
{
    return edge_from(V, c) == edge_to(V, o);
}

/* Edges were counted when inserted. If none has a third corner or runs one way twice, the corners
 * that do not lead were all matched, and the report is complete. */
static void pairs_done(nook_link_state *s)
{
    nook_report *r = s->report;
    uint32_t members = 3u * s->mesh->nt - r->edges;
    bool wants_to_hear = s->finder != NULL && s->finder->found != NULL;
    s->phase = CLEAR_MARKS;
    if (s->flags & SUSPECT) return;
    if (wants_to_hear && r->edges != members) return;
    r->border_edges = r->odd_edges = r->edges - members;
    r->matched_edges = members;
    s->phase = FINISHED;
}

/* A pair of triangles on the same three vertices counts once, at its edge of two smaller vertices. */
static void count_twins(nook_link_state *s, uint32_t c, uint32_t o)
{
    const nook_index *V = s->mesh->V;
    if (V[c] != V[o] || V[c] < edge_high(V, c)) return;
    s->report->duplicate_triangles++;
    tell(s, NOOK_DUPLICATE_TRIANGLE, NOOK_AT_TRIANGLE, nook_triangle(o));
}

/* The ring of corner c, if c leads it: leaders alone point forward, or at themselves. */
static void count_ring(nook_link_state *s, uint32_t c)
{
    nook_report *r = s->report;
    const nook_index *V = s->mesh->V, *O = s->mesh->O;
    uint32_t o = O[c];
    if (o < c) return;
    if (o == c) {
        r->border_edges++;
        r->odd_edges++;
        tell(s, NOOK_BORDER_EDGE, NOOK_AT_CORNER, c);
    } else if (O[o] != c) {
        r->nonmanifold_edges++;
        tell(s, NOOK_NONMANIFOLD_EDGE, NOOK_AT_CORNER, c);
        s->phase = MARK_RING;
        s->list = s->leader = c;
        s->corners = 0;
    } else {
        count_twins(s, c, o);
        if (coherent(V, c, o)) {
            r->matched_edges++;
        } else {
            r->incoherent_edges++;
            tell(s, NOOK_INCOHERENT_EDGE, NOOK_AT_CORNER, c);
        }
    }
}

/* One corner of a ring of three or more. Its tip is marked; a tip met again is a duplicate triangle.
 * Only tips beyond the edge count, so that each set of vertices counts at one of its edges. */
static void mark_ring(nook_link_state *s)
{
    const nook_index *V = s->mesh->V;
    uint32_t tip = V[s->list];
    s->corners++;
    if (s->marks.Mv != NULL && tip > edge_high(V, s->list)) {
        if (nook_bit(s->marks.Mv, tip)) {
            s->report->duplicate_triangles++;
            tell(s, NOOK_DUPLICATE_TRIANGLE, NOOK_AT_TRIANGLE, nook_triangle(s->list));
        }
        nook_set_bit(s->marks.Mv, tip);
    }
    s->list = s->mesh->O[s->list];
    if (s->list == s->leader) {
        s->report->odd_edges += s->corners & 1u;
        s->phase = UNMARK_RING;
    }
}

static void unmark_ring(nook_link_state *s)
{
    if (s->marks.Mv != NULL) nook_clear_bit(s->marks.Mv, s->mesh->V[s->list]);
    s->list = s->mesh->O[s->list];
    if (s->list == s->leader) s->phase = CENSUS;
}

/* After the census: what comes next, and what can no longer be known. */
static void census_done(nook_link_state *s)
{
    nook_report *r = s->report;
    bool rings = r->nonmanifold_edges != 0;
    if (!rings && r->incoherent_edges == 0) {
        s->phase = FINISHED;
    } else if (s->marks.Mt != NULL) {
        s->phase = FIND_RING;
    } else {
        s->phase = CUT;
        if (rings) r->duplicate_triangles = NOOK_UNKNOWN;
    }
}

static nook_status begin_survey(nook_link_state *s)
{
    nook_view view = nook_view_of(s->mesh);
    nook_index *lists = s->report->nonmanifold_edges != 0 ? s->mesh->O : NULL;
    s->phase = SURVEY;
    return nook_survey_begin(&s->in.survey, &view, lists, &s->marks, s->shells, s->finder, &s->report->survey);
}

/* A ring of three or more becomes a list that ends at itself: that is what the survey takes apart. */
static void find_ring(nook_link_state *s)
{
    const nook_index *O = s->mesh->O;
    uint32_t c = s->at++;
    if (O[c] <= c || O[O[c]] == c) return;
    s->list = s->leader = c;
    s->phase = OPEN_RING;
}

static void open_ring(nook_link_state *s)
{
    nook_index *O = s->mesh->O;
    uint32_t x = s->list;
    s->list = O[x];
    if (s->list != s->leader) return;
    O[x] = nook_store(x);
    s->phase = FIND_RING;
}

/* Everything but a coherent pair becomes its own opposite. Corners of an edge with three triangles
 * or more are never mutual, in their rings or as the survey leaves them. */
static void cut(nook_link_state *s)
{
    nook_index *O = s->mesh->O;
    uint32_t c = s->at++, o = O[c];
    if (O[o] == c && coherent(s->mesh->V, c, o)) return;
    if (O[o] == c) O[o] = nook_store(o);
    O[c] = nook_store(c);
}

/* The items of the pass; passes inside a list or ring end on their own. */
static uint32_t length(const nook_link_state *s)
{
    switch (s->phase) {
    case CLEAR_HEADS:
    case FIND_TAIL:
        return s->mesh->nv;
    case INSERT:
        return s->mesh->nt;
    case CLEAR_MARKS:
        return s->marks.Mv == NULL ? 0 : (uint32_t)NOOK_MV_BYTES(s->mesh->nv);
    case PAIR:
    case CENSUS:
    case FIND_RING:
    case CUT:
        return 3u * s->mesh->nt;
    default:
        return NOOK_NONE;
    }
}

static nook_status next_pass(nook_link_state *s)
{
    s->at = 0;
    switch (s->phase) {
    case CLEAR_HEADS:
        s->phase = INSERT;
        return NOOK_OK;
    case INSERT:
        s->phase = s->flags & LONG_LIST ? FIND_TAIL : PAIR;
        return NOOK_OK;
    case FIND_TAIL:
        s->phase = PAIR;
        return NOOK_OK;
    case PAIR:
        pairs_done(s);
        return NOOK_OK;
    case CLEAR_MARKS:
        s->phase = CENSUS;
        return NOOK_OK;
    case CENSUS:
        census_done(s);
        return NOOK_OK;
    case FIND_RING:
        return begin_survey(s);
    default:
        s->phase = FINISHED;
        return NOOK_OK;
    }
}

static nook_status survey(nook_link_state *s, uint32_t *units)
{
    nook_status status = nook_survey_step(&s->in.survey, units);
    if (status == NOOK_MORE) return NOOK_OK;
    if (status != NOOK_OK) return fail(s, status, nook_at(NOOK_NOWHERE, 0));
    s->phase = CUT;
    return NOOK_OK;
}

/* One item of a pass that is not worth a loop of its own. */
static void work(nook_link_state *s)
{
    switch (s->phase) {
    case FIND_TAIL:
        find_tail(s);
        return;
    case SPLIT_TAIL:
        split_tail(s);
        return;
    case CLEAR_MARKS:
        s->marks.Mv[s->at++] = 0;
        return;
    case CENSUS:
        count_ring(s, s->at++);
        return;
    case MARK_RING:
        mark_ring(s);
        return;
    case UNMARK_RING:
        unmark_ring(s);
        return;
    case FIND_RING:
        find_ring(s);
        return;
    case OPEN_RING:
        open_ring(s);
        return;
    default:
        cut(s);
        return;
    }
}

static nook_status advance(nook_link_state *s, uint32_t *units)
{
    uint32_t left = length(s) - s->at, count = *units < left ? *units : left;
    if (left == 0) return next_pass(s);
    if (s->phase == SURVEY) return survey(s, units);
    if (s->phase == SORT_TAIL) {
        sort_tail(s, units);
        return NOOK_OK;
    }
    *units -= count;
    if (s->phase == INSERT) return insert_triangles(s, count);
    if (s->phase == PAIR) {
        pair_corners(s, count);
        return NOOK_OK;
    }
    if (s->phase == CLEAR_HEADS) {
        clear_heads(s, count);
        return NOOK_OK;
    }
    *units += count - 1u;
    work(s);
    return NOOK_OK;
}

nook_status nook_link_step(nook_link_state *s, uint32_t *units)
{
    while (s->phase < FINISHED) {
        nook_status status;
        if (*units == 0) return NOOK_MORE;
        status = advance(s, units);
        if (status != NOOK_OK) return status;
    }
    return s->phase == FINISHED ? NOOK_OK : (nook_status)s->at;
}

static void empty_report(nook_report *report, uint32_t nt)
{
    memset(report, 0, sizeof *report);
    report->triangles = nt;
    report->survey.components = NOOK_UNKNOWN;
    report->survey.fans = NOOK_UNKNOWN;
    report->survey.nonmanifold_vertices = NOOK_UNKNOWN;
    report->survey.border_loops = NOOK_UNKNOWN;
    report->survey.orientable = NOOK_MAYBE;
}

nook_status nook_link_begin(nook_link_state *s, nook_mesh *mesh, const nook_marks *marks, nook_shells *shells,
                            const nook_finder *finder, nook_report *report)
{
    if (s == NULL || mesh == NULL || report == NULL) return NOOK_NULL_ARGUMENT;
    memset(s, 0, sizeof *s);
    s->phase = FAILED;
    s->at = (uint32_t)NOOK_NULL_ARGUMENT;
    if (marks != NULL) {
        if (marks->Mt == NULL || marks->Mv == NULL) return NOOK_NULL_ARGUMENT;
        if (marks->max_nt < mesh->nt || marks->max_nv < mesh->nv) return NOOK_NO_CAPACITY;
        s->marks = *marks;
    }
    empty_report(report, mesh->nt);
    s->mesh = mesh;
    s->report = report;
    s->finder = finder;
    s->shells = shells;
    s->phase = CLEAR_HEADS;
    s->at = 0;
    return NOOK_OK;
}

nook_status nook_link(nook_mesh *mesh, const nook_marks *marks, nook_shells *shells, const nook_finder *finder,
                      nook_report *report, nook_where *where)
{
    nook_link_state state;
    uint32_t units;
    nook_status status = nook_link_begin(&state, mesh, marks, shells, finder, report);
    if (where != NULL) *where = nook_at(NOOK_NOWHERE, 0);
    if (status != NOOK_OK) return status;
    do {
        units = UINT32_MAX;
        status = nook_link_step(&state, &units);
    } while (status == NOOK_MORE);
    if (where != NULL) *where = state.where;
    return status;
}
