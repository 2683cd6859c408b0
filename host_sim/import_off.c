/* import_off.c -- OFF with its prefixes: three numbers a vertex, a count and indices a face; what
 * else stands on their last line (colours, normals) is passed over, as are comments from '#'. */
#include <inttypes.h>

#include "import.h"
#include "scan.h"

static void begin(scan *s, const uint8_t *data, size_t size) {
    scan_begin(s, data, size);
    s->comments = true;
}

/* Take text off the front of w. */
static bool take_prefix(word *w, const char *text) {
    size_t n = strlen(text);
    if (w->length < n || memcmp(w->at, text, n) != 0) return false;
    w->at += n;
    w->length -= n;
    return true;
}

/* The magic word (ST)(C)(N)(4)(n)OFF; counts may be glued to it and are left in w. */
static bool take_magic(word *w, bool *other_dimension) {
    bool four, n;
    (void)take_prefix(w, "ST");
    (void)take_prefix(w, "C");
    (void)take_prefix(w, "N");
    four = take_prefix(w, "4");
    n = take_prefix(w, "n");
    *other_dimension = four || n;
    return take_prefix(w, "OFF") && (w->length == 0 || (*w->at >= '0' && *w->at <= '9'));
}

bool looks_like_off(const uint8_t *data, size_t size) {
    scan s;
    word w;
    bool other;
    begin(&s, data, size);
    return scan_any_word(&s, &w) && take_magic(&w, &other);
}

static bool ends_early(const scan *s, failure *f) {
    return fail_at_line(f, NOOK_TRUNCATED, "the data ends before what the header announces", s->line);
}

static bool read_count(scan *s, word *glued, int64_t *n, failure *f) {
    word w = *glued;
    glued->length = 0;
    if (w.length == 0 && !scan_any_word(s, &w)) return ends_early(s, f);
    if (word_integer(w, n) && *n >= 0) return true;
    return fail_at_line(f, NOOK_BAD_NUMBER, "a count in the header is not a number", s->line);
}

static bool read_vertex(imported *m, scan *s, failure *f) {
    float x[3];
    word w;
    nook_status status = NOOK_OK;
    uint32_t i;
    for (i = 0; i < 3u; i++) {
        if (!scan_any_word(s, &w)) {
            (void)ends_early(s, f);
            return fail_element(f, "vertex", m->nv);
        }
        status = word_float(w, &x[i]);
        if (status != NOOK_OK) break;
    }
    if (!import_text_vertex(m, x, status, s->line, f)) return false;
    (void)scan_next_line(s);
    return true;
}

static bool read_face(imported *m, scan *s, failure *f) {
    word w;
    int64_t n, i, v;
    if (!scan_any_word(s, &w)) return ends_early(s, f);
    if (!word_integer(w, &n) || n < 0)
        return fail_at_line(f, NOOK_BAD_NUMBER, "the number of corners is not a count", s->line);
    polygon_begin(m);
    for (i = 0; i < n; i++) {
        if (!scan_any_word(s, &w)) return ends_early(s, f);
        if (!word_integer(w, &v))
            return fail_at_line(f, NOOK_BAD_NUMBER, "a vertex index is not an integer", s->line);
        if (v < 0 || v >= (int64_t)m->nv) {
            return fail_at_line(f, NOOK_INDEX_OUT_OF_RANGE, "a face names a vertex that does not exist",
                                s->line);
        }
        polygon_corner(m, (uint32_t)v);
    }
    polygon_end(m);
    (void)scan_next_line(s);
    return true;
}

static bool read_header(scan *s, int64_t *nv, int64_t *nf, failure *f) {
    word w;
    scan ahead;
    bool other;
    if (!scan_any_word(s, &w)) return ends_early(s, f);
    (void)take_magic(&w, &other);
    if (other)
        return fail_at_line(f, NOOK_UNKNOWN_FORMAT, "OFF of other than three dimensions is not read",
                            s->line);
    ahead = *s;
    if (w.length == 0 && scan_word(&ahead, &w)) {
        if (word_is(w, "BINARY"))
            return fail_at_line(f, NOOK_UNKNOWN_FORMAT, "binary OFF is not read", s->line);
        w.length = 0;
    }
    if (!read_count(s, &w, nv, f) || !read_count(s, &w, nf, f)) return false;
    (void)scan_next_line(s);
    return true;
}

bool import_off(imported *m, const uint8_t *data, size_t size, failure *f) {
    scan s;
    int64_t nv = 0, nf = 0, i;
    char what[120];
    m->format = "OFF";
    begin(&s, data, size);
    if (!read_header(&s, &nv, &nf, f)) return false;
    /* "0 0 0" and a line end are the least for a vertex, "0" and a line end for a face */
    if (nv > (int64_t)scan_left(&s) / 5 || nf > (int64_t)scan_left(&s)) {
        (void)snprintf(what, sizeof what,
                       "truncated: %" PRId64 " vertices and %" PRId64
                       " faces announced, more than the file can hold",
                       nv, nf);
        return fail_at_line(f, NOOK_TRUNCATED, what, s.line > 1 ? s.line - 1 : 1);
    }
    for (i = 0; i < nv; i++) {
        if (!read_vertex(m, &s, f)) return false;
    }
    for (i = 0; i < nf; i++) {
        if (!read_face(m, &s, f)) return fail_element(f, "face", (uint64_t)i);
    }
    return true;
}
