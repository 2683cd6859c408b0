/* nook_digest.c -- one number for a whole mesh, equal wherever the mesh is equal.
 *
 * CRC-32, four bits at a time: a table of 64 bytes in flash instead of 1,024. */
#include "core/nook_vector.h"

static const uint32_t crc_of_nibble[16] = {
    0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu, 0x76DC4190u, 0x6B6B51F4u, 0x4DB26158u, 0x5005713Cu,
    0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu, 0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu,
};

static uint32_t digest_word(uint32_t crc, uint32_t word) {
    uint32_t i;
    crc ^= word; /* a little-endian word is its four bytes in order */
    for (i = 0; i < 8u; i++) crc = crc >> 4 ^ crc_of_nibble[crc & 15u];
    return crc;
}

static uint32_t digest_float(uint32_t crc, float x) {
    return digest_word(crc, nook_float_bits(x == 0 ? 0.0f : x));
}

uint32_t nook_digest(const nook_view *view) {
    uint32_t i, crc = UINT32_MAX;
    NOOK_REQUIRE(view != NULL);
    crc = digest_word(crc, view->nv);
    crc = digest_word(crc, view->nt);
    for (i = 0; i < view->nv; i++) {
        crc = digest_float(crc, view->G[i].x);
        crc = digest_float(crc, view->G[i].y);
        crc = digest_float(crc, view->G[i].z);
    }
    for (i = 0; i < 3u * view->nt; i++) crc = digest_word(crc, view->V[i]);
    for (i = 0; i < 3u * view->nt; i++) crc = digest_word(crc, view->O[i]);
    return ~crc;
}
