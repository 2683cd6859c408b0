/* exact.c -- ten million hard cases of each exact predicate against big integers.
 *
 * The cases are those of tests/big.h, from the dice that test_exact.c starts with, so that the first hundred
 * thousand are the ones whose digest every board repeats. */
#include "big.h"
#include "prove.h"

enum { CASES = 10000000 };

static uint32_t wrong[4], zero[4];

static void judge(uint32_t which, int got, int expected) {
    wrong[which] += got != expected;
    zero[which] += expected == 0;
}

/* A triangle of the four and another of them, or both quadrilaterals, in two orders. */
static void judge_normals(const nook_point p[4], uint32_t order) {
    static const uint8_t choice[4][8] = {{0, 1, 2, 2, 1, 3, 2, 2},
                                         {0, 1, 3, 3, 0, 1, 2, 2},
                                         {0, 1, 2, 2, 0, 1, 3, 2},
                                         {0, 1, 2, 3, 2, 0, 3, 1}};
    nook_point q[8];
    const nook_point *one[4], *other[4];
    uint32_t i;
    for (i = 0; i < 8; i++) q[i] = p[choice[order % 4][i]];
    for (i = 0; i < 4; i++) one[i] = &q[i], other[i] = &q[4 + i];
    judge(3, nook_compare_normals(one, other), big_compare_normals(q));
}

static void ten_million_hard_cases(void) {
    dice d = {12345u};
    uint32_t i;
    for (i = 0; i < (uint32_t)CASES; i++) {
        nook_point p[4];
        throw_case(&d, p);
        judge(0, nook_orient3d(&p[0], &p[1], &p[2], &p[3]), big_orient3d(p));
        judge(1, nook_orient2d(&p[0], &p[1], &p[2], i % 3), big_orient2d(p, i % 3));
        judge(2, nook_compare_distances(&p[0], &p[1], &p[2], &p[3]), big_compare_distances(p));
        if (i % 16 == 0) judge_normals(p, i / 16);
    }
    for (i = 0; i < 4; i++) {
        CHECK_EQUAL(wrong[i], 0);
        CHECK(zero[i] > CASES / (i == 3 ? 16000 : 1000));
    }
}

int main(void) {
    static const test tests[] = {TEST(ten_million_hard_cases)};
    uint32_t start = milliseconds();
    run_tests(tests, 1);
    print_figure("exact signs, each of three predicates (and normals: one case of 16)", CASES, "cases",
                 start);
    return finish_tests();
}
