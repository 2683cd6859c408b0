/* options.c -- options anywhere, "--name value" or "--name=value", until "--". */
#include "options.h"

#include <stdlib.h>

#include "heap.h"
#include "scan.h"

static const struct {
    const char *name;
    bool takes_value;
    unsigned commands;
} table[OPTION_COUNT] = {
    {"--help", false, FOR_ALL},
    {"--version", false, FOR_ALL},
    {"--json", false, FOR_MESH},
    {"--weld", true, FOR_MESH},
    {"--scale", true, FOR_MESH},
    {"--require", true, FOR_CHECK},
    {"--max-list", true, FOR_CHECK},
    {"--board", true, FOR_CHECK},
    {"--html", true, FOR_CHECK},
    {"--svg", true, FOR_CHECK},
    {"--triangles", true, FOR_MAKE | FOR_SIMPLIFY},
    {"--defect", true, FOR_MAKE},
    {"-o", true, FOR_MAKE},
    {"--format", true, FOR_MAKE | FOR_HULL | FOR_SIMPLIFY | FOR_SMOOTH},
    {"--budget", true, FOR_QUERY},
    {"--error", true, FOR_SIMPLIFY},
    {"--outside", false, FOR_SIMPLIFY},
    {"--convex", false, FOR_SIMPLIFY},
    {"--unguarded", false, FOR_SIMPLIFY},
    {"--iterations", true, FOR_SMOOTH},
    {"--method", true, FOR_SMOOTH},
    {"--slide", false, FOR_SMOOTH},
};

bool usage_error(const char *what, const char *about) {
    (void)fprintf(stderr, "nook: %s%s\n", what, about);
    return false;
}

/* The option that arg names, with the length of its name; OPTION_COUNT if none. */
static int find(const char *arg, size_t *length) {
    int i;
    *length = strcspn(arg, "=");
    if (strcmp(arg, "-h") == 0) return OPTION_HELP;
    for (i = 0; i < OPTION_COUNT; i++) {
        if (strlen(table[i].name) == *length && memcmp(table[i].name, arg, *length) == 0) return i;
    }
    return OPTION_COUNT;
}

static bool parse_option(options *o, int argc, char **argv, int *at) {
    const char *arg = argv[*at];
    size_t length;
    int i = find(arg, &length);
    if (i == OPTION_COUNT) {
        (void)fprintf(stderr, "nook: no option is called %s (see nook --help)\n", arg);
        return false;
    }
    if (!table[i].takes_value && arg[length] == '=') return usage_error("this option takes no value: ", arg);
    if (table[i].takes_value && arg[length] == 0 && *at + 1 == argc)
        return usage_error("a value must follow ", arg);
    o->given[i] = true;
    if (table[i].takes_value) o->value[i] = arg[length] == '=' ? arg + length + 1 : argv[++*at];
    return true;
}

bool options_parse(options *o, int argc, char **argv) {
    int i;
    bool only_operands = false;
    memset(o, 0, sizeof *o);
    o->operand = take((size_t)argc + 1, sizeof *o->operand);
    for (i = 1; i < argc; i++) {
        if (i == 1 && strcmp(argv[i], "help") == 0) {
            o->given[OPTION_HELP] = true;
        } else if (only_operands || argv[i][0] != '-' || argv[i][1] == 0) {
            o->operand[o->operands++] = argv[i];
        } else if (strcmp(argv[i], "--") == 0) {
            only_operands = true;
        } else if (!parse_option(o, argc, argv, &i)) {
            return false;
        }
    }
    return true;
}

bool options_allowed(const options *o, unsigned command, const char *name) {
    int i;
    for (i = 0; i < OPTION_COUNT; i++) {
        if (!o->given[i] || (table[i].commands & command) != 0) continue;
        (void)fprintf(stderr, "nook: %s has no option %s (see nook %s --help)\n", name, table[i].name, name);
        return false;
    }
    return true;
}

static word word_of(const char *text) {
    word w;
    w.at = text;
    w.length = strlen(text);
    return w;
}

bool option_count(const options *o, option which, uint32_t *value) {
    int64_t n;
    if (!o->given[which]) return true;
    if (!word_integer(word_of(o->value[which]), &n) || n < 0 || n > (int64_t)UINT32_MAX - 1) {
        (void)fprintf(stderr, "nook: %s needs a count, not '%s'\n", table[which].name, o->value[which]);
        return false;
    }
    *value = (uint32_t)n;
    return true;
}

bool option_length(const options *o, option which, float *value) {
    if (!o->given[which]) return true;
    if (word_float(word_of(o->value[which]), value) == NOOK_OK && *value >= 0) return true;
    (void)fprintf(stderr, "nook: %s needs a length, not '%s'\n", table[which].name, o->value[which]);
    return false;
}

static bool parse_weld(const char *text, weld_choice *weld) {
    float distance;
    if (strcmp(text, "exact") == 0) {
        *weld = WELD_EXACT;
    } else if (strcmp(text, "none") == 0) {
        *weld = WELD_NONE;
    } else if (word_float(word_of(text), &distance) == NOOK_OK) {
        return usage_error("welding by distance is not available yet: --weld ", text);
    } else {
        return usage_error("--weld is exact or none, not ", text);
    }
    return true;
}

bool options_for_load(const options *o, load_options *load) {
    load->weld = WELD_DEFAULT;
    load->scale = 1;
    if (o->given[OPTION_WELD] && !parse_weld(o->value[OPTION_WELD], &load->weld)) return false;
    if (!o->given[OPTION_SCALE]) return true;
    if (word_float(word_of(o->value[OPTION_SCALE]), &load->scale) != NOOK_OK || !(load->scale > 0)) {
        return usage_error("--scale needs a positive number, not ", o->value[OPTION_SCALE]);
    }
    return true;
}

bool option_format(const options *o, const char *out, file_format *format) {
    if (o->given[OPTION_FORMAT]) {
        *format = format_named(o->value[OPTION_FORMAT]);
        return *format != NO_FORMAT
                   ? true
                   : usage_error("the formats are stl, obj, off and ply, not ", o->value[OPTION_FORMAT]);
    }
    *format = format_of_path(out);
    return *format != NO_FORMAT
               ? true
               : usage_error("no format: end the name in .stl, .obj, .off or .ply, or give --format: ", out);
}
