/* import.h -- the bytes of any mesh file to points and triangles.
 *
 * The format is told by content. Importers take any bytes: a count in a header is held against the
 * bytes present before anything is reserved, arrays grow with what was really read, and each loop
 * uses up input. Memory: at most 24 bytes of arrays for a byte of input, with doubling (a binary PLY
 * of one-byte indices); typically one or two. */
#ifndef IMPORT_H
#define IMPORT_H

#include "bytes.h"
#include "imported.h"

/* False with f filled when the bytes are not a mesh. The caller frees m either way. */
bool import_mesh(imported *m, const bytes *b, failure *f);

/* For the importers of single formats, which have the same form. */
bool import_stl(imported *m, const uint8_t *data, size_t size, failure *f);
bool import_obj(imported *m, const uint8_t *data, size_t size, failure *f);
bool import_off(imported *m, const uint8_t *data, size_t size, failure *f);
bool import_ply(imported *m, const uint8_t *data, size_t size, failure *f);

/* The vertex at x, read with this status from this line of a text, or the failure to. */
bool import_text_vertex(imported *m, const float x[3], nook_status status, uint32_t line, failure *f);

/* Whether a text looks like OBJ (some line is an OBJ statement), or like OFF (its first word). */
bool looks_like_obj(const uint8_t *data, size_t size);
bool looks_like_off(const uint8_t *data, size_t size);

#endif
