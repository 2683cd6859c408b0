/* main.c -- the nook program: finds the command, runs it, and makes sure that its output arrived. */
#define _POSIX_C_SOURCE 200809L
#include <signal.h>
#include <stdlib.h>

#include "commands.h"

static const struct {
    const char *name;
    int (*run)(const options *o);
    const char *help;
    unsigned set;
} commands[] = {
    {"check", cmd_check, check_help, FOR_CHECK},     {"make", cmd_make, make_help, FOR_MAKE},
    {"query", cmd_query, query_help, FOR_QUERY},     {"hull", cmd_hull, hull_help, FOR_HULL},
    {"smooth", cmd_smooth, smooth_help, FOR_SMOOTH}, {"simplify", cmd_simplify, simplify_help, FOR_SIMPLIFY},
};

static const char *const planned[] = {
    "repair", "collide", "pack", "unpack", "verify", "robot", "boards", "run",
};

static const char help[] =
    "nook -- triangle meshes for microcontrollers, on the PC\n"
    "\n"
    "  nook check FILE...                       is this mesh sound, and if not, where?\n"
    "  nook make SHAPE [--triangles N] -o OUT   a mesh to try things with, sound or with a defect\n"
    "  nook query FILE                          distance, inside or outside, and rays: JSON on standard "
    "input\n"
    "  nook hull IN OUT                         the convex hull\n"
    "  nook smooth IN OUT                       without noise\n"
    "  nook simplify IN OUT --triangles N       fewer triangles, or as few as --error E allows\n"
    "  nook COMMAND --help                      the options of a command\n"
    "  nook --version\n"
    "\n"
    "Exit status: 0 done or sound, 1 the answer is no, 2 wrong usage or unreadable input.\n";

static int run_command(const options *o) {
    size_t i;
    const char *name = o->operand[0];
    for (i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        if (strcmp(name, commands[i].name) != 0) continue;
        if (o->given[OPTION_HELP]) return fputs(commands[i].help, stdout) < 0 ? 2 : 0;
        return options_allowed(o, commands[i].set, name) ? commands[i].run(o) : 2;
    }
    for (i = 0; i < sizeof planned / sizeof planned[0]; i++) {
        if (strcmp(name, planned[i]) == 0)
            return usage_error("this command does not exist yet: ", name) ? 0 : 2;
    }
    (void)fprintf(stderr, "nook: no command is called %s (see nook --help)\n", name);
    return 2;
}

static int run(const options *o) {
    if (o->given[OPTION_VERSION]) {
        (void)printf("nook %s, %d-bit indices\n", NOOK_VERSION_TEXT, NOOK_INDEX_BITS);
        return 0;
    }
    if (o->operands != 0) return run_command(o);
    (void)fputs(help, o->given[OPTION_HELP] ? stdout : stderr);
    return o->given[OPTION_HELP] ? 0 : 2;
}

int main(int argc, char **argv) {
    options o;
    int status = 2;
    (void)signal(SIGPIPE, SIG_IGN); /* a reader that went away is an error of writing, exit 2 */
    if (options_parse(&o, argc, argv)) status = run(&o);
    free(o.operand);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        (void)fputs("nook: standard output cannot be written\n", stderr);
        status = 2;
    }
    return status;
}
