/* export.h -- a drawing as the bytes of a mesh file: STL binary, OBJ, OFF, or PLY binary. */
#ifndef EXPORT_H
#define EXPORT_H

#include "bytes.h"
#include "shapes.h"

typedef enum file_format { NO_FORMAT, FORMAT_STL, FORMAT_OBJ, FORMAT_OFF, FORMAT_PLY } file_format;

/* By name ("stl", any case) or by the ending of a file's name. */
file_format format_named(const char *name);
file_format format_of_path(const char *path);

/* out begins empty; the caller frees it. Coordinates in text read back to the same floats. */
void export_drawing(bytes *out, const drawing *d, file_format format);
/* The same to a file, whole or not at all; false after saying why not. */
bool write_drawing(const drawing *d, const char *path, file_format format);
bool write_mesh(const nook_mesh *mesh, const char *path, file_format format);

#endif
