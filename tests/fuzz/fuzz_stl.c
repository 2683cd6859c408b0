/* fuzz_stl.c -- any bytes as an STL that arrives in chunks of any size.
 *
 * The last nine bytes of the input say how: eight chunk sizes, used in turn, and what size the reader is
 * told. Each chunk lies in a heap block of its own. Must hold: the triangles, the statuses and the places are
 * those of the same bytes in one chunk; bytes are used up from the front; a triangle's points can be used; an
 * error is given again by every later call, without taking bytes. */
#include "fuzz.h"

enum { SIZES = 8 };

typedef struct reading {
    nook_stl stl;
    uint32_t triangles, points; /* how many, and a number made of all their bits */
    nook_status status;
} reading;

static void take_triangle(reading *r, const nook_point corners[3]) {
    uint32_t i;
    r->triangles++;
    for (i = 0; i < 3; i++) {
        EXPECT(nook_point_status(corners[i]) == NOOK_OK);
        r->points = 31u * r->points + nook_float_bits(corners[i].x);
        r->points = 31u * r->points + nook_float_bits(corners[i].y);
        r->points = 31u * r->points + nook_float_bits(corners[i].z);
    }
}

/* False when the reader has given up. */
static bool push_chunk(reading *r, const uint8_t *data, size_t size) {
    uint8_t *chunk = exact(data, size);
    const uint8_t *at = chunk;
    size_t left = size;
    nook_point corners[3];
    while ((r->status = nook_stl_push(&r->stl, &at, &left, corners)) == NOOK_TRIANGLE) {
        take_triangle(r, corners);
        EXPECT(r->triangles <= size / 8 + r->stl.offset / 8);
        EXPECT(left <= size && at == chunk + (size - left));
    }
    EXPECT(left <= size && at == chunk + (size - left));
    if (r->status == NOOK_MORE) {
        EXPECT(left == 0);
    } else {
        size_t before = left;
        EXPECT(r->status >= NOOK_NOT_FINITE && r->status != NOOK_OK);
        EXPECT(nook_stl_push(&r->stl, &at, &left, corners) == r->status && left == before);
    }
    free(chunk);
    return r->status == NOOK_MORE;
}

static void finish(reading *r) {
    nook_status status = nook_stl_end(&r->stl);
    EXPECT(r->status == NOOK_MORE || status == r->status);
    EXPECT(r->stl.triangles == r->triangles);
    if (status != NOOK_OK) EXPECT(nook_stl_end(&r->stl) == status);
    r->status = status;
}

static uint32_t told_size(uint8_t how, size_t size) {
    if (how % 3 == 0) return NOOK_UNKNOWN;
    return how % 3 == 1 ? (uint32_t)size : (uint32_t)size + how - 128u;
}

static void read_whole(reading *r, const uint8_t *data, size_t size, uint8_t how) {
    memset(r, 0, sizeof *r);
    nook_stl_begin(&r->stl, told_size(how, size));
    (void)push_chunk(r, data, size);
    finish(r);
}

static void read_in_chunks(reading *r, const uint8_t *data, size_t size, uint8_t how, const uint8_t *sizes) {
    uint32_t k = 0;
    memset(r, 0, sizeof *r);
    nook_stl_begin(&r->stl, told_size(how, size));
    r->status = NOOK_MORE;
    while (size != 0 && r->status == NOOK_MORE) {
        size_t take = sizes[k % SIZES];
        if (take == 0 && k % SIZES != 0) take = 64; /* one empty chunk in eight is enough */
        if (take > size) take = size;
        (void)push_chunk(r, data, take);
        data += take;
        size -= take;
        k++;
    }
    finish(r);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    uint8_t control[SIZES + 1] = {0};
    reading whole, cut;
    if (size > sizeof control) {
        size -= sizeof control;
        memcpy(control, data + size, sizeof control);
    }
    read_whole(&whole, data, size, control[SIZES]);
    read_in_chunks(&cut, data, size, control[SIZES], control);
    EXPECT(whole.status == cut.status && whole.triangles == cut.triangles && whole.points == cut.points);
    EXPECT(whole.stl.where.kind == cut.stl.where.kind && whole.stl.where.index == cut.stl.where.index);
    EXPECT(whole.stl.ascii == cut.stl.ascii && whole.stl.declared == cut.stl.declared);
    EXPECT(whole.stl.trailing == cut.stl.trailing);
    return 0;
}
