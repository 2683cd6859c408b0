/* nook_status.h -- one list of everything that can be said about a call or about a mesh.
 *
 * The same codes serve as the result of functions and as the kind of a defect, so that "which
 * triangle, and why" reads the same from an importer, a check and a refused edit. */
#ifndef NOOK_STATUS_H
#define NOOK_STATUS_H

#include "core/nook_config.h"

typedef enum nook_status {
    NOOK_OK = 0,   /* done, and nothing to say */
    NOOK_MORE,     /* a resumable call used up its units, or a parser its bytes: call again */
    NOOK_TRIANGLE, /* a parser or a search has a triangle, a pair, or an edge, ready: take it, call again */

    /* The call cannot be carried out. */
    NOOK_NULL_ARGUMENT, /* a pointer that must be given is null */
    NOOK_MISALIGNED,    /* an array does not start at a multiple of NOOK_ALIGNMENT or of its element */
    NOOK_NO_CAPACITY,   /* more elements than the arrays, or this index width, can hold */

    /* Numbers and tables that cannot be used. */
    NOOK_INDEX_OUT_OF_RANGE,   /* V names a vertex that does not exist. where: the corner */
    NOOK_NOT_FINITE,           /* a coordinate is NaN or infinite. where: the vertex */
    NOOK_COORDINATE_TOO_LARGE, /* |x| > 2^30. where: the vertex */
    NOOK_BAD_OPPOSITE,         /* O[O[c]] != c, O out of range, or the two edges differ. where: the corner */
    NOOK_BAD_VERTEX_CORNER, /* the corner-of-a-vertex table names a corner of another vertex. where: the vertex */

    /* Defects of a mesh. Edges are named by a corner that faces them. */
    NOOK_EMPTY_MESH,      /* no triangles; or a tree that is asked was not built over them */
    NOOK_REPEATED_VERTEX, /* a triangle with two or three equal vertices. where: the triangle */
    NOOK_DUPLICATE_TRIANGLE, /* a triangle on the same three vertices as another; every copy but one is named. where: the triangle */
    NOOK_ISOLATED_VERTEX,    /* a vertex of no triangle. where: the vertex */
    NOOK_BORDER_EDGE,        /* an edge with one triangle. where: the corner */
    NOOK_INCOHERENT_EDGE,    /* an edge whose two triangles run it in the same direction. where: the corner */
    NOOK_NONMANIFOLD_EDGE,   /* an edge with three or more triangles. where: the corner */
    NOOK_NONMANIFOLD_VERTEX, /* triangles around it form more than one fan. where: the vertex */
    NOOK_NOT_ORIENTABLE, /* no choice of directions agrees, as on a Moebius strip. where: the corner where it shows */
    NOOK_INSIDE_OUT,         /* a closed, oriented shell of negative volume. where: its first triangle */
    NOOK_FLAT_SHELL,         /* the same of no volume: it folds onto itself. where: its first triangle */
    NOOK_ZERO_AREA_TRIANGLE, /* three different vertices on one line. where: the triangle */
    NOOK_FOLDED_EDGE, /* its two triangles are in one plane, one back upon the other. where: the corner */

    NOOK_SELF_INTERSECTION, /* it meets another triangle where the two share nothing. where: the triangle */
    NOOK_T_JUNCTION,        /* a vertex within a border edge of which it is no end. where: the vertex */

    /* An edit that would spoil the mesh, and is refused. */
    NOOK_DUPLICATE_EDGE,     /* two vertices would be joined twice */
    NOOK_WRONG_VALENCE,      /* the vertex has another number of triangles than the operator asks for */
    NOOK_LAST_TRIANGLE,      /* nothing would be left to hold on to */
    NOOK_INTERIOR_EDGE,      /* an edge of two triangles where one of the border is required */
    NOOK_INTERIOR_VERTEX,    /* a vertex that is not at a border, where one that is is required */
    NOOK_TOO_MANY_TRIANGLES, /* a vertex would come to have more triangles than the limit */
    NOOK_TURNED_TRIANGLE,    /* a triangle would turn over, or lose its area */
    NOOK_NO_PLACE, /* a vertex has no place where the surface is as near, as far out, or as convex as asked */

    /* Bytes that cannot be read. where: the byte, or the line of a text format */
    NOOK_BAD_NUMBER,     /* not a decimal number */
    NOOK_BAD_SYNTAX,     /* a word where another was required */
    NOOK_TRUNCATED,      /* the input ends before what it announced */
    NOOK_UNKNOWN_FORMAT, /* neither a binary nor an ASCII STL */

    NOOK_STATUS_COUNT
} nook_status;

typedef enum nook_kind {
    NOOK_NOWHERE = 0,
    NOOK_AT_VERTEX,
    NOOK_AT_CORNER, /* also names the edge that the corner faces */
    NOOK_AT_TRIANGLE,
    NOOK_AT_BYTE, /* from 0 */
    NOOK_AT_LINE  /* from 1 */
} nook_kind;

/* The element a status is about. */
typedef struct nook_where {
    nook_kind kind;
    uint32_t index;
} nook_where;

static inline nook_where nook_at(nook_kind kind, uint32_t index) {
    nook_where where = {kind, index};
    return where;
}

/* Called once for each defect found, in the order found. found may be null. The mesh must not be
 * changed from inside; while link runs, O and C hold other things. After NOOK_INDEX_OUT_OF_RANGE the corner's V is
 * no vertex. */
typedef struct nook_finder {
    void (*found)(void *user, nook_status defect, nook_where where);
    void *user;
} nook_finder;

static inline void nook_tell(const nook_finder *finder, nook_status defect, nook_kind kind, uint32_t index) {
    if (finder != NULL && finder->found != NULL) finder->found(finder->user, defect, nook_at(kind, index));
}

/* Names for logs ("border_edge") and sentences for people ("edge with a single triangle"), English,
 * static. They stand in an object file of their own, which the linker drops when nobody asks.
 * Any number that is not a status gives "unknown_status". */
const char *nook_status_name(nook_status status);
const char *nook_status_text(nook_status status);

#endif
