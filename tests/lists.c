/* lists.c -- see lists.h. */
#include "lists.h"

#include <string.h>

nook_index list[MOST_C];
uint32_t listed;
nook_check_result list_result;

static nook_mesh other; /* for the list, linked anew */
static NOOK_MESH_ARRAYS(MOST, MOST) other_arrays;
static nook_report other_report;

static NOOK_MESH_ARRAYS(MOST, MOST) kept;

void take_list(void) {
    listed = b.mesh.nt;
    memcpy(list, b.mesh.V, 3 * listed * sizeof *list);
}

bool list_has(uint32_t t, uint32_t v) {
    return list[3 * t] == v || list[3 * t + 1] == v || list[3 * t + 2] == v;
}

/* Link the list; whether it is a manifold without duplicates, whose directions agree. */
bool list_is_manifold(uint32_t nv) {
    nook_view view;
    uint32_t v;
    nook_mesh_init(&other, other_arrays.G, other_arrays.V, other_arrays.O, other_arrays.C, MOST, MOST);
    for (v = 0; v < nv; v++) other.G[v] = nook_make((float)v, (float)(v * v % 17), (float)(v * v * v % 23));
    memcpy(other.V, list, 3 * listed * sizeof *list);
    other.nv = nv;
    other.nt = listed;
    if (nook_link(&other, &b.marks, NULL, NULL, &other_report, NULL) != NOOK_OK) return false;
    view = nook_view_of(&other);
    CHECK_EQUAL(nook_check(&view, &b.marks, &other_report, NULL, NULL, &list_result), NOOK_OK);
    return list_result.manifold == NOOK_YES && other_report.incoherent_edges == 0 &&
           other_report.duplicate_triangles == 0;
}

/* The tables of b.mesh are whole, and O is what its V says. */
void tables_hold(void) {
    nook_view view = nook_view_of(&b.mesh);
    uint32_t c;
    take_list();
    CHECK(listed == 0 || list_is_manifold(b.mesh.nv));
    for (c = 0; c < 3 * b.mesh.nt; c++) CHECK_EQUAL(b.mesh.O[c], other.O[c]);
    CHECK_EQUAL(nook_check(&view, &b.marks, NULL, NULL, NULL, &b.result), NOOK_OK);
    CHECK_EQUAL(b.result.bad_indices + b.result.bad_opposites + b.result.bad_corners, 0);
}

void keep(void) {
    memcpy(kept.V, b.mesh.V, sizeof kept.V);
    memcpy(kept.O, b.mesh.O, sizeof kept.O);
    memcpy(kept.C, b.mesh.C, sizeof kept.C);
    memcpy(kept.G, b.mesh.G, sizeof kept.G);
}

void restore(uint32_t nv, uint32_t nt) {
    memcpy(b.mesh.V, kept.V, sizeof kept.V);
    memcpy(b.mesh.O, kept.O, sizeof kept.O);
    memcpy(b.mesh.C, kept.C, sizeof kept.C);
    memcpy(b.mesh.G, kept.G, sizeof kept.G);
    b.mesh.nv = nv;
    b.mesh.nt = nt;
}

uint32_t list_opposite(uint32_t c) { return other.O[c]; }

const nook_index *kept_V(void) { return kept.V; }

void starts_as_kept(uint32_t nt) {
    CHECK_EQUAL(b.mesh.nt, nt);
    CHECK(memcmp(b.mesh.V, kept.V, 3 * nt * sizeof *kept.V) == 0);
    CHECK(memcmp(b.mesh.O, kept.O, 3 * nt * sizeof *kept.O) == 0);
}

void is_as_kept(void) {
    CHECK(memcmp(b.mesh.V, kept.V, sizeof kept.V) == 0 && memcmp(b.mesh.O, kept.O, sizeof kept.O) == 0);
    CHECK(memcmp(b.mesh.C, kept.C, sizeof kept.C) == 0 && memcmp(b.mesh.G, kept.G, sizeof kept.G) == 0);
}

/* Coherent manifold shapes that fit. The numbers of the whole are in list_result. */
bool begin_whole(uint32_t i) {
    shapes[i].build();
    if (b.mesh.nt + 4 > MOST || b.mesh.nv + 2 > MOST) return false;
    take_list();
    if (!list_is_manifold(b.mesh.nv)) return false;
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    return true;
}

/* Whether the mesh has exactly the triangles of the list, in any order and turn. */
void same_triangles(void) {
    uint32_t t, u, i;
    CHECK_EQUAL(b.mesh.nt, listed);
    for (t = 0; t < listed; t++) {
        uint32_t found = 0;
        for (u = 0; u < b.mesh.nt; u++) {
            for (i = 0; i < 3; i++) {
                found += b.mesh.V[3 * u + i] == list[3 * t] &&
                         b.mesh.V[3 * u + (i + 1) % 3] == list[3 * t + 1] &&
                         b.mesh.V[3 * u + (i + 2) % 3] == list[3 * t + 2];
            }
        }
        CHECK_EQUAL(found, 1);
    }
}
