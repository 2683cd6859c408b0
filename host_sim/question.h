/* question.h -- one line of JSON as a question about a mesh. */
#ifndef QUESTION_H
#define QUESTION_H

#include "nook.h"

typedef enum question_kind {
    ASK_NOTHING,
    ASK_POINT,  /* a */
    ASK_RAY,    /* from a along b, which is not 0 */
    ASK_SEGMENT /* a to b, with a radius */
} question_kind;

typedef struct question {
    question_kind kind;
    nook_point a, b;
    float radius;
} question;

/* False with *wrong saying what is not as it should be; any bytes may come in. Places are finite and at most
 * 2^30, directions finite. */
bool question_read(question *q, const char *text, size_t length, const char **wrong);

#endif
