/* files.c -- folders, one level deep. Names are compared byte by byte, so the order is the same
 * everywhere. */
#define _POSIX_C_SOURCE 200809L
#include "files.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <sys/stat.h>

#include "heap.h"
#include "scan.h"

static void add(files *list, const char *folder, const char *name) {
    size_t n = strlen(folder), room = n + strlen(name) + 2;
    bool slash = n != 0 && folder[n - 1] != '/';
    list->path = grow(list->path, &list->room, list->count + 1, sizeof *list->path);
    list->path[list->count] = take(room, 1);
    (void)snprintf(list->path[list->count++], room, "%s%s%s", folder, slash ? "/" : "", name);
}

static bool is_folder(const char *path) {
    struct stat s;
    return stat(path, &s) == 0 && S_ISDIR(s.st_mode);
}

static bool is_mesh_name(const char *name) {
    static const char *const endings[] = {".stl", ".obj", ".off", ".ply"};
    word w;
    size_t i, n = strlen(name);
    if (n < 5 || name[0] == '.') return false;
    w.at = name + n - 4;
    w.length = 4;
    for (i = 0; i < sizeof endings / sizeof endings[0]; i++) {
        if (word_is_any_case(w, endings[i])) return true;
    }
    return false;
}

static int by_name(const void *a, const void *b) { return strcmp(*(char *const *)a, *(char *const *)b); }

bool files_add(files *list, const char *operand, failure *f) {
    DIR *folder;
    struct dirent *entry;
    size_t first = list->count;
    if (strcmp(operand, "-") == 0 || !is_folder(operand)) {
        add(list, "", operand);
        return true;
    }
    folder = opendir(operand);
    if (folder == NULL) {
        (void)fail(f, NOOK_OK, strerror(errno));
        f->code = "cannot_read";
        return false;
    }
    while ((entry = readdir(folder)) != NULL) {
        if (!is_mesh_name(entry->d_name)) continue;
        add(list, operand, entry->d_name);
        if (is_folder(list->path[list->count - 1])) free(list->path[--list->count]);
    }
    (void)closedir(folder);
    if (list->count == first) {
        (void)fail(f, NOOK_UNKNOWN_FORMAT, "no mesh file (.stl, .obj, .off, .ply) in this folder");
        return false;
    }
    qsort(list->path + first, list->count - first, sizeof *list->path, by_name);
    return true;
}

void files_free(files *list) {
    size_t i;
    for (i = 0; i < list->count; i++) free(list->path[i]);
    free(list->path);
    memset(list, 0, sizeof *list);
}

bool is_same_file(const char *a, const char *b) {
    struct stat s, t;
    if (stat(a, &s) != 0 || stat(b, &t) != 0) return false;
    return s.st_dev == t.st_dev && s.st_ino == t.st_ino;
}
