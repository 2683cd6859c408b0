/* report_text.c -- the answer of check for people: the verdict, then the reasons and where they
 * are, then figures. */
#include <inttypes.h>

#include "decimal.h"
#include "report.h"

typedef struct wording {
    nook_status kind;
    const char *one, *many, *meaning;
} wording;

static const wording wordings[] = {
    {NOOK_EMPTY_MESH, "no triangle", "no triangle", "there is nothing to use"},
    {NOOK_REPEATED_VERTEX, "degenerate triangle", "degenerate triangles",
     "two corners at the same vertex; numbered as in the file, dropped before everything else"},
    {NOOK_DUPLICATE_TRIANGLE, "duplicate triangle", "duplicate triangles",
     "the same three vertices as another triangle"},
    {NOOK_ISOLATED_VERTEX, "isolated vertex", "isolated vertices",
     "used by no triangle; harmless, but takes memory"},
    {NOOK_BORDER_EDGE, "border edge", "border edges",
     "only one triangle there: the surface has a hole or an open rim"},
    {NOOK_INCOHERENT_EDGE, "incoherent edge", "incoherent edges",
     "the two triangles there face opposite ways: one of them is turned over"},
    {NOOK_NONMANIFOLD_EDGE, "non-manifold edge", "non-manifold edges",
     "more than two triangles there: sheets or solids meet"},
    {NOOK_NONMANIFOLD_VERTEX, "non-manifold vertex", "non-manifold vertices",
     "more than one fan of triangles there: parts touch at a point, or at a non-manifold edge"},
    {NOOK_NOT_ORIENTABLE, "one-sided component", "one-sided components",
     "no choice of directions agrees, as on a Moebius strip"},
    {NOOK_INSIDE_OUT, "shell inside out", "shells inside out",
     "the triangles face into the solid: a negative volume, or in a cavity a positive one"},
    {NOOK_FLAT_SHELL, "flat shell", "flat shells", "no volume: the surface lies folded upon itself"},
    {NOOK_ZERO_AREA_TRIANGLE, "triangle without area", "triangles without area",
     "three different vertices on one line"},
    {NOOK_FOLDED_EDGE, "folded edge", "folded edges",
     "the two triangles there lie in one plane, one back upon the other"},
    {NOOK_SELF_INTERSECTION, "self-intersection", "self-intersections",
     "two triangles meet elsewhere than in the vertices they share: the surface goes through itself or "
     "touches "
     "itself"},
    {NOOK_T_JUNCTION, "T-junction", "T-junctions",
     "a vertex within a border edge: one side of a seam has it, the other has not"},
};

static wording wording_of(nook_status kind) {
    wording w;
    size_t i;
    for (i = 0; i < sizeof wordings / sizeof wordings[0]; i++) {
        if (wordings[i].kind == kind) return wordings[i];
    }
    w.kind = kind;
    w.one = w.many = nook_status_text(kind);
    w.meaning = "the tables of the mesh do not agree";
    return w;
}

static void print_count(FILE *to, nook_status kind, uint32_t count) {
    wording w = wording_of(kind);
    if (kind == NOOK_EMPTY_MESH) {
        (void)fputs(w.one, to);
    } else {
        (void)fprintf(to, "%" PRIu32 " %s", count, count == 1u ? w.one : w.many);
    }
}

static void print_point(FILE *to, nook_point p) {
    decimal x = decimal_of(p.x), y = decimal_of(p.y), z = decimal_of(p.z);
    (void)fprintf(to, "(%s, %s, %s)", x.text, y.text, z.text);
}

/* ---- verdict ----------------------------------------------------------------------------------- */

static void print_verdict(FILE *to, const char *file, const model *m, const verdict *v, uint32_t required) {
    bool sound = is_sound(v, m, required);
    const char *before = ": DEFECTIVE: ";
    int kind;
    print_name(to, file);
    for (kind = 0; kind < NOOK_STATUS_COUNT && !sound; kind++) {
        if (v->defects[kind].count == 0 || !is_error((nook_status)kind)) continue;
        (void)fputs(before, to);
        print_count(to, (nook_status)kind, v->defects[kind].count);
        before = ", ";
    }
    if (sound) (void)fputs(": sound", to);
    if (!sound && before[0] == ':') (void)fputs(": DEFECTIVE: a required property does not hold", to);
    (void)fputc('\n', to);
}

/* Required properties that do not hold. */
static void print_unmet(FILE *to, const model *m, const verdict *v, uint32_t required) {
    const char *before = "  required, but not so: ";
    uint32_t i;
    for (i = 0; i < PROPERTY_COUNT; i++) {
        nook_truth truth = property_of(v, m, i);
        if ((required >> i & 1u) == 0 || truth == NOOK_YES) continue;
        (void)fprintf(to, "%s%s%s", before, property_name(i), truth == NOOK_MAYBE ? " (undefined here)" : "");
        before = ", ";
    }
    if (before[0] == ',') (void)fputc('\n', to);
}

/* ---- reasons ----------------------------------------------------------------------------------- */

static void print_edge(FILE *to, const model *m, uint32_t corner) {
    (void)fprintf(to, "edge %" PRIu32 "-%" PRIu32 " of triangle %" PRIu32,
                  (uint32_t)m->mesh.V[nook_next(corner)], (uint32_t)m->mesh.V[nook_prev(corner)],
                  nook_triangle(corner));
}

static void print_element(FILE *to, const model *m, const verdict *v, nook_status kind, uint32_t i) {
    const place *p = &v->defects[kind].place[i];
    (void)fputs("      ", to);
    if (p->where.kind == NOOK_AT_CORNER) {
        print_edge(to, m, p->where.index);
    } else {
        (void)fprintf(to, "%s %" PRIu32, p->where.kind == NOOK_AT_VERTEX ? "vertex" : "triangle",
                      p->where.index);
    }
    if (kind == NOOK_SELF_INTERSECTION) (void)fprintf(to, " and triangle %" PRIu32, p->other);
    if (kind == NOOK_T_JUNCTION) {
        (void)fputs(" on ", to);
        print_edge(to, m, p->other);
    }
    (void)fputs(" at ", to);
    print_point(to, place_of(v, m, kind, i));
    (void)fputc('\n', to);
}

static void print_defect(FILE *to, const model *m, const verdict *v, nook_status kind, bool decides) {
    const defect *d = &v->defects[kind];
    uint32_t i, listed = kind == NOOK_EMPTY_MESH ? d->count : d->listed;
    (void)fputs(decides && is_error(kind) ? "  " : "  note: ", to);
    print_count(to, kind, d->count);
    (void)fprintf(to, ": %s\n", wording_of(kind).meaning);
    for (i = 0; i < listed && kind != NOOK_EMPTY_MESH; i++) print_element(to, m, v, kind, i);
    if (listed != 0 && d->count > listed)
        (void)fprintf(to, "      ... and %" PRIu32 " more\n", d->count - listed);
}

static void print_reasons(FILE *to, const model *m, const verdict *v, bool sound) {
    int kind;
    char hint[160];
    for (kind = 0; kind < NOOK_STATUS_COUNT; kind++) {
        if (v->defects[kind].count != 0) print_defect(to, m, v, (nook_status)kind, !sound);
    }
    if (v->check.border_edges != 0 && model_hint(m, hint, sizeof hint)) (void)fprintf(to, "  %s\n", hint);
}

/* ---- figures ----------------------------------------------------------------------------------- */

static void print_number(FILE *to, uint32_t n) {
    if (n == NOOK_UNKNOWN) {
        (void)fputs("unknown", to);
    } else {
        (void)fprintf(to, "%" PRIu32, n);
    }
}

static bool is_solid(const nook_check_result *r) {
    return r->watertight == NOOK_YES && r->oriented == NOOK_YES;
}

static void print_shells(FILE *to, const verdict *v) {
    uint32_t k;
    (void)fputs("  shells     ", to);
    print_number(to, v->check.survey.components);
    for (k = 0; k < v->shells.count && k < 5u; k++) {
        uint32_t genus = nook_shell_genus(&v->shells.shell[k]);
        (void)fprintf(to, "%s%" PRIu32 " %s", k == 0 ? ": " : "; ", v->shells.shell[k].triangles,
                      v->shells.shell[k].triangles == 1u ? "triangle" : "triangles");
        if (genus != NOOK_UNKNOWN) (void)fprintf(to, ", genus %" PRIu32, genus);
    }
    (void)fputs(v->shells.count > 5u ? "; ...\n" : "\n", to);
}

static void print_edges(FILE *to, const nook_check_result *r) {
    const nook_geometry *g = &r->geometry;
    (void)fputs("  edges      ", to);
    print_number(to, r->edges);
    if (is_solid(r)) {
        (void)fprintf(to, ": %" PRIu32 " convex, %" PRIu32 " concave, %" PRIu32 " flat", g->convex_edges,
                      g->concave_edges, g->flat_edges);
    }
    (void)fputc('\n', to);
}

static void print_convexity(FILE *to, const nook_geometry *g) {
    if (g->convex == NOOK_MAYBE) return;
    (void)fputs(g->convex == NOOK_YES ? "  convex     yes" : "  convex     no", to);
    if (g->witness_vertex != NOOK_NONE) {
        (void)fprintf(to, ": vertex %" PRIu32 " is outside the plane of triangle %" PRIu32, g->witness_vertex,
                      g->witness_triangle);
    }
    (void)fputc('\n', to);
}

static void print_measures(FILE *to, const model *m, const nook_check_result *r) {
    const nook_geometry *g = &r->geometry;
    if (!g->known || m->mesh.nt == 0) return;
    (void)fprintf(to, "  area       %s\n", decimal_of(g->area).text);
    (void)fprintf(to, "  volume     %s\n",
                  is_solid(r) ? decimal_of(g->signed_volume).text
                              : "undefined (not watertight and oriented)");
    if (g->mass_known) {
        (void)fputs("  centroid   ", to);
        print_point(to, g->centroid);
        (void)fputc('\n', to);
    }
    (void)fputs("  box        ", to);
    print_point(to, g->box_min);
    (void)fputs(" to ", to);
    print_point(to, g->box_max);
    (void)fputc('\n', to);
    print_convexity(to, g);
}

/* Which way the shells face, and how many lie in others. */
static void print_outward(FILE *to, const verdict *v) {
    uint32_t k, cavities = 0;
    if (!is_solid(&v->check)) return;
    for (k = 0; k < v->shells.count; k++) cavities += v->shells.shell[k].cavity == NOOK_YES;
    (void)fputs(v->outward == NOOK_YES  ? "  outward    yes"
                : v->outward == NOOK_NO ? "  outward    no"
                                        : "  outward    undefined: shells cross or share more than corners",
                to);
    if (v->outward != NOOK_MAYBE && cavities != 0)
        (void)fprintf(to, "; %" PRIu32 " of %" PRIu32 " shells %s", cavities, v->shells.count,
                      cavities == 1u ? "bounds a cavity" : "bound cavities");
    (void)fputc('\n', to);
}

static void print_figures(FILE *to, const model *m, const verdict *v) {
    const nook_check_result *r = &v->check;
    size_t tables = NOOK_MESH_BYTES(m->mesh.nv, m->mesh.nt);
    (void)fprintf(to, "  format     %s, %s\n", m->format,
                  m->welded ? "equal vertices welded" : "vertices as in the file");
    (void)fprintf(to, "  triangles  %" PRIu32 "\n  vertices   %" PRIu32 "\n", m->mesh.nt, m->mesh.nv);
    print_edges(to, r);
    print_shells(to, v);
    print_measures(to, m, r);
    print_outward(to, v);
    (void)fprintf(to, "  memory     %lu bytes of tables with %d-bit indices; digest %08" PRIx32 "\n",
                  (unsigned long)tables, NOOK_INDEX_BITS, v->digest);
}

void report_text(FILE *to, const char *file, const model *m, const verdict *v, uint32_t required) {
    print_verdict(to, file, m, v, required);
    print_unmet(to, m, v, required);
    print_reasons(to, m, v, is_sound(v, m, required));
    print_figures(to, m, v);
}
