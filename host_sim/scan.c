/* scan.c -- a scanner of words. One pass, nothing kept; every loop advances or stops. */
#include "scan.h"

void scan_begin(scan *s, const uint8_t *data, size_t size) {
    memset(s, 0, sizeof *s);
    s->at = (const char *)data;
    s->end = s->at + size;
    s->line = 1;
}

static bool is_line_end(char c) { return c == '\n' || c == '\r'; }

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

static void take_line_end(scan *s) {
    char c = *s->at++;
    if (c == '\r' && s->at < s->end && *s->at == '\n') s->at++;
    s->line++;
}

static bool at_continuation(const scan *s) {
    return s->continued && *s->at == '\\' && s->at + 1 < s->end && is_line_end(s->at[1]);
}

static void skip_blanks(scan *s) {
    while (s->at < s->end) {
        if (is_blank(*s->at)) {
            s->at++;
        } else if (at_continuation(s)) {
            s->at++;
            take_line_end(s);
        } else if (s->comments && *s->at == '#') {
            while (s->at < s->end && !is_line_end(*s->at)) s->at++;
        } else {
            return;
        }
    }
}

bool scan_word(scan *s, word *w) {
    skip_blanks(s);
    w->at = s->at;
    while (s->at < s->end && !is_blank(*s->at) && !is_line_end(*s->at)) {
        if (at_continuation(s) || (s->comments && *s->at == '#')) break;
        s->at++;
    }
    w->length = (size_t)(s->at - w->at);
    return w->length != 0;
}

bool scan_next_line(scan *s) {
    while (s->at < s->end && !is_line_end(*s->at)) {
        skip_blanks(s);
        if (s->at < s->end && !is_line_end(*s->at)) s->at++;
    }
    if (s->at == s->end) return false;
    take_line_end(s);
    return true;
}

bool scan_any_word(scan *s, word *w) {
    while (!scan_word(s, w)) {
        if (!scan_next_line(s)) return false;
    }
    return true;
}

size_t scan_left(const scan *s) { return (size_t)(s->end - s->at); }

static char lower(char c) {
    if (c >= 'A' && c <= 'Z') return (char)(c - 'A' + 'a');
    return c;
}

bool word_is(word w, const char *text) {
    return strlen(text) == w.length && memcmp(w.at, text, w.length) == 0;
}

static bool begins_any_case(word w, const char *text) {
    size_t i;
    for (i = 0; text[i] != 0; i++) {
        if (i >= w.length || lower(w.at[i]) != text[i]) return false;
    }
    return true;
}

bool word_is_any_case(word w, const char *text) {
    return strlen(text) == w.length && begins_any_case(w, text);
}

nook_status word_float(word w, float *x) {
    nook_status status = nook_parse_float(w.at, w.length, x);
    if (status != NOOK_BAD_NUMBER) return status;
    if (w.length != 0 && (*w.at == '+' || *w.at == '-')) {
        w.at++;
        w.length--;
    }
    if (begins_any_case(w, "nan") || begins_any_case(w, "inf") || begins_any_case(w, "1.#"))
        return NOOK_NOT_FINITE;
    return NOOK_BAD_NUMBER;
}

bool word_integer(word w, int64_t *i) {
    bool minus = w.length != 0 && *w.at == '-';
    size_t k = w.length != 0 && (*w.at == '-' || *w.at == '+') ? 1 : 0;
    int64_t value = 0;
    if (k == w.length) return false;
    for (; k < w.length; k++) {
        if (w.at[k] < '0' || w.at[k] > '9' || value > INT64_MAX / 20) return false;
        value = 10 * value + (w.at[k] - '0');
    }
    *i = minus ? -value : value;
    return true;
}
