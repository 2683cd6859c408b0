/* nook_vector.h -- vectors of three floats, and a square root that sets no errno. */
#ifndef NOOK_VECTOR_H
#define NOOK_VECTOR_H

#include <string.h>

#include "core/nook_mesh.h"

/* The bits of a float, and back. */
static inline uint32_t nook_float_bits(float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline float nook_float_from(uint32_t bits) {
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* 2^(biased - 127), and the biased exponent of |x| brought into 1..253, so that both the power of
 * two near x and its inverse are normal floats. */
static inline float nook_power_of_two(uint32_t biased) { return nook_float_from(biased << 23); }

static inline uint32_t nook_exponent(float x) {
    uint32_t biased = nook_float_bits(x) >> 23 & 0xFFu;
    return biased < 1u ? 1u : biased > 253u ? 253u : biased;
}

/* A coordinate along axis 0, 1, 2: a point is three floats without gaps. */
static inline float nook_along(const nook_point *p, uint32_t axis) { return (&p->x)[axis]; }
static inline float *nook_axis(nook_point *p, uint32_t axis) { return &p->x + axis; }

/* The axis, or corner of three, after another. */
static inline uint32_t nook_after(uint32_t i) { return i == 2u ? 0 : i + 1u; }

static inline nook_point nook_make(float x, float y, float z) {
    nook_point p = {x, y, z};
    return p;
}

static inline nook_point nook_sub(nook_point a, nook_point b) {
    return nook_make(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline nook_point nook_scaled(nook_point a, float s) { return nook_make(a.x * s, a.y * s, a.z * s); }

static inline float nook_dot(nook_point a, nook_point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static inline nook_point nook_cross(nook_point a, nook_point b) {
    return nook_make(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

/* The correctly rounded square root by integers alone, for cores without one: the same bits as
 * the instruction on every finite x >= 0 and infinity; NaN for x < 0. Steps: 25 of a few
 * instructions. */
float nook_sqrt_by_integers(float x);

/* The correctly rounded square root: one instruction where the core has it. */
static inline float nook_sqrt(float x) {
#if defined(__ARM_FP) && (__ARM_FP & 4) && defined(__arm__)
    float root;
    __asm__("vsqrt.f32 %0, %1" : "=t"(root) : "t"(x));
    return root;
#elif defined(__SSE__)
    float root;
    __asm__("sqrtss %1, %0" : "=x"(root) : "x"(x));
    return root;
#elif defined(__aarch64__)
    float root;
    __asm__("fsqrt %s0, %s1" : "=w"(root) : "w"(x));
    return root;
#elif defined(__riscv_flen)
    float root;
    __asm__("fsqrt.s %0, %1" : "=f"(root) : "f"(x));
    return root;
#else
    return nook_sqrt_by_integers(x);
#endif
}

/* |a| without overflow or underflow in the squares. */
float nook_length(nook_point a);

/* The barycentric coordinates of p, as it is seen along the normal of the triangle: p = w0 p0 + w1 p1 + w2 p2 in the
 * plane. A third each if the triangle has no area (in floats). Steps: constant. */
void nook_barycentric(const nook_point triangle[3], nook_point p, float w[3]);

/* The normal of a triangle, of length 1, to the side from which it is seen counter-clockwise; 0 if it has no area (in
 * floats). Steps: constant. */
nook_point nook_normal(const nook_point triangle[3]);

/* The angle of (x, y) from the x axis, -pi to pi, within 3e-7 of itself; 0 for (0, 0). The same bits everywhere, which no
 * libm's arctangent promises. Finite arguments. Steps: constant. */
float nook_angle(float y, float x);

#endif
