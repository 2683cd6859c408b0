/* exact.c -- ten million hard cases of each exact predicate against big integers.
 *
 * The cases are those of tests/big.h, from the dice that test_exact.c starts with, so that the first hundred
 * thousand are the ones whose digest every board repeats. */
#include "big.h"
#include "prove.h"

enum { CASES = 10000000 };

static uint32_t wrong[3], zero[3];

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
    }
    for (i = 0; i < 3; i++) {
        CHECK_EQUAL(wrong[i], 0);
        CHECK(zero[i] > CASES / 1000);
    }
}

int main(void) {
    static const test tests[] = {TEST(ten_million_hard_cases)};
    uint32_t start = milliseconds();
    run_tests(tests, 1);
    print_figure("exact signs, each of three predicates", CASES, "cases", start);
    return finish_tests();
}
