/* tree.h -- the tree of boxes over a loaded mesh, on the heap. */
#ifndef TREE_H
#define TREE_H

#include "failure.h"

typedef struct tree {
    nook_bvh bvh;
    nook_boxes *boxes;
    nook_index *order;
} tree;

/* The mesh must outlive the tree. False with f filled if it has no triangle; tree_free() either way. */
bool tree_build(tree *t, const nook_mesh *mesh, failure *f);
void tree_free(tree *t);

#endif
