/* lists.h -- the oracle of edits: a list of triangles, changed without any adjacency and linked anew. */
#ifndef LISTS_H
#define LISTS_H

#include "shapes.h"

enum { MOST = 64, MOST_C = 3 * MOST };

extern nook_index list[MOST_C]; /* the triangles as they should be */
extern uint32_t listed;
extern nook_check_result list_result; /* of the list, when it was last linked */

/* Take the triangles of b.mesh; whether triangle t of the list has vertex v. */
void take_list(void);
bool list_has(uint32_t t, uint32_t v);
/* Link the list; whether it is a manifold without duplicates, whose directions agree. */
bool list_is_manifold(uint32_t nv);
/* What O of the list is, when it was last linked. */
uint32_t list_opposite(uint32_t c);
/* Whether the mesh has exactly the triangles of the list, in any order and turn. */
void same_triangles(void);
/* The tables of b.mesh are whole, and O is what its V says. */
void tables_hold(void);

/* Remember b's tables, take them back, and compare. */
void keep(void);
const nook_index *kept_V(void);
void restore(uint32_t nv, uint32_t nt);
void is_as_kept(void);
/* V and O of nt triangles, which are all. */
void starts_as_kept(uint32_t nt);

/* Shape i, linked, if it is a coherent manifold that fits with a few elements more; list_result has its numbers. */
bool begin_whole(uint32_t i);

#endif
