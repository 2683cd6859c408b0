/* failure.c -- filling and printing failures; always one line, whatever a file is called. */
#include "failure.h"

#include <inttypes.h>

bool fail(failure *f, nook_status status, const char *what) {
    f->code = nook_status_name(status);
    (void)snprintf(f->what, sizeof f->what, "%s", what != NULL ? what : nook_status_text(status));
    f->byte = f->line = FAILURE_NOWHERE;
    f->element[0] = 0;
    return false;
}

bool fail_at_byte(failure *f, nook_status status, const char *what, uint64_t byte) {
    (void)fail(f, status, what);
    f->byte = byte;
    return false;
}

bool fail_at_line(failure *f, nook_status status, const char *what, uint64_t line) {
    (void)fail(f, status, what);
    f->line = line;
    return false;
}

bool fail_element(failure *f, const char *kind, uint64_t number) {
    (void)snprintf(f->element, sizeof f->element, "%.20s %" PRIu64, kind, number);
    return false;
}

void print_name(FILE *to, const char *name) {
    for (; *name != 0; name++) (void)fputc((unsigned char)*name < 32 || *name == 127 ? '?' : *name, to);
}

void print_message(FILE *to, const char *file, const char *message) {
    (void)fputs("nook: ", to);
    print_name(to, file);
    (void)fprintf(to, ": %s\n", message);
}

void print_failure(FILE *to, const char *file, const failure *f) {
    char line[320];
    int used = snprintf(line, sizeof line, "%s", f->what);
    if (f->byte != FAILURE_NOWHERE)
        used += snprintf(line + used, sizeof line - (size_t)used, ", byte %" PRIu64, f->byte);
    if (f->line != FAILURE_NOWHERE)
        used += snprintf(line + used, sizeof line - (size_t)used, ", line %" PRIu64, f->line);
    if (f->element[0] != 0) (void)snprintf(line + used, sizeof line - (size_t)used, ", %s", f->element);
    print_message(to, file, line);
}
