/* bytes.c -- files as byte arrays. Reads in chunks, so that pipes work like files; memory is at most
 * twice the file. */
#define _POSIX_C_SOURCE 200809L
#include "bytes.h"

#include <errno.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "heap.h"

#define LARGEST_FILE ((size_t)0xFFFFFFFEu)

static bool fail_io(failure *f, const char *code, int error) {
    (void)fail(f, NOOK_OK, error == 0 ? "input or output error" : strerror(error));
    f->code = code;
    return false;
}

static bool read_all(bytes *b, FILE *from, failure *f) {
    size_t got;
    do {
        b->data = grow(b->data, &b->room, b->size + 65536, 1);
        errno = 0;
        got = fread(b->data + b->size, 1, b->room - b->size, from);
        b->size += got;
        if (b->size > LARGEST_FILE)
            return fail(f, NOOK_NO_CAPACITY, "the file is larger than 4 GiB, the limit of this program");
    } while (got != 0);
    return ferror(from) ? fail_io(f, "cannot_read", errno) : true;
}

bool bytes_read(bytes *b, const char *path, failure *f) {
    FILE *from = stdin;
    bool done;
    memset(b, 0, sizeof *b);
    errno = 0;
    if (strcmp(path, "-") != 0) from = fopen(path, "rb");
    if (from == NULL) return fail_io(f, "cannot_read", errno);
    done = read_all(b, from, f);
    if (from != stdin) (void)fclose(from);
    if (!done) bytes_free(b);
    return done;
}

static bool write_stream(const bytes *b, FILE *to) {
    bool good = b->size == 0 || fwrite(b->data, 1, b->size, to) == b->size;
    return fflush(to) == 0 && good;
}

/* A name beside path that does not exist yet, opened; null if there is none. */
static FILE *open_beside(const char *path, char *name, size_t room) {
    FILE *to;
    mode_t mask;
    int fd;
    (void)snprintf(name, room, "%s.XXXXXX", path);
    fd = mkstemp(name);
    if (fd < 0) return NULL;
    mask = umask(0); /* the permissions that fopen() would have given */
    (void)umask(mask);
    (void)fchmod(fd, (S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH) & ~mask);
    to = fdopen(fd, "wb");
    if (to == NULL) {
        (void)close(fd);
        (void)remove(name);
    }
    return to;
}

bool bytes_write(const bytes *b, const char *path, failure *f) {
    struct stat there;
    char *name;
    FILE *to;
    bool good;
    size_t room = strlen(path) + 8;
    errno = 0;
    if (strcmp(path, "-") == 0) return write_stream(b, stdout) ? true : fail_io(f, "cannot_write", errno);
    if (stat(path, &there) == 0 && !S_ISREG(there.st_mode)) { /* a device or pipe cannot be renamed over */
        to = fopen(path, "wb");
        good = to != NULL && write_stream(b, to);
        if (to != NULL && fclose(to) != 0) good = false;
        return good ? true : fail_io(f, "cannot_write", errno);
    }
    name = take(room, 1);
    to = open_beside(path, name, room);
    good = to != NULL && write_stream(b, to);
    if (to != NULL && fclose(to) != 0) good = false;
    good = good && rename(name, path) == 0;
    if (!good) {
        (void)fail_io(f, "cannot_write", errno);
        if (to != NULL) (void)remove(name);
    }
    free(name);
    return good;
}

void bytes_add(bytes *b, const void *data, size_t size) {
    b->data = grow(b->data, &b->room, b->size + size, 1);
    if (size != 0) memcpy(b->data + b->size, data, size);
    b->size += size;
}

void bytes_add_text(bytes *b, const char *text) { bytes_add(b, text, strlen(text)); }

void bytes_add_u32(bytes *b, uint32_t word) {
    uint8_t four[4];
    uint32_t i;
    for (i = 0; i < 4u; i++) four[i] = (uint8_t)(word >> (8u * i));
    bytes_add(b, four, sizeof four);
}

void bytes_free(bytes *b) {
    free(b->data);
    memset(b, 0, sizeof *b);
}
