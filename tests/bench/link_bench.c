/* link_bench.c -- nook_link alone on three meshes, for callgrind and for the clock.
 *
 * usage: link_bench ordered|shuffled|hub TIMES     prints triangles, edges and nanoseconds a triangle
 * The same meshes are written as OBJ by "link_bench MESH write", so that a peer gets the same input. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "nook.h"

enum { MOST = 20480, MOST_V = 20482 };
static nook_point G[MOST_V];
static nook_index V[3 * MOST], O[3 * MOST], C[MOST_V], kept[3 * MOST];
static uint32_t nv, nt;

static uint32_t random_below(uint32_t n) {
    static uint64_t state = 88172645463325252u;
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (uint32_t)(state >> 33) % n;
}

static void corner(uint32_t c, uint32_t v) { V[c] = nook_store(v); }

/* Midpoint of an edge: found again by a table of pairs, made once for the coarser mesh. */
static uint32_t midpoint(uint32_t a, uint32_t b, uint32_t (*seen)[3], uint32_t *count) {
    uint32_t low = a < b ? a : b, high = a < b ? b : a, i = (low * 7919u + high) % 65536u;
    while (seen[i][2] != 0 && (seen[i][0] != low || seen[i][1] != high)) i = (i + 1u) % 65536u;
    if (seen[i][2] == 0) {
        nook_point p = nook_make(G[a].x + G[b].x, G[a].y + G[b].y, G[a].z + G[b].z);
        G[nv] = nook_scaled(p, 1.0f / nook_length(p));
        seen[i][0] = low;
        seen[i][1] = high;
        seen[i][2] = ++nv;
        ++*count;
    }
    return seen[i][2] - 1u;
}

static void icosphere(void) {
    static const float X = 0.525731112f, Z = 0.850650808f;
    static const uint8_t faces[60] = {0,  4, 1, 0, 9, 4, 9, 5,  4, 4, 5,  8,  4,  8, 1, 8,  10, 1,  8, 3,
                                      10, 5, 3, 8, 5, 2, 3, 2,  7, 3, 7,  10, 3,  7, 6, 10, 7,  11, 6, 11,
                                      0,  6, 0, 1, 6, 6, 1, 10, 9, 0, 11, 9,  11, 2, 9, 2,  5,  7,  2, 11};
    const nook_point at[12] = {{-X, 0, Z}, {X, 0, Z},   {-X, 0, -Z}, {X, 0, -Z}, {0, Z, X},  {0, Z, -X},
                               {0, -Z, X}, {0, -Z, -X}, {Z, X, 0},   {-Z, X, 0}, {Z, -X, 0}, {-Z, -X, 0}};
    static uint32_t seen[65536][3];
    uint32_t level, t, i, count;
    memcpy(G, at, sizeof at);
    nv = 12;
    nt = 20;
    for (i = 0; i < 60; i++) corner(i, faces[i]);
    for (level = 0; level < 5; level++) {
        memset(seen, 0, sizeof seen);
        count = 0;
        for (t = nt; t-- > 0;) {
            uint32_t a = V[3 * t], b = V[3 * t + 1], c = V[3 * t + 2];
            uint32_t ab = midpoint(a, b, seen, &count), bc = midpoint(b, c, seen, &count),
                     ca = midpoint(c, a, seen, &count);
            const uint32_t four[12] = {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca};
            for (i = 0; i < 12; i++) corner(12 * t + i, four[i]);
        }
        nt *= 4;
    }
}

static void shuffle(void) {
    static uint32_t name[MOST_V];
    uint32_t i, j, k;
    for (i = 0; i < nv; i++) name[i] = i;
    for (i = nv; i > 1; i--) {
        uint32_t keep = name[j = random_below(i)];
        name[j] = name[i - 1];
        name[i - 1] = keep;
    }
    for (i = 0; i < 3 * nt; i++) corner(i, name[V[i]]);
    for (i = nt; i > 1; i--) {
        j = random_below(i);
        for (k = 0; k < 3; k++) {
            uint32_t keep = V[3 * j + k];
            corner(3 * j + k, V[3 * (i - 1) + k]);
            corner(3 * (i - 1) + k, keep);
        }
    }
}

static void hub(void) {
    nt = MOST;
    nv = nt + 1;
    for (uint32_t t = 0; t < nt; t++) {
        corner(3 * t, 0);
        corner(3 * t + 1, 1 + t);
        corner(3 * t + 2, 1 + (t + 1) % nt);
    }
}

static void write_obj(void) {
    for (uint32_t v = 0; v < nv; v++)
        printf("v %.9g %.9g %.9g\n", (double)G[v].x, (double)G[v].y, (double)G[v].z);
    for (uint32_t t = 0; t < nt; t++)
        printf("f %u %u %u\n", V[3 * t] + 1u, V[3 * t + 1] + 1u, V[3 * t + 2] + 1u);
}

int main(int argc, char **argv) {
    nook_mesh mesh;
    nook_report report;
    struct timespec begin, end;
    int i, times;
    double best = 1e30;
    if (argc < 3) return 2;
    if (strcmp(argv[1], "hub") == 0)
        hub();
    else
        icosphere();
    if (strcmp(argv[1], "shuffled") == 0) shuffle();
    if (strcmp(argv[2], "write") == 0) {
        write_obj();
        return 0;
    }
    times = atoi(argv[2]);
    memcpy(kept, V, sizeof V);
    nook_mesh_init(&mesh, G, V, O, C, MOST_V, MOST);
    mesh.nv = nv;
    mesh.nt = nt;
    for (i = 0; i < times; i++) {
        clock_gettime(CLOCK_MONOTONIC, &begin);
        if (nook_link(&mesh, NULL, NULL, NULL, &report, NULL) != NOOK_OK) return 1;
        clock_gettime(CLOCK_MONOTONIC, &end);
        double ns = (double)(end.tv_sec - begin.tv_sec) * 1e9 + (double)(end.tv_nsec - begin.tv_nsec);
        if (ns < best) best = ns;
    }
    printf("%s: %u triangles, %u edges, %.1f ns a triangle\n", argv[1], nt, report.edges, best / nt);
    return 0;
}
