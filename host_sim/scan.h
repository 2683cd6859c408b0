/* scan.h -- words and numbers of a text in memory, line by line, without a locale.
 *
 * Lines end with LF, CR LF or CR. Nothing is copied and no byte beyond end is read. */
#ifndef SCAN_H
#define SCAN_H

#include "nook.h"

typedef struct word {
    const char *at;
    size_t length;
} word;

typedef struct scan {
    const char *at, *end;
    uint32_t line;  /* from 1 */
    bool comments;  /* '#' to the end of the line is skipped */
    bool continued; /* '\' before a line end joins the lines; not inside a comment */
} scan;

void scan_begin(scan *s, const uint8_t *data, size_t size);

/* The next word on this line; false if there is none. */
bool scan_word(scan *s, word *w);
/* The next word on this line or a later one; false at the end of the text. */
bool scan_any_word(scan *s, word *w);
/* Past the end of this line; false if the text ends first. */
bool scan_next_line(scan *s);
/* Bytes not read yet. */
size_t scan_left(const scan *s);

/* Whether a word is this text, in the same or in any case. */
bool word_is(word w, const char *text);
bool word_is_any_case(word w, const char *text);

/* A word as the nearest float. NOOK_BAD_NUMBER; NOOK_NOT_FINITE also for every spelling of nan
 * and inf. */
nook_status word_float(word w, float *x);
/* A word as an integer: optional sign and digits. False if it is none or needs more than 62 bits. */
bool word_integer(word w, int64_t *i);

#endif
