/* test_exact.c -- signs that rounding cannot turn, against big integers and against what must hold of them.
 *
 * The oracle is big.c, which shares no method with the library. That a PC, a core with an FPU and one without
 * decide 100,000 hard cases alike is shown by one digest of all signs; `make prove` holds ten million such
 * cases against the oracle. */
#include "big.h"
#include "rooms.h"

#include <string.h>

#if NOOK_TEST_RAM < 2000000
enum { AGAINST_ORACLE = 2000 };
#else
enum { AGAINST_ORACLE = 30000 };
#endif
enum { IN_DIGEST = 100000 };

static int orient3d(const nook_point p[4]) { return nook_orient3d(&p[0], &p[1], &p[2], &p[3]); }
static int orient2d(const nook_point p[3], uint32_t axis) { return nook_orient2d(&p[0], &p[1], &p[2], axis); }
static int distances(const nook_point p[4]) { return nook_compare_distances(&p[0], &p[1], &p[2], &p[3]); }

/* ---- cases ----------------------------------------------------------------------------------------- */

static void hard_cases_have_the_sign_of_big_integers(void) {
    dice d = {88172645u};
    uint32_t i, axis;
    int expected = 0, sign;
    for (i = 0; i < (uint32_t)AGAINST_ORACLE && !test_has_failed(); i++) {
        nook_point p[4];
        throw_case(&d, p);
        CHECK_EQUAL(orient3d(p), big_orient3d(p));
        for (axis = 0; axis < 3; axis++) CHECK_EQUAL(orient2d(p, axis), big_orient2d(p, axis));
        CHECK_EQUAL(distances(p), big_compare_distances(p));
        sign = compare_pieces(p, i / 8, &expected);
        CHECK_EQUAL(sign, expected);
    }
}

/* CRC-32 of a byte a case: the three signs in base 3. */
static void a_hundred_thousand_hard_cases_have_one_digest_on_all_machines(void) {
    dice d = {12345u};
    uint32_t i, crc = UINT32_MAX, bit;
    for (i = 0; i < (uint32_t)IN_DIGEST; i++) {
        nook_point p[4];
        throw_case(&d, p);
        crc ^= (uint32_t)(orient3d(p) + 1 + 3 * (orient2d(p, i % 3) + 1) + 9 * (distances(p) + 1));
        for (bit = 0; bit < 8; bit++) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0);
    }
    CHECK_EQUAL(~crc, 0xE26969F9u);
}

/* Every choice of four corners of a cube, at three sizes an axis: small, with all bits in use, and with
 * corners that are neighbouring floats. */
static void every_choice_of_cube_corners(void) {
    static const float low[3] = {-1, 0.1f, 1}, high[3] = {1, 0.7f, 1.00000012f};
    uint32_t choice, size, i, axis;
    for (size = 0; size < 27; size++) {
        for (choice = 0; choice < 4096 && !test_has_failed(); choice += NOOK_TEST_RAM < 2000000 ? 5 : 1) {
            const uint32_t sx = size % 3, sy = size / 3 % 3, sz = size / 9;
            int32_t u[4][3], minor, expected, turns[3];
            nook_point p[4];
            for (i = 0; i < 4; i++) {
                for (axis = 0; axis < 3; axis++) u[i][axis] = (int32_t)(choice >> (3 * i + axis) & 1);
                p[i] = nook_make(u[i][0] ? high[sx] : low[sx], u[i][1] ? high[sy] : low[sy],
                                 u[i][2] ? high[sz] : low[sz]);
            }
            for (expected = 0, axis = 0; axis < 3; axis++) {
                uint32_t v = (axis + 1) % 3, w = (axis + 2) % 3;
                minor = (u[1][v] - u[0][v]) * (u[2][w] - u[0][w]) - (u[2][v] - u[0][v]) * (u[1][w] - u[0][w]);
                turns[axis] = minor;
                expected += minor * (u[3][axis] - u[0][axis]);
            }
            CHECK_EQUAL(orient3d(p), (expected > 0) - (expected < 0));
            for (axis = 0; axis < 3; axis++) {
                CHECK_EQUAL(orient2d(p, axis), (turns[axis] > 0) - (turns[axis] < 0));
            }
        }
    }
}

/* The walls of a cube: the same, opposite, and at right angles; and a dent that floats would call right. */
static void normals_of_walls(void) {
    static const nook_point p[8] = {{0, 0, 0},    {0.1f, 0, 0},    {0.1f, 0.1f, 0},    {0, 0.1f, 0},
                                    {0, 0, 0.1f}, {0.1f, 0, 0.1f}, {0.1f, 0.1f, 0.1f}, {0, 0.1f, 0.1f}};
    static const nook_point dent = {0.1f, -1e-9f, 1e30f}, bump = {0.1f, 1e-9f, 1e30f};
    const nook_point *const floor[4] = {&p[0], &p[1], &p[2], &p[3]}, *const roof[4] = {&p[7], &p[6], &p[5],
                                                                                       &p[4]};
    const nook_point *const wall[4] = {&p[0], &p[1], &p[5], &p[4]}, *const line[4] = {&p[0], &p[1], &p[1],
                                                                                      &p[1]};
    const nook_point *const in[4] = {&p[0], &p[1], &dent, &dent}, *const out[4] = {&p[0], &p[1], &bump,
                                                                                   &bump};
    CHECK(nook_compare_normals(floor, floor) == 1 && nook_compare_normals(floor, roof) == -1);
    CHECK(nook_compare_normals(floor, wall) == 0 && nook_compare_normals(wall, roof) == 0);
    CHECK(nook_compare_normals(line, floor) == 0 && nook_compare_normals(floor, line) == 0);
    CHECK(nook_compare_normals(floor, in) == -1 && nook_compare_normals(floor, out) == 1);
}

static nook_point points[4];

static void set(uint32_t i, float x, float y, float z) { points[i] = nook_make(x, y, z); }

/* a b c counter-clockwise in the plane z, d at (x, y, w). */
static int above_triangle(float z, float x, float y, float w) {
    set(0, -3, -3, z);
    set(1, 3, -3, z);
    set(2, 0, 5, z);
    set(3, x, y, w);
    return orient3d(points);
}

static void the_side_of_a_plane_is_told_to_the_last_place(void) {
    static const float z[] = {0, 1, -1, 0.1f, 1073741824.0f, -1073741824.0f, 1e-30f, 1.4e-45f};
    uint32_t i;
    for (i = 0; i < sizeof z / sizeof *z; i++) {
        uint32_t bits = nook_float_bits(z[i]);
        float up = nook_float_from(z[i] < 0 ? bits - 1 : bits + 1);
        float down = z[i] == 0 ? -1.4e-45f : nook_float_from(z[i] < 0 ? bits + 1 : bits - 1);
        CHECK_EQUAL(above_triangle(z[i], 0, 0, z[i]), 0);
        CHECK_EQUAL(above_triangle(z[i], 0, 0, up), 1);
        CHECK_EQUAL(above_triangle(z[i], 0, 0, down), -1);
        CHECK_EQUAL(above_triangle(z[i], 3e38f, -3e38f, up), 1);
    }
    CHECK_EQUAL(above_triangle(0, 1, 1, -0.0f), 0);
    CHECK_EQUAL(above_triangle(-0.0f, 1, 1, 0), 0);
}

/* 1e-17 and 1e-33 beside 1, as CAD programs write for 0: not the same as 0. */
static void tiny_coordinates_beside_large_ones_count(void) {
    set(0, 0, 0, 1e-33f);
    set(1, 1, 0, 0);
    set(2, 0, 1, 0);
    set(3, 1, 1, 0);
    CHECK_EQUAL(orient3d(points), big_orient3d(points));
    CHECK(orient3d(points) != 0);
    set(3, 0.5f, 0.5f, 0);
    CHECK_EQUAL(orient3d(points), 0);
    set(3, 0.5f, 0.5f, -1e-17f);
    CHECK(orient3d(points) != 0);
}

/* Rounding of more than two eps: floats alone have the other sign, so the filter must not trust itself there. */
static void rounding_of_more_than_two_eps_turns_no_sign(void) {
    set(0, 0x1.146888p+0f, 0x1.82c414p-4f, -0x1.b4a6fp-3f);
    set(1, -0x1.386c1p-4f, 0x1.3c9eacp-2f, 0x1.d4f36p+0f);
    set(2, -0x1.0aa5f6p-2f, -0x1.36c26ap-3f, -0x1.74a6dep-2f);
    set(3, -0x1.f428d2p-4f, 0x1.6b63ecp-2f, 0x1.0d1346p+1f);
    CHECK_EQUAL(orient3d(points), 1);
    set(0, -0x1.9d4022p-2f, 0x1.234f6p-4f, 0);
    set(1, 0x1.6576ep-3f, -0x1.3b46a8p+1f, 0);
    set(2, -0x1.d01988p-1f, 0x1.23459cp+1f, 0);
    CHECK_EQUAL(orient2d(points, 2), 1);
    set(0, -0x1.1c14p-1f, -0x1.2aa0aap-1f, 0x1.09cac4p-2f);
    set(1, 0x1.bf54b6p+1f, -0x1.f7e674p-2f, -0x1.b4e97ap-2f);
    set(2, -0x1.614f86p-3f, -0x1.e4b7c8p+1f, 0x1.56cc9p+0f);
    set(3, -0x1.b298p-1f, 0x1.f2a8dep-3f, 0x1.c2a9ccp+0f);
    CHECK_EQUAL(distances(points), -1);
}

static void points_that_fall_together_or_on_a_line_are_coplanar(void) {
    uint32_t i, j;
    dice d = {4321u};
    for (i = 0; i < 200 && !test_has_failed(); i++) {
        throw_case(&d, points);
        for (j = 0; j < 4; j++) {
            nook_point keep = points[j], middle;
            points[j] = points[(j + 1) % 4];
            CHECK_EQUAL(orient3d(points), 0);
            points[j] = keep;
            middle = nook_scaled(points[0], 0.5f);
            if (!(middle.x * 2 == points[0].x && middle.y * 2 == points[0].y && middle.z * 2 == points[0].z))
                continue;
            set(1, 0, 0, 0);
            points[2] = middle;
            CHECK_EQUAL(orient3d(points), 0);
            CHECK_EQUAL(orient2d(points, j % 3), 0);
        }
    }
}

/* ---- laws -------------------------------------------------------------------------------------------- */

static void swap(nook_point *a, nook_point *b) {
    nook_point keep = *a;
    *a = *b;
    *b = keep;
}

static void swapping_two_points_turns_every_sign(void) {
    dice d = {777u};
    uint32_t i, j;
    for (i = 0; i < 1000 && !test_has_failed(); i++) {
        int three, two, far;
        throw_case(&d, points);
        three = orient3d(points), two = orient2d(points, i % 3), far = distances(points);
        for (j = 0; j < 3; j++) {
            swap(&points[j], &points[j + 1]);
            CHECK_EQUAL(orient3d(points), -three);
            if (j < 2) CHECK_EQUAL(orient2d(points, i % 3), -two);
            swap(&points[j], &points[j + 1]);
        }
        swap(&points[0], &points[1]);
        CHECK_EQUAL(distances(points), far);
        swap(&points[0], &points[2]);
        swap(&points[1], &points[3]);
        CHECK_EQUAL(distances(points), -far);
    }
}

static void a_shift_by_a_power_of_two_changes_no_sign(void) {
    dice d = {4711u};
    uint32_t i, j;
    for (i = 0; i < 1000 && !test_has_failed(); i++) {
        int three, far;
        do {
        } while (throw_case(&d, points) >= CASE_CAD); /* kinds with exponents far from both ends */
        three = orient3d(points), far = distances(points);
        for (j = 0; j < 4; j++) points[j] = nook_scaled(points[j], 0x1p-40f);
        CHECK_EQUAL(orient3d(points), three);
        CHECK_EQUAL(distances(points), far);
    }
}

static void facing_names_the_first_axis_with_an_area(void) {
    uint32_t axis;
    set(0, 0, 0, 0);
    set(1, 1, 0, 0);
    set(2, 0, 1, 0);
    CHECK_EQUAL(nook_facing(&points[0], &points[1], &points[2], &axis), 1);
    CHECK_EQUAL(axis, 2);
    CHECK_EQUAL(nook_facing(&points[1], &points[0], &points[2], &axis), -1);
    set(2, 0, 1, 1e-38f);
    CHECK_EQUAL(nook_facing(&points[0], &points[1], &points[2], &axis), -1);
    CHECK_EQUAL(axis, 1);
    set(1, 1, 2, 5);
    CHECK_EQUAL(nook_facing(&points[0], &points[1], &points[2], &axis), -1);
    CHECK_EQUAL(axis, 0);
    set(2, 2, 4, 10);
    CHECK_EQUAL(nook_facing(&points[0], &points[1], &points[2], &axis), 0);
    set(2, 2, 4, 10.000001f);
    CHECK(nook_facing(&points[0], &points[1], &points[2], &axis) != 0);
}

static void distances_are_compared_to_the_last_place(void) {
    set(0, 0, 0, 0);
    set(1, 3, 4, 0);
    set(2, 7, 7, 7);
    set(3, 7, 7, 12);
    CHECK_EQUAL(distances(points), 0);
    set(3, 7, 7, 12.000001f);
    CHECK_EQUAL(distances(points), -1);
    set(3, 7, 7, 11.999999f);
    CHECK_EQUAL(distances(points), 1);
    set(1, 1e-45f, 0, 0);
    points[3] = points[2];
    CHECK_EQUAL(distances(points), 1);
    set(1, 3e38f, 3e38f, 3e38f);
    set(2, -3e38f, 3e38f, 3e38f);
    CHECK_EQUAL(distances(points), big_compare_distances(points));
}

/* Infinities and NaN give some sign and disturb nothing beside the volume. */
static void numbers_that_are_none_do_no_harm(void) {
    static const uint32_t bits[] = {0x7F800000u, 0xFF800000u, 0x7FC00000u,
                                    0xFFFFFFFFu, 0x7F7FFFFFu, 0x3F800000u};
    struct {
        uint32_t before;
        nook_volume volume;
        uint32_t after;
    } room;
    dice d = {31u};
    uint32_t i;
    room.before = room.after = 0x5A5A5A5Au;
    nook_volume_clear(&room.volume);
    for (i = 0; i < 3000; i++) {
        uint32_t j;
        throw_case(&d, points);
        for (j = 0; j < 4; j++) {
            if (throw_dice(&d, 2)) points[j].x = nook_float_from(bits[throw_dice(&d, 6)]);
            if (throw_dice(&d, 2)) points[j].z = nook_float_from(bits[throw_dice(&d, 6)]);
        }
        CHECK(orient3d(points) * orient3d(points) <= 1);
        CHECK(orient2d(points, i % 3) * orient2d(points, i % 3) <= 1);
        CHECK(distances(points) * distances(points) <= 1);
        nook_volume_add(&room.volume, &points[0], &points[1], &points[2]);
    }
    CHECK_EQUAL(room.before, 0x5A5A5A5Au);
    CHECK_EQUAL(room.after, 0x5A5A5A5Au);
}

/* ---- volume ------------------------------------------------------------------------------------------ */

static nook_volume volume_of(const nook_point *p, uint32_t n) {
    nook_volume volume;
    uint32_t t;
    nook_volume_clear(&volume);
    for (t = 0; t < n; t++) nook_volume_add(&volume, &p[3 * t], &p[3 * t + 1], &p[3 * t + 2]);
    return volume;
}

/* a b c / 6 is never nearer to a neighbour of the float. */
static void a_volume_is_rounded_to_the_nearest_float(void) {
    dice d = {99u};
    uint32_t i;
    for (i = 0; i < 2000 && !test_has_failed(); i++) {
        uint32_t a = 1 + throw_dice(&d, 8192), c = 1 + throw_dice(&d, 8192), e = 1 + throw_dice(&d, 8192),
                 side;
        int64_t six = (int64_t)a * c * e, error[3];
        nook_volume volume;
        float value;
        set(0, (float)a, 0, 0);
        set(1, 0, (float)c, 0);
        set(2, 0, 0, (float)e);
        if (i % 2) swap(&points[0], &points[1]);
        volume = volume_of(points, 1);
        value = nook_volume_value(&volume);
        CHECK_EQUAL(nook_volume_sign(&volume), i % 2 ? -1 : 1);
        if (i % 2) value = -value;
        for (side = 0; side < 3; side++) {
            /* Six times the neighbour, in units of 2^-24. */
            float near = nook_float_from(nook_float_bits(value) + side - 1);
            int64_t units = (int64_t)(nook_float_bits(near) & 0x7FFFFFu) + 0x800000;
            int32_t shift = (int32_t)(nook_float_bits(near) >> 23) - 150 + 24;
            error[side] = 6 * (shift >= 0 ? units << shift : units >> -shift) - (six << 24);
            if (error[side] < 0) error[side] = -error[side];
        }
        CHECK(error[1] <= error[0] && error[1] <= error[2]);
    }
}

static void the_order_of_triangles_does_not_matter_to_a_volume(void) {
    enum { N = 8 };
    static nook_point p[3 * N];
    dice d = {5u};
    uint32_t i, j, t;
    for (i = 0; i < 300 && !test_has_failed(); i++) {
        nook_volume one, other, half;
        for (t = 0; t < 3 * N; t++) {
            do {
                throw_case(&d, points);
            } while (nook_point_status(points[t % 4]) != NOOK_OK);
            p[t] = points[t % 4];
        }
        one = volume_of(p, N);
        CHECK_EQUAL(nook_volume_sign(&one), big_volume_sign(p, N));
        half = volume_of(p + 12, N - 4);
        for (t = N; t-- > 1;) {
            uint32_t u = throw_dice(&d, t + 1);
            for (j = 0; j < 3; j++) swap(&p[3 * t + j], &p[3 * u + j]);
        }
        other = volume_of(p, N);
        CHECK(memcmp(&one, &other, sizeof one) == 0);
        nook_volume_merge(&other, &half);
        nook_volume_merge(&one, &half);
        CHECK(memcmp(&one, &other, sizeof one) == 0);
    }
}

static void a_volume_and_its_mirror_cancel_exactly(void) {
    dice d = {6u};
    uint32_t i;
    nook_volume sum, none;
    nook_volume_clear(&sum);
    nook_volume_clear(&none);
    CHECK_EQUAL(nook_volume_sign(&none), 0);
    CHECK(nook_volume_value(&none) == 0);
    for (i = 0; i < 500 && !test_has_failed(); i++) {
        nook_volume one, mirror;
        do {
            throw_case(&d, points);
        } while (nook_point_status(points[0]) + nook_point_status(points[1]) + nook_point_status(points[2]) !=
                 0);
        one = volume_of(points, 1);
        nook_volume_merge(&sum, &one);
        swap(&points[0], &points[2]);
        mirror = volume_of(points, 1);
        CHECK_EQUAL(nook_volume_sign(&mirror), -nook_volume_sign(&one));
        CHECK(nook_volume_value(&mirror) == -nook_volume_value(&one));
        nook_volume_merge(&one, &mirror);
        CHECK(memcmp(&one, &none, sizeof one) == 0);
        nook_volume_merge(&sum, &mirror);
    }
    CHECK_EQUAL(nook_volume_sign(&sum), 0);
}

/* 2^24 + 1 lies half way between two floats: what stands 100 bits below decides. */
static void what_lies_far_below_decides_how_a_volume_rounds(void) {
    uint32_t over, side;
    for (over = 0; over < 2; over++) {
        for (side = 0; side < 3; side++) {
            nook_volume volume, tiny;
            float value, expected = side == 2 ? 16777218.0f : 16777216.0f;
            set(0, 6 * 97, 0, 0);
            set(1, 0, 257, 0);
            set(2, 0, 0, 673);
            if (over) swap(&points[0], &points[1]);
            volume = volume_of(points, 1);
            set(0, 0x1p-40f, 0, 0);
            set(1, 0, 0x1p-40f, 0);
            set(2, 0, 0, side == 1 ? -1.0f : 1.0f);
            if (over) swap(&points[0], &points[1]);
            tiny = volume_of(points, 1);
            if (side != 0) nook_volume_merge(&volume, &tiny);
            value = nook_volume_value(&volume);
            CHECK(value == (over ? -expected : expected));
        }
    }
}

/* The largest coordinates, and the smallest: 6 * 2^90 / 6, and a sixth of 2^-447, which is no float. */
static void volumes_reach_from_end_to_end(void) {
    nook_volume volume;
    float size = 1073741824.0f;
    set(0, size, 0, 0);
    set(1, 0, size, 0);
    set(2, 0, 0, 6);
    volume = volume_of(points, 1);
    CHECK(nook_volume_value(&volume) == size * size);
    set(2, 0, 0, size);
    volume = volume_of(points, 1);
    CHECK(nook_volume_value(&volume) > 0x1.5555p+87f && nook_volume_value(&volume) < 0x1.5556p+87f);
    set(0, 1e-45f, 0, 0);
    set(1, 0, 1e-45f, 0);
    set(2, 0, 0, -1e-45f);
    volume = volume_of(points, 1);
    CHECK_EQUAL(nook_volume_sign(&volume), -1);
    CHECK(nook_volume_value(&volume) == 0);
    set(1, 0, 1, 0);
    set(2, 0, 0, 6 * 3);
    volume = volume_of(points, 1);
    CHECK(nook_volume_value(&volume) == 4.2e-45f);
    set(2, 0, 0, 8);
    volume = volume_of(points, 1);
    CHECK(nook_volume_value(&volume) == 1.4e-45f);
}

/* All ones in a number that was flipped in memory: the carry ends where the words end. */
static void a_spoiled_volume_carries_no_further_than_its_end(void) {
    struct {
        nook_volume volume;
        uint32_t after[4];
    } room;
    uint32_t i;
    for (i = 0; i < 2; i++) {
        memset(&room, i == 0 ? 0xFF : 0, sizeof room);
        set(0, 1, 0, 0);
        set(1, 0, 1, 0);
        set(2, 0, 0, i == 0 ? 1.0f : -1.0f);
        nook_volume_add(&room.volume, &points[0], &points[1], &points[2]);
        CHECK_EQUAL(room.volume.word[NOOK_VOLUME_WORDS - 1], i == 0 ? 0 : UINT32_MAX);
        CHECK_EQUAL(room.after[0], i == 0 ? UINT32_MAX : 0);
    }
}

static const test tests[] = {
    TEST(hard_cases_have_the_sign_of_big_integers),
    TEST(a_hundred_thousand_hard_cases_have_one_digest_on_all_machines),
    TEST(every_choice_of_cube_corners),
    TEST(normals_of_walls),
    TEST(the_side_of_a_plane_is_told_to_the_last_place),
    TEST(tiny_coordinates_beside_large_ones_count),
    TEST(rounding_of_more_than_two_eps_turns_no_sign),
    TEST(points_that_fall_together_or_on_a_line_are_coplanar),
    TEST(swapping_two_points_turns_every_sign),
    TEST(a_shift_by_a_power_of_two_changes_no_sign),
    TEST(facing_names_the_first_axis_with_an_area),
    TEST(distances_are_compared_to_the_last_place),
    TEST(numbers_that_are_none_do_no_harm),
    TEST(a_volume_is_rounded_to_the_nearest_float),
    TEST(the_order_of_triangles_does_not_matter_to_a_volume),
    TEST(a_volume_and_its_mirror_cancel_exactly),
    TEST(what_lies_far_below_decides_how_a_volume_rounds),
    TEST(volumes_reach_from_end_to_end),
    TEST(a_spoiled_volume_carries_no_further_than_its_end),
};

void test_exact(void) { run_tests(tests, sizeof tests / sizeof *tests); }
