/* files.h -- the files that operands stand for: a folder is the mesh files in it, sorted by name. */
#ifndef FILES_H
#define FILES_H

#include "failure.h"

typedef struct files {
    char **path; /* heap, each of them too */
    size_t count, room;
} files;

/* Add what an operand stands for. False with f filled if it is a folder that cannot be read or has
 * no mesh file; anything else is taken as a file, whether it exists or not. */
bool files_add(files *list, const char *operand, failure *f);
void files_free(files *list);

/* Whether two names are of one file that exists. */
bool is_same_file(const char *a, const char *b);

#endif
