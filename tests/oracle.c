/* oracle.c -- every pair of corners is compared with every other; what belongs together is found by
 * handing the smaller number on until nothing changes. No marks, no links, no order. */
#include "oracle.h"

static uint32_t tip(uint32_t c) { return b.mesh.V[c]; }
static uint32_t from(uint32_t c) { return b.mesh.V[3 * (c / 3) + (c + 1) % 3]; }
static uint32_t to(uint32_t c) { return b.mesh.V[3 * (c / 3) + (c + 2) % 3]; }

bool same_direction(uint32_t c, uint32_t d) { return from(c) == from(d) && to(c) == to(d); }
bool same_edge(uint32_t c, uint32_t d) {
    return same_direction(c, d) || (from(c) == to(d) && to(c) == from(d));
}

static bool has(uint32_t t, uint32_t v) {
    return tip(3 * t) == v || tip(3 * t + 1) == v || tip(3 * t + 2) == v;
}

static bool same_vertices(uint32_t t, uint32_t u) {
    return has(u, tip(3 * t)) && has(u, tip(3 * t + 1)) && has(u, tip(3 * t + 2));
}

static uint32_t corner_at(uint32_t t, uint32_t v) {
    return tip(3 * t) == v ? 3 * t : tip(3 * t + 1) == v ? 3 * t + 1 : 3 * t + 2;
}

static bool hand_on(uint16_t *one, uint16_t *other) {
    uint16_t least = *one < *other ? *one : *other;
    bool changed = *one != *other;
    *one = *other = least;
    return changed;
}

static void judge_edges(oracle *o) {
    nook_report *r = &o->report;
    uint32_t c, d, nc = 3 * b.mesh.nt;
    for (c = 0; c < nc; c++) {
        uint32_t partner = c;
        o->on_edge[c] = 0;
        o->leads[c] = true;
        for (d = 0; d < nc; d++) {
            if (!same_edge(c, d)) continue;
            o->on_edge[c]++;
            if (d < c) o->leads[c] = false;
            if (d != c) partner = d;
        }
        o->O[c] = (uint16_t)(o->on_edge[c] == 2 && !same_direction(c, partner) ? partner : c);
        if (!o->leads[c]) continue;
        r->edges++;
        r->border_edges += o->on_edge[c] == 1;
        r->matched_edges += o->on_edge[c] == 2 && !same_direction(c, partner);
        r->incoherent_edges += o->on_edge[c] == 2 && same_direction(c, partner);
        r->nonmanifold_edges += o->on_edge[c] > 2;
        r->odd_edges += o->on_edge[c] % 2;
    }
}

static void judge_duplicates(oracle *o) {
    uint32_t t, u;
    for (t = 0; t < b.mesh.nt; t++) {
        for (u = 0; u < t && !same_vertices(t, u); u++) {
        }
        o->report.duplicate_triangles += u < t;
    }
}

/* Components, fans and loops: hand on across what joins them. */
static void judge_parts(oracle *o) {
    uint32_t c, d, nc = 3 * b.mesh.nt, end;
    bool changed = true;
    for (c = 0; c < nc; c++) {
        o->component[c / 3] = (uint16_t)(c / 3);
        o->fan[c] = o->loop[c] = (uint16_t)c;
    }
    while (changed) {
        changed = false;
        for (c = 0; c < nc; c++) {
            for (d = 0; d < c; d++) {
                if (!same_edge(c, d)) continue;
                changed |= hand_on(&o->component[c / 3], &o->component[d / 3]);
                if (o->on_edge[c] != 2) continue;
                changed |= hand_on(&o->fan[corner_at(c / 3, from(c))], &o->fan[corner_at(d / 3, from(c))]);
                changed |= hand_on(&o->fan[corner_at(c / 3, to(c))], &o->fan[corner_at(d / 3, to(c))]);
            }
        }
    }
    for (changed = true; changed;) {
        changed = false;
        for (c = 0; c < nc; c++) {
            for (d = 0; d < c; d++) {
                if (o->on_edge[c] != 1 || o->on_edge[d] != 1) continue;
                for (end = 0; end < 2; end++) {
                    uint32_t v = end ? from(c) : to(c);
                    if (v != from(d) && v != to(d)) continue;
                    if (o->fan[corner_at(c / 3, v)] == o->fan[corner_at(d / 3, v)])
                        changed |= hand_on(&o->loop[c], &o->loop[d]);
                }
            }
        }
    }
}

/* Colour each component from its first triangle; then look for an edge that disagrees. */
static void judge_orientation(oracle *o) {
    static bool coloured[ORACLE_T];
    uint32_t c, d, t, nc = 3 * b.mesh.nt;
    bool changed = true;
    for (t = 0; t < b.mesh.nt; t++) coloured[t] = o->turned[t] = o->conflict[t] = false;
    while (changed) {
        changed = false;
        for (c = 0; c < nc; c++) {
            for (d = 0; d < nc; d++) {
                if (c == d || o->on_edge[c] != 2 || !same_edge(c, d) || !coloured[c / 3] || coloured[d / 3])
                    continue;
                coloured[d / 3] = changed = true;
                o->turned[d / 3] = o->turned[c / 3] != same_direction(c, d);
            }
        }
        for (t = 0; t < b.mesh.nt && !changed; t++) {
            if (!coloured[t]) coloured[t] = changed = true;
        }
    }
    for (c = 0; c < nc; c++) {
        for (d = 0; d < c; d++) {
            if (o->on_edge[c] != 2 || !same_edge(c, d)) continue;
            if ((o->turned[c / 3] != o->turned[d / 3]) != same_direction(c, d))
                o->conflict[o->component[c / 3]] = true;
        }
    }
}

static void count_parts(oracle *o) {
    nook_survey *s = &o->report.survey;
    uint32_t c, v, nc = 3 * b.mesh.nt;
    s->orientable = NOOK_YES;
    for (c = 0; c < nc; c++) {
        s->components += c % 3 == 0 && o->component[c / 3] == c / 3;
        s->fans += o->fan[c] == c;
        s->border_loops += o->on_edge[c] == 1 && o->loop[c] == c;
        if (o->conflict[c / 3]) s->orientable = NOOK_NO;
    }
    for (v = 0; v < b.mesh.nv; v++) {
        uint32_t fans = 0;
        for (c = 0; c < nc; c++) fans += tip(c) == v && o->fan[c] == c;
        s->nonmanifold_vertices += fans > 1;
        o->used_vertices += fans > 0;
    }
    if (o->report.nonmanifold_edges == 0) return;
    s->border_loops = NOOK_UNKNOWN;
    s->orientable = NOOK_MAYBE;
}

void judge(oracle *o) {
    memset(&o->report, 0, sizeof o->report);
    if (!CHECK(b.mesh.nt <= ORACLE_T)) return;
    o->used_vertices = 0;
    o->report.triangles = b.mesh.nt;
    judge_edges(o);
    judge_duplicates(o);
    judge_parts(o);
    judge_orientation(o);
    count_parts(o);
}
