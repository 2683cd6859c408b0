/* failure.h -- why a file cannot be read, and where: one line for people, one object for programs.
 *
 * Importers return false after filling one of these. It owns no memory. */
#ifndef FAILURE_H
#define FAILURE_H

#include <stdio.h>

#include "nook.h"

#define FAILURE_NOWHERE UINT64_MAX

typedef struct failure {
    const char *code; /* a status name, or "cannot_read" */
    char what[160];
    uint64_t byte, line; /* FAILURE_NOWHERE where it does not apply */
    char element[48];    /* "vertex 12"; empty where it does not apply */
} failure;

/* Start a failure that is nowhere yet. Returns false, so that importers can return it. */
bool fail(failure *f, nook_status status, const char *what);
bool fail_at_byte(failure *f, nook_status status, const char *what, uint64_t byte);
bool fail_at_line(failure *f, nook_status status, const char *what, uint64_t line);

/* Add the element at fault; returns false. */
bool fail_element(failure *f, const char *kind, uint64_t number);

/* The line for stderr: nook: FILE: what, where. */
void print_failure(FILE *to, const char *file, const failure *f);
/* A file name on one line: control characters become '?'. */
void print_name(FILE *to, const char *name);
void print_message(FILE *to, const char *file, const char *message);

#endif
