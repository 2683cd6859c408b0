/* nook_config.h -- what may differ between builds, and the one header that decides it.
 *
 * Every setting has a default and may be set on the compiler's command line or in a header of
 * your own, named by -DNOOK_USER_CONFIG='"my_nook_config.h"'. Library and application must be
 * built with the same NOOK_INDEX_BITS; a mix does not link (see NOOK_WIDTH_GUARD). */
#ifndef NOOK_CONFIG_H
#define NOOK_CONFIG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef NOOK_USER_CONFIG
#include NOOK_USER_CONFIG
#endif

#define NOOK_VERSION_MAJOR 0
#define NOOK_VERSION_MINOR 1
#define NOOK_VERSION_PATCH 0
#define NOOK_VERSION_TEXT "0.1.0"

/* 16: at most 21,845 triangles, 12 bytes of tables each. 32: up to 357,913,941, 24 bytes. */
#ifndef NOOK_INDEX_BITS
#define NOOK_INDEX_BITS 16
#endif

/* Called with a condition that only a mistake in the calling program can break, never with one
 * that data can break. Off by default; define it as your assert to have misuse stopped early. */
#ifndef NOOK_REQUIRE
#define NOOK_REQUIRE(condition) ((void)0)
#endif

/* Whether the core computes floats in float32 by itself. Exact predicates then try floats first; their
 * answers are the same either way. */
#ifndef NOOK_HAS_FPU
#if (defined(__ARM_FP) && (__ARM_FP & 4)) || defined(__SSE__) || defined(__aarch64__) || defined(__riscv_flen)
#define NOOK_HAS_FPU 1
#else
#define NOOK_HAS_FPU 0
#endif
#endif

/* How many boxes or triangles are looked at side by side: loops of that length that a compiler turns into instructions on
 * several floats at once, where the core has them. Answers are the same either way. */
#ifndef NOOK_LANES
#ifdef __has_builtin
#define NOOK_HAS_SHUFFLE __has_builtin(__builtin_shufflevector)
#else
#define NOOK_HAS_SHUFFLE 0
#endif
#if (defined(__SSE2__) || defined(__ARM_NEON)) && NOOK_HAS_SHUFFLE
#define NOOK_LANES 4
#else
#define NOOK_LANES 1
#endif
#endif

/* Keeps a function out of line, so that its stack is not added to that of its neighbours. */
#ifdef __GNUC__
#define NOOK_APART __attribute__((noinline))
#else
#define NOOK_APART
#endif

/* How an index is stored. Parameters and locals are uint32_t; nook_store() converts.
 * Corner ids run to 3T - 1, so the largest value of nook_index always stays free for "none". */
#if NOOK_INDEX_BITS == 16
typedef uint16_t nook_index;
#define NOOK_MAX_TRIANGLES 21845u
#define NOOK_MAX_VERTICES 65535u
#define NOOK_WIDTH_GUARD(name) name##_for_16_bit_indices
#elif NOOK_INDEX_BITS == 32
typedef uint32_t nook_index;
#define NOOK_MAX_TRIANGLES 357913941u /* 3T < 2^30, so that bounds on steps fit 32 bits */
#define NOOK_MAX_VERTICES 1073741823u
#define NOOK_WIDTH_GUARD(name) name##_for_32_bit_indices
#else
#error "NOOK_INDEX_BITS must be 16 or 32"
#endif

/* How a bound of a box is stored in a BVH: 8 bits make 2 bytes a triangle, 16 bits 4 bytes and tighter boxes,
 * which pays from some 20,000 triangles. Answers are the same. */
#ifndef NOOK_BOUND_BITS
#define NOOK_BOUND_BITS (NOOK_INDEX_BITS / 2)
#endif
#if NOOK_BOUND_BITS == 8
typedef uint8_t nook_bound;
#define NOOK_BOUND_GUARD(name) name##_for_8_bit_bounds
#elif NOOK_BOUND_BITS == 16
typedef uint16_t nook_bound;
#define NOOK_BOUND_GUARD(name) name##_for_16_bit_bounds
#else
#error "NOOK_BOUND_BITS must be 8 or 16"
#endif
#define nook_bvh_begin NOOK_BOUND_GUARD(nook_bvh_begin)

/* The entry points through which every mesh and view must pass carry the width in their linker
 * names, so an application built for the other width fails to link and the message says why. */
#define nook_mesh_init NOOK_WIDTH_GUARD(nook_mesh_init)
#define nook_view_init NOOK_WIDTH_GUARD(nook_view_init)

/* "No element": one value in every parameter, result and struct field of type uint32_t. */
#define NOOK_NONE UINT32_MAX
/* A count that cannot be told from what was given. */
#define NOOK_UNKNOWN UINT32_MAX
/* Coordinates are refused above this magnitude, so that squares and cubes stay finite. */
#define NOOK_MAX_COORDINATE 1073741824.0f

/* A property that may also be undefined or not decidable from what was given. */
typedef enum nook_truth { NOOK_NO = 0, NOOK_YES = 1, NOOK_MAYBE = 2 } nook_truth;

#endif
