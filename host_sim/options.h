/* options.h -- the command line: one table of options, and which commands know each of them. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "export.h"
#include "model.h"

typedef enum command_set {
    FOR_CHECK = 1,
    FOR_MAKE = 2,
    FOR_QUERY = 4,
    FOR_HULL = 8,
    FOR_SMOOTH = 16,
    FOR_SIMPLIFY = 32,
    FOR_MESH = FOR_CHECK | FOR_QUERY | FOR_HULL | FOR_SMOOTH | FOR_SIMPLIFY, /* reads one */
    FOR_ALL = FOR_MESH | FOR_MAKE
} command_set;

typedef enum option {
    OPTION_HELP,
    OPTION_VERSION,
    OPTION_JSON,
    OPTION_WELD,
    OPTION_SCALE,
    OPTION_REQUIRE,
    OPTION_MAX_LIST,
    OPTION_BOARD,
    OPTION_HTML,
    OPTION_SVG,
    OPTION_TRIANGLES,
    OPTION_DEFECT,
    OPTION_OUTPUT,
    OPTION_FORMAT,
    OPTION_BUDGET,
    OPTION_ERROR,
    OPTION_OUTSIDE,
    OPTION_CONVEX,
    OPTION_UNGUARDED,
    OPTION_ITERATIONS,
    OPTION_METHOD,
    OPTION_SLIDE,
    OPTION_COUNT
} option;

typedef struct options {
    bool given[OPTION_COUNT];
    const char *value[OPTION_COUNT]; /* the last one given */
    const char **operand;            /* heap; the first is the command */
    size_t operands;
} options;

/* False after saying on stderr what is wrong. */
bool options_parse(options *o, int argc, char **argv);
/* Refuses options that this command does not know. */
bool options_allowed(const options *o, unsigned command, const char *name);

/* The values of single options; each false after saying what is wrong, and leaves its result alone
 * when the option was not given. */
bool option_count(const options *o, option which, uint32_t *value);
bool option_length(const options *o, option which, float *value); /* 0 or more */
bool options_for_load(const options *o, load_options *load);
/* The format to write: as --format says, or as out ends. */
bool option_format(const options *o, const char *out, file_format *format);

/* One line on stderr; returns false. */
bool usage_error(const char *what, const char *about);

#endif
