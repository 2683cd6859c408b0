/* shapes.h -- meshes with known answers, written into one set of arrays that the tests share. */
#ifndef SHAPES_H
#define SHAPES_H

#include "check.h"
#include "nook.h"

/* All shapes fit 128 triangles; where there is room, hubs and spheres are large. */
#if NOOK_TEST_RAM < 2000000
enum { MOST_T = 128, MOST_SHELLS = 16 };
#elif NOOK_INDEX_BITS == 16
enum { MOST_T = 20480, MOST_SHELLS = 64 };
#else
enum { MOST_T = 56000, MOST_SHELLS = 64 };
#endif
enum { MOST_V = MOST_T + 2 };

/* The mesh under test and all that link and check may want. */
typedef struct bench {
    nook_mesh mesh;
    nook_marks marks;
    nook_shells shells;
    nook_report report;
    nook_check_result result;
    NOOK_MESH_ARRAYS(MOST_V, MOST_T) arrays;
    nook_index kept[3 * MOST_T]; /* V as it was before link */
    nook_index component[MOST_T], stamp[MOST_V];
    nook_shell shell[MOST_SHELLS];
    uint8_t Mt[NOOK_MT_BYTES(MOST_T)], Mv[NOOK_MV_BYTES(MOST_V)];
} bench;
extern bench b;

/* An empty mesh over b's arrays; nv vertices at scattered points; one triangle more. */
void begin_shape(uint32_t nv);
void place(uint32_t v, float x, float y, float z);
void add(uint32_t v0, uint32_t v1, uint32_t v2);
void add_list(const uint8_t *vertices, uint32_t triangles);
/* Run triangle t the other way. */
void turn_over(uint32_t t);

typedef struct shape {
    const char *name;
    void (*build)(void);
    int32_t euler;
    uint32_t components, genus, border_loops, nonmanifold_vertices; /* genus: NOOK_UNKNOWN if none */
    bool orientable;
} shape;
extern const shape shapes[];
extern const uint32_t shape_count;

void tetrahedron(void);
void octahedron(void);
void cube(void); /* from 0 to 1 */
void icosphere(uint32_t levels);
void torus(uint32_t columns, uint32_t rows);
void grid(uint32_t columns, uint32_t rows);
/* A closed fan round a hub that is vertex 0 or the last one. */
void hub_fan(uint32_t valence, bool hub_first);
/* Pages on the edge 0-1; bit i of turned: page i runs it from 1 to 0. */
void book(uint32_t pages, uint32_t turned);

/* Triangles in another order, turned by 0 to 2 corners, vertices with other names. */
void shuffle(dice *d);

/* Link and check b.mesh with everything; the status of link. */
nook_status link_and_check(const nook_finder *finder);

#endif
