/* nook_marks.h -- bits about triangles, corners and vertices, kept outside the mesh so that tasks
 * can share one mesh and each have their own.
 *
 * Mt holds 3 bits a triangle: a search reads them as one number a triangle (how it was entered), a
 * walk over fans or loops as one bit a corner. Mv holds 1 bit a vertex. Together 0.44 bytes a
 * triangle when V = T/2. Contents need no preparation: whoever takes marks clears them first. */
#ifndef NOOK_MARKS_H
#define NOOK_MARKS_H

#include "core/nook_config.h"

/* Bytes of Mt[] for max_nt triangles and of Mv[] for max_nv vertices; constant expressions.
 * One byte is added so that three bits can be read as two bytes. */
#define NOOK_MT_BYTES(max_nt) ((size_t)(max_nt)*3u / 8u + 2u)
#define NOOK_MV_BYTES(max_nv) (((size_t)(max_nv) + 7u) / 8u)

typedef struct nook_marks {
    uint8_t *Mt;             /* [NOOK_MT_BYTES(max_nt)] */
    uint8_t *Mv;             /* [NOOK_MV_BYTES(max_nv)] */
    uint32_t max_nt, max_nv; /* for how many they were declared */
} nook_marks;

static inline bool nook_bit(const uint8_t *bits, uint32_t i) {
    return ((uint32_t)bits[i >> 3] >> (i & 7u) & 1u) != 0;
}

static inline void nook_set_bit(uint8_t *bits, uint32_t i) {
    bits[i >> 3] = (uint8_t)(bits[i >> 3] | 1u << (i & 7u));
}

static inline void nook_clear_bit(uint8_t *bits, uint32_t i) {
    bits[i >> 3] = (uint8_t)(bits[i >> 3] & ~(1u << (i & 7u)));
}

/* The three bits of triangle t as a number 0..7. */
static inline uint32_t nook_code(const uint8_t *Mt, uint32_t t) {
    uint32_t i = 3u * t;
    uint32_t two = Mt[i >> 3] | (uint32_t)Mt[(i >> 3) + 1u] << 8;
    return two >> (i & 7u) & 7u;
}

static inline void nook_set_code(uint8_t *Mt, uint32_t t, uint32_t code) {
    uint32_t i = 3u * t, shift = i & 7u;
    uint32_t two = Mt[i >> 3] | (uint32_t)Mt[(i >> 3) + 1u] << 8;
    two = (two & ~(7u << shift)) | code << shift;
    Mt[i >> 3] = (uint8_t)two;
    Mt[(i >> 3) + 1u] = (uint8_t)(two >> 8);
}

#endif
