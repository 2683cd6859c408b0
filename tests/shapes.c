/* shapes.c -- generators. Their Euler numbers, loops and genus are those of the surfaces they triangulate. */
#include "shapes.h"

bench b;

void place(uint32_t v, float x, float y, float z) { b.mesh.G[v] = nook_make(x, y, z); }

void begin_shape(uint32_t nv) {
    uint32_t v;
    nook_mesh_init(&b.mesh, b.arrays.G, b.arrays.V, b.arrays.O, b.arrays.C, MOST_V, MOST_T);
    b.marks.Mt = b.Mt;
    b.marks.Mv = b.Mv;
    b.marks.max_nt = MOST_T;
    b.marks.max_nv = MOST_V;
    b.shells.shell = b.shell;
    b.shells.component = b.component;
    b.shells.stamp = b.stamp;
    b.shells.max_shells = MOST_SHELLS;
    b.mesh.nv = nv;
    for (v = 0; v < nv; v++) place(v, (float)(v % 7u), (float)(v % 11u), (float)v);
}

void add(uint32_t v0, uint32_t v1, uint32_t v2) {
    nook_index *V = b.mesh.V + 3u * b.mesh.nt++;
    V[0] = nook_store(v0);
    V[1] = nook_store(v1);
    V[2] = nook_store(v2);
}

void add_list(const uint8_t *vertices, uint32_t triangles) {
    uint32_t t;
    for (t = 0; t < triangles; t++) add(vertices[3 * t], vertices[3 * t + 1], vertices[3 * t + 2]);
}

void turn_over(uint32_t t) {
    nook_index keep = b.mesh.V[3 * t];
    b.mesh.V[3 * t] = b.mesh.V[3 * t + 1];
    b.mesh.V[3 * t + 1] = keep;
}

void tetrahedron(void) {
    static const uint8_t list[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    begin_shape(4);
    place(0, 0, 0, 0);
    place(1, 1, 0, 0);
    place(2, 0, 1, 0);
    place(3, 0, 0, 1);
    add_list(list, 4);
}

static void open_tetrahedron(void) {
    tetrahedron();
    b.mesh.nt = 3;
}

void octahedron(void) {
    static const uint8_t list[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    uint32_t v;
    begin_shape(6);
    for (v = 0; v < 6; v++) {
        float at = v % 2u ? -1.0f : 1.0f;
        place(v, v < 2 ? at : 0, v / 2 == 1 ? at : 0, v > 3 ? at : 0);
    }
    add_list(list, 8);
}

void cube(void) {
    static const uint8_t list[] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                   2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    uint32_t v;
    begin_shape(8);
    for (v = 0; v < 8; v++) place(v, (float)(v & 1u), (float)(v >> 1 & 1u), (float)(v >> 2));
    add_list(list, 12);
}

/* The vertex half way between two, found by looking through those made before. */
static uint32_t midpoint(uint32_t v, uint32_t w, uint32_t first) {
    nook_point p = nook_make(b.mesh.G[v].x + b.mesh.G[w].x, b.mesh.G[v].y + b.mesh.G[w].y,
                             b.mesh.G[v].z + b.mesh.G[w].z);
    uint32_t i;
    p = nook_scaled(p, 1.0f / nook_length(p));
    for (i = first; i < b.mesh.nv; i++) {
        if (b.mesh.G[i].x == p.x && b.mesh.G[i].y == p.y && b.mesh.G[i].z == p.z) return i;
    }
    b.mesh.G[b.mesh.nv] = p;
    return b.mesh.nv++;
}

void icosphere(uint32_t levels) {
    uint32_t t, i, nt;
    for (octahedron(); levels > 0; levels--) {
        uint32_t first = b.mesh.nv;
        nt = b.mesh.nt;
        for (t = 0; t < nt; t++) {
            uint32_t v[3], m[3];
            for (i = 0; i < 3; i++) v[i] = b.mesh.V[3 * t + i];
            for (i = 0; i < 3; i++) m[i] = midpoint(v[i], v[(i + 1) % 3], first);
            for (i = 0; i < 3; i++) b.mesh.V[3 * t + i] = nook_store(m[i]);
            for (i = 0; i < 3; i++) add(v[i], m[i], m[(i + 2) % 3]);
        }
    }
}

/* Cells of two triangles; wrapped or not in each direction, and turned over where a row is wrapped. */
static void cells(uint32_t columns, uint32_t rows, bool wrap_x, bool wrap_y, bool twist) {
    uint32_t x, y, wide = columns + !wrap_x, high = rows + !wrap_y, i;
    begin_shape(wide * high);
    for (y = 0; y < rows; y++) {
        for (x = 0; x < columns; x++) {
            uint32_t v[4];
            for (i = 0; i < 4; i++) {
                uint32_t cx = x + (i == 1 || i == 2), cy = y + (i > 1);
                if (cx == columns && wrap_x) {
                    cx = 0;
                    if (twist) cy = wrap_y ? (rows - cy) % rows : rows - cy;
                }
                v[i] = (cy == rows && wrap_y ? 0 : cy) * wide + cx;
            }
            add(v[0], v[1], v[2]);
            add(v[0], v[2], v[3]);
        }
    }
}

void torus(uint32_t columns, uint32_t rows) { cells(columns, rows, true, true, false); }
void grid(uint32_t columns, uint32_t rows) { cells(columns, rows, false, false, false); }
static void small_torus(void) { torus(5, 6); }
static void small_grid(void) { grid(4, 5); }
static void cylinder(void) { cells(6, 3, true, false, false); }
static void moebius(void) { cells(7, 1, true, false, true); }
static void klein_bottle(void) { cells(6, 5, true, true, true); }
static void sphere(void) { icosphere(1); }

static void projective_plane(void) { /* the least one: half an icosahedron */
    static const uint8_t list[] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 1,
                                   1, 3, 4, 2, 4, 5, 3, 5, 1, 4, 1, 2, 5, 2, 3};
    begin_shape(6);
    add_list(list, 10);
}

static void pillow(void) {
    begin_shape(3);
    place(0, 0, 0, 0);
    place(1, 1, 0, 0);
    place(2, 0, 1, 0);
    add(0, 1, 2);
    add(0, 2, 1);
}

static void open_bow_tie(void) {
    begin_shape(5);
    add(0, 1, 2);
    add(0, 3, 4);
}

static void closed_bow_tie(void) { /* two tetrahedra that share vertex 3 */
    static const uint8_t list[] = {3, 5, 4, 3, 4, 6, 4, 5, 6, 5, 3, 6};
    tetrahedron();
    b.mesh.nv = 7;
    place(4, 2, 0, 5);
    place(5, 0, 2, 5);
    place(6, 0, 0, 7);
    add_list(list, 4);
}

static void two_shells(void) {
    static const uint8_t list[] = {4, 6, 5, 4, 5, 7, 5, 6, 7, 6, 4, 7};
    tetrahedron();
    b.mesh.nv = 8;
    place(4, 10, 0, 0);
    place(5, 12, 0, 0);
    place(6, 10, 2, 0);
    place(7, 10, 0, 2);
    add_list(list, 4);
}

void hub_fan(uint32_t valence, bool hub_first) {
    uint32_t i, hub = hub_first ? 0 : valence, rim = hub_first ? 1 : 0;
    begin_shape(valence + 1u);
    for (i = 0; i < valence; i++) add(hub, rim + i, rim + (i + 1u) % valence);
}
static void small_hub(void) { hub_fan(40, true); }

void book(uint32_t pages, uint32_t turned) {
    uint32_t i;
    begin_shape(2u + pages);
    for (i = 0; i < pages; i++) {
        if (turned >> i & 1u) {
            add(1, 0, 2u + i);
        } else {
            add(0, 1, 2u + i);
        }
    }
}

const shape shapes[] = {
    {"open tetrahedron", open_tetrahedron, 1, 1, 0, 1, 0, true},
    {"tetrahedron", tetrahedron, 2, 1, 0, 0, 0, true},
    {"octahedron", octahedron, 2, 1, 0, 0, 0, true},
    {"cube", cube, 2, 1, 0, 0, 0, true},
    {"sphere", sphere, 2, 1, 0, 0, 0, true},
    {"torus", small_torus, 0, 1, 1, 0, 0, true},
    {"disk", small_grid, 1, 1, 0, 1, 0, true},
    {"cylinder", cylinder, 0, 1, 0, 2, 0, true},
    {"Moebius strip", moebius, 0, 1, NOOK_UNKNOWN, 1, 0, false},
    {"Klein bottle", klein_bottle, 0, 1, NOOK_UNKNOWN, 0, 0, false},
    {"projective plane", projective_plane, 1, 1, NOOK_UNKNOWN, 0, 0, false},
    {"pillow", pillow, 2, 1, 0, 0, 0, true},
    {"open bow-tie", open_bow_tie, 1, 2, 0, 2, 1, true},
    {"closed bow-tie", closed_bow_tie, 3, 2, 0, 0, 1, true},
    {"two shells", two_shells, 4, 2, 0, 0, 0, true},
    {"fan of 40", small_hub, 1, 1, 0, 1, 0, true},
};
const uint32_t shape_count = sizeof shapes / sizeof *shapes;

void shuffle(dice *d) {
    static nook_index name[MOST_V];
    nook_index *V = b.mesh.V;
    uint32_t i, j, k;
    for (i = 0; i < b.mesh.nv; i++) name[i] = nook_store(i);
    for (i = b.mesh.nv; i > 1; i--) {
        nook_index keep = name[j = throw_dice(d, i)];
        nook_point point = b.mesh.G[j];
        name[j] = name[i - 1];
        name[i - 1] = keep;
        b.mesh.G[j] = b.mesh.G[i - 1];
        b.mesh.G[i - 1] = point;
    }
    /* The point that now lies at place j belongs to the vertex name[j]. */
    for (i = 0; i < b.mesh.nv; i++) b.stamp[name[i]] = nook_store(i);
    for (i = 0; i < 3 * b.mesh.nt; i++) V[i] = b.stamp[V[i]];
    for (i = b.mesh.nt; i > 0; i--) {
        uint32_t turn = throw_dice(d, 3);
        nook_index keep[3];
        j = throw_dice(d, i);
        for (k = 0; k < 3; k++) keep[k] = V[3 * j + (k + turn) % 3];
        for (k = 0; k < 3; k++) V[3 * j + k] = V[3 * (i - 1) + k];
        for (k = 0; k < 3; k++) V[3 * (i - 1) + k] = keep[k];
    }
}

nook_status link_and_check(const nook_finder *finder) {
    nook_view view;
    nook_status status;
    memcpy(b.kept, b.mesh.V, 3u * b.mesh.nt * sizeof *b.kept);
    status = nook_link(&b.mesh, &b.marks, &b.shells, finder, &b.report, NULL);
    if (status != NOOK_OK) return status;
    view = nook_view_of(&b.mesh);
    return nook_check(&view, &b.marks, &b.report, &b.shells, finder, &b.result);
}
