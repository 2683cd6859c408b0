/* exact.c -- instructions of the exact predicates on an emulated core that counts them.
 *
 * Over the cases of big.h, each kind by itself: the mean and the most of one call. TICK is the length of a
 * tick of the port in tenths of a nanosecond; the emulator counts 64 ns for every instruction. */
#include "big.h"
#include "nook_port.h"

enum { CASES = 3000 };

static const char *const names[CASE_KINDS] = {"uniform",
                                              "coplanar +-1 ulp",
                                              "on a triangle, rounded",
                                              "small grid",
                                              "same plane",
                                              "CAD: 1e-17 beside 1",
                                              "far away",
                                              "any bits",
                                              "subnormal",
                                              "far apart exponents",
                                              "collinear +-1 ulp",
                                              "edge cases"};

typedef struct cost {
    uint32_t sum, most, calls;
} cost;

static cost costs[CASE_KINDS][3], all[3];
static uint32_t buckets[3][16]; /* of 500 instructions each */

static uint32_t instructions(uint32_t ticks) { return ticks * TICK / 640u; }

static void note(uint32_t kind, uint32_t which, uint32_t before, uint32_t overhead) {
    uint32_t n = instructions(((nook_port_ticks() - before) & 0xFFFFFFu) - overhead);
    cost *c = &costs[kind][which];
    c->sum += n, c->calls++;
    if (n > c->most) c->most = n;
    all[which].sum += n, all[which].calls++;
    if (n > all[which].most) all[which].most = n;
    buckets[which][n / 500u > 15u ? 15u : n / 500u]++;
}

static void print_cost(const cost *c) {
    print_text("  ");
    print_number(c->sum / c->calls);
    print_text(" / ");
    print_number(c->most);
}

int main(void) {
    volatile int sink;
    dice d = {2463534242u};
    uint32_t i, k, before, overhead;
    before = nook_port_ticks();
    overhead = (nook_port_ticks() - before) & 0xFFFFFFu;
    for (i = 0; i < (uint32_t)CASES * CASE_KINDS; i++) {
        nook_point p[4];
        k = throw_case(&d, p);
        before = nook_port_ticks();
        sink = nook_orient3d(&p[0], &p[1], &p[2], &p[3]);
        note(k, 0, before, overhead);
        before = nook_port_ticks();
        sink = nook_orient2d(&p[0], &p[1], &p[2], i % 3u);
        note(k, 1, before, overhead);
        before = nook_port_ticks();
        sink = nook_compare_distances(&p[0], &p[1], &p[2], &p[3]);
        note(k, 2, before, overhead);
    }
    (void)sink;
    print_text("orient3d, orient2d, compare distances: mean / most instructions\n");
    for (k = 0; k <= (uint32_t)CASE_KINDS; k++) {
        for (i = 0; i < 3u; i++) print_cost(k < (uint32_t)CASE_KINDS ? &costs[k][i] : &all[i]);
        print_text("   ");
        print_text(k < (uint32_t)CASE_KINDS ? names[k] : "all");
        print_text("\n");
    }
    for (i = 0; i < 3u; i++) {
        for (k = 0; k < 16u; k++) {
            print_text(" ");
            print_number(buckets[i][k] * 1000u / all[i].calls);
        }
        print_text("  of 1000 calls, by 500 instructions\n");
    }
    return 0;
}
