/* tree.c -- memory for a tree, and the tree. */
#include "tree.h"

#include <stdlib.h>

#include "heap.h"

bool tree_build(tree *t, const nook_mesh *mesh, failure *f) {
    nook_view view = nook_view_of(mesh);
    nook_status status;
    t->boxes = take(NOOK_BVH_GROUPS(mesh->nt), sizeof *t->boxes);
    t->order = take(mesh->nt, sizeof *t->order);
    status = nook_bvh_build(&t->bvh, &view, t->boxes, t->order, NULL);
    return status == NOOK_OK ? true : fail(f, status, status == NOOK_EMPTY_MESH ? "no triangle" : NULL);
}

void tree_free(tree *t) {
    free(t->boxes);
    free(t->order);
    memset(t, 0, sizeof *t);
}
