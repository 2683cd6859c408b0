/* test_edit.c -- local operators, legal and refused, against what becomes of the list of triangles.
 *
 * The oracle does to the list of triangles what the operator says, without any adjacency, and links the result
 * anew: the operator must be legal exactly if that is a manifold of the same kind, with as many loops, handles and
 * parts; and then its tables must be those of the new list. Refusals must leave every byte as it was. The flip
 * is also tested by what it can reach: all triangulations of the sphere, of which the numbers are known. */
#include <string.h>

#include "lists.h"
#include "rooms.h"

/* ---- the operators on the list ------------------------------------------------------------------------- */

static bool list_flips(uint32_t c) {
    uint32_t a = list[c], d, t, o = b.mesh.O[c];
    if (o == c) return false;
    d = list[o];
    for (t = 0; t < listed; t++) {
        if (a == d || (list_has(t, a) && list_has(t, d))) return false;
    }
    list[nook_prev(c)] = nook_store(d);
    list[nook_prev(o)] = nook_store(a);
    return list_is_manifold(b.mesh.nv);
}

/* B becomes C, triangles with both go, and the last names fill the gaps as in the mesh; legal if what is left is a
 * manifold of the same kind. */
static bool list_collapses(uint32_t c) {
    uint32_t gone = list[nook_next(c)], stays = list[nook_prev(c)], i, t, last = b.mesh.nv - 1;
    nook_check_result before;
    CHECK(list_is_manifold(b.mesh.nv));
    before = list_result;
    for (t = 0; t < listed;) {
        if (list_has(t, gone) && list_has(t, stays)) {
            listed--;
            memmove(list + 3 * t, list + 3 * t + 3, 3 * (listed - t) * sizeof *list);
        } else {
            t++;
        }
    }
    for (i = 0; i < 3 * listed; i++) {
        if (list[i] == gone) list[i] = nook_store(stays);
        if (list[i] == last) list[i] = nook_store(gone);
    }
    if (listed == 0 || !list_is_manifold(b.mesh.nv - 1)) return false;
    return list_result.euler == before.euler &&
           list_result.survey.border_loops == before.survey.border_loops &&
           list_result.survey.components == before.survey.components && list_result.isolated_vertices == 0;
}

/* ---- every edge of every shape --------------------------------------------------------------------------- */

static void every_flip_is_legal_or_refused_as_the_list_says(void) {
    uint32_t i, c, legal = 0, refused = 0;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        keep();
        for (c = 0; c < 3 * b.mesh.nt; c++) {
            bool good;
            nook_status status;
            take_list();
            good = list_flips(c);
            status = nook_flip(&b.mesh, c, NULL);
            CHECK_EQUAL(status == NOOK_OK, good);
            if (good) {
                CHECK(memcmp(b.mesh.V, list, 3 * listed * sizeof *list) == 0);
                tables_hold();
                restore(b.mesh.nv, b.mesh.nt);
                legal++;
            } else {
                CHECK_EQUAL(status, b.mesh.O[c] == c ? NOOK_BORDER_EDGE : NOOK_DUPLICATE_EDGE);
                is_as_kept();
                refused++;
            }
        }
    }
    CHECK(legal > 50 && refused > 50);
    CHECK_EQUAL(nook_flip(&b.mesh, 3 * b.mesh.nt, NULL), NOOK_INDEX_OUT_OF_RANGE);
}

static uint32_t renamed_vertices, renamed_triangles, last_from, last_to;
static void hear(void *user, nook_kind kind, uint32_t from, uint32_t to) {
    (void)user;
    *(kind == NOOK_AT_VERTEX ? &renamed_vertices : &renamed_triangles) += 1;
    if (kind == NOOK_AT_VERTEX) last_from = from, last_to = to;
}
static const nook_edit listening = {.renamed = hear};

static void every_collapse_is_legal_or_refused_as_the_list_says(void) {
    uint32_t i, c, legal = 0, seen[NOOK_STATUS_COUNT];
    memset(seen, 0, sizeof seen);
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        keep();
        for (c = 0; c < 3 * b.mesh.nt; c++) {
            uint32_t nv = b.mesh.nv, nt = b.mesh.nt, gone = b.mesh.V[nook_next(c)],
                     stays = b.mesh.V[nook_prev(c)];
            bool good, border = b.mesh.O[c] == c;
            nook_status status;
            take_list();
            good = list_collapses(c);
            renamed_vertices = renamed_triangles = 0;
            status = nook_collapse(&b.mesh, c, nook_make(1, 2, 3), &listening);
            seen[status]++;
            CHECK_EQUAL(status == NOOK_OK, good);
            if (!good) {
                is_as_kept();
                continue;
            }
            CHECK_EQUAL(b.mesh.nv, nv - 1);
            CHECK_EQUAL(b.mesh.nt, nt - (border ? 1 : 2));
            CHECK_EQUAL(renamed_vertices, gone != nv - 1);
            if (gone != nv - 1) CHECK(last_from == nv - 1 && last_to == gone);
            CHECK(b.mesh.G[stays == nv - 1 ? gone : stays].z == 3);
            same_triangles();
            tables_hold();
            restore(nv, nt);
            legal++;
        }
    }
    CHECK(legal > 50);
    CHECK(seen[NOOK_DUPLICATE_EDGE] > 0 && seen[NOOK_NONMANIFOLD_VERTEX] > 0 &&
          seen[NOOK_DUPLICATE_TRIANGLE] > 0);
    CHECK_EQUAL(nook_collapse(&b.mesh, 3 * b.mesh.nt, nook_make(0, 0, 0), NULL), NOOK_INDEX_OUT_OF_RANGE);
    begin_shape(3);
    add(0, 1, 2);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    keep();
    for (c = 0; c < 3; c++)
        CHECK_EQUAL(nook_collapse(&b.mesh, c, nook_make(0, 0, 0), NULL), NOOK_LAST_TRIANGLE);
    is_as_kept();
}

static void a_split_triangle_is_whole_and_its_vertex_can_be_removed(void) {
    uint32_t i, t;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        keep();
        for (t = 0; t < b.mesh.nt; t++) {
            uint32_t nv = b.mesh.nv, nt = b.mesh.nt, v;
            CHECK_EQUAL(nook_split_triangle(&b.mesh, t, nook_make(7, 8, 9), NULL), NOOK_OK);
            CHECK(b.mesh.nv == nv + 1 && b.mesh.nt == nt + 2 && b.mesh.G[nv].y == 8);
            tables_hold();
            CHECK_EQUAL(list_result.euler, shapes[i].euler);
            for (v = 0; v < nv; v++) {
                nook_view view = nook_view_of(&b.mesh);
                uint32_t valence = nook_valence(&view, b.mesh.C[v]);
                if (valence != 3) CHECK_EQUAL(nook_remove_vertex(&b.mesh, v, NULL), NOOK_WRONG_VALENCE);
            }
            renamed_vertices = renamed_triangles = 0;
            CHECK_EQUAL(nook_remove_vertex(&b.mesh, nv, &listening), NOOK_OK);
            starts_as_kept(nt);
            CHECK_EQUAL(renamed_vertices + renamed_triangles, 0);
            tables_hold();
            restore(nv, nt);
        }
    }
    CHECK_EQUAL(nook_split_triangle(&b.mesh, b.mesh.nt, nook_make(0, 0, 0), NULL), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_remove_vertex(&b.mesh, b.mesh.nv, NULL), NOOK_INDEX_OUT_OF_RANGE);
    b.mesh.max_nt = b.mesh.nt + 1;
    CHECK_EQUAL(nook_split_triangle(&b.mesh, 0, nook_make(0, 0, 0), NULL), NOOK_NO_CAPACITY);
    b.mesh.max_nt = b.mesh.nt + 2;
    b.mesh.max_nv = b.mesh.nv;
    CHECK_EQUAL(nook_split_triangle(&b.mesh, 0, nook_make(0, 0, 0), NULL), NOOK_NO_CAPACITY);
    begin_whole(1); /* a tetrahedron: under each vertex there is the triangle that would stay */
    keep();
    for (i = 0; i < 4; i++) CHECK_EQUAL(nook_remove_vertex(&b.mesh, i, NULL), NOOK_DUPLICATE_TRIANGLE);
    is_as_kept();
    CHECK_EQUAL(nook_remove_vertex(&b.mesh, 4, NULL), NOOK_INDEX_OUT_OF_RANGE);
}

static void a_split_edge_is_whole_and_its_half_can_be_collapsed(void) {
    uint32_t i, c;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        keep();
        for (c = 0; c < 3 * b.mesh.nt; c++) {
            uint32_t nv = b.mesh.nv, nt = b.mesh.nt, end = b.mesh.V[nook_prev(c)],
                     from = b.mesh.V[nook_next(c)];
            nook_point at = b.mesh.G[end];
            bool border = b.mesh.O[c] == c;
            CHECK_EQUAL(nook_split_edge(&b.mesh, c, nook_make(7, 8, 9), NULL), NOOK_OK);
            CHECK(b.mesh.nv == nv + 1 && b.mesh.nt == nt + (border ? 1 : 2) && b.mesh.G[nv].y == 8);
            CHECK(b.mesh.V[nook_next(c)] == from && b.mesh.V[nook_prev(c)] == nv);
            tables_hold();
            CHECK_EQUAL(list_result.euler, shapes[i].euler);
            /* The first new triangle has its first corner opposite to the edge from the new vertex to C. */
            CHECK(b.mesh.V[3 * nt + 1] == nv && b.mesh.V[3 * nt + 2] == end);
            CHECK_EQUAL(nook_collapse(&b.mesh, 3 * nt, at, NULL), NOOK_OK);
            starts_as_kept(nt);
            tables_hold();
            restore(nv, nt);
        }
    }
    CHECK_EQUAL(nook_split_edge(&b.mesh, 3 * b.mesh.nt, nook_make(0, 0, 0), NULL), NOOK_INDEX_OUT_OF_RANGE);
    begin_whole(1);
    b.mesh.max_nt = b.mesh.nt + 1;
    CHECK_EQUAL(nook_split_edge(&b.mesh, 0, nook_make(0, 0, 0), NULL), NOOK_NO_CAPACITY);
    b.mesh.max_nt = b.mesh.nt + 2;
    b.mesh.max_nv = b.mesh.nv;
    CHECK_EQUAL(nook_split_edge(&b.mesh, 0, nook_make(0, 0, 0), NULL), NOOK_NO_CAPACITY);
    shapes[11].build(); /* two triangles back to back */
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(nook_split_edge(&b.mesh, 0, nook_make(0, 0, 0), NULL), NOOK_DUPLICATE_TRIANGLE);
    CHECK_EQUAL(nook_collapse(&b.mesh, 0, nook_make(0, 0, 0), NULL), NOOK_DUPLICATE_TRIANGLE);
    CHECK_EQUAL(nook_flip(&b.mesh, 0, NULL), NOOK_DUPLICATE_EDGE);
}

/* Every sector of every fan, by the corners that face its first edge and its last; NOOK_NONE where it reaches an end. What
 * is split is whole, and the collapse of the new edge restores V and O. */
static void try_to_split_vertex(uint32_t c, uint32_t d, nook_status expected) {
    uint32_t nv = b.mesh.nv, nt = b.mesh.nt, more = (uint32_t)(c != NOOK_NONE) + (uint32_t)(d != NOOK_NONE);
    uint32_t v = b.mesh.V[c != NOOK_NONE ? nook_next(c) : nook_prev(d)];
    nook_status status = nook_split_vertex(&b.mesh, c, d, nook_make(7, 8, 9), NULL);
    CHECK_EQUAL(status, expected);
    if (status != NOOK_OK) {
        is_as_kept();
        return;
    }
    CHECK(b.mesh.nv == nv + 1 && b.mesh.nt == nt + more && b.mesh.G[nv].y == 8);
    tables_hold();
    CHECK_EQUAL(nook_collapse(&b.mesh, 3 * nt, b.mesh.G[v], NULL), NOOK_OK);
    starts_as_kept(nt);
    tables_hold();
    restore(nv, nt);
}

static void every_vertex_can_be_split_and_collapsed_again(void) {
    uint32_t i, c, x;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        keep();
        for (c = 0; c < 3 * b.mesh.nt; c += NOOK_TEST_RAM < 2000000 ? 5 : 1) {
            nook_view view = nook_view_of(&b.mesh);
            nook_star star;
            uint32_t first = nook_next(c);
            CHECK_EQUAL(nook_star_begin(&star, &view, first, true), NOOK_OK);
            try_to_split_vertex(c, NOOK_NONE, star.open ? NOOK_OK : NOOK_INTERIOR_VERTEX);
            try_to_split_vertex(NOOK_NONE, nook_prev(c), star.open ? NOOK_OK : NOOK_INTERIOR_VERTEX);
            x = first;
            do {
                uint32_t turned = nook_turn(&view, x, false);
                try_to_split_vertex(c, nook_next(x), turned == first ? NOOK_DUPLICATE_TRIANGLE : NOOK_OK);
                x = turned;
            } while (x != NOOK_NONE && x != first);
            /* Nor does turning lead back past a border, or to another vertex. */
            if (star.open && nook_turn(&view, first, true) != NOOK_NONE) {
                try_to_split_vertex(c, nook_next(nook_turn(&view, first, true)), NOOK_NONMANIFOLD_VERTEX);
            }
            try_to_split_vertex(c, c, NOOK_NONMANIFOLD_VERTEX);
        }
    }
    CHECK_EQUAL(nook_split_vertex(&b.mesh, NOOK_NONE, NOOK_NONE, nook_make(0, 0, 0), NULL),
                NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_split_vertex(&b.mesh, 0, 3 * b.mesh.nt, nook_make(0, 0, 0), NULL),
                NOOK_INDEX_OUT_OF_RANGE);
    begin_whole(1);
    b.mesh.max_nt = b.mesh.nt + 1;
    CHECK_EQUAL(nook_split_vertex(&b.mesh, 0, 2, nook_make(0, 0, 0), NULL), NOOK_NO_CAPACITY);
}

/* Merging the edges at a vertex of four triangles, or of two at a border, is a collapse; all else is refused. */
static void every_merge_is_legal_or_refused_as_the_list_says(void) {
    uint32_t i, c, legal = 0, seen[NOOK_STATUS_COUNT];
    memset(seen, 0, sizeof seen);
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        keep();
        for (c = 0; c < 3 * b.mesh.nt; c++) {
            nook_view view = nook_view_of(&b.mesh);
            uint32_t nv = b.mesh.nv, nt = b.mesh.nt, valence = nook_valence(&view, c);
            bool open = nook_turn(&view, c, true) == NOOK_NONE, good;
            nook_status status;
            take_list();
            good = open ? valence == 2
                        : valence == 4 && nook_turn(&view, nook_turn(&view, nook_turn(&view, c, true), true),
                                                    true) == nook_turn(&view, c, false);
            good = good && list_collapses(nook_prev(c));
            status = nook_merge_edges(&b.mesh, c, NULL);
            seen[status]++;
            CHECK_EQUAL(status == NOOK_OK, good);
            if (!good) {
                is_as_kept();
                continue;
            }
            CHECK_EQUAL(b.mesh.nt, nt - (open ? 1 : 2));
            same_triangles();
            tables_hold();
            restore(nv, nt);
            legal++;
        }
    }
    CHECK(legal > 20 && seen[NOOK_WRONG_VALENCE] > 20 && seen[NOOK_INTERIOR_EDGE] > 0);
    CHECK_EQUAL(nook_merge_edges(&b.mesh, 3 * b.mesh.nt, NULL), NOOK_INDEX_OUT_OF_RANGE);
}

/* What nook_split_edge() made, nook_merge_edges() takes back, exactly. */
static void a_split_edge_can_be_merged(void) {
    uint32_t i, c;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        keep();
        for (c = 0; c < 3 * b.mesh.nt; c++) {
            uint32_t nt = b.mesh.nt;
            CHECK_EQUAL(nook_split_edge(&b.mesh, c, nook_make(7, 8, 9), NULL), NOOK_OK);
            CHECK_EQUAL(nook_merge_edges(&b.mesh, 3 * nt + 1, NULL), NOOK_OK);
            starts_as_kept(nt);
            tables_hold();
            restore(b.mesh.nv, nt);
        }
    }
}

/* ---- all triangulations of the sphere -------------------------------------------------------------------- */

enum { CODE = 3 * 2 * (9 - 2) };
typedef struct code {
    uint8_t v[CODE];
} code;
enum { KNOWN = NOOK_TEST_RAM < 2000000 ? 16 : 64 };
static code known[KNOWN];

/* The list of triangles in the order of a search from corner c, by new names; from either side. */
static code code_from(uint32_t c, bool mirrored) {
    static uint8_t name[MOST], queue[MOST_C], done[MOST];
    code k;
    uint32_t head = 0, tail = 0, names = 0, n = 0, i;
    memset(name, 0xFF, sizeof name);
    memset(done, 0, sizeof done);
    memset(&k, 0, sizeof k);
    queue[tail++] = (uint8_t)c;
    done[c / 3] = 1;
    while (head < tail) {
        uint32_t x = queue[head++], order[3];
        order[0] = x, order[1] = mirrored ? nook_prev(x) : nook_next(x),
        order[2] = mirrored ? nook_next(x) : nook_prev(x);
        for (i = 0; i < 3; i++) {
            uint32_t v = b.mesh.V[order[i]];
            if (name[v] == 0xFF) name[v] = (uint8_t)names++;
            k.v[n++] = name[v];
        }
        for (i = 0; i < 3; i++) {
            uint32_t o = b.mesh.O[order[i]];
            if (done[o / 3]) continue;
            done[o / 3] = 1;
            queue[tail++] = (uint8_t)o;
        }
    }
    return k;
}

static code canonical(void) {
    code best = code_from(0, false);
    uint32_t c, side;
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        for (side = 0; side < 2; side++) {
            code k = code_from(c, side == 1);
            if (memcmp(&k, &best, sizeof k) < 0) best = k;
        }
    }
    return best;
}

static void build_from(const code *k, uint32_t nv) {
    begin_shape(nv);
    add_list(k->v, 2 * nv - 4);
    CHECK_EQUAL(nook_link(&b.mesh, NULL, NULL, NULL, &b.report, NULL), NOOK_OK);
}

/* From one triangulation by flips alone, all that there are. */
static void flips_reach_all_triangulations_of_the_sphere(void) {
    static const uint8_t counts[] = {1, 1, 2, 5, 14, 50};
    uint32_t nv, c, i;
    for (nv = 4; nv <= (NOOK_TEST_RAM < 2000000 ? 8u : 9u) && !test_has_failed(); nv++) {
        uint32_t found = 1, next;
        tetrahedron();
        CHECK_EQUAL(nook_link(&b.mesh, NULL, NULL, NULL, &b.report, NULL), NOOK_OK);
        while (b.mesh.nv < nv)
            CHECK_EQUAL(nook_split_triangle(&b.mesh, 0, nook_make(0, 0, 0), NULL), NOOK_OK);
        known[0] = canonical();
        for (next = 0; next < found && found < (uint32_t)KNOWN; next++) {
            for (c = 0; c < 3 * (2 * nv - 4); c++) {
                code k;
                build_from(&known[next], nv);
                if (nook_flip(&b.mesh, c, NULL) != NOOK_OK) continue;
                k = canonical();
                for (i = 0; i < found && memcmp(&k, &known[i], sizeof k) != 0; i++) {
                }
                if (i == found) known[found++] = k;
            }
        }
        CHECK_EQUAL(found, counts[nv - 4]);
    }
}

/* ---- many, one after the other ----------------------------------------------------------------------------- */

static void thousands_of_mixed_edits_keep_a_mesh_whole(void) {
    static const uint8_t start[] = {1, 4, 5, 6, 7}; /* tetrahedron, sphere, torus, disk, cylinder */
    dice d = {20261125u};
    uint32_t k, step, steps = NOOK_TEST_RAM < 2000000 ? 1500 : 40000, done[5] = {0, 0, 0, 0, 0};
    for (k = 0; k < sizeof start && !test_has_failed(); k++) {
        shapes[start[k]].build();
        if (b.mesh.nt + 4 > MOST || b.mesh.nv + 2 > MOST) torus(4, 5);
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        b.mesh.max_nv = b.mesh.max_nt = MOST;
        for (step = 0; step < steps && !test_has_failed(); step++) {
            uint32_t c = throw_dice(&d, 3 * b.mesh.nt), what = throw_dice(&d, 5);
            nook_point at = nook_make((float)step, 0, 0);
            nook_status status = what == 0   ? nook_flip(&b.mesh, c, NULL)
                                 : what == 1 ? nook_split_triangle(&b.mesh, c / 3, at, NULL)
                                 : what == 2 ? nook_split_edge(&b.mesh, c, at, NULL)
                                 : what == 3 ? nook_collapse(&b.mesh, c, at, NULL)
                                             : nook_remove_vertex(&b.mesh, b.mesh.V[c], NULL);
            CHECK(status != NOOK_BAD_OPPOSITE);
            done[what] += status == NOOK_OK;
            if (step % 16 == 0) tables_hold();
        }
        tables_hold();
        if (!test_has_failed()) CHECK_EQUAL(list_result.survey.components, 1);
    }
    for (k = 0; k < 5; k++) CHECK(done[k] > steps / 20);
}

/* Geometry included: new points are means, and every other edit must turn no triangle over. */
static void a_thousand_edits_have_one_digest_on_all_machines(void) {
    static const nook_edit careful = {.no_turn = true};
    dice d = {4u};
    nook_view view;
    uint32_t step, carried = 0;
    torus(4, 5);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    b.mesh.max_nv = b.mesh.max_nt = MOST;
    for (step = 0; step < 1000; step++) {
        uint32_t c = throw_dice(&d, 3 * b.mesh.nt), what = throw_dice(&d, 8);
        const nook_edit *edit = step % 2 == 0 ? &careful : NULL;
        nook_point p, q, at;
        view = nook_view_of(&b.mesh);
        p = nook_point_at(&view, nook_next(c)), q = nook_point_at(&view, nook_prev(c));
        at = nook_make((p.x + q.x) * 0.5f, (p.y + q.y) * 0.5f, (p.z + q.z) * 0.3f);
        carried += (what == 0   ? nook_flip(&b.mesh, c, edit)
                    : what == 1 ? nook_split_triangle(&b.mesh, c / 3, at, edit)
                    : what == 2 ? nook_split_edge(&b.mesh, c, at, edit)
                    : what == 3 ? nook_collapse(&b.mesh, c, at, edit)
                    : what == 4 ? nook_split_vertex(&b.mesh, c, nook_prev(c), at, edit)
                    : what == 5 ? nook_remove_triangle(&b.mesh, c / 3, edit)
                    : what == 6 ? nook_fill_hole(&b.mesh, c, (nook_fill_way)(step % 3), edit)
                                : nook_merge_edges(&b.mesh, c, edit)) == NOOK_OK;
    }
    view = nook_view_of(&b.mesh);
    tables_hold();
    CHECK_EQUAL(carried, 197);
    CHECK_EQUAL(nook_digest(&view), 1040304782u);
}

/* O of other bits where an operator looks: refused before anything is changed. */
static void spoiled_tables_are_refused(void) {
    uint32_t c, bit;
    begin_whole(4);
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        for (bit = 0; bit < NOOK_INDEX_BITS; bit += 3) {
            nook_index good = b.mesh.O[c];
            b.mesh.O[c] = (nook_index)(b.mesh.O[c] ^ (nook_index)1 << bit);
            keep();
            if (b.mesh.O[c] == c) { /* as good as a border, from this side */
                b.mesh.O[c] = good;
                continue;
            }
            CHECK_EQUAL(nook_flip(&b.mesh, c, NULL), NOOK_BAD_OPPOSITE);
            CHECK_EQUAL(nook_split_edge(&b.mesh, c, nook_make(0, 0, 0), NULL), NOOK_BAD_OPPOSITE);
            CHECK_EQUAL(nook_split_triangle(&b.mesh, c / 3, nook_make(0, 0, 0), NULL), NOOK_BAD_OPPOSITE);
            CHECK_EQUAL(nook_collapse(&b.mesh, c, nook_make(0, 0, 0), NULL), NOOK_BAD_OPPOSITE);
            is_as_kept();
            b.mesh.O[c] = good;
        }
    }
}

/* The last vertex takes the number of a vertex of no triangle, as C says; but C has it at a corner which that number is on already,
 * and turning from there runs into a circle that never comes back to it. */
static void a_fan_that_never_comes_round_is_left(void) {
    nook_view view;
    uint32_t x, y, last;
    CHECK(begin_whole(4));
    view = nook_view_of(&b.mesh);
    last = b.mesh.nv - 1u;
    x = nook_turn(&view, b.mesh.C[0], false);
    y = nook_turn(&view, x, false);
    CHECK(y != NOOK_NONE && y != b.mesh.C[0]);
    b.mesh.O[nook_next(y)] = nook_store(nook_prev(x));
    b.mesh.C[last] = b.mesh.C[0];
    b.mesh.C[0] = NOOK_STORED_NONE;
    CHECK_EQUAL(nook_remove_vertex(&b.mesh, 0, NULL), NOOK_OK);
    CHECK_EQUAL(b.mesh.nv, last);
}

/* Any entry of any table another one: whatever the operators say, they end, and write nothing when they refuse. */
enum { OPERATORS = 17 };
static nook_status edit_anyhow(uint32_t what, uint32_t c) {
    static float attributes[3 * MOST];
    static uint8_t color[MOST];
    static const nook_edit careful = {
        .no_turn = true, .max_valence = 5, .color = color, .attributes = attributes, .width = 1};
    static nook_boxes boxes[NOOK_BVH_GROUPS(MOST)];
    static nook_guard guard;
    static const nook_edit watched = {.guard = &guard};
    const nook_edit *edit = c % 3 == 0 ? NULL : c % 3 == 1 ? &careful : &watched;
    nook_point at = nook_make(0, 0, 0);
    uint32_t d = (c + 3) % (3 * b.mesh.nt), v[3];
    nook_split_fans fans;
    nook_reverse reverse;
    uint32_t units = 1000;
    b.mesh.max_nt = MOST;
    if (edit == &watched) {
        (void)nook_guard_begin(&guard, &b.mesh, boxes);
        (void)nook_bvh_refit(&guard.bvh, boxes, NULL); /* of any bits where V names no vertex */
    }
    v[0] = c % b.mesh.nv, v[1] = d % b.mesh.nv, v[2] = (c + d) % b.mesh.nv;
    switch (what) {
    case 0: return nook_flip(&b.mesh, c, edit);
    case 1: return nook_split_triangle(&b.mesh, c / 3, at, edit);
    case 2: return nook_split_edge(&b.mesh, c, at, edit);
    case 3: return nook_collapse(&b.mesh, c, at, edit);
    case 4: return nook_remove_vertex(&b.mesh, c % b.mesh.nv, edit);
    case 5: return nook_split_vertex(&b.mesh, c, NOOK_NONE, at, edit);
    case 6: return nook_split_vertex(&b.mesh, NOOK_NONE, c, at, edit);
    case 7: return nook_split_vertex(&b.mesh, c, nook_prev(c), at, edit);
    case 8: return nook_split_vertex(&b.mesh, c, d, at, edit);
    case 9: return nook_merge_edges(&b.mesh, c, edit);
    case 10: return nook_make_triangle(&b.mesh, v, edit);
    case 11: return nook_remove_triangle(&b.mesh, c / 3, edit);
    case 12: return nook_stitch(&b.mesh, c, d, edit);
    case 13: return nook_cut(&b.mesh, c, edit);
    case 14: return nook_fill_hole(&b.mesh, c, (nook_fill_way)(c % 3), edit);
    case 15: {
        nook_status status = nook_reverse_begin(&reverse, &b.mesh, NULL, 0, edit);
        return status != NOOK_OK ? status : nook_reverse_step(&reverse, &units);
    }
    default: {
        nook_status status = nook_split_fans_begin(&fans, &b.mesh, &b.marks, edit);
        return status != NOOK_OK ? status : nook_split_fans_step(&fans, &units);
    }
    }
}

/* Filling plans in what the mesh does not use. */
static void is_refused(uint32_t what, uint32_t nt) {
    if (what == 14) {
        starts_as_kept(nt);
    } else {
        is_as_kept();
    }
}

static void try_spoiled(nook_index *entry, uint32_t value) {
    uint32_t what, c, nv = b.mesh.nv, nt = b.mesh.nt;
    nook_index good = *entry;
    *entry = nook_store(value);
    keep();
    for (what = 0; what < OPERATORS; what++) {
        for (c = 0; c < 3 * nt; c += NOOK_TEST_RAM < 2000000 ? 5 : 1) {
            if (edit_anyhow(what, c) != NOOK_OK) is_refused(what, nt);
            CHECK(b.mesh.nv <= MOST && b.mesh.nt <= MOST);
            restore(nv, nt);
        }
    }
    *entry = good;
}

static void any_spoiled_entry_ends_well(void) {
    uint32_t k, i, c, value, step = NOOK_TEST_RAM < 2000000 ? 7 : 1;
    for (k = 0; k < 3; k++) { /* the first is open */
        if (!begin_whole(k)) continue;
        if (k == 1) CHECK_EQUAL(nook_split_triangle(&b.mesh, 1, nook_make(3, 3, 3), NULL), NOOK_OK);
        b.mesh.nv++; /* and a vertex of no triangle, which is the last */
        b.mesh.C[b.mesh.nv - 1] = NOOK_STORED_NONE;
        for (value = 0; value <= 3 * b.mesh.nt + 1; value += step) {
            uint32_t other_value = value > 3 * b.mesh.nt ? NOOK_STORED_NONE : value;
            for (i = 0; i < 3 * b.mesh.nt; i++) try_spoiled(&b.mesh.O[i], other_value);
            for (i = 0; i < 3 * b.mesh.nt; i++) try_spoiled(&b.mesh.V[i], other_value);
            for (i = 0; i < b.mesh.nv; i++) try_spoiled(&b.mesh.C[i], other_value);
            if (test_has_failed()) return;
        }
    }
    begin_shape(4); /* two triangles joined at all edges, whose third vertices differ all the same */
    add(0, 1, 2);
    add(0, 2, 1);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    b.mesh.V[b.mesh.O[0]] = 3;
    CHECK_EQUAL(nook_collapse(&b.mesh, 0, nook_make(0, 0, 0), NULL), NOOK_BAD_OPPOSITE);
    c = b.mesh.O[1];
    b.mesh.O[1] = 1;
    b.mesh.O[c] = nook_store(c);
    CHECK_EQUAL(nook_collapse(&b.mesh, 0, nook_make(0, 0, 0), NULL), NOOK_BAD_OPPOSITE);
    begin_shape(3); /* a triangle whose own corners face each other */
    add(0, 1, 2);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    b.mesh.O[1] = 2;
    b.mesh.O[2] = 1;
    keep();
    CHECK_EQUAL(nook_remove_vertex(&b.mesh, 0, NULL), NOOK_WRONG_VALENCE);
    is_as_kept();
}

static const test tests[] = {
    TEST(every_flip_is_legal_or_refused_as_the_list_says),
    TEST(every_collapse_is_legal_or_refused_as_the_list_says),
    TEST(a_split_triangle_is_whole_and_its_vertex_can_be_removed),
    TEST(a_split_edge_is_whole_and_its_half_can_be_collapsed),
    TEST(every_vertex_can_be_split_and_collapsed_again),
    TEST(every_merge_is_legal_or_refused_as_the_list_says),
    TEST(a_split_edge_can_be_merged),
    TEST(flips_reach_all_triangulations_of_the_sphere),
    TEST(thousands_of_mixed_edits_keep_a_mesh_whole),
    TEST(a_thousand_edits_have_one_digest_on_all_machines),
    TEST(spoiled_tables_are_refused),
    TEST(a_fan_that_never_comes_round_is_left),
    TEST(any_spoiled_entry_ends_well),
};

void test_edit(void) { run_tests(tests, sizeof tests / sizeof *tests); }
