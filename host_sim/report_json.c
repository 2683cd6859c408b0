/* report_json.c -- the JSON object of check. Every field is always there; null is "undefined for
 * this mesh" or "not computed". Any file name gives valid JSON. */
#include <inttypes.h>

#include "json.h"
#include "report.h"

/* A byte or line of a file. */
static void put_place(FILE *to, const char *name, uint64_t n) {
    put_key(to, name);
    if (n == FAILURE_NOWHERE) {
        (void)fputs("null", to);
    } else {
        (void)fprintf(to, "%" PRIu64, n);
    }
}

/* ---- the object ------------------------------------------------------------------------------ */

static void begin_object(FILE *to, const char *file, const char *format, const char *said) {
    (void)fputs("{\"file\":", to);
    put_string(to, file);
    if (format != NULL) {
        put_text(to, "format", format);
    } else {
        put_null(to, "format");
    }
    put_text(to, "verdict", said);
    put_count(to, "index_bits", NOOK_INDEX_BITS);
}

static void put_counts(FILE *to, const model *m, const nook_check_result *r) {
    put_count(to, "vertices", m->mesh.nv);
    put_count(to, "isolated_vertices", r->isolated_vertices);
    put_count(to, "triangles_in", m->triangles_in);
    put_count(to, "degenerate_triangles", m->degenerate);
    put_count(to, "triangles", m->mesh.nt);
    put_count(to, "duplicate_triangles", r->duplicate_triangles);
    put_count(to, "edges", r->edges);
    put_count(to, "border_edges", r->border_edges);
    put_count(to, "nonmanifold_edges", r->nonmanifold_edges);
    put_count(to, "incoherent_edges", r->incoherent_edges);
    put_count(to, "nonmanifold_vertices", r->survey.nonmanifold_vertices);
    put_count(to, "border_loops", r->edge_manifold == NOOK_YES ? r->survey.border_loops : NOOK_UNKNOWN);
    put_count(to, "components", r->survey.components);
    put_key(to, "euler");
    if (r->euler_known) {
        (void)fprintf(to, "%" PRId32, r->euler);
    } else {
        (void)fputs("null", to);
    }
}

static void put_witness(FILE *to, const nook_geometry *g) {
    if (g->witness_vertex == NOOK_NONE) {
        put_null(to, "convex_witness");
        return;
    }
    put_key(to, "convex_witness");
    (void)fprintf(to, "{\"vertex\":%" PRIu32 ",\"triangle\":%" PRIu32 "}", g->witness_vertex,
                  g->witness_triangle);
}

static void put_measures(FILE *to, const model *m, const verdict *v) {
    const nook_check_result *r = &v->check;
    const nook_geometry *g = &r->geometry;
    bool any = m->mesh.nt != 0, known = any && g->known,
         solid = known && r->watertight == NOOK_YES && r->oriented == NOOK_YES, mass = solid && g->mass_known;
    put_count(to, "self_intersections", v->self_intersections);
    put_count(to, "t_junctions", v->t_junctions);
    put_count(to, "concave_edges", solid ? g->concave_edges : NOOK_UNKNOWN);
    put_count(to, "convex_edges", solid ? g->convex_edges : NOOK_UNKNOWN);
    put_count(to, "flat_edges", solid ? g->flat_edges : NOOK_UNKNOWN);
    put_count(to, "folded_edges", !any || known ? g->folded_edges : NOOK_UNKNOWN);
    put_count(to, "zero_area_triangles", !any || known ? g->zero_area_triangles : NOOK_UNKNOWN);
    put_witness(to, g);
    put_float(to, "area", !any || known, any ? g->area : 0);
    put_float(to, "signed_volume", solid, g->signed_volume);
    put_point(to, "centroid", mass, g->centroid);
    put_floats(to, "inertia", mass, g->inertia, 6);
    put_point(to, "bbox_min", known, g->box_min);
    put_point(to, "bbox_max", known, g->box_max);
    put_null(to, "hints");
}

static void put_shell(FILE *to, const nook_shell *s) {
    bool pairs = !s->has_nonmanifold_edge, solid = pairs && s->border_edges == 0 && s->incoherent_edges == 0;
    (void)fprintf(to, "{\"first_triangle\":%" PRIu32, s->first_triangle);
    put_count(to, "triangles", s->triangles);
    put_count(to, "vertices", s->vertices);
    put_count(to, "border_loops", pairs ? s->border_loops : NOOK_UNKNOWN);
    put_count(to, "genus", nook_shell_genus(s));
    put_float(to, "signed_volume", solid, s->signed_volume);
    put_truth(to, "oriented", !pairs ? NOOK_MAYBE : s->incoherent_edges == 0 ? NOOK_YES : NOOK_NO);
    put_truth(to, "orientable", !pairs ? NOOK_MAYBE : s->orientable ? NOOK_YES : NOOK_NO);
    (void)fputc('}', to);
}

static void put_shells(FILE *to, const nook_shells *shells) {
    uint32_t k;
    put_key(to, "shells");
    (void)fputc('[', to);
    for (k = 0; k < shells->count; k++) {
        if (k != 0) (void)fputc(',', to);
        put_shell(to, &shells->shell[k]);
    }
    (void)fputc(']', to);
}

static void put_corner(FILE *to, const model *m, uint32_t corner) {
    (void)fprintf(to, "\"corner\":%" PRIu32 ",\"edge\":[%" PRIu32 ",%" PRIu32 "]", corner,
                  (uint32_t)m->mesh.V[nook_next(corner)], (uint32_t)m->mesh.V[nook_prev(corner)]);
}

static void put_element(FILE *to, const model *m, const verdict *v, nook_status kind, uint32_t i) {
    nook_where where = v->defects[kind].place[i].where;
    uint32_t other = v->defects[kind].place[i].other;
    (void)fputc('{', to);
    if (where.kind == NOOK_AT_CORNER) {
        put_corner(to, m, where.index);
    } else {
        (void)fprintf(to, "\"%s\":%" PRIu32, where.kind == NOOK_AT_VERTEX ? "vertex" : "triangle",
                      where.index);
    }
    if (kind == NOOK_SELF_INTERSECTION) put_count(to, "other", other);
    if (kind == NOOK_T_JUNCTION) {
        (void)fputc(',', to);
        put_corner(to, m, other);
    }
    put_point(to, "position", true, place_of(v, m, kind, i));
    (void)fputc('}', to);
}

static void put_defect(FILE *to, const model *m, const verdict *v, nook_status kind) {
    const defect *d = &v->defects[kind];
    uint32_t i;
    (void)fputs("{\"code\":", to);
    put_string(to, nook_status_name(kind));
    put_text(to, "severity", is_error(kind) ? "error" : "warning");
    put_count(to, "count", d->count);
    put_key(to, "elements");
    (void)fputc('[', to);
    for (i = 0; i < d->listed && d->place[i].where.kind != NOOK_NOWHERE; i++) {
        if (i != 0) (void)fputc(',', to);
        put_element(to, m, v, kind, i);
    }
    (void)fputs("]}", to);
}

static void put_defects(FILE *to, const model *m, const verdict *v) {
    int kind;
    bool first = true;
    put_key(to, "defects");
    (void)fputc('[', to);
    for (kind = 0; kind < NOOK_STATUS_COUNT; kind++) {
        if (v->defects[kind].count == 0) continue;
        if (!first) (void)fputc(',', to);
        first = false;
        put_defect(to, m, v, (nook_status)kind);
    }
    (void)fputc(']', to);
}

static void put_memory(FILE *to, const nook_mesh *mesh) {
    uint64_t flash = NOOK_MESH_BYTES(mesh->nv, mesh->nt),
             marks = NOOK_MT_BYTES(mesh->nt) + NOOK_MV_BYTES(mesh->nv);
    put_key(to, "memory");
    (void)fprintf(to, "{\"flash_bytes\":%" PRIu64 ",\"ram_bytes\":%" PRIu64 "}", flash, flash + marks);
}

void report_json(FILE *to, const char *file, const model *m, const verdict *v, uint32_t required) {
    uint32_t i;
    begin_object(to, file, m->format, is_sound(v, m, required) ? "sound" : "defective");
    (void)fprintf(to, ",\"digest\":\"%08" PRIx32 "\"", v->digest);
    put_counts(to, m, &v->check);
    for (i = 0; i < PROPERTY_FIELDS; i++) put_truth(to, property_name(i), property_of(v, m, i));
    put_measures(to, m, v);
    put_shells(to, &v->shells);
    put_defects(to, m, v);
    put_memory(to, &m->mesh);
    (void)fputs("}\n", to);
}

void report_json_unreadable(FILE *to, const char *file, const char *format, const failure *f) {
    begin_object(to, file, format, "unreadable");
    put_key(to, "error");
    (void)fputs("{\"code\":", to);
    put_string(to, f->code);
    put_place(to, "byte", f->byte);
    put_place(to, "line", f->line);
    if (f->element[0] != 0) {
        put_text(to, "element", f->element);
    } else {
        put_null(to, "element");
    }
    (void)fputs("}}\n", to);
}
