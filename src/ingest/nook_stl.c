/* nook_stl.c -- STL from a stream, binary or ASCII, one small state and no look back.
 *
 * The first 84 bytes are kept until it is clear which format this is; of a text they are then read
 * like all that follow, and cannot hold a whole facet. After that a binary file is a row of 50-byte
 * records, and a text is a fixed sequence of words (expected[]) around skipped normals and parsed
 * coordinates. */
#include "ingest/nook_stl.h"

#include <string.h>

#include "core/nook_corner.h"
#include "core/nook_vector.h"

enum { HEADER_BYTES = 84, RECORD_BYTES = 50 };

/* What a facet consists of, word for word: a name, a number, or something to skip. */
static const char *const expected[] = {
    "facet",  "normal", "",  "",  "",       "outer", "loop", "vertex", "0",       "0",        "0",
    "vertex", "0",      "0", "0", "vertex", "0",     "0",    "0",      "endloop", "endfacet",
};

enum step { FACET, SKIPS = 2, NUMBERS = 8, ENDFACET = 20, SOLID, NAME, LAST_NAME, HEADER, RECORD };

static nook_status fail(nook_stl *stl, nook_status status) {
    stl->failed = (uint8_t)status;
    stl->where = stl->ascii ? nook_at(NOOK_AT_LINE, stl->line) : nook_at(NOOK_AT_BYTE, stl->offset);
    return status;
}

void nook_stl_begin(nook_stl *stl, uint32_t size) {
    memset(stl, 0, sizeof *stl);
    stl->size = size;
    stl->line = 1;
    stl->step = HEADER;
}

static uint32_t little_endian(const uint8_t *b) {
    return (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

static bool is_space(uint8_t byte) { return byte == ' ' || (byte >= '\t' && byte <= '\r'); }

/* ---- binary ---------------------------------------------------------------------------------- */

static float *coordinate(nook_stl *stl, uint32_t i) {
    nook_point *p = &stl->corner[nook_triangle(i)];
    uint32_t axis = i - 3u * nook_triangle(i);
    return axis == 0 ? &p->x : axis == 1u ? &p->y : &p->z;
}

static nook_status take_record(nook_stl *stl, nook_point corners[3]) {
    uint32_t i;
    for (i = 0; i < 9u; i++) *coordinate(stl, i) = nook_float_from(little_endian(stl->bytes + 12u + 4u * i));
    for (i = 0; i < 3u; i++) {
        nook_status status = nook_point_status(stl->corner[i]);
        if (status != NOOK_OK) {
            stl->offset -= RECORD_BYTES - 12u - 12u * i; /* the first byte of that vertex */
            return fail(stl, status);
        }
        corners[i] = stl->corner[i];
    }
    stl->filled = 0;
    stl->triangles++;
    return NOOK_TRIANGLE;
}

/* Copy into bytes[] until it holds count; true when it does. */
static bool fill(nook_stl *stl, uint32_t count, const uint8_t **at, size_t *left) {
    size_t wanted = count - stl->filled, take = wanted < *left ? wanted : *left;
    if (take == 0) return false;
    memcpy(stl->bytes + stl->filled, *at, take);
    stl->filled = (uint8_t)(stl->filled + take);
    stl->offset += (uint32_t)take;
    *at += take;
    *left -= take;
    return stl->filled == count;
}

static nook_status push_binary(nook_stl *stl, const uint8_t **at, size_t *left, nook_point corners[3]) {
    if (stl->triangles == stl->declared) {
        if (*left == 0) return NOOK_MORE;
        stl->trailing = true;
        *at += *left;
        *left = 0;
        return NOOK_MORE;
    }
    return fill(stl, RECORD_BYTES, at, left) ? take_record(stl, corners) : NOOK_MORE;
}

/* ---- ASCII ----------------------------------------------------------------------------------- */

static bool word_is(const nook_stl *stl, const char *word) {
    uint32_t i = 0;
    while (i < stl->letters && word[i] != 0 && word[i] == stl->word[i]) i++;
    return i == stl->letters && word[i] == 0;
}

/* A word has ended where a name was due. */
static nook_status take_word(nook_stl *stl) {
    bool solid = word_is(stl, "solid"), end = word_is(stl, "endsolid");
    if (stl->step == SOLID && !solid) return fail(stl, NOOK_BAD_SYNTAX);
    if (stl->step == SOLID || (stl->step == FACET && (solid || end))) {
        stl->step = end ? LAST_NAME : NAME;
    } else if (word_is(stl, expected[stl->step])) {
        stl->step++;
    } else {
        return fail(stl, NOOK_BAD_SYNTAX);
    }
    return NOOK_OK;
}

static nook_status take_number(nook_stl *stl) {
    uint32_t i = (uint32_t)(stl->step - NUMBERS);
    float *value = coordinate(stl, i - i / 4u);
    nook_status status = nook_number_value(&stl->number, value);
    if (status == NOOK_OK) status = nook_point_status(nook_make(*value, 0, 0));
    stl->step++;
    return status == NOOK_OK ? NOOK_OK : fail(stl, status);
}

static bool at_number(const nook_stl *stl) { return stl->step < ENDFACET && expected[stl->step][0] == '0'; }

static bool at_skip(const nook_stl *stl) {
    return stl->step >= NAME || (stl->step >= SKIPS && stl->step < SKIPS + 3);
}

/* White space ends a word, and a line ends a name. */
static nook_status take_space(nook_stl *stl, uint8_t byte) {
    nook_status status = NOOK_OK;
    if (stl->letters != 0 && at_number(stl)) {
        status = take_number(stl);
    } else if (stl->letters != 0 && !at_skip(stl)) {
        status = take_word(stl);
    } else if (stl->letters != 0 && stl->step < NAME) {
        stl->step++;
    }
    stl->letters = 0;
    if (byte == '\n' || byte == '\r') {
        if (stl->step == NAME) stl->step = FACET;
        if (stl->step == LAST_NAME) stl->step = SOLID;
    }
    if (status == NOOK_OK) stl->line += byte == '\r' || (byte == '\n' && !stl->after_return);
    stl->after_return = byte == '\r';
    return status;
}

/* The word "nan" or "inf" where a number is due deserves its own answer. */
static nook_status bad_number(const nook_stl *stl, uint8_t byte) {
    uint8_t letter = byte | 0x20u;
    return stl->number.place <= 1u && (letter == 'n' || letter == 'i') ? NOOK_NOT_FINITE : NOOK_BAD_NUMBER;
}

/* One byte of a text. NOOK_TRIANGLE with the last letter of "endfacet", which may end the file. */
static nook_status take_byte(nook_stl *stl, uint8_t byte) {
    if (is_space(byte)) return take_space(stl, byte);
    if (at_number(stl)) {
        if (stl->letters == 0) nook_number_begin(&stl->number);
        if (nook_number_push(&stl->number, (char)byte) != NOOK_OK) return fail(stl, bad_number(stl, byte));
    } else if (stl->letters < sizeof stl->word) {
        stl->word[stl->letters] = (char)(byte >= 'A' && byte <= 'Z' ? byte + 32 : byte);
    }
    if (stl->letters < sizeof stl->word) stl->letters++; /* at 9 the word is none of ours */
    if (stl->step != ENDFACET || !word_is(stl, "endfacet")) return NOOK_OK;
    stl->step = FACET;
    stl->letters = 0;
    stl->triangles++;
    return NOOK_TRIANGLE;
}

static nook_status push_ascii(nook_stl *stl, const uint8_t **at, size_t *left, nook_point corners[3]) {
    while (*left != 0) {
        nook_status status = take_byte(stl, **at);
        if (status != NOOK_OK && status != NOOK_TRIANGLE) return status;
        ++*at;
        --*left;
        stl->offset++;
        if (status == NOOK_TRIANGLE) {
            memcpy(corners, stl->corner, sizeof stl->corner);
            return status;
        }
    }
    return NOOK_MORE;
}

/* ---- which of the two ------------------------------------------------------------------------ */

/* The bytes of a mark that some editors put before a text in UTF-8. */
static uint32_t mark_of_utf8(const nook_stl *stl) {
    return stl->filled >= 3u && memcmp(stl->bytes, "\xEF\xBB\xBF", 3) == 0 ? 3u : 0;
}

static bool looks_like_text(const nook_stl *stl) {
    static const char solid[] = "solid";
    uint32_t i, first = mark_of_utf8(stl);
    while (first < stl->filled && is_space(stl->bytes[first])) first++;
    for (i = 0; i < 5u; i++) {
        if (first + i >= stl->filled || (stl->bytes[first + i] | 0x20u) != (uint8_t)solid[i]) return false;
    }
    for (i = 0; i < stl->filled; i++) {
        if (stl->bytes[i] < ' ' && !is_space(stl->bytes[i])) return false;
    }
    return true;
}

static nook_status begin_text(nook_stl *stl) {
    nook_status status = NOOK_OK;
    uint32_t i;
    stl->ascii = true;
    stl->step = SOLID;
    for (i = mark_of_utf8(stl); i < stl->filled && status == NOOK_OK; i++)
        status = take_byte(stl, stl->bytes[i]);
    return status;
}

static nook_status decide(nook_stl *stl) {
    uint64_t needed;
    stl->declared = little_endian(stl->bytes + 80);
    needed = HEADER_BYTES + (uint64_t)RECORD_BYTES * stl->declared;
    if (stl->size != needed && looks_like_text(stl)) return begin_text(stl);
    stl->step = RECORD;
    stl->filled = 0;
    if (stl->size == NOOK_UNKNOWN || stl->size >= needed) return NOOK_OK;
    stl->offset = stl->size;
    return fail(stl, NOOK_TRUNCATED);
}

nook_status nook_stl_push(nook_stl *stl, const uint8_t **at, size_t *left, nook_point corners[3]) {
    if (stl->failed != NOOK_OK) return (nook_status)stl->failed;
    if (stl->step == HEADER) {
        nook_status status;
        if (!fill(stl, HEADER_BYTES, at, left)) return NOOK_MORE;
        status = decide(stl);
        if (status != NOOK_OK) return status;
    }
    return stl->ascii ? push_ascii(stl, at, left, corners) : push_binary(stl, at, left, corners);
}

nook_status nook_stl_end(nook_stl *stl) {
    nook_status status = NOOK_OK;
    if (stl->failed != NOOK_OK) return (nook_status)stl->failed;
    if (stl->step == HEADER) {
        if (!looks_like_text(stl)) return fail(stl, NOOK_UNKNOWN_FORMAT);
        status = begin_text(stl);
    }
    if (stl->step == RECORD) return stl->triangles == stl->declared ? NOOK_OK : fail(stl, NOOK_TRUNCATED);
    if (status == NOOK_OK) status = take_space(stl, ' ');
    if (status != NOOK_OK) return status;
    return stl->step == FACET || stl->step >= SOLID ? NOOK_OK : fail(stl, NOOK_TRUNCATED);
}
