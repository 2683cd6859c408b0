/* cmd_make.c -- a generated mesh in a file, sound or with a chosen defect. */
#include <inttypes.h>

#include "commands.h"

const char make_help[] =
    "nook make SHAPE [--triangles N] [--defect KIND] [--format F] -o OUT      a mesh to try things with\n"
    "\n"
    "  SHAPE          icosphere torus box capsule pipe gear tetrahedron: closed and facing outward;\n"
    "                 sheet: flat and open; moebius: one-sided\n"
    "  --triangles N  as near to N as the shape can come (default 320)\n"
    "  --defect KIND  hole flipped inside-out duplicate nonmanifold-edge bow-tie crossing isolated\n"
    "                 degenerate zero-area unwelded nan\n"
    "  -o OUT         the ending .stl .obj .off .ply decides the format; - is standard output\n"
    "  --format F     stl obj off ply, whatever OUT is called\n"
    "\n"
    "The same bytes on every machine. Exit status: 0 written, 2 not.\n";

static bool draw(drawing *d, const options *o, uint32_t triangles, file_format format) {
    const char *kind = o->value[OPTION_DEFECT];
    if (!draw_shape(d, o->operand[1], triangles)) return usage_error("the shapes are: ", shape_names);
    if (kind == NULL) return true;
    if (format == FORMAT_STL && strcmp(kind, "isolated") == 0)
        return usage_error("STL has no vertices of their own, so none can be isolated", "");
    return spoil(d, kind) ? true : usage_error("the defects are: ", defect_names);
}

int cmd_make(const options *o) {
    drawing d;
    file_format format;
    const char *out = o->value[OPTION_OUTPUT];
    uint32_t triangles = 320;
    bool good;
    if (o->operands != 2) return usage_error("make needs one shape out of: ", shape_names) ? 0 : 2;
    if (!o->given[OPTION_OUTPUT]) return usage_error("make needs -o OUT", "") ? 0 : 2;
    if (!option_count(o, OPTION_TRIANGLES, &triangles) || !option_format(o, out, &format)) return 2;
    memset(&d, 0, sizeof d);
    good = draw(&d, o, triangles, format) && write_drawing(&d, out, format);
    if (good)
        (void)fprintf(stderr, "nook: %s: %" PRIu32 " triangles, %" PRIu32 " vertices\n", out, d.nt, d.nv);
    drawing_free(&d);
    return good ? 0 : 2;
}
