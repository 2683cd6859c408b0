/* import_ply.c -- PLY, ASCII and binary of both byte orders, with properties in any order.
 *
 * The header becomes a list of properties; then every element is read row by row, and what has no
 * role (colours, normals, other elements) is stepped over. Before an element is read its count is
 * held against the bytes left, at the fewest bytes a row can have; elements without properties have
 * no bytes and are not walked at all. So the work is bounded by the bytes present. */
#include <stdlib.h>

#include "import.h"
#include "heap.h"
#include "scan.h"

typedef enum type { NO_TYPE, INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 } type;
typedef enum role { PASSED_OVER, X, Y, Z, CORNERS } role;
typedef enum form { NO_FORM, TEXT, LITTLE, BIG } form;
typedef enum sort { OTHER, VERTEX, FACE } sort;

static const char *const type_names[][2] = {
    {"", ""},         {"char", "int8"},   {"uchar", "uint8"},   {"short", "int16"},    {"ushort", "uint16"},
    {"int", "int32"}, {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"},
};
static const uint8_t type_size[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};

typedef struct property {
    type of, count; /* count: NO_TYPE for a property that is not a list */
    role role;
} property;

typedef struct element {
    sort sort;
    int64_t rows;
    size_t first, properties; /* in ply.property */
} element;

typedef struct ply {
    property *property;
    element *element;
    size_t properties, room_p, elements, room_e;
    form form;
    scan text;                       /* the header, then the rows of the text form */
    const uint8_t *begin, *at, *end; /* the rows of a binary form */
    const uint8_t *value;            /* where the value last read begins */
    int64_t vertices;                /* declared */
    imported *m;
    failure *f;
} ply;

/* ---- header -------------------------------------------------------------------------------- */

static bool header_fails(ply *p, nook_status status, const char *what) {
    return fail_at_line(p->f, status, what, p->text.line);
}

static type type_of(word w) {
    int t;
    for (t = INT8; t <= FLOAT64; t++) {
        if (word_is(w, type_names[t][0]) || word_is(w, type_names[t][1])) return (type)t;
    }
    return NO_TYPE;
}

static bool read_format(ply *p) {
    word w;
    if (!scan_word(&p->text, &w)) return header_fails(p, NOOK_BAD_SYNTAX, "the format is missing");
    if (word_is(w, "ascii")) p->form = TEXT;
    if (word_is(w, "binary_little_endian")) p->form = LITTLE;
    if (word_is(w, "binary_big_endian")) p->form = BIG;
    return p->form != NO_FORM ? true : header_fails(p, NOOK_BAD_SYNTAX, "unknown PLY format");
}

static bool has_element(const ply *p, sort of) {
    size_t i;
    for (i = 0; i < p->elements; i++) {
        if (p->element[i].sort == of) return true;
    }
    return false;
}

static bool read_element(ply *p) {
    word name, w;
    element *e;
    p->element = grow(p->element, &p->room_e, p->elements + 1, sizeof *p->element);
    e = &p->element[p->elements];
    memset(e, 0, sizeof *e);
    if (!scan_word(&p->text, &name) || !scan_word(&p->text, &w))
        return header_fails(p, NOOK_BAD_SYNTAX, "an element needs a name and a count");
    if (!word_integer(w, &e->rows) || e->rows < 0)
        return header_fails(p, NOOK_BAD_NUMBER, "the count of an element is not a number");
    if (word_is(name, "vertex") && !has_element(p, VERTEX)) e->sort = VERTEX;
    if (word_is(name, "face") && !has_element(p, FACE)) e->sort = FACE;
    if (e->sort == VERTEX) p->vertices = e->rows;
    e->first = p->properties;
    p->elements++;
    return true;
}

static role role_of(const ply *p, word name, bool list) {
    sort of = p->element[p->elements - 1].sort;
    if (of == FACE && list && (word_is(name, "vertex_indices") || word_is(name, "vertex_index")))
        return CORNERS;
    if (of != VERTEX || list) return PASSED_OVER;
    if (word_is(name, "x")) return X;
    if (word_is(name, "y")) return Y;
    return word_is(name, "z") ? Z : PASSED_OVER;
}

static bool read_property(ply *p) {
    property q = {NO_TYPE, NO_TYPE, PASSED_OVER};
    word w;
    bool list;
    if (p->elements == 0) return header_fails(p, NOOK_BAD_SYNTAX, "a property before any element");
    if (!scan_word(&p->text, &w))
        return header_fails(p, NOOK_BAD_SYNTAX, "a property needs a type and a name");
    list = word_is(w, "list");
    if (list) {
        if (!scan_word(&p->text, &w))
            return header_fails(p, NOOK_BAD_SYNTAX, "a list needs two types and a name");
        q.count = type_of(w);
        if (q.count == NO_TYPE || q.count >= FLOAT32)
            return header_fails(p, NOOK_BAD_SYNTAX, "a list is counted by an integer type");
        if (!scan_word(&p->text, &w))
            return header_fails(p, NOOK_BAD_SYNTAX, "a list needs two types and a name");
    }
    q.of = type_of(w);
    if (q.of == NO_TYPE) return header_fails(p, NOOK_BAD_SYNTAX, "unknown property type");
    if (!scan_word(&p->text, &w)) return header_fails(p, NOOK_BAD_SYNTAX, "a property needs a name");
    q.role = role_of(p, w, list);
    if (q.role == CORNERS && q.of >= FLOAT32)
        return header_fails(p, NOOK_BAD_SYNTAX, "vertex indices must be of an integer type");
    p->property = grow(p->property, &p->room_p, p->properties + 1, sizeof *p->property);
    p->property[p->properties++] = q;
    p->element[p->elements - 1].properties++;
    return true;
}

static bool has_role(const ply *p, const element *e, role wanted) {
    size_t i;
    for (i = 0; i < e->properties; i++) {
        if (p->property[e->first + i].role == wanted) return true;
    }
    return false;
}

static bool header_is_complete(ply *p) {
    size_t i;
    if (p->form == NO_FORM) return header_fails(p, NOOK_BAD_SYNTAX, "the header has no format line");
    for (i = 0; i < p->elements; i++) {
        const element *e = &p->element[i];
        if (e->rows == 0) continue;
        if (e->sort == VERTEX && !(has_role(p, e, X) && has_role(p, e, Y) && has_role(p, e, Z))) {
            return header_fails(p, NOOK_BAD_SYNTAX, "the vertices have no x, y and z");
        }
        if (e->sort == FACE && !has_role(p, e, CORNERS)) {
            return header_fails(p, NOOK_BAD_SYNTAX, "the faces have no list vertex_indices or vertex_index");
        }
    }
    return true;
}

static bool read_header(ply *p) {
    word w;
    (void)scan_any_word(&p->text, &w); /* "ply" itself */
    while (scan_next_line(&p->text)) {
        if (!scan_word(&p->text, &w)) continue;
        if (word_is(w, "end_header")) return header_is_complete(p);
        if (word_is(w, "comment") || word_is(w, "obj_info")) continue;
        if (word_is(w, "format")) {
            if (!read_format(p)) return false;
        } else if (word_is(w, "element")) {
            if (!read_element(p)) return false;
        } else if (word_is(w, "property")) {
            if (!read_property(p)) return false;
        } else {
            return header_fails(p, NOOK_BAD_SYNTAX, "unknown word in the PLY header");
        }
    }
    return header_fails(p, NOOK_TRUNCATED, "the PLY header does not end");
}

/* The data begin after exactly one line end; after a lone CR only if the header knows no LF, since
 * a binary value may begin with the byte of LF. */
static void begin_rows(ply *p, const uint8_t *data) {
    bool has_lf = memchr(data, '\n', (size_t)((const uint8_t *)p->text.at - data)) != NULL;
    const uint8_t *end = (const uint8_t *)p->text.end, *at = (const uint8_t *)p->text.at;
    while (at < end && *at != '\n' && *at != '\r') at++;
    if (at < end && *at++ == '\r' && has_lf && at < end && *at == '\n') at++;
    p->begin = data;
    p->at = p->value = at;
    p->end = end;
    (void)scan_next_line(&p->text);
}

/* ---- rows ---------------------------------------------------------------------------------- */

static bool row_fails(ply *p, nook_status status, const char *what) {
    if (p->form == TEXT) return fail_at_line(p->f, status, what, p->text.line);
    return fail_at_byte(p->f, status, what, (uint64_t)(p->value - p->begin));
}

static bool ends_early(ply *p) {
    return row_fails(p, NOOK_TRUNCATED, "the data ends before what the header announces");
}

/* Read size bytes as an unsigned number in the file's byte order. */
static bool read_bits(ply *p, uint32_t size, uint64_t *bits) {
    uint32_t i;
    p->value = p->at;
    if ((size_t)(p->end - p->at) < size) return ends_early(p);
    for (*bits = 0, i = 0; i < size; i++) {
        *bits |= (uint64_t)p->at[p->form == BIG ? size - 1u - i : i] << (8u * i);
    }
    p->at += size;
    return true;
}

static bool read_word(ply *p, word *w) { return scan_any_word(&p->text, w) ? true : ends_early(p); }

static bool read_integer(ply *p, type of, int64_t *i) {
    word w;
    uint64_t bits, sign;
    if (p->form == TEXT) {
        if (!read_word(p, &w)) return false;
        return word_integer(w, i) ? true
                                  : row_fails(p, NOOK_BAD_NUMBER, "not an integer where a list needs one");
    }
    if (!read_bits(p, type_size[of], &bits)) return false;
    sign = (uint64_t)1 << (8u * type_size[of] - 1u);
    *i = (int64_t)bits;
    if ((of == INT8 || of == INT16 || of == INT32) && (bits & sign) != 0) *i -= (int64_t)(2 * sign);
    return true;
}

/* The nearest float of a double; what is beyond every float becomes infinite. */
static float narrowed(double d) {
    if (d > 3.5e38) return nook_float_from(0x7F800000u);
    if (d < -3.5e38) return nook_float_from(0xFF800000u);
    if (d > 3.4e38) return 3.4e38f; /* too large for a coordinate in any case */
    if (d < -3.4e38) return -3.4e38f;
    return (float)d;
}

static bool read_float(ply *p, type of, float *x) {
    word w;
    uint64_t bits;
    int64_t i;
    double d;
    nook_status status;
    if (p->form == TEXT) {
        if (!read_word(p, &w)) return false;
        status = word_float(w, x);
        return status == NOOK_OK ? true : row_fails(p, status, NULL);
    }
    if (of < FLOAT32) {
        if (!read_integer(p, of, &i)) return false;
        *x = (float)i;
        return true;
    }
    if (!read_bits(p, of == FLOAT32 ? 4u : 8u, &bits)) return false;
    memcpy(&d, &bits, sizeof d);
    *x = of == FLOAT32 ? nook_float_from((uint32_t)bits) : narrowed(d);
    return true;
}

static bool pass_over(ply *p, type of, int64_t count) {
    word w;
    p->value = p->at;
    if (p->form != TEXT) {
        if (count > (int64_t)(p->end - p->at) / type_size[of]) return ends_early(p);
        p->at += count * type_size[of];
        return true;
    }
    for (; count > 0; count--) {
        if (!read_word(p, &w)) return false;
    }
    return true;
}

static bool read_corners(ply *p, type of, int64_t count) {
    int64_t v;
    polygon_begin(p->m);
    for (; count > 0; count--) {
        if (!read_integer(p, of, &v)) return false;
        if (v < 0 || v >= p->vertices)
            return row_fails(p, NOOK_INDEX_OUT_OF_RANGE, "a face names a vertex that does not exist");
        polygon_corner(p->m, (uint32_t)v);
    }
    polygon_end(p->m);
    return true;
}

static bool read_property_of_row(ply *p, const property *q, float x[3]) {
    int64_t count = 1;
    if (q->count != NO_TYPE && !read_integer(p, q->count, &count)) return false;
    if (count < 0) return row_fails(p, NOOK_BAD_NUMBER, "a list of negative length");
    if (q->role == CORNERS) return read_corners(p, q->of, count);
    if (q->role != PASSED_OVER) return read_float(p, q->of, &x[q->role - X]);
    return pass_over(p, q->of, count);
}

static bool read_row(ply *p, const element *e) {
    float x[3] = {0, 0, 0};
    nook_point point;
    const uint8_t *row = p->at;
    size_t i;
    for (i = 0; i < e->properties; i++) {
        if (!read_property_of_row(p, &p->property[e->first + i], x)) return false;
    }
    if (e->sort != VERTEX) return true;
    point = nook_make(x[0], x[1], x[2]);
    p->value = row;
    if (nook_point_status(point) != NOOK_OK) return row_fails(p, nook_point_status(point), NULL);
    import_vertex(p->m, point);
    return true;
}

/* The fewest bytes of a row: of a list its count alone; in text a digit and a blank each. */
static uint64_t least_row(const ply *p, const element *e) {
    uint64_t least = 0;
    size_t i;
    for (i = 0; i < e->properties; i++) {
        const property *q = &p->property[e->first + i];
        least += p->form == TEXT ? 2u : type_size[q->count != NO_TYPE ? q->count : q->of];
    }
    return least;
}

static bool read_rows(ply *p, const element *e) {
    static const char *const names[] = {"row", "vertex", "face"};
    uint64_t least = least_row(p, e);
    uint64_t left = p->form == TEXT ? (uint64_t)scan_left(&p->text) + 1u : (uint64_t)(p->end - p->at);
    int64_t i;
    if (least == 0) return true;
    p->value = p->at;
    if ((uint64_t)e->rows > left / least) {
        (void)row_fails(p, NOOK_TRUNCATED, "truncated: the header announces more than the file can hold");
        return fail_element(p->f, names[e->sort], left / least);
    }
    for (i = 0; i < e->rows; i++) {
        if (!read_row(p, e)) return fail_element(p->f, names[e->sort], (uint64_t)i);
    }
    return true;
}

bool import_ply(imported *m, const uint8_t *data, size_t size, failure *f) {
    ply p;
    size_t i;
    bool good;
    memset(&p, 0, sizeof p);
    p.m = m;
    p.f = f;
    scan_begin(&p.text, data, size);
    good = read_header(&p);
    m->format = p.form == TEXT  ? "PLY text"
                : p.form == BIG ? "PLY binary big-endian"
                                : "PLY binary little-endian";
    if (good) begin_rows(&p, data);
    for (i = 0; good && i < p.elements; i++) good = read_rows(&p, &p.element[i]);
    free(p.property);
    free(p.element);
    return good;
}
