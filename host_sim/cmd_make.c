/* cmd_make.c -- a generated mesh in a file, sound or with a chosen defect. */
#include <inttypes.h>

#include "commands.h"
#include "export.h"

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

static bool choose_format(const options *o, file_format *format) {
    const char *out = o->value[OPTION_OUTPUT];
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

static bool draw(drawing *d, const options *o, uint32_t triangles, file_format format) {
    const char *kind = o->value[OPTION_DEFECT];
    if (!draw_shape(d, o->operand[1], triangles)) return usage_error("the shapes are: ", shape_names);
    if (kind == NULL) return true;
    if (format == FORMAT_STL && strcmp(kind, "isolated") == 0)
        return usage_error("STL has no vertices of their own, so none can be isolated", "");
    return spoil(d, kind) ? true : usage_error("the defects are: ", defect_names);
}

static bool write_drawing(const drawing *d, const char *path, file_format format) {
    bytes out;
    failure f;
    bool good;
    export_drawing(&out, d, format);
    good = bytes_write(&out, path, &f);
    bytes_free(&out);
    if (!good) {
        print_failure(stderr, path, &f);
        return false;
    }
    (void)fprintf(stderr, "nook: %s: %" PRIu32 " triangles, %" PRIu32 " vertices\n", path, d->nt, d->nv);
    return true;
}

int cmd_make(const options *o) {
    drawing d;
    file_format format;
    uint32_t triangles = 320;
    bool good;
    if (o->operands != 2) return usage_error("make needs one shape out of: ", shape_names) ? 0 : 2;
    if (!o->given[OPTION_OUTPUT]) return usage_error("make needs -o OUT", "") ? 0 : 2;
    if (!option_count(o, OPTION_TRIANGLES, &triangles) || !choose_format(o, &format)) return 2;
    memset(&d, 0, sizeof d);
    good = draw(&d, o, triangles, format) && write_drawing(&d, o->value[OPTION_OUTPUT], format);
    drawing_free(&d);
    return good ? 0 : 2;
}
