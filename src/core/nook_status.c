/* nook_status.c -- the names of statuses, in an object of their own so that firmware which only
 * compares numbers carries no text. */
#include "core/nook_status.h"

static const char *const names[NOOK_STATUS_COUNT][2] = {
    {"ok", "done"},
    {"more", "call again"},
    {"triangle", "a triangle or a pair is ready"},
    {"null_argument", "a required pointer is null"},
    {"misaligned", "an array is not aligned"},
    {"no_capacity", "more elements than the arrays or the index width can hold"},
    {"index_out_of_range", "a corner names a vertex that does not exist"},
    {"not_finite", "a coordinate is not a finite number"},
    {"coordinate_too_large", "a coordinate is larger than 2^30"},
    {"bad_opposite", "a corner and its opposite do not agree"},
    {"bad_vertex_corner", "the corner kept for a vertex is not one of its corners"},
    {"empty_mesh", "no triangles, or no tree over them"},
    {"repeated_vertex", "triangle with a repeated vertex"},
    {"duplicate_triangle", "triangle on the same vertices as another"},
    {"isolated_vertex", "vertex of no triangle"},
    {"border_edge", "edge with a single triangle"},
    {"incoherent_edge", "edge that both its triangles run in the same direction"},
    {"nonmanifold_edge", "edge with more than two triangles"},
    {"nonmanifold_vertex", "vertex whose triangles form more than one fan"},
    {"not_orientable", "surface that cannot be oriented"},
    {"inside_out", "shell of negative volume"},
    {"flat_shell", "shell of no volume"},
    {"zero_area_triangle", "triangle without area"},
    {"folded_edge", "edge at which one triangle lies back upon the other"},
    {"self_intersection", "triangle that meets another where they share nothing"},
    {"t_junction", "vertex within a border edge"},
    {"duplicate_edge", "two vertices would be joined twice"},
    {"wrong_valence", "the vertex has another number of triangles than required"},
    {"last_triangle", "nothing would be left of this part"},
    {"interior_edge", "edge with two triangles where one of the border is required"},
    {"interior_vertex", "vertex that is not at a border"},
    {"too_many_triangles", "a vertex would have more triangles than the limit"},
    {"turned_triangle", "a triangle would turn over or lose its area"},
    {"no_place", "a vertex has no place that keeps what was asked of the surface"},
    {"bad_number", "not a number"},
    {"bad_syntax", "unexpected word"},
    {"truncated", "the input ends too early"},
    {"unknown_format", "not a format that can be read"},
};

static const char *text(nook_status status, int which) {
    if ((unsigned)status >= (unsigned)NOOK_STATUS_COUNT) return "unknown_status";
    return names[status][which];
}

const char *nook_status_name(nook_status status) { return text(status, 0); }

const char *nook_status_text(nook_status status) { return text(status, 1); }
