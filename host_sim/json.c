/* json.c -- JSON in two directions. Both are one pass; the reader never looks beyond the end of its text. */
#include "json.h"

#include <inttypes.h>

#include "decimal.h"

/* ---- writing --------------------------------------------------------------------------------- */

/* The length of a well-formed UTF-8 sequence at s, or 0. */
static size_t utf8_length(const unsigned char *s) {
    size_t i, n = s[0] < 0x80 ? 1 : s[0] >= 0xF0 ? 4 : s[0] >= 0xE0 ? 3 : 2;
    if (n == 1) return 1;
    if (s[0] < 0xC2 || s[0] > 0xF4) return 0;
    for (i = 1; i < n; i++) {
        if ((s[i] & 0xC0) != 0x80) return 0;
    }
    if ((s[0] == 0xE0 && s[1] < 0xA0) || (s[0] == 0xED && s[1] > 0x9F)) return 0;
    if ((s[0] == 0xF0 && s[1] < 0x90) || (s[0] == 0xF4 && s[1] > 0x8F)) return 0;
    return n;
}

void put_string(FILE *to, const char *text) {
    const unsigned char *s = (const unsigned char *)text;
    (void)fputc('"', to);
    while (*s != 0) {
        size_t n = utf8_length(s);
        if (n == 0) {
            (void)fputs("\\ufffd", to);
            s++;
            continue;
        }
        if (*s < 32 || *s == 127) {
            (void)fprintf(to, "\\u%04x", (unsigned)*s);
        } else {
            if (*s == '"' || *s == '\\') (void)fputc('\\', to);
            (void)fwrite(s, 1, n, to);
        }
        s += n;
    }
    (void)fputc('"', to);
}

void put_key(FILE *to, const char *name) { (void)fprintf(to, ",\"%s\":", name); }

void put_text(FILE *to, const char *name, const char *text) {
    put_key(to, name);
    put_string(to, text);
}

void put_null(FILE *to, const char *name) {
    put_key(to, name);
    (void)fputs("null", to);
}

void put_count(FILE *to, const char *name, uint32_t n) {
    if (n == NOOK_UNKNOWN) {
        put_null(to, name);
        return;
    }
    put_key(to, name);
    (void)fprintf(to, "%" PRIu32, n);
}

void put_truth(FILE *to, const char *name, nook_truth truth) {
    put_key(to, name);
    (void)fputs(truth == NOOK_MAYBE ? "null" : truth == NOOK_YES ? "true" : "false", to);
}

static bool is_finite(float x) { return (nook_float_bits(x) & 0x7F800000u) != 0x7F800000u; }

void put_float(FILE *to, const char *name, bool known, float x) {
    put_key(to, name);
    (void)fputs(known && is_finite(x) ? decimal_of(x).text : "null", to);
}

void put_floats(FILE *to, const char *name, bool known, const float *x, uint32_t n) {
    uint32_t i;
    for (i = 0; i < n; i++) known = known && is_finite(x[i]);
    put_key(to, name);
    if (!known) (void)fputs("null", to);
    for (i = 0; i < n && known; i++) (void)fprintf(to, "%c%s", i == 0 ? '[' : ',', decimal_of(x[i]).text);
    if (known) (void)fputc(']', to);
}

void put_point(FILE *to, const char *name, bool known, nook_point p) {
    const float x[3] = {p.x, p.y, p.z};
    put_floats(to, name, known, x, 3);
}

/* ---- reading: words -------------------------------------------------------------------------- */

void json_begin(json *j, const char *text, size_t length) {
    j->at = text;
    j->end = text + length;
    j->wrong = NULL;
}

bool json_fail(json *j, const char *wrong) {
    if (j->wrong == NULL) j->wrong = wrong;
    return false;
}

static void skip_blanks(json *j) {
    while (j->at < j->end && (*j->at == ' ' || *j->at == '\t' || *j->at == '\r' || *j->at == '\n')) j->at++;
}

bool json_at_end(json *j) {
    skip_blanks(j);
    return j->at == j->end;
}

bool json_take(json *j, char c) {
    skip_blanks(j);
    if (j->at == j->end || *j->at != c) return false;
    j->at++;
    return true;
}

static bool is_one_of(char c, const char *set) { return c != 0 && strchr(set, c) != NULL; }

/* The rest of an escape, after its backslash. */
static bool take_escape(json *j) {
    int digits;
    if (j->at == j->end) return false;
    if (*j->at++ != 'u') return is_one_of(j->at[-1], "\"\\/bfnrt");
    for (digits = 0; digits < 4; digits++, j->at++) {
        if (j->at == j->end || !is_one_of(*j->at, "0123456789abcdefABCDEF")) return false;
    }
    return true;
}

/* A string, as what stands between its quotes. */
static bool take_string(json *j, word *text) {
    if (!json_take(j, '"')) return json_fail(j, "a string in quotes is missing");
    text->at = j->at;
    while (j->at < j->end) {
        char c = *j->at++;
        text->length = (size_t)(j->at - 1 - text->at);
        if (c == '"') return true;
        if ((unsigned char)c < 32) return json_fail(j, "a control character in a string");
        if (c == '\\' && !take_escape(j)) return json_fail(j, "a bad escape in a string");
    }
    return json_fail(j, "a string without an end");
}

/* What a number, a literal or a mistake is made of, up to what may follow one. */
static word take_word(json *j) {
    word w;
    skip_blanks(j);
    w.at = j->at;
    while (j->at < j->end && (unsigned char)*j->at > ' ' && !is_one_of(*j->at, ",:[]{}\"")) j->at++;
    w.length = (size_t)(j->at - w.at);
    return w;
}

static size_t count_digits(word w, size_t from) {
    size_t i = from;
    while (i < w.length && w.at[i] >= '0' && w.at[i] <= '9') i++;
    return i - from;
}

/* Numbers of JSON have no plus sign, no leading zero, and digits on both sides of a point. */
static bool is_number(word w) {
    size_t i = w.length != 0 && *w.at == '-' ? 1 : 0, digits = count_digits(w, i);
    if (digits == 0 || (digits > 1 && w.at[i] == '0')) return false;
    i += digits;
    if (i < w.length && w.at[i] == '.') {
        digits = count_digits(w, i + 1);
        if (digits == 0) return false;
        i += digits + 1;
    }
    if (i == w.length) return true;
    if (w.at[i] != 'e' && w.at[i] != 'E') return false;
    i++;
    if (i < w.length && (w.at[i] == '+' || w.at[i] == '-')) i++;
    digits = count_digits(w, i);
    return digits != 0 && i + digits == w.length;
}

static bool skip_scalar(json *j) {
    word w;
    if (j->at < j->end && *j->at == '"') return take_string(j, &w);
    w = take_word(j);
    return is_number(w) || word_is(w, "true") || word_is(w, "false") || word_is(w, "null")
               ? true
               : json_fail(j, "a value is missing");
}

/* ---- reading: values ------------------------------------------------------------------------- */

bool json_float(json *j, float *x) {
    word w = take_word(j);
    nook_status status = word_float(w, x);
    if (status == NOOK_NOT_FINITE) return json_fail(j, "a number that is no finite float32");
    return status == NOOK_OK && is_number(w) ? true : json_fail(j, "a number is missing");
}

bool json_floats(json *j, float *x, uint32_t n) {
    uint32_t i;
    if (!json_take(j, '[')) return json_fail(j, "an array of numbers is missing");
    for (i = 0; i < n; i++) {
        if (i != 0 && !json_take(j, ',')) return json_fail(j, "an array with too few numbers");
        if (!json_float(j, &x[i])) return false;
    }
    return json_take(j, ']') ? true : json_fail(j, "an array does not end where it should");
}

bool json_member(json *j, bool *first, word *key) {
    if (json_take(j, '}')) return false;
    if (!*first && !json_take(j, ',')) return json_fail(j, "a comma or } is missing");
    *first = false;
    if (!take_string(j, key)) return false;
    return json_take(j, ':') ? true : json_fail(j, "a colon is missing");
}

/* Like json_member, for an array. */
static bool json_element(json *j, bool *first) {
    if (json_take(j, ']')) return false;
    if (!*first && !json_take(j, ',')) return json_fail(j, "a comma or ] is missing");
    *first = false;
    return true;
}

/* Bit 0 of arrays: whether the innermost of the values that are open is an array. */
bool json_skip(json *j) {
    uint64_t arrays = 0;
    uint32_t depth = 0;
    bool first = false;
    word key;
    do {
        bool array = json_take(j, '['), opens = array || json_take(j, '{');
        if (opens && depth++ == JSON_DEPTH) return json_fail(j, "nested too deep");
        if (opens) arrays = arrays << 1 | (array ? 1u : 0u);
        if (!opens && !skip_scalar(j)) return false;
        first = opens;
        while (depth != 0 && !((arrays & 1u) != 0 ? json_element(j, &first) : json_member(j, &first, &key))) {
            if (j->wrong != NULL) return false;
            depth--;
            arrays >>= 1;
            first = false;
        }
    } while (depth != 0);
    return true;
}
