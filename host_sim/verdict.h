/* verdict.h -- a loaded mesh examined by the library: every count, every defect with its place, and
 * whether the properties that are required hold. */
#ifndef VERDICT_H
#define VERDICT_H

#include "model.h"

/* Where a defect is. other: the second triangle of a self-intersection; the corner that faces the edge of a
 * T-junction, whose vertex is where. */
typedef struct place {
    nook_where where;
    uint32_t other;
} place;

/* One kind of defect: how many, and the first few of them. */
typedef struct defect {
    uint32_t count, listed;
    place *place; /* [listed] */
    size_t room;
} defect;

typedef struct verdict {
    nook_report report;
    nook_check_result check;
    nook_shells shells;
    nook_truth outward; /* as nook_orient_shells has it; NOOK_MAYBE without a solid, or where shells cross */
    uint32_t self_intersections; /* pairs of triangles */
    uint32_t t_junctions;        /* pairs of a vertex and a border edge */
    uint32_t digest;
    defect defects[NOOK_STATUS_COUNT];
    uint32_t max_list;
} verdict;

/* Links and checks m, and looks for triangles that meet, for T-junctions, and for which shells lie in others. False with f filled if the
 * library refuses; verdict_free() either way. */
bool examine(verdict *v, model *m, uint32_t max_list, failure *f);
void verdict_free(verdict *v);

/* Properties that a verdict can require, as bits in the order of property_name(). */
#define PROPERTY_COUNT 16u
#define PROPERTY_FIELDS 12u /* the first ones are also fields of the JSON object */
#define PROPERTIES_BY_DEFAULT                                                                                \
    "manifold,watertight,oriented,outward,no-degenerate,no-duplicate,no-self-intersection"
const char *property_name(uint32_t property);
/* NOOK_MAYBE: undefined for this mesh. */
nook_truth property_of(const verdict *v, const model *m, uint32_t property);
/* A comma-separated list to bits; false if it holds an unknown name. */
bool properties_parse(const char *list, uint32_t *bits);

/* The verdict: there is a triangle, and every required property holds. What is undefined does not. */
bool is_sound(const verdict *v, const model *m, uint32_t required);

/* Whether a kind of defect decides the default verdict, or is only worth knowing. */
bool is_error(nook_status kind);

/* Where an element is: the middle of an edge or triangle, the vertex, or of two triangles that meet the
 * middle of what their boxes have in common. */
nook_point place_of(const verdict *v, const model *m, nook_status kind, uint32_t i);

#endif
