/* test_walk.c -- stars, borders, relations, half-edges, searches and rings, on every shape of shapes.h.
 *
 * What belongs together is taken from the oracle, which compares all pairs of corners; distances and rings are
 * found by handing numbers on until nothing changes; and the algebra of edges is tested by its laws. */
#include <string.h>

#include "oracle.h"
#include "rooms.h"

static oracle o;
static nook_view view;

static uint32_t corners(void) { return 3 * b.mesh.nt; }

/* Build, judge, link. Shapes that are too large for the oracle, or whose edges link must cut, are passed by. */
static bool begin(uint32_t i) {
    shapes[i].build();
    if (b.mesh.nt > ORACLE_T) return false;
    judge(&o);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    view = nook_view_of(&b.mesh);
    return b.report.nonmanifold_edges + b.report.incoherent_edges == 0;
}

/* The shapes whose vertices all have one fan, and whose edges have one or two triangles. */
static bool is_manifold(void) { return b.result.manifold == NOOK_YES; }

/* ---- stars ------------------------------------------------------------------------------------------- */

static void a_star_is_the_fan_of_its_corner_each_triangle_once(void) {
    static uint8_t seen[3 * ORACLE_T];
    uint32_t i, c, way;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin(i)) continue;
        for (c = 0; c < corners(); c++) {
            for (way = 0; way < 2; way++) {
                nook_star star;
                uint32_t x, n = 0, fan = 0, last = NOOK_NONE;
                memset(seen, 0, sizeof seen);
                CHECK_EQUAL(nook_star_begin(&star, &view, c, way == 1), NOOK_OK);
                while ((x = nook_star_next(&star)) != NOOK_NONE) {
                    CHECK_EQUAL(seen[x], 0);
                    CHECK_EQUAL(view.V[x], view.V[c]);
                    CHECK_EQUAL(o.fan[x], o.fan[c]);
                    if (last != NOOK_NONE) CHECK_EQUAL(nook_turn(&view, x, way == 0), last);
                    if (last != NOOK_NONE && way == 1) CHECK_EQUAL(nook_swing(&view, last), x);
                    seen[x] = 1;
                    last = x;
                    n++;
                }
                for (x = 0; x < corners(); x++) fan += o.fan[x] == o.fan[c] && view.V[x] == view.V[c];
                CHECK_EQUAL(n, fan);
                CHECK_EQUAL(nook_valence(&view, c), fan);
                CHECK_EQUAL(nook_star_next(&star), NOOK_NONE);
                if (!star.open) CHECK_EQUAL(star.first, c);
                if (star.open)
                    CHECK(nook_is_border(&view, way == 1 ? nook_next(star.first) : nook_prev(star.first)));
                CHECK_EQUAL(nook_turn(&view, last, way == 1), star.open ? NOOK_NONE : c);
            }
        }
    }
    begin(1);
    {
        nook_star star;
        CHECK_EQUAL(nook_star_begin(&star, &view, corners(), true), NOOK_INDEX_OUT_OF_RANGE);
    }
    CHECK_EQUAL(nook_valence(&view, corners()), 0);
}

static void all_corners_of_a_vertex_are_found_in_all_its_fans(void) {
    uint32_t i, v, c, n;
    for (i = 0; i < shape_count; i++) {
        if (!begin(i)) continue;
        for (v = 0, n = 0; v < b.mesh.nv; v++) {
            for (c = nook_corner_after(&view, v, NOOK_NONE); c != NOOK_NONE;
                 c = nook_corner_after(&view, v, c)) {
                CHECK_EQUAL(view.V[c], v);
                n++;
            }
        }
        CHECK_EQUAL(n, corners());
    }
}

/* ---- borders ------------------------------------------------------------------------------------------ */

static void border_loops_are_those_of_the_oracle_also_where_they_touch(void) {
    uint32_t i, c, x, n, loops;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin(i)) continue;
        for (c = 0, loops = 0; c < corners(); c++) {
            if (!nook_is_border(&view, c)) {
                CHECK_EQUAL(nook_border_next(&view, c, true), NOOK_NONE);
                CHECK_EQUAL(nook_border_length(&view, c), 0);
                continue;
            }
            x = nook_border_next(&view, c, true);
            CHECK_EQUAL(nook_border_next(&view, x, false), c);
            CHECK_EQUAL(view.V[nook_next(x)], view.V[nook_prev(c)]); /* begins where c ends */
            CHECK_EQUAL(o.loop[x], o.loop[c]);
            for (x = 0, n = 0; x < corners(); x++) n += nook_is_border(&view, x) && o.loop[x] == o.loop[c];
            CHECK_EQUAL(nook_border_length(&view, c), n);
            loops += o.loop[c] == c;
        }
        CHECK_EQUAL(loops, shapes[i].border_loops);
    }
    CHECK_EQUAL(nook_border_next(&view, corners(), true), NOOK_NONE);
}

/* ---- relations ----------------------------------------------------------------------------------------- */

static uint32_t list[ORACLE_T + 8], listed;
static void read_list(nook_relation relation, uint32_t element) {
    nook_related related;
    uint32_t x;
    listed = 0;
    CHECK_EQUAL(nook_related_begin(&related, &view, relation, element), NOOK_OK);
    while (nook_related_next(&related, &x) && listed < ORACLE_T + 4) list[listed++] = x;
    CHECK(!nook_related_next(&related, &x));
}

static bool edge_has(uint32_t e, uint32_t v) {
    return view.V[nook_next(e)] == v || view.V[nook_prev(e)] == v;
}
static bool face_has(uint32_t t, uint32_t v) { return nook_corner_in(&view, t, v) != NOOK_NONE; }
static bool face_has_edge(uint32_t t, uint32_t e) {
    return nook_triangle(e) == t || (view.O[e] != e && nook_triangle(view.O[e]) == t);
}

static void lists_about_a_vertex_keep_the_rules_of_their_order(void) {
    static uint32_t edges[ORACLE_T + 8], faces[ORACLE_T + 8];
    uint32_t i, v, k, nf, ne, c;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin(i) || !is_manifold()) continue;
        for (v = 0; v < b.mesh.nv; v++) {
            uint32_t valence = 0, degree = 0;
            for (c = 0; c < corners(); c++) {
                valence += view.V[c] == v;
                degree += nook_edge(&view, c) == c && edge_has(c, v);
            }
            read_list(NOOK_VF, v);
            memcpy(faces, list, sizeof faces);
            nf = listed;
            read_list(NOOK_VE, v);
            memcpy(edges, list, sizeof edges);
            ne = listed;
            read_list(NOOK_VV, v);
            CHECK_EQUAL(nf, valence);
            CHECK_EQUAL(ne, degree);
            CHECK_EQUAL(listed, ne);
            for (k = 0; k < ne; k++) {
                CHECK(edge_has(edges[k], v) && edge_has(edges[k], list[k]) && list[k] != v);
                CHECK_EQUAL(nook_edge(&view, edges[k]), edges[k]);
            }
            for (k = 0; k < nf; k++) {
                CHECK(face_has(faces[k], v));
                CHECK(face_has_edge(faces[k], edges[k]) && face_has_edge(faces[k], edges[(k + 1) % ne]));
                CHECK_EQUAL(nook_nvat(&view, v, faces[k]), list[k]); /* counter-clockwise */
            }
        }
    }
}

static void lists_of_edges_and_faces_keep_the_rules_of_their_order(void) {
    uint32_t i, c, k, v[2], f[2], e[4];
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin(i)) continue;
        for (c = 0; c < corners(); c++) {
            uint32_t across = view.O[c] == c ? NOOK_NONE : nook_triangle(view.O[c]);
            read_list(NOOK_EV, c);
            CHECK_EQUAL(listed, 2);
            memcpy(v, list, sizeof v);
            read_list(NOOK_EF, c);
            CHECK_EQUAL(listed, 2);
            memcpy(f, list, sizeof f);
            read_list(NOOK_EE, c);
            CHECK_EQUAL(listed, 4);
            memcpy(e, list, sizeof e);
            CHECK_EQUAL(nook_nvat(&view, v[0], f[0]), v[1]); /* f1 on the left of v1 -> v2 */
            CHECK_EQUAL(f[0], nook_triangle(c));
            CHECK_EQUAL(f[1], across);
            for (k = 0; k < 4; k++) {
                if (f[k & 1] == NOOK_NONE) {
                    CHECK_EQUAL(e[k], NOOK_NONE);
                } else {
                    CHECK(edge_has(e[k], v[k >> 1]) && face_has_edge(f[k & 1], e[k]));
                    CHECK(e[k] != nook_edge(&view, c));
                }
            }
        }
        for (k = 0; k < b.mesh.nt; k++) {
            uint32_t vertex[3], edge[3], j;
            read_list(NOOK_FV, k);
            CHECK_EQUAL(listed, 3);
            memcpy(vertex, list, sizeof vertex);
            read_list(NOOK_FE, k);
            CHECK_EQUAL(listed, 3);
            memcpy(edge, list, sizeof edge);
            read_list(NOOK_FF, k);
            CHECK_EQUAL(listed, 3);
            for (j = 0; j < 3; j++) {
                CHECK_EQUAL(nook_nvat(&view, vertex[j], k), vertex[(j + 1) % 3]);
                CHECK(edge_has(edge[j], vertex[j]) && edge_has(edge[j], vertex[(j + 1) % 3]));
                CHECK(face_has_edge(k, edge[j]));
                CHECK_EQUAL(list[j] == NOOK_NONE, nook_is_border(&view, edge[j]));
                if (list[j] != NOOK_NONE) CHECK(face_has_edge(list[j], edge[j]) && list[j] != k);
            }
        }
    }
}

static void relations_of_nothing_are_refused_or_empty(void) {
    nook_related related;
    uint32_t x;
    octahedron();
    b.mesh.nv = 7;
    place(6, 9, 9, 9);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    view = nook_view_of(&b.mesh);
    CHECK_EQUAL(nook_related_begin(&related, &view, NOOK_VV, 6), NOOK_OK);
    CHECK(!nook_related_next(&related, &x));
    CHECK_EQUAL(nook_related_begin(&related, &view, NOOK_VE, 7), NOOK_INDEX_OUT_OF_RANGE);
    CHECK(!nook_related_next(&related, &x));
    CHECK_EQUAL(nook_related_begin(&related, &view, NOOK_EV, 24), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_related_begin(&related, &view, NOOK_FF, 8), NOOK_INDEX_OUT_OF_RANGE);
}

/* ---- half-edges ---------------------------------------------------------------------------------------- */

static uint32_t ring_length(uint32_t (*next)(const nook_view *, uint32_t), uint32_t h) {
    uint32_t x = h, n = 0;
    do {
        x = next(&view, x);
        n++;
    } while (x != h && n < 6 * b.mesh.nt);
    return n;
}

static uint32_t onext(const nook_view *m, uint32_t h) { return nook_onext(m, h); }

static void the_algebra_of_edges_holds_on_both_sides_and_along_holes(void) {
    uint32_t i, h, edges;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin(i)) continue;
        for (h = 0, edges = 0; h < 6 * b.mesh.nt; h++) {
            uint32_t sym = nook_pair(h), c;
            if (!nook_is_halfedge(&view, h)) continue;
            edges++;
            c = nook_halfedge_corner(&view, h);
            CHECK_EQUAL(nook_pair(sym), h);
            CHECK(nook_is_halfedge(&view, sym) && sym / 2 == h / 2);
            CHECK_EQUAL(nook_origin(&view, h), nook_target(&view, sym));
            CHECK_EQUAL(nook_left_face(&view, h), nook_right_face(&view, sym));
            if (c != NOOK_NONE) {
                CHECK_EQUAL(nook_halfedge(&view, c), h);
                CHECK_EQUAL(nook_nvat(&view, nook_origin(&view, h), nook_left_face(&view, h)),
                            nook_target(&view, h));
                CHECK_EQUAL(ring_length(nook_next_halfedge, h), 3);
            } else {
                CHECK_EQUAL(ring_length(nook_next_halfedge, h), nook_border_length(&view, h / 2));
            }
            /* Guibas and Stolfi; seed 004's table */
            CHECK_EQUAL(nook_oprev(&view, nook_onext(&view, h)), h);
            CHECK_EQUAL(nook_onext(&view, nook_oprev(&view, h)), h);
            CHECK_EQUAL(nook_prev_halfedge(&view, nook_next_halfedge(&view, h)), h);
            CHECK_EQUAL(nook_next_halfedge(&view, nook_prev_halfedge(&view, h)), h);
            CHECK_EQUAL(nook_dprev(&view, nook_dnext(&view, h)), h);
            CHECK_EQUAL(nook_rprev(&view, nook_rnext(&view, h)), h);
            CHECK_EQUAL(nook_next_halfedge(&view, h), nook_oprev(&view, sym));
            CHECK_EQUAL(nook_prev_halfedge(&view, h), nook_pair(nook_onext(&view, h)));
            CHECK_EQUAL(nook_dnext(&view, h), nook_pair(nook_onext(&view, sym)));
            CHECK_EQUAL(nook_dprev(&view, h), nook_pair(nook_oprev(&view, sym)));
            CHECK_EQUAL(nook_rnext(&view, h), nook_pair(nook_oprev(&view, h)));
            CHECK_EQUAL(nook_rprev(&view, h), nook_onext(&view, sym));
            /* what each of them keeps */
            CHECK_EQUAL(nook_origin(&view, nook_onext(&view, h)), nook_origin(&view, h));
            CHECK_EQUAL(nook_target(&view, nook_dnext(&view, h)), nook_target(&view, h));
            CHECK_EQUAL(nook_left_face(&view, nook_next_halfedge(&view, h)), nook_left_face(&view, h));
            CHECK_EQUAL(nook_right_face(&view, nook_rnext(&view, h)), nook_right_face(&view, h));
            CHECK_EQUAL(nook_origin(&view, nook_next_halfedge(&view, h)), nook_target(&view, h));
        }
        CHECK_EQUAL(edges, 2 * b.report.edges);
        CHECK(!nook_is_halfedge(&view, h));
    }
}

static void an_origin_ring_has_the_edges_of_its_vertex(void) {
    uint32_t i, v;
    for (i = 0; i < shape_count; i++) {
        if (!begin(i) || !is_manifold()) continue;
        for (v = 0; v < b.mesh.nv; v++) {
            uint32_t h = nook_halfedge_of_vertex(&view, v);
            CHECK_EQUAL(nook_origin(&view, h), v);
            read_list(NOOK_VE, v);
            CHECK_EQUAL(ring_length(onext, h), listed);
        }
    }
    b.mesh.C[0] = NOOK_STORED_NONE;
    CHECK_EQUAL(nook_halfedge_of_vertex(&view, 0), NOOK_NONE);
}

/* ---- searches ------------------------------------------------------------------------------------------- */

static nook_flood flood;

static void a_search_takes_three_hops_a_triangle_and_one_a_component(void) {
    static uint16_t tag[ORACLE_T];
    uint32_t i, t, cut;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin(i)) continue;
        for (cut = 1; cut < 4; cut++) {
            uint32_t entered = 0, vertices = 0, v[3];
            nook_status status;
            memset(tag, 0xFF, sizeof tag);
            memset(b.Mv, 0, sizeof b.Mv);
            CHECK_EQUAL(nook_flood_begin(&flood, &view, &b.marks, NOOK_NONE), NOOK_OK);
            do {
                uint32_t units = cut;
                status = nook_flood_step(&flood, &units);
                CHECK(units <= cut);
                if (status != NOOK_TRIANGLE) continue;
                t = nook_triangle(flood.corner);
                CHECK_EQUAL(tag[t], 0xFFFF);
                tag[t] = (uint16_t)flood.component;
                if (view.O[flood.corner] != flood.corner && flood.corner % 3 != 0)
                    CHECK_EQUAL(tag[nook_triangle(view.O[flood.corner])], tag[t]);
                vertices += nook_flood_new_vertices(&flood, b.Mv, v);
                entered++;
            } while (status == NOOK_TRIANGLE || status == NOOK_MORE);
            CHECK_EQUAL(status, NOOK_OK);
            CHECK_EQUAL(entered, b.mesh.nt);
            CHECK_EQUAL(flood.hops, 3 * b.mesh.nt + shapes[i].components);
            CHECK_EQUAL(vertices, b.mesh.nv);
            for (t = 0; t < b.mesh.nt; t++) CHECK_EQUAL(tag[t] == tag[o.component[t]], true);
        }
    }
}

/* From any seed, border or not, all of its component and nothing else. */
static void a_search_from_any_seed_reaches_its_whole_component(void) {
    uint32_t i, seed, t;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin(i)) continue;
        for (seed = 0; seed < b.mesh.nt; seed++) {
            uint32_t entered = 0, size = 0, units = UINT32_MAX;
            nook_status status;
            CHECK_EQUAL(nook_flood_begin(&flood, &view, &b.marks, seed), NOOK_OK);
            while ((status = nook_flood_step(&flood, &units)) == NOOK_TRIANGLE) {
                if (entered == 0) CHECK_EQUAL(flood.corner, 3 * seed);
                CHECK_EQUAL(o.component[nook_triangle(flood.corner)], o.component[seed]);
                entered++;
            }
            for (t = 0; t < b.mesh.nt; t++) size += o.component[t] == o.component[seed];
            CHECK_EQUAL(status, NOOK_OK);
            CHECK_EQUAL(entered, size);
        }
    }
}

/* Where a recursive search would be as deep as the mesh has triangles. */
static void a_long_strip_needs_no_stack(void) {
    uint32_t n = MOST_T, t, units = UINT32_MAX, entered = 0;
    begin_shape(n + 2);
    for (t = 0; t < n; t++) {
        if (t % 2) {
            add(t + 1, t, t + 2);
        } else {
            add(t, t + 1, t + 2);
        }
    }
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    view = nook_view_of(&b.mesh);
    CHECK_EQUAL(nook_flood_begin(&flood, &view, &b.marks, n / 2), NOOK_OK);
    while (nook_flood_step(&flood, &units) == NOOK_TRIANGLE) entered++;
    CHECK_EQUAL(entered, n);
    CHECK_EQUAL(flood.hops, 3 * n + 1);
}

static nook_status run_rings(nook_rings *r, uint32_t seed, uint32_t cut) {
    nook_status status = nook_rings_begin(r, &view, seed, b.component, b.kept);
    uint32_t spent = 0;
    while (status == NOOK_OK) {
        uint32_t units = cut;
        status = nook_rings_step(r, &units);
        spent += cut - units;
        if (status == NOOK_OK) break;
        if (status == NOOK_MORE) status = NOOK_OK;
    }
    CHECK(spent <= 2 * b.mesh.nt);
    return status;
}

static void rings_have_the_distance_across_edges(void) {
    static uint16_t far[ORACLE_T];
    uint32_t i, seed, t, c;
    nook_rings r;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin(i)) continue;
        for (seed = 0; seed < b.mesh.nt; seed += 7) {
            bool changed = true;
            uint32_t reached = 0;
            for (t = 0; t < b.mesh.nt; t++) far[t] = t == seed ? 0 : 0xFFFF;
            while (changed) {
                changed = false;
                for (c = 0; c < corners(); c++) {
                    uint32_t u = view.O[c] / 3u;
                    if (far[c / 3] == 0xFFFF || far[u] <= far[c / 3] + 1) continue;
                    far[u] = (uint16_t)(far[c / 3] + 1);
                    changed = true;
                }
            }
            CHECK_EQUAL(run_rings(&r, seed, 1 + seed % 5), NOOK_OK);
            for (t = 0; t < b.mesh.nt; t++) {
                CHECK_EQUAL((uint16_t)b.component[t], far[t]);
                reached += far[t] != 0xFFFF;
            }
            CHECK_EQUAL(r.tail, reached);
            for (t = 1; t < reached; t++) CHECK(far[b.kept[t - 1]] <= far[b.kept[t]]);
            CHECK_EQUAL(b.kept[0], seed);
        }
    }
}

static void components_by_sets_are_those_of_the_oracle(void) {
    uint32_t i, t, cut;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin(i)) continue;
        for (cut = 1; cut < 40; cut += 13) {
            nook_components sets;
            nook_status status;
            uint32_t next = 0;
            CHECK_EQUAL(nook_components_begin(&sets, &view, b.component), NOOK_OK);
            do {
                uint32_t units = cut;
                status = nook_components_step(&sets, &units);
            } while (status == NOOK_MORE);
            CHECK_EQUAL(status, NOOK_OK);
            CHECK_EQUAL(sets.count, shapes[i].components);
            for (t = 0; t < b.mesh.nt; t++) {
                if (o.component[t] == t) CHECK_EQUAL(b.component[t], next++);
                CHECK_EQUAL(b.component[t], b.component[o.component[t]]);
            }
        }
    }
}

/* ---- k-rings ---------------------------------------------------------------------------------------------- */

static uint8_t vertex_ring[ORACLE_C], face_ring[ORACLE_T]; /* 255: not yet */

/* By the definition: ring after ring, every face at a vertex of the ring before. */
static void grow_rings(nook_where seed) {
    uint32_t ring, t, v, i;
    bool more = true;
    memset(vertex_ring, 255, sizeof vertex_ring);
    memset(face_ring, 255, sizeof face_ring);
    if (seed.kind == NOOK_AT_VERTEX) vertex_ring[seed.index] = 0;
    for (i = 0; i < 3 && seed.kind != NOOK_AT_VERTEX; i++) {
        uint32_t c = seed.kind == NOOK_AT_TRIANGLE ? 3 * seed.index + i : nook_triangle(seed.index) * 3 + i;
        if (seed.kind == NOOK_AT_TRIANGLE || c != seed.index) vertex_ring[view.V[c]] = 0;
    }
    for (ring = 1; more; ring++) {
        more = false;
        for (t = 0; t < b.mesh.nt; t++) {
            for (i = 0; i < 3; i++) {
                if (face_ring[t] != 255 || vertex_ring[view.V[3 * t + i]] != ring - 1) continue;
                face_ring[t] = (uint8_t)ring;
                more = true;
            }
        }
        for (v = 0; v < corners(); v++) {
            if (face_ring[v / 3] == ring && vertex_ring[view.V[v]] == 255)
                vertex_ring[view.V[v]] = (uint8_t)ring;
        }
    }
}

static void compare_rings(nook_where seed) {
    nook_neighborhood n;
    nook_status status;
    uint32_t met = 0, t, reached = 0, last = 1, spent = 0;
    grow_rings(seed);
    CHECK_EQUAL(nook_neighborhood_begin(&n, &view, &b.marks, b.stamp, seed), NOOK_OK);
    do {
        uint32_t units = 1;
        status = nook_neighborhood_step(&n, &units);
        spent += 1 - units;
        if (status != NOOK_TRIANGLE) continue;
        CHECK_EQUAL(face_ring[nook_triangle(n.corner)], n.ring);
        CHECK(n.ring == last || n.ring == last + 1);
        last = n.ring;
        met++;
    } while (status == NOOK_TRIANGLE || status == NOOK_MORE);
    CHECK_EQUAL(status, NOOK_OK);
    for (t = 0; t < b.mesh.nt; t++) reached += face_ring[t] != 255;
    CHECK_EQUAL(met, reached);
    CHECK(spent <= 4 * b.mesh.nt + 2 * b.mesh.nv + 2);
}

static void rings_by_stars_are_those_of_the_definition(void) {
    uint32_t i, k;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin(i) || !is_manifold()) continue;
        for (k = 0; k < b.mesh.nv; k += 3) compare_rings(nook_at(NOOK_AT_VERTEX, k));
        for (k = 0; k < corners(); k += 7) compare_rings(nook_at(NOOK_AT_CORNER, k));
        for (k = 0; k < b.mesh.nt; k += 5) compare_rings(nook_at(NOOK_AT_TRIANGLE, k));
    }
}

/* ---- what is refused, and tables of any bits ----------------------------------------------------------------- */

static void what_a_walk_cannot_do_without_is_asked_for(void) {
    nook_marks few = b.marks;
    nook_rings r;
    nook_components sets;
    nook_neighborhood n;
    begin(2);
    few.max_nt = 7;
    CHECK_EQUAL(nook_flood_begin(NULL, &view, &b.marks, 0), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_flood_begin(&flood, NULL, &b.marks, 0), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_flood_begin(&flood, &view, NULL, 0), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_flood_begin(&flood, &view, &few, 0), NOOK_NO_CAPACITY);
    CHECK_EQUAL(nook_flood_begin(&flood, &view, &b.marks, 8), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_rings_begin(NULL, &view, 0, b.component, b.kept), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_rings_begin(&r, NULL, 0, b.component, b.kept), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_rings_begin(&r, &view, 0, NULL, b.kept), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_rings_begin(&r, &view, 0, b.component, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_rings_begin(&r, &view, 8, b.component, b.kept), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_components_begin(NULL, &view, b.component), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_components_begin(&sets, NULL, b.component), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_components_begin(&sets, &view, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_neighborhood_begin(&n, &view, &b.marks, NULL, nook_at(NOOK_AT_VERTEX, 0)),
                NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_neighborhood_begin(&n, &view, &few, b.stamp, nook_at(NOOK_AT_VERTEX, 0)),
                NOOK_NO_CAPACITY);
    few = b.marks;
    few.max_nv = 5;
    CHECK_EQUAL(nook_neighborhood_begin(&n, &view, &few, b.stamp, nook_at(NOOK_AT_VERTEX, 0)),
                NOOK_NO_CAPACITY);
    few.Mv = NULL;
    CHECK_EQUAL(nook_neighborhood_begin(&n, &view, &few, b.stamp, nook_at(NOOK_AT_VERTEX, 0)),
                NOOK_NULL_ARGUMENT);
    few.Mt = NULL;
    CHECK_EQUAL(nook_neighborhood_begin(&n, &view, &few, b.stamp, nook_at(NOOK_AT_VERTEX, 0)),
                NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_flood_begin(&flood, &view, &few, 0), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_neighborhood_begin(&n, &view, &b.marks, b.stamp, nook_at(NOOK_AT_VERTEX, 6)),
                NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_neighborhood_begin(&n, &view, &b.marks, b.stamp, nook_at(NOOK_AT_CORNER, 24)),
                NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_neighborhood_begin(&n, &view, &b.marks, b.stamp, nook_at(NOOK_AT_TRIANGLE, 8)),
                NOOK_INDEX_OUT_OF_RANGE);
}

/* Everything that walks, over tables of any bits: it ends, and it stays inside the arrays. */
static void walk_everywhere(dice *d) {
    uint32_t c = throw_dice(d, corners()), x, n, units, seed = throw_dice(d, b.mesh.nt), calls;
    nook_related related;
    nook_rings r;
    nook_components sets;
    nook_neighborhood near;
    nook_status status;
    CHECK(nook_valence(&view, c) <= b.mesh.nt);
    CHECK(nook_border_length(&view, c) <= corners());
    for (n = NOOK_VV; n <= NOOK_VF; n++) {
        uint32_t found = 0;
        (void)nook_related_begin(&related, &view, (nook_relation)n, throw_dice(d, b.mesh.nv));
        while (nook_related_next(&related, &x)) found++;
        CHECK(found <= b.mesh.nt + 1);
    }
    CHECK_EQUAL(nook_flood_begin(&flood, &view, &b.marks, throw_dice(d, 2) ? NOOK_NONE : seed), NOOK_OK);
    units = 6 * b.mesh.nt + 10;
    while ((status = nook_flood_step(&flood, &units)) == NOOK_TRIANGLE) {
    }
    CHECK(status == NOOK_OK || status == NOOK_BAD_OPPOSITE);
    CHECK(run_rings(&r, seed, 3) == NOOK_OK);
    CHECK_EQUAL(nook_components_begin(&sets, &view, b.component), NOOK_OK);
    units = 7 * b.mesh.nt + 6 * b.mesh.nt * 8;
    CHECK_EQUAL(nook_components_step(&sets, &units), NOOK_OK);
    CHECK_EQUAL(nook_neighborhood_begin(&near, &view, &b.marks, b.stamp, nook_at(NOOK_AT_CORNER, c)),
                NOOK_OK);
    for (calls = 0, status = NOOK_MORE;
         calls < 8 * b.mesh.nt + 100 && (status == NOOK_MORE || status == NOOK_TRIANGLE); calls++) {
        units = 1;
        status = nook_neighborhood_step(&near, &units);
    }
    CHECK(status == NOOK_OK || status == NOOK_BAD_OPPOSITE || status == NOOK_INDEX_OUT_OF_RANGE);
}

static void walks_over_spoiled_tables_end_in_time(void) {
    dice d = {60229u};
    uint32_t round, k, i;
    for (round = 0; round < (NOOK_TEST_RAM < 2000000 ? 60 : 3000) && !test_has_failed(); round++) {
        i = throw_dice(&d, shape_count);
        if (!begin(i)) continue;
        for (k = throw_dice(&d, 12); k > 0; k--) {
            uint32_t c = throw_dice(&d, corners());
            switch (throw_dice(&d, 4)) {
            case 0: b.mesh.O[c] = (nook_index)throw_dice(&d, UINT32_MAX); break;
            case 1: b.mesh.O[c] = (nook_index)throw_dice(&d, corners()); break;
            case 2: b.mesh.V[c] = (nook_index)throw_dice(&d, b.mesh.nv); break;
            default: b.mesh.C[throw_dice(&d, b.mesh.nv)] = (nook_index)throw_dice(&d, corners()); break;
            }
        }
        walk_everywhere(&d);
    }
}

/* Every O of two triangles: loops that never come back to where they began among them. */
static void border_loops_end_whatever_O_holds(void) {
    uint32_t table, c, endless = 0, step = NOOK_TEST_RAM < 2000000 ? 13 : 1;
    for (table = 0; table < 262144 && !test_has_failed(); table += step) {
        begin_shape(4);
        add(0, 1, 2);
        add(0, 2, 3);
        for (c = 0; c < 6; c++) {
            uint32_t across = table >> 3 * c & 7;
            b.mesh.O[c] = nook_store(across == 7 ? NOOK_STORED_NONE : across);
        }
        view = nook_view_of(&b.mesh);
        for (c = 0; c < 6; c++) {
            uint32_t length = nook_border_length(&view, c);
            CHECK(length <= 6);
            endless +=
                length == 0 && nook_is_border(&view, c) && nook_border_next(&view, c, true) != NOOK_NONE;
        }
    }
    CHECK(endless > 0);
}

static void walks_say_where_tables_do_not_hold(void) {
    nook_neighborhood n;
    uint32_t c, v[3], units = 1000;
    nook_status status;
    begin(6); /* a disk */
    for (c = 0; !nook_is_border(&view, c); c++) {
    }
    for (units = 0; units < corners(); units++) { /* nobody is at the vertex where the border goes on */
        if (units / 3 != c / 3 && view.V[units] == view.V[nook_next(c)])
            b.mesh.V[units] = nook_store(view.nv);
    }
    CHECK_EQUAL(nook_next_halfedge(&view, nook_halfedge(&view, c) ^ 1), NOOK_NONE);
    CHECK_EQUAL(nook_oprev(&view, nook_halfedge(&view, c)), NOOK_NONE);
    CHECK_EQUAL(nook_rnext(&view, nook_halfedge(&view, c)), NOOK_NONE);

    begin(1); /* a tetrahedron */
    b.mesh.V[1] = nook_store(view.nv);
    memset(b.Mv, 0, sizeof b.Mv);
    units = 100;
    CHECK_EQUAL(nook_flood_begin(&flood, &view, &b.marks, 0), NOOK_OK);
    CHECK_EQUAL(nook_flood_step(&flood, &units), NOOK_TRIANGLE);
    CHECK_EQUAL(nook_flood_new_vertices(&flood, b.Mv, v), 2); /* the third is no vertex */
    CHECK_EQUAL(nook_neighborhood_begin(&n, &view, &b.marks, b.stamp, nook_at(NOOK_AT_TRIANGLE, 0)), NOOK_OK);
    do {
        status = nook_neighborhood_step(&n, &units);
    } while (status == NOOK_TRIANGLE);
    CHECK(status == NOOK_OK || status == NOOK_BAD_OPPOSITE);
    CHECK(n.tail <= view.nv);
}

/* More bytes of marks for the vertices than for the triangles; and a seed that has no triangle. */
static void an_isolated_seed_has_no_rings(void) {
    nook_neighborhood n;
    uint32_t units = 1000;
    begin_shape(60);
    add(0, 1, 2);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    view = nook_view_of(&b.mesh);
    memset(b.Mv, 0xFF, sizeof b.Mv);
    CHECK_EQUAL(nook_neighborhood_begin(&n, &view, &b.marks, b.stamp, nook_at(NOOK_AT_VERTEX, 50)), NOOK_OK);
    CHECK_EQUAL(nook_neighborhood_step(&n, &units), NOOK_OK);
    CHECK_EQUAL(n.tail, 1);
    CHECK_EQUAL(nook_neighborhood_begin(&n, &view, &b.marks, b.stamp, nook_at(NOOK_AT_VERTEX, 2)), NOOK_OK);
    CHECK_EQUAL(nook_neighborhood_step(&n, &units), NOOK_TRIANGLE);
    CHECK_EQUAL(n.ring, 1);
    CHECK_EQUAL(nook_neighborhood_step(&n, &units), NOOK_OK);
    CHECK_EQUAL(n.tail, 3);
}

/* O that names no corner is as good as a border for what looks across. */
static void nothing_lies_across_an_opposite_that_does_not_exist(void) {
    nook_view v;
    nook_related all;
    uint32_t element, n;
    tetrahedron();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    b.mesh.O[0] = nook_store(3 * b.mesh.nt);
    v = nook_view_of(&b.mesh);
    CHECK_EQUAL(nook_halfedge_corner(&v, 1), NOOK_NONE);
    CHECK_EQUAL(nook_left_face(&v, 1), NOOK_NONE);
    CHECK_EQUAL(nook_related_begin(&all, &v, NOOK_EF, 0), NOOK_OK);
    for (n = 0; nook_related_next(&all, &element); n++) CHECK_EQUAL(element, n == 0 ? 0 : NOOK_NONE);
    CHECK_EQUAL(n, 2);
    b.mesh.C[0] = nook_store(3 * b.mesh.nt);
    CHECK_EQUAL(nook_halfedge_of_vertex(&v, 0), NOOK_NONE);
}

static const test tests[] = {
    TEST(a_star_is_the_fan_of_its_corner_each_triangle_once),
    TEST(all_corners_of_a_vertex_are_found_in_all_its_fans),
    TEST(border_loops_are_those_of_the_oracle_also_where_they_touch),
    TEST(lists_about_a_vertex_keep_the_rules_of_their_order),
    TEST(lists_of_edges_and_faces_keep_the_rules_of_their_order),
    TEST(relations_of_nothing_are_refused_or_empty),
    TEST(the_algebra_of_edges_holds_on_both_sides_and_along_holes),
    TEST(an_origin_ring_has_the_edges_of_its_vertex),
    TEST(a_search_takes_three_hops_a_triangle_and_one_a_component),
    TEST(a_search_from_any_seed_reaches_its_whole_component),
    TEST(a_long_strip_needs_no_stack),
    TEST(rings_have_the_distance_across_edges),
    TEST(components_by_sets_are_those_of_the_oracle),
    TEST(rings_by_stars_are_those_of_the_definition),
    TEST(what_a_walk_cannot_do_without_is_asked_for),
    TEST(border_loops_end_whatever_O_holds),
    TEST(walks_say_where_tables_do_not_hold),
    TEST(an_isolated_seed_has_no_rings),
    TEST(walks_over_spoiled_tables_end_in_time),
    TEST(nothing_lies_across_an_opposite_that_does_not_exist),
};

void test_walk(void) { run_tests(tests, sizeof tests / sizeof *tests); }
