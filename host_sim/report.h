/* report.h -- what check found, for programs (one JSON object on one line) and for people. */
#ifndef REPORT_H
#define REPORT_H

#include "verdict.h"

void report_json(FILE *to, const char *file, const model *m, const verdict *v, uint32_t required);
void report_json_unreadable(FILE *to, const char *file, const char *format, const failure *f);
void report_text(FILE *to, const char *file, const model *m, const verdict *v, uint32_t required);

#endif
