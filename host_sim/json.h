/* json.h -- JSON: writing an object value by value, and reading a line without building a tree.
 *
 * The writer is a list of put_X(to, name, value), each of which begins with a comma: the first member of an
 * object is the caller's. Every text gives valid JSON, every float the shortest decimals.
 *
 * The reader goes along a text once and keeps nothing: a caller asks for what it expects, and skips the
 * rest. No recursion: a value that is skipped may be nested JSON_DEPTH deep. Keys are compared byte for byte,
 * so one that is written with escapes is unknown. */
#ifndef JSON_H
#define JSON_H

#include <stdio.h>

#include "scan.h"

void put_key(FILE *to, const char *name);
/* A string alone, as an element or after put_key(). */
void put_string(FILE *to, const char *text);
void put_text(FILE *to, const char *name, const char *text);
void put_null(FILE *to, const char *name);
/* null for NOOK_UNKNOWN, which is NOOK_NONE too. */
void put_count(FILE *to, const char *name, uint32_t n);
/* null for NOOK_MAYBE. */
void put_truth(FILE *to, const char *name, nook_truth truth);
/* null if not known or beyond float32; of several, as a whole. */
void put_float(FILE *to, const char *name, bool known, float x);
void put_floats(FILE *to, const char *name, bool known, const float *x, uint32_t n);
void put_point(FILE *to, const char *name, bool known, nook_point p);

#define JSON_DEPTH 64u

typedef struct json {
    const char *at, *end;
    const char *wrong; /* what, after a function below has failed; a text for people */
} json;

void json_begin(json *j, const char *text, size_t length);
/* Whether this character comes next, blanks aside; it is then taken. */
bool json_take(json *j, char c);
/* Whether nothing but blanks is left. */
bool json_at_end(json *j);
/* The next key of an object whose '{' has been taken, and its colon. False at '}', which is taken, or with
 * wrong set. *first is true before the first key. */
bool json_member(json *j, bool *first, word *key);
/* A number, or an array of exactly n, as the nearest floats. */
bool json_float(json *j, float *x);
bool json_floats(json *j, float *x, uint32_t n);
/* Any value. */
bool json_skip(json *j);
/* Sets what is wrong, unless something was before; returns false. */
bool json_fail(json *j, const char *wrong);

#endif
