/* export.c -- four writers. Same drawing, same bytes, on every machine. */
#include "export.h"

#include <inttypes.h>

#include "decimal.h"
#include "scan.h"

file_format format_named(const char *name) {
    static const char *const names[] = {"stl", "obj", "off", "ply"};
    word w;
    int i;
    w.at = name;
    w.length = strlen(name);
    for (i = 0; i < 4; i++) {
        if (word_is_any_case(w, names[i])) return (file_format)(FORMAT_STL + i);
    }
    return NO_FORMAT;
}

file_format format_of_path(const char *path) {
    const char *dot = strrchr(path, '.');
    return dot != NULL ? format_named(dot + 1) : NO_FORMAT;
}

static void add_point(bytes *out, nook_point p) {
    bytes_add_u32(out, nook_float_bits(p.x));
    bytes_add_u32(out, nook_float_bits(p.y));
    bytes_add_u32(out, nook_float_bits(p.z));
}

static nook_point normal_of(const nook_point c[3]) {
    nook_point n = nook_cross(nook_sub(c[1], c[0]), nook_sub(c[2], c[0]));
    float length = nook_length(n);
    return length > 0 ? nook_make(n.x / length, n.y / length, n.z / length) : nook_make(0, 0, 0);
}

static void export_stl(bytes *out, const drawing *d) {
    char header[80] = "binary STL written by nook";
    uint32_t t, i;
    nook_point corner[3];
    bytes_add(out, header, sizeof header);
    bytes_add_u32(out, d->nt);
    for (t = 0; t < d->nt; t++) {
        for (i = 0; i < 3u; i++) corner[i] = d->G[d->V[3 * (size_t)t + i]];
        add_point(out, normal_of(corner));
        for (i = 0; i < 3u; i++) add_point(out, corner[i]);
        bytes_add(out, "\0\0", 2);
    }
}

static void add_vertices(bytes *out, const drawing *d, const char *before) {
    uint32_t v;
    for (v = 0; v < d->nv; v++) {
        bytes_add_text(out, before);
        bytes_add_text(out, decimal_of(d->G[v].x).text);
        bytes_add_text(out, " ");
        bytes_add_text(out, decimal_of(d->G[v].y).text);
        bytes_add_text(out, " ");
        bytes_add_text(out, decimal_of(d->G[v].z).text);
        bytes_add_text(out, "\n");
    }
}

static void add_faces(bytes *out, const drawing *d, const char *before, uint32_t base) {
    char line[64];
    uint32_t t;
    for (t = 0; t < d->nt; t++) {
        const uint32_t *v = &d->V[3 * (size_t)t];
        (void)snprintf(line, sizeof line, "%s%" PRIu32 " %" PRIu32 " %" PRIu32 "\n", before, v[0] + base,
                       v[1] + base, v[2] + base);
        bytes_add_text(out, line);
    }
}

static void export_obj(bytes *out, const drawing *d) {
    add_vertices(out, d, "v ");
    add_faces(out, d, "f ", 1);
}

static void export_off(bytes *out, const drawing *d) {
    char line[64];
    (void)snprintf(line, sizeof line, "OFF\n%" PRIu32 " %" PRIu32 " 0\n", d->nv, d->nt);
    bytes_add_text(out, line);
    add_vertices(out, d, "");
    add_faces(out, d, "3 ", 0);
}

static void export_ply(bytes *out, const drawing *d) {
    char header[320];
    uint32_t i;
    (void)snprintf(header, sizeof header,
                   "ply\nformat binary_little_endian 1.0\ncomment written by nook\nelement vertex %" PRIu32
                   "\n"
                   "property float x\nproperty float y\nproperty float z\nelement face %" PRIu32 "\n"
                   "property list uchar uint vertex_indices\nend_header\n",
                   d->nv, d->nt);
    bytes_add_text(out, header);
    for (i = 0; i < d->nv; i++) add_point(out, d->G[i]);
    for (i = 0; i < 3u * d->nt; i++) {
        if (i % 3u == 0) bytes_add(out, "\3", 1);
        bytes_add_u32(out, d->V[i]);
    }
}

void export_drawing(bytes *out, const drawing *d, file_format format) {
    memset(out, 0, sizeof *out);
    if (format == FORMAT_STL) export_stl(out, d);
    if (format == FORMAT_OBJ) export_obj(out, d);
    if (format == FORMAT_OFF) export_off(out, d);
    if (format == FORMAT_PLY) export_ply(out, d);
}

bool write_drawing(const drawing *d, const char *path, file_format format) {
    bytes out;
    failure f;
    bool good;
    export_drawing(&out, d, format);
    good = bytes_write(&out, path, &f);
    bytes_free(&out);
    if (!good) print_failure(stderr, path, &f);
    return good;
}

bool write_mesh(const nook_mesh *mesh, const char *path, file_format format) {
    drawing d;
    uint32_t i;
    bool good;
    memset(&d, 0, sizeof d);
    for (i = 0; i < mesh->nv; i++) (void)drawing_vertex(&d, mesh->G[i]);
    for (i = 0; i < mesh->nt; i++)
        drawing_triangle(&d, mesh->V[3u * i], mesh->V[3u * i + 1u], mesh->V[3u * i + 2u]);
    good = write_drawing(&d, path, format);
    drawing_free(&d);
    return good;
}
