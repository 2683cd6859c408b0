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

static void ten_million_hard_cases(void) {
    dice d = {12345u};
    uint32_t i;
    for (i = 0; i < (uint32_t)CASES; i++) {
        nook_point p[4];
        throw_case(&d, p);
        judge(0, nook_orient3d(&p[0], &p[1], &p[2], &p[3]), big_orient3d(p));
        judge(1, nook_orient2d(&p[0], &p[1], &p[2], i % 3), big_orient2d(p, i % 3));
        judge(2, nook_compare_distances(&p[0], &p[1], &p[2], &p[3]), big_compare_distances(p));
        if (i % 16 == 0) {
            int expected, sign = compare_pieces(p, i / 16, &expected);
            judge(3, sign, expected);
        }
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
