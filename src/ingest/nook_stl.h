/* nook_stl.h -- triangles out of an STL file that arrives in chunks of any size.
 *
 * The state is fixed (at most 256 bytes), nothing of the file is kept, and no byte can hurt: use it
 * behind a serial line or a file system read. Binary or ASCII is decided by content: many binary
 * files begin with the word "solid". With the file's size known, 84 + 50 n bytes are binary;
 * otherwise a text has "solid" first and no control character in its first 84 bytes.
 *
 *     nook_stl stl;
 *     nook_stl_begin(&stl, NOOK_UNKNOWN);
 *     while (there are bytes) {
 *         const uint8_t *at = bytes;  size_t left = how many;
 *         while ((status = nook_stl_push(&stl, &at, &left, corners)) == NOOK_TRIANGLE)
 *             nook_mesh_append(&mesh, corners);
 *         if (status != NOOK_MORE) stop: stl.where says where
 *     }
 *     status = nook_stl_end(&stl);
 *
 * Normals and attribute bytes are ignored. ASCII: any case, several solids joined, "endsolid"
 * optional; but the name of a solid ends with its line. */
#ifndef NOOK_STL_H
#define NOOK_STL_H

#include "core/nook_mesh.h"
#include "ingest/nook_number.h"

typedef struct nook_stl {
    nook_number number;   /* ASCII: the coordinate being read */
    nook_point corner[3]; /* of the triangle being read */
    nook_where where;     /* of an error: the byte of a binary file, the line of a text */
    uint32_t triangles;   /* given so far */
    uint32_t declared;    /* binary: how many the header announces */
    uint32_t size;        /* of the file, or NOOK_UNKNOWN */
    uint32_t offset;      /* of the next byte */
    uint32_t line;        /* ASCII: the one being read, from 1 */
    uint8_t bytes[84];    /* the header, then the binary record being read */
    char word[9];         /* ASCII: the word being read, in lower case */
    uint8_t filled;       /* of bytes[] */
    uint8_t letters;      /* of the word being read */
    uint8_t step;         /* private: what is read now */
    uint8_t failed;       /* the status that ended reading; NOOK_OK */
    bool ascii, after_return;
    bool trailing; /* bytes followed the declared triangles and were ignored */
} nook_stl;

/* size: of the whole file in bytes, or NOOK_UNKNOWN when it is a stream. */
void nook_stl_begin(nook_stl *stl, uint32_t size);

/* Read from *at, advancing *at and *left past what was used, until a triangle is complete.
 *   NOOK_TRIANGLE             corners[3] is set; bytes may be left: call again
 *   NOOK_MORE                 all bytes are used
 *   NOOK_BAD_NUMBER           a coordinate is not a number. stl->where: the line
 *   NOOK_BAD_SYNTAX           another word was expected. stl->where: the line
 *   NOOK_NOT_FINITE, NOOK_COORDINATE_TOO_LARGE  a coordinate; a word that begins like "nan" or
 *                             "inf" is called not finite. stl->where: byte or line
 *   NOOK_TRUNCATED            size is known and too small for the triangles announced
 * After an error every further call returns the same one. Steps: O(bytes); the number parser's
 * bound for each number. */
nook_status nook_stl_push(nook_stl *stl, const uint8_t **at, size_t *left, nook_point corners[3]);

/* No more bytes will come.
 *   NOOK_OK              the file was complete (stl->triangles may be 0)
 *   NOOK_TRUNCATED       it ends inside a triangle or before the announced number
 *   NOOK_UNKNOWN_FORMAT  fewer than 84 bytes and not a text that begins with "solid"
 * or an error in the last word. A text that fits into the first 84 bytes is only now read: it can
 * hold no complete triangle, so none is lost. */
nook_status nook_stl_end(nook_stl *stl);

#endif
