/* import_obj.c -- Wavefront OBJ: v and f; everything else is passed over.
 *
 * Two passes. The first counts the vertices, so that in the second an index may refer forward and a
 * bad one is named with its line. */
#include "import.h"
#include "scan.h"

static void begin(scan *s, const uint8_t *data, size_t size) {
    scan_begin(s, data, size);
    s->comments = true;
    s->continued = true;
}

static bool is_numeric(word w) {
    float x;
    size_t sign = *w.at == '-' || *w.at == '+' ? 1 : 0;
    if (word_float(w, &x) != NOOK_BAD_NUMBER) return true;
    return w.length > sign && w.at[sign] >= '0' && w.at[sign] <= '9'; /* "7/1/2" */
}

static bool is_statement(scan *s) {
    static const char *const numbers[] = {"v", "vn", "vt", "vp", "f", "l", "p"};
    static const char *const names[] = {"o", "g", "usemtl", "mtllib"};
    word keyword, w;
    size_t i;
    if (!scan_word(s, &keyword)) return false;
    for (i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        if (word_is(keyword, numbers[i])) return scan_word(s, &w) && is_numeric(w);
    }
    for (i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (word_is(keyword, names[i])) return true;
    }
    if (!word_is(keyword, "s") || !scan_word(s, &w)) return false;
    return is_numeric(w) || word_is(w, "off") || word_is(w, "on");
}

bool looks_like_obj(const uint8_t *data, size_t size) {
    scan s;
    if (memchr(data, 0, size) != NULL) return false;
    begin(&s, data, size);
    do {
        if (is_statement(&s)) return true;
    } while (scan_next_line(&s));
    return false;
}

static uint32_t count_vertices(const uint8_t *data, size_t size) {
    scan s;
    word w;
    uint32_t n = 0;
    begin(&s, data, size);
    do {
        if (scan_word(&s, &w) && word_is(w, "v")) n++;
    } while (scan_next_line(&s));
    return n;
}

static bool read_vertex(imported *m, scan *s, failure *f) {
    float x[3];
    word w;
    nook_status status = NOOK_OK;
    uint32_t i;
    for (i = 0; i < 3u && status == NOOK_OK; i++) {
        if (!scan_word(s, &w)) {
            (void)fail_at_line(f, NOOK_BAD_SYNTAX, "a vertex needs three numbers", s->line);
            return fail_element(f, "vertex", m->nv);
        }
        status = word_float(w, &x[i]);
    }
    return import_text_vertex(m, x, status, s->line, f);
}

/* The vertex of "7", "7/1", "7//3" or "-1/2/3"; negative ones count back from the vertices so far. */
static bool face_vertex(const imported *m, word w, uint32_t all, uint32_t line, uint32_t *v, failure *f) {
    const char *slash = memchr(w.at, '/', w.length);
    int64_t i;
    if (slash != NULL) w.length = (size_t)(slash - w.at);
    if (!word_integer(w, &i))
        return fail_at_line(f, NOOK_BAD_NUMBER, "a vertex index is not an integer", line);
    if (i < 0) i += (int64_t)m->nv + 1;
    if (i < 1 || i > (int64_t)all) {
        return fail_at_line(f, NOOK_INDEX_OUT_OF_RANGE,
                            "a face names a vertex that does not exist (indices start at 1)", line);
    }
    *v = (uint32_t)(i - 1);
    return true;
}

static bool read_face(imported *m, scan *s, uint32_t all, failure *f) {
    word w;
    uint32_t v = 0;
    polygon_begin(m);
    while (scan_word(s, &w)) {
        if (!face_vertex(m, w, all, s->line, &v, f)) return fail_element(f, "triangle", m->nt);
        polygon_corner(m, v);
    }
    polygon_end(m);
    return true;
}

bool import_obj(imported *m, const uint8_t *data, size_t size, failure *f) {
    uint32_t all = count_vertices(data, size);
    scan s;
    word w;
    m->format = "OBJ";
    begin(&s, data, size);
    do {
        if (!scan_word(&s, &w)) continue;
        if (word_is(w, "v") && !read_vertex(m, &s, f)) return false;
        if (word_is(w, "f") && !read_face(m, &s, all, f)) return false;
    } while (scan_next_line(&s));
    return true;
}
