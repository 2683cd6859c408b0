/* hull.c -- the hull of every choice of 4 to 8 points of a grid of 3 x 3 x 3, and of many of larger grids.
 *
 * The oracle is of integers and knows no mesh. A plane through three points that has all others on one side holds a face of
 * the hull; a point is a vertex exactly if the normals of three such planes through it are independent; the polygon of a face
 * is wound round its vertices, each time to the one that has all others on the left, and gives the volume.
 * Of the mesh: its vertices are the points that are vertices, by their places and by renamed(); each triangle lies in a plane of the oracle
 * and faces outward, and a face of w vertices has w - 2 of them; O is the pairing looked up in V; C names corners; the volume
 * is that of the oracle. The arrays have room for 2 nv - 4 triangles, and behind that there is a fence.
 *
 * Choices are taken once up to the 48 symmetries of the cube, and the sizes of their orbits must add up to the binomial
 * coefficients; each comes in three orders, so each of its points is among the first four in one of them. */
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "nook.h"
#include "prove.h"

enum { MOST = 48, MOST_PLANES = 2 * MOST };

typedef struct vector {
    int64_t x, y, z;
} vector;

static vector point[MOST];
static uint32_t points, origin[MOST];
static nook_mesh mesh;
static nook_marks marks;
static uint32_t hulls, flats, dropped;

/* ---- the oracle ------------------------------------------------------------------------------------ */

static vector less(vector a, vector b) {
    vector d = {a.x - b.x, a.y - b.y, a.z - b.z};
    return d;
}

static vector across(vector a, vector b) {
    vector n = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return n;
}

static int64_t dot(vector a, vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static vector normal_of(vector a, vector b, vector c) { return across(less(b, a), less(c, a)); }

static bool is_zero(vector a) { return a.x == 0 && a.y == 0 && a.z == 0; }

static struct {
    uint64_t on[MOST_PLANES]; /* the points in each plane */
    vector normal[MOST_PLANES];
    uint32_t planes;
    uint64_t vertices;
    int64_t volume; /* six times */
} known;

/* The plane of three points is a face's if all others are on one side, and some are. */
static void try_plane(uint32_t i, uint32_t j, uint32_t k) {
    vector n = normal_of(point[i], point[j], point[k]);
    uint64_t on = 0;
    uint32_t v;
    int side = 0;
    if (is_zero(n)) return;
    for (v = 0; v < points; v++) {
        int64_t d = dot(n, less(point[v], point[i]));
        if (d == 0) on |= (uint64_t)1 << v;
        if ((d < 0 && side > 0) || (d > 0 && side < 0)) return;
        if (d != 0) side = d < 0 ? -1 : 1;
    }
    if (side == 0) return;
    for (v = 0; v < known.planes; v++) {
        if (known.on[v] == on) return;
    }
    if (side > 0) n = less(less(n, n), n);
    known.on[known.planes] = on;
    known.normal[known.planes++] = n;
}

static bool is_vertex(uint32_t v) {
    uint32_t i, j, k;
    for (i = 0; i < known.planes; i++) {
        for (j = 0; j < i && known.on[i] >> v & 1u; j++) {
            for (k = 0; k < j && known.on[j] >> v & 1u; k++) {
                vector n = across(known.normal[i], known.normal[j]);
                if ((known.on[k] >> v & 1u) != 0 && dot(n, known.normal[k]) != 0) return true;
            }
        }
    }
    return false;
}

static uint32_t next_round(uint32_t v, uint64_t on, vector n) {
    uint32_t w, best = NOOK_NONE;
    for (w = 0; w < points; w++) {
        if ((on >> w & 1u) == 0 || w == v) continue;
        if (best == NOOK_NONE || dot(n, normal_of(point[v], point[best], point[w])) < 0) best = w;
    }
    return best;
}

static int64_t volume_under(uint32_t plane) {
    uint64_t on = known.on[plane] & known.vertices;
    uint32_t first = 0, v, w;
    int64_t sum = 0;
    while ((on >> first & 1u) == 0) first++;
    for (v = next_round(first, on, known.normal[plane]); v != first; v = w) {
        w = next_round(v, on, known.normal[plane]);
        sum += dot(across(point[first], point[v]), point[w]);
    }
    return sum;
}

static void ask_oracle(void) {
    uint32_t i, j, k;
    memset(&known, 0, sizeof known);
    for (i = 0; i < points; i++) {
        for (j = 0; j < i; j++) {
            for (k = 0; k < j; k++) try_plane(i, j, k);
        }
    }
    for (i = 0; i < points; i++) {
        if (is_vertex(i)) known.vertices |= (uint64_t)1 << i;
    }
    for (i = 0; i < known.planes; i++) known.volume += volume_under(i);
}

static uint32_t count_bits(uint64_t bits) {
    uint32_t n = 0;
    for (; bits != 0; bits &= bits - 1) n++;
    return n;
}

/* ---- the mesh -------------------------------------------------------------------------------------- */

static void hear(void *user, nook_kind kind, uint32_t from, uint32_t to) {
    (void)user;
    if (kind != NOOK_AT_VERTEX || from >= points || to >= from) CHECK(false);
    origin[to] = origin[from];
}
static const nook_edit listening = {.renamed = hear};

static void make_room(uint32_t nv) {
    uint32_t max_nt = nv < 3 ? 0 : 2 * nv - 4;
    drop_fences();
    marks.max_nv = nv;
    marks.max_nt = max_nt;
    marks.Mt = fenced(NOOK_MT_BYTES(max_nt));
    marks.Mv = fenced(NOOK_MV_BYTES(nv));
    CHECK_EQUAL(
        nook_mesh_init(&mesh, fenced(nv * sizeof(nook_point)), fenced(3 * max_nt * sizeof(nook_index)),
                       fenced(3 * max_nt * sizeof(nook_index)), fenced(nv * sizeof(nook_index)), nv, max_nt),
        NOOK_OK);
}

static void vertices_are_those_known(void) {
    uint64_t vertices = 0;
    uint32_t v;
    for (v = 0; v < mesh.nv; v++) {
        vector p = point[origin[v]];
        nook_point g = mesh.G[v];
        if (g.x != (float)p.x || g.y != (float)p.y || g.z != (float)p.z) CHECK(false);
        if (mesh.C[v] >= 3 * mesh.nt || mesh.V[mesh.C[v]] != v) CHECK(false);
        vertices |= (uint64_t)1 << origin[v];
    }
    if (vertices != known.vertices || mesh.nv != count_bits(vertices)) CHECK(false);
    if (mesh.nt != 2 * mesh.nv - 4) CHECK_EQUAL(mesh.nt, 2 * mesh.nv - 4);
}

static void faces_are_those_known(void) {
    uint32_t left[MOST_PLANES], t, i;
    int64_t volume = 0;
    for (i = 0; i < known.planes; i++) left[i] = count_bits(known.on[i] & known.vertices) - 2;
    for (t = 0; t < mesh.nt; t++) {
        uint32_t a = origin[mesh.V[3 * t]], b = origin[mesh.V[3 * t + 1]], c = origin[mesh.V[3 * t + 2]];
        uint64_t all = (uint64_t)1 << a | (uint64_t)1 << b | (uint64_t)1 << c;
        vector n = normal_of(point[a], point[b], point[c]);
        for (i = 0; i < known.planes && (known.on[i] & all) != all; i++) continue;
        if (i == known.planes || dot(n, known.normal[i]) <= 0 || left[i]-- == 0) CHECK(false);
        volume += dot(across(point[a], point[b]), point[c]);
    }
    for (i = 0; i < known.planes; i++) {
        if (left[i] != 0) CHECK_EQUAL(left[i], 0);
    }
    if (volume != known.volume || volume <= 0) CHECK(false);
}

/* Every edge is run once each way, and O says where. That all is in one piece follows from Euler's number with every
 * vertex counted, as no plane has more than its triangles. */
static void opposites_are_those_of_V(void) {
    uint16_t run[MOST][MOST];
    uint32_t c;
    memset(run, 0, sizeof run);
    for (c = 0; c < 3 * mesh.nt; c++) {
        uint16_t *at = &run[mesh.V[nook_next(c)]][mesh.V[nook_prev(c)]];
        if (*at != 0) CHECK(false);
        *at = (uint16_t)(c + 1);
    }
    for (c = 0; c < 3 * mesh.nt; c++) {
        if (run[mesh.V[nook_prev(c)]][mesh.V[nook_next(c)]] != mesh.O[c] + 1u) CHECK(false);
    }
}

static void try_hull(void) {
    nook_status status;
    uint32_t v;
    for (v = 0; v < points; v++) {
        mesh.G[v] = nook_make((float)point[v].x, (float)point[v].y, (float)point[v].z);
        origin[v] = v;
    }
    mesh.nv = points;
    mesh.nt = 0;
    ask_oracle();
    status = nook_hull(&mesh, &marks, &listening, NULL);
    if (status != (known.planes == 0 ? NOOK_FLAT_SHELL : NOOK_OK)) CHECK(false);
    hulls++;
    if (status != NOOK_OK) {
        flats++;
        if (mesh.nv != points || mesh.nt != 0) CHECK(false);
        return;
    }
    dropped += points - mesh.nv;
    vertices_are_those_known();
    faces_are_those_known();
    opposites_are_those_of_V();
}

/* ---- all choices of the small grid ------------------------------------------------------------------ */

enum { CELLS = 27, SYMMETRIES = 48 };
static uint32_t image[SYMMETRIES][3][512]; /* of nine cells at a time */

static uint32_t moved(uint32_t cell, uint32_t s) {
    static const uint8_t order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    uint32_t at[3] = {cell % 3, cell / 3 % 3, cell / 9}, to = 0, i;
    for (i = 3; i-- > 0;) {
        uint32_t x = at[order[s / 8][i]];
        to = 3 * to + (s >> i & 1u ? 2 - x : x);
    }
    return to;
}

static void make_images(void) {
    uint32_t s, part, bits, i;
    for (s = 0; s < SYMMETRIES; s++) {
        for (part = 0; part < 3; part++) {
            for (bits = 0; bits < 512; bits++) {
                for (i = 0; i < 9; i++) {
                    if (bits >> i & 1u) image[s][part][bits] |= 1u << moved(9 * part + i, s);
                }
            }
        }
    }
}

/* The size of the orbit of a choice that is the smallest in it, else 0. */
static uint32_t orbit_of(uint32_t choice) {
    uint32_t s, fixed = 0;
    for (s = 0; s < SYMMETRIES; s++) {
        uint32_t other =
            image[s][0][choice & 511u] | image[s][1][choice >> 9 & 511u] | image[s][2][choice >> 18];
        if (other < choice) return 0;
        fixed += other == choice;
    }
    return SYMMETRIES / fixed;
}

static void turn_order(uint32_t by) {
    vector keep[MOST];
    uint32_t i;
    memcpy(keep, point, sizeof keep);
    for (i = 0; i < points; i++) point[i] = keep[(points - 1 - i + by) % points];
}

static void try_choice(uint32_t choice) {
    uint32_t i;
    for (points = 0, i = 0; i < CELLS; i++) {
        vector p = {(int64_t)(i % 3), (int64_t)(i / 3 % 3), (int64_t)(i / 9)};
        if (choice >> i & 1u) point[points++] = p;
    }
    for (i = 0; i < 3; i++) {
        try_hull();
        turn_order(i + points / 2);
    }
}

static void every_choice_of_points_has_its_hull(void) {
    static const uint32_t binomial[] = {17550, 80730, 296010, 888030, 2220075};
    uint32_t n, start = milliseconds(), before, choices = 0;
    make_images();
    for (n = 4; n <= 8; n++) {
        uint32_t choice = (1u << n) - 1u, total = 0;
        make_room(n);
        before = hulls;
        while (choice < 1u << CELLS && !test_has_failed()) {
            uint32_t orbit = orbit_of(choice), low = choice & (0u - choice), up = choice + low;
            total += orbit;
            if (orbit != 0) try_choice(choice), choices++;
            choice = up | ((choice ^ up) / low >> 2); /* the next number with as many bits */
        }
        CHECK(fences_hold());
        CHECK_EQUAL(total, binomial[n - 4]);
        CHECK(hulls > before);
    }
    drop_fences();
    print_figure("choices of 4 to 8 points of 27, up to symmetry", choices, "in three orders", start);
}

/* ---- more points ------------------------------------------------------------------------------------- */

/* In small grids many on lines and planes, in large ones few. */
static void many_points_have_their_hull(void) {
    dice d = {1};
    uint32_t i, v, start = milliseconds(), before = hulls;
    for (i = 0; i < 60000 && !test_has_failed(); i++) {
        uint32_t sides = 2 + throw_dice(&d, 5) * throw_dice(&d, 5) * 2;
        points = 0;
        make_room(4 + throw_dice(&d, i % 20 == 0 ? MOST - 3 : 20));
        for (v = mesh.max_nv; v > 0; v--) {
            int64_t x = (int64_t)throw_dice(&d, sides), y = (int64_t)throw_dice(&d, sides);
            vector p = {x, y, (int64_t)throw_dice(&d, sides)};
            uint32_t k;
            for (k = 0; k < points && !is_zero(less(point[k], p)); k++) continue;
            if (k == points) point[points++] = p;
        }
        try_hull();
        CHECK(fences_hold());
        drop_fences();
    }
    print_figure("sets of up to 48 points of larger grids", hulls - before, "sets", start);
}

int main(void) {
    static const test tests[] = {TEST(every_choice_of_points_has_its_hull),
                                 TEST(many_points_have_their_hull)};
    run_tests(tests, sizeof tests / sizeof *tests);
    (void)printf("%u hulls and %u flat sets, %u points inside\n", (unsigned)(hulls - flats), (unsigned)flats,
                 (unsigned)dropped);
    return finish_tests();
}
