/* oracle.h -- the same answers as link, survey and check, found the slow and obvious way. */
#ifndef ORACLE_H
#define ORACLE_H

#include "shapes.h"

enum { ORACLE_T = NOOK_TEST_RAM < 2000000 ? 64 : 128, ORACLE_C = 3 * ORACLE_T };

typedef struct oracle {
    nook_report report; /* survey included, as if it had been asked for */
    uint32_t used_vertices;
    uint16_t O[ORACLE_C];
    uint16_t on_edge[ORACLE_C];   /* how many corners face the edge that this one faces */
    bool leads[ORACLE_C];         /* the smallest of them */
    uint16_t component[ORACLE_T]; /* its first triangle */
    uint16_t fan[ORACLE_C];       /* the smallest corner of its fan */
    uint16_t loop[ORACLE_C];      /* of border corners: the smallest of its loop */
    bool turned[ORACLE_T];        /* conflict with the colouring shows in this triangle's component */
    bool conflict[ORACLE_T];      /* of a component, by its first triangle */
} oracle;

/* Judge the triangles of b.mesh (at most ORACLE_T) by V alone. */
void judge(oracle *o);

/* Whether corners c and d face the same edge; whether they run it in the same direction. */
bool same_edge(uint32_t c, uint32_t d);
bool same_direction(uint32_t c, uint32_t d);

#endif
