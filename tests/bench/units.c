/* units.c -- the most instructions that one unit of work costs, on an emulated core that counts them.
 *
 * weld, link and check run one unit at a time over a torus, sound and with defects of every kind; the
 * largest difference of the port's ticks is printed. With the emulator counting 2^6 ns for every
 * instruction and 40 ns a tick (25 MHz), instructions are ticks * 40 / 64. */
#include "check.h"
#include "nook.h"
#include "nook_port.h"

enum { SIDE = 24, T = 2 * SIDE * SIDE, MORE = 40, MAX_T = T + MORE, MAX_V = 3 * MAX_T };
static NOOK_MESH_ARRAYS(MAX_V, MAX_T) arrays;
static nook_index map[MAX_V], component[MAX_T], stamp[MAX_V];
static nook_shell shell[MAX_T];
static uint8_t Mt[NOOK_MT_BYTES(MAX_T)], Mv[NOOK_MV_BYTES(MAX_V)];
static nook_mesh mesh;

/* A torus of SIDE x SIDE cells of two triangles, shuffled: 577 and T have no common factor. With
 * defects: some triangles turned over, and a fan of MORE triangles about the vertex of cell 0. */
static void soup(bool defects) {
    static const uint8_t step[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};
    uint32_t k, i;
    nook_mesh_init(&mesh, arrays.G, arrays.V, arrays.O, arrays.C, MAX_V, MAX_T);
    for (k = 0; k < (uint32_t)MORE && defects; k++) {
        const nook_point fan[3] = {{0, 0, 0}, {(float)k, -1, 3}, {(float)k + 1, -1, 3}};
        nook_mesh_append(&mesh, fan);
    }
    for (k = 0; k < (uint32_t)T; k++) {
        nook_point p[3], keep;
        uint32_t t = k * 577u % T;
        for (i = 0; i < 3u; i++) {
            uint32_t x = (t / 2u + step[t & 1u][i][0]) % SIDE,
                     y = (t / 2u / SIDE + step[t & 1u][i][1]) % SIDE;
            p[i] = nook_make((float)x * 1.37f, (float)y * 0.61f, (float)((x * 7u + y * 5u) % 11u));
        }
        keep = p[0];
        if (defects && k % 50u == 7u) p[0] = p[1], p[1] = keep;
        nook_mesh_append(&mesh, p);
    }
}

static void print_most(const char *what, uint32_t most) {
    print_text(what);
    print_number(most * 40u / 64u);
    print_text(" instructions\n");
}

/* Ticks for reading the counter twice, to be taken off. */
static uint32_t overhead(void) {
    uint32_t a = nook_port_ticks(), b = nook_port_ticks();
    return (b - a) & 0xFFFFFFu;
}

#define MOST_TICKS(most, step)                                                                               \
    do {                                                                                                     \
        uint32_t units = 1, before = nook_port_ticks(), spent;                                               \
        status = (step);                                                                                     \
        spent = ((nook_port_ticks() - before) & 0xFFFFFFu) - overhead();                                     \
        if (spent > (most)) (most) = spent;                                                                  \
    } while (status == NOOK_MORE)

static void measure(const char *name, bool defects) {
    nook_marks marks = {Mt, Mv, MAX_T, MAX_V};
    nook_shells shells = {shell, component, stamp, MAX_T, 0};
    nook_weld_state weld;
    nook_link_state link;
    nook_check_state check;
    nook_report report;
    nook_check_result result;
    nook_view view;
    nook_status status;
    uint32_t w = 0, l = 0, c = 0;
    soup(defects);
    nook_weld_begin(&weld, &mesh, map, arrays.O);
    MOST_TICKS(w, nook_weld_step(&weld, &units));
    nook_link_begin(&link, &mesh, &marks, &shells, NULL, &report);
    MOST_TICKS(l, nook_link_step(&link, &units));
    view = nook_view_of(&mesh);
    nook_check_begin(&check, &view, &marks, &report, &shells, NULL, &result);
    MOST_TICKS(c, nook_check_step(&check, &units));
    print_text(name);
    print_text("\n");
    print_most("  weld, one unit:  ", w);
    print_most("  link, one unit:  ", l);
    print_most("  check, one unit: ", c);
}

int main(void) {
    measure("torus", false);
    measure("torus with defects", true);
    return 0;
}
