/* import.c -- which format these bytes are.
 *
 * The exact size of a binary STL comes first, since any text may stand in its header. */
#include "import.h"

#include "scan.h"

static bool is_exact_binary_stl(const uint8_t *data, size_t size) {
    uint64_t facets;
    if (size < 84) return false;
    facets = data[80] | (uint64_t)data[81] << 8 | (uint64_t)data[82] << 16 | (uint64_t)data[83] << 24;
    return size == 84 + 50 * facets;
}

/* Every other byte of the beginning is zero and the rest are characters. */
static bool is_utf16(const uint8_t *data, size_t size) {
    size_t i, n = size < 64 ? size : 64, zeros[2] = {0, 0};
    if (size >= 2 && ((data[0] == 0xFF && data[1] == 0xFE) || (data[0] == 0xFE && data[1] == 0xFF)))
        return true;
    for (i = 0; i < n; i++) {
        if (data[i] == 0) zeros[i & 1]++;
    }
    return n >= 8 && ((zeros[0] == 0 && zeros[1] == n / 2) || (zeros[1] == 0 && zeros[0] >= n / 2));
}

/* A header of 80 bytes and a count are never text throughout: small counts have zero bytes. */
static bool has_control_bytes(const uint8_t *data, size_t size) {
    size_t i;
    for (i = 0; i < size && i < 84; i++) {
        if (data[i] < 9 || (data[i] > 13 && data[i] < 32)) return true;
    }
    return false;
}

static bool begins_with(const uint8_t *data, size_t size, const char *name) {
    scan s;
    word w;
    scan_begin(&s, data, size);
    return scan_any_word(&s, &w) && word_is_any_case(w, name);
}

bool import_mesh(imported *m, const bytes *b, failure *f) {
    const uint8_t *data = b->data;
    size_t size = b->size;
    memset(m, 0, sizeof *m);
    if (size == 0) return fail_at_byte(f, NOOK_UNKNOWN_FORMAT, "the file is empty", 0);
    if (is_exact_binary_stl(data, size)) return import_stl(m, data, size, f);
    if (is_utf16(data, size))
        return fail(f, NOOK_UNKNOWN_FORMAT, "text in UTF-16 is not read; save it as UTF-8 or ASCII");
    if (size >= 3 && data[0] == 0xEF && data[1] == 0xBB && data[2] == 0xBF) {
        data += 3;
        size -= 3;
    }
    if (begins_with(data, size, "ply")) return import_ply(m, data, size, f);
    if (looks_like_off(data, size)) return import_off(m, data, size, f);
    if (begins_with(data, size, "solid")) return import_stl(m, data, size, f);
    if (looks_like_obj(data, size)) return import_obj(m, data, size, f);
    if (has_control_bytes(data, size)) return import_stl(m, data, size, f);
    return fail(f, NOOK_UNKNOWN_FORMAT, "not a mesh in any format that is read (STL, OBJ, OFF, PLY)");
}
