/* cmd_check.c -- is each mesh sound, and if not, where? One file after the other; memory is that of
 * the largest. */
#include "commands.h"
#include "files.h"
#include "report.h"

const char check_help[] =
    "nook check [OPTION...] FILE...      is this mesh sound, and if not, where?\n"
    "\n"
    "Reads STL, OBJ, OFF and PLY, told by content. FILE may be a folder, or - for standard input.\n"
    "  --weld exact|none   join vertices with equal coordinates (default: exact for STL, none else)\n"
    "  --scale S           multiply every coordinate by S first\n"
    "  --require LIST      the properties that decide the verdict, separated by commas; default\n"
    "                      " PROPERTIES_BY_DEFAULT "\n"
    "  --max-list N        elements listed for each kind of defect (default 10); totals are exact\n"
    "  --json              one JSON object a file, on one line\n"
    "\n"
    "Triangles are numbered as left when degenerate ones are dropped, from 0; the dropped ones\n"
    "themselves as in the file. Polygons count as the triangles they are cut into.\n"
    "Exit status: 0 sound, 1 defective, 2 unreadable or wrong usage; the highest of all files.\n";

typedef struct check_options {
    load_options load;
    uint32_t required, max_list;
    bool json;
} check_options;

static bool parse_required(const char *list, uint32_t *required) {
    uint32_t i;
    if (properties_parse(list, required)) return true;
    (void)fprintf(stderr, "nook: --require %s: the properties are", list);
    for (i = 0; i < PROPERTY_COUNT; i++) (void)fprintf(stderr, "%s %s", i == 0 ? "" : ",", property_name(i));
    (void)fputc('\n', stderr);
    return false;
}

static bool not_yet(const options *o, option which, const char *name) {
    return o->given[which] ? !usage_error("not available yet: ", name) : false;
}

static bool parse(const options *o, check_options *c) {
    c->max_list = 10;
    c->json = o->given[OPTION_JSON];
    if (not_yet(o, OPTION_BOARD, "--board") || not_yet(o, OPTION_HTML, "--html")) return false;
    if (not_yet(o, OPTION_SVG, "--svg")) return false;
    if (!options_for_load(o, &c->load) || !option_count(o, OPTION_MAX_LIST, &c->max_list)) return false;
    return parse_required(o->given[OPTION_REQUIRE] ? o->value[OPTION_REQUIRE] : PROPERTIES_BY_DEFAULT,
                          &c->required);
}

static int unreadable(const char *file, const char *format, const failure *f, const check_options *c) {
    print_failure(stderr, file, f);
    if (c->json) report_json_unreadable(stdout, file, format, f);
    return 2;
}

static int check_file(const char *file, const check_options *c) {
    model m;
    verdict v;
    failure f;
    int status;
    memset(&v, 0, sizeof v);
    if (!model_load(&m, file, &c->load, c->max_list, &f) || !examine(&v, &m, c->max_list, &f)) {
        status = unreadable(file, m.format, &f, c);
    } else {
        (c->json ? report_json : report_text)(stdout, file, &m, &v, c->required);
        status = is_sound(&v, &m, c->required) ? 0 : 1;
    }
    verdict_free(&v);
    model_free(&m);
    return status;
}

static void tally(int status, size_t count[3], int *worst) {
    count[status]++;
    if (status > *worst) *worst = status;
}

static void print_summary(const size_t count[3]) {
    unsigned long all = (unsigned long)(count[0] + count[1] + count[2]);
    (void)fprintf(stderr, "nook: %lu %s: %lu sound, %lu defective, %lu unreadable\n", all,
                  all == 1 ? "file" : "files", (unsigned long)count[0], (unsigned long)count[1],
                  (unsigned long)count[2]);
}

int cmd_check(const options *o) {
    check_options c;
    files list = {NULL, 0, 0};
    failure f;
    size_t i, k, count[3] = {0, 0, 0};
    int worst = 0;
    bool folder = false;
    if (!parse(o, &c)) return 2;
    if (o->operands < 2) return usage_error("check needs a file (see nook check --help)", "") ? 0 : 2;
    for (i = 1; i < o->operands; i++) {
        if (!files_add(&list, o->operand[i], &f))
            tally(unreadable(o->operand[i], NULL, &f, &c), count, &worst);
        folder = folder || list.count == 0 || strcmp(list.path[0], o->operand[i]) != 0;
        for (k = 0; k < list.count; k++) tally(check_file(list.path[k], &c), count, &worst);
        files_free(&list);
    }
    if (folder || count[0] + count[1] + count[2] > 1) print_summary(count);
    return worst;
}
