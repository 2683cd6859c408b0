/* test_stl.c -- the STL reader, fed with every size of chunk.
 *
 * Three facets whose coordinates count up in quarters are built as a binary file and as a text. Both
 * are read whole, in pieces, cut at every length, spelled in every way that exporters have, and with
 * bytes changed at random: what comes out must be these facets, a status that the format explains, or
 * at least never a triangle that the bytes cannot hold. */
#include "check.h"
#include "rooms.h"

#include <string.h>

#include "nook.h"

#define FACETS 3u
#define MOST_BYTES 3000u
#define MOST_TRIANGLES 64u

static uint8_t file[MOST_BYTES];
static size_t size;
static nook_stl stl;
static nook_point got[MOST_TRIANGLES][3];
static uint32_t count;

static void put_byte(uint32_t byte) {
    if (size < MOST_BYTES) file[size++] = (uint8_t)byte;
}

static void put_word(uint32_t word) {
    uint32_t i;
    for (i = 0; i < 4u; i++) put_byte(word >> 8u * i & 0xFFu);
}

static void put_text(const char *text) {
    while (*text != '\0') put_byte((uint8_t)*text++);
}

static void make_text(const char *text) {
    size = 0;
    put_text(text);
}

static float coordinate(uint32_t facet, uint32_t corner, uint32_t axis) {
    return (float)(9u * facet + 3u * corner + axis) * 0.25f - 3.0f;
}

/* The binary file: 80 bytes of header, filled up with fill; the number of facets; the facets. */
static void make_binary(const char *header, char fill, uint32_t announced) {
    uint32_t f, i;
    size = 0;
    put_text(header);
    while (size < 80u) put_byte((uint8_t)fill);
    put_word(announced);
    for (f = 0; f < FACETS; f++) {
        for (i = 0; i < 3u; i++) put_word(0x7FC00000u + i); /* normals are not looked at */
        for (i = 0; i < 9u; i++) put_word(nook_float_bits(coordinate(f, i / 3u, i % 3u)));
        put_byte(0xFFu);
        put_byte(0x0Au);
    }
}

static const char sample_text[] = "solid cube 3\n"
                                  "  facet normal 0 0 1\n"
                                  "    outer loop\n"
                                  "      vertex -3 -2.75 -25e-1\n"
                                  "      vertex -2.25 -2.0 -1.75\n"
                                  "      vertex -1.5000 -1.25 -1\n"
                                  "    endloop\n"
                                  "  endfacet\n"
                                  "  facet normal 1.0 -0 1e-3\n"
                                  "    outer loop\n"
                                  "      vertex -0.75 -.5 -0.25\n"
                                  "      vertex 0 +.25 5.0E-01\n"
                                  "      vertex .75 1. 1.25\n"
                                  "    endloop\n"
                                  "  endfacet\n"
                                  "  facet normal 0 0 0\n"
                                  "    outer loop\n"
                                  "      vertex 1.5 1.75 0.2e1\n"
                                  "      vertex 2.25 2.5 +2.75\n"
                                  "      vertex 3e0 3.25 3.5\n"
                                  "    endloop\n"
                                  "  endfacet\n"
                                  "endsolid cube 3\n";

/* Give the first n bytes of file in chunks; announced: the size told at the beginning. What ended
 * the reading, an error or the end; the triangles are in got[]. */
static nook_status read_file(size_t n, size_t chunk, uint32_t announced) {
    size_t done = 0;
    nook_status status = NOOK_MORE;
    count = 0;
    nook_stl_begin(&stl, announced);
    while (done < n) {
        size_t piece = n - done < chunk ? n - done : chunk, left = piece;
        const uint8_t *at = file + done;
        nook_point corners[3];
        while ((status = nook_stl_push(&stl, &at, &left, corners)) == NOOK_TRIANGLE) {
            if (!CHECK(count < MOST_TRIANGLES)) return NOOK_STATUS_COUNT;
            memcpy(got[count++], corners, sizeof corners);
            CHECK_EQUAL(stl.triangles, count);
            CHECK(at + left == file + done + piece);
        }
        CHECK(left <= piece && at + left == file + done + piece);
        if (status != NOOK_MORE) {
            nook_where where = stl.where;
            left = 0;
            CHECK_EQUAL(nook_stl_push(&stl, &at, &left, corners), status);
            at = file;
            left = n;
            CHECK_EQUAL(nook_stl_push(&stl, &at, &left, corners), status);
            CHECK_EQUAL(nook_stl_end(&stl), status);
            CHECK(where.kind == stl.where.kind && where.index == stl.where.index);
            return status;
        }
        CHECK_EQUAL(left, 0);
        done += piece;
    }
    return nook_stl_end(&stl);
}

static nook_status read_whole(void) { return read_file(size, size, NOOK_UNKNOWN); }

/* Whether the first `expected` of the three facets came, and no other. */
static void expect_facets(uint32_t expected) {
    uint32_t f, i;
    CHECK_EQUAL(count, expected);
    CHECK_EQUAL(stl.triangles, expected);
    for (f = 0; f < count && f < FACETS; f++) {
        for (i = 0; i < 3u; i++) {
            CHECK_EQUAL(nook_float_bits(got[f][i].x), nook_float_bits(coordinate(f, i, 0)));
            CHECK_EQUAL(nook_float_bits(got[f][i].y), nook_float_bits(coordinate(f, i, 1)));
            CHECK_EQUAL(nook_float_bits(got[f][i].z), nook_float_bits(coordinate(f, i, 2)));
        }
    }
}

/* The file, in every size of chunk, with and without its size known. */
static void expect_in_every_chunk(uint32_t expected) {
    size_t chunk;
    for (chunk = 1; chunk <= 200u && !test_has_failed(); chunk++) {
        CHECK_EQUAL(read_file(size, chunk, NOOK_UNKNOWN), NOOK_OK);
        expect_facets(expected);
        CHECK_EQUAL(read_file(size, chunk, (uint32_t)size), NOOK_OK);
        expect_facets(expected);
    }
}

static void expect_line(nook_status expected, uint32_t line) {
    static const size_t chunks[] = {1, 2, 7, 84, 85, MOST_BYTES};
    size_t i;
    for (i = 0; i < sizeof chunks / sizeof *chunks; i++) {
        CHECK_EQUAL(read_file(size, chunks[i], NOOK_UNKNOWN), expected);
        CHECK_EQUAL(stl.where.kind, NOOK_AT_LINE);
        CHECK_EQUAL(stl.where.index, line);
    }
}

/* READING WHAT IS RIGHT */

static void a_binary_file_is_read_in_every_size_of_chunk(void) {
    make_binary("made by hand", '\0', FACETS);
    expect_in_every_chunk(FACETS);
    CHECK(!stl.ascii && !stl.trailing);
}

static void a_text_is_read_in_every_size_of_chunk(void) {
    make_text(sample_text);
    expect_in_every_chunk(FACETS);
    CHECK(stl.ascii);
}

static void a_binary_file_may_begin_with_solid(void) {
    make_binary("solid", ' ', FACETS);
    expect_in_every_chunk(FACETS);
    make_binary("solid named\n", '\0', FACETS);
    expect_in_every_chunk(FACETS);
    make_binary("solid facet normal 0 0 0 outer loop", 'x', FACETS);
    expect_in_every_chunk(FACETS);
    CHECK(!stl.ascii);
}

static void a_binary_file_of_no_triangle_is_whole(void) {
    make_binary("", '\0', 0);
    CHECK_EQUAL(read_file(84, 10, NOOK_UNKNOWN), NOOK_OK);
    CHECK_EQUAL(count, 0);
    CHECK_EQUAL(read_file(84, 84, 84), NOOK_OK);
    CHECK_EQUAL(count, 0);
    CHECK(!stl.trailing);
}

static void a_text_of_no_triangle_is_whole(void) {
    make_text("solid nothing\nendsolid nothing\n");
    expect_in_every_chunk(0);
    make_text("solid\nendsolid\n");
    expect_in_every_chunk(0);
    make_text(
        "solid with a name that is longer than the eighty-four bytes that decide about the format of it\n"
        "endsolid");
    expect_in_every_chunk(0);
}

static void make_upper(void) {
    size_t i;
    for (i = 0; i < size; i++) {
        if (file[i] >= 'a' && file[i] <= 'z') file[i] = (uint8_t)(file[i] - 'a' + 'A');
    }
}

/* The sample with each line end, or each space, written as other bytes. */
static void make_with(char old, const char *now) {
    const char *s;
    size = 0;
    for (s = sample_text; *s != '\0'; s++) {
        if (*s == old) {
            put_text(now);
        } else {
            put_byte((uint8_t)*s);
        }
    }
}

static void letters_may_be_of_either_case(void) {
    size_t i;
    make_text(sample_text);
    make_upper();
    expect_in_every_chunk(FACETS);
    make_text(sample_text);
    for (i = 0; i < size; i += 2) {
        if (file[i] >= 'a' && file[i] <= 'z') file[i] = (uint8_t)(file[i] - 'a' + 'A');
    }
    expect_in_every_chunk(FACETS);
}

static void lines_may_end_in_carriage_return_and_line_feed(void) {
    make_with('\n', "\r\n");
    expect_in_every_chunk(FACETS);
}

static void words_may_be_parted_by_tabs_and_blank_lines(void) {
    make_with(' ', "\t");
    expect_in_every_chunk(FACETS);
    make_with(' ', " \t  ");
    expect_in_every_chunk(FACETS);
    make_with('\n', "\n\n \n");
    expect_in_every_chunk(FACETS);
}

static void a_facet_may_stand_in_one_line(void) {
    make_text("solid flat\nfacet normal 0 0 1 outer loop vertex -3 -2.75 -2.5 vertex -2.25 -2 -1.75 "
              "vertex -1.5 -1.25 -1 endloop endfacet endsolid");
    expect_in_every_chunk(1);
}

#define FACET_0                                                                                              \
    "facet normal 0 0 1\nouter loop\nvertex -3 -2.75 -2.5\nvertex -2.25 -2 -1.75\nvertex -1.5 -1.25 -1\n"    \
    "endloop\nendfacet\n"
#define FACET_1                                                                                              \
    "facet normal 0 0 1\nouter loop\nvertex -.75 -.5 -.25\nvertex 0 .25 .5\nvertex .75 1 1.25\n"             \
    "endloop\nendfacet\n"
#define FACET_2                                                                                              \
    "facet normal 0 0 1\nouter loop\nvertex 1.5 1.75 2\nvertex 2.25 2.5 2.75\nvertex 3 3.25 3.5\n"           \
    "endloop\nendfacet\n"

static void several_solids_are_joined(void) {
    make_text("solid one\n" FACET_0 FACET_1 "endsolid one\nsolid two\n" FACET_2 "endsolid two\n");
    expect_in_every_chunk(3);
    make_text("solid\n" FACET_0 "endsolid\n\nsolid\nendsolid\nsolid\n" FACET_1 FACET_2 "endsolid");
    expect_in_every_chunk(3);
}

static void endsolid_may_be_missing(void) {
    make_text("solid\n" FACET_0 FACET_1 FACET_2);
    expect_in_every_chunk(3);
    make_text("solid one\n" FACET_0 "solid two\n" FACET_1 "endsolid two\nsolid\n" FACET_2);
    expect_in_every_chunk(3);
}

static void names_may_be_missing_or_look_like_words_of_the_format(void) {
    make_text("solid\n" FACET_0 "endsolid\n");
    expect_in_every_chunk(1);
    make_text("solid facet normal outer loop vertex 1 2 3\n" FACET_0 "endsolid solid facet vertex\n");
    expect_in_every_chunk(1);
    make_text("solid endsolid\n" FACET_0 "endsolid endsolid\n");
    expect_in_every_chunk(1);
    make_text("solid a,b;c \"quoted\" 1.5 0x10 #!\n" FACET_0 "endsolid ...\n");
    expect_in_every_chunk(1);
}

static void a_coordinate_may_have_any_number_of_digits(void) {
    uint32_t i;
    make_text("solid long\nfacet normal 0 0 1\nouter loop\nvertex -3");
    for (i = 0; i < 1000u; i++) put_byte(i == 0 ? '.' : '0');
    put_text(" -2.75 -2.5\nvertex -");
    for (i = 0; i < 1000u; i++) put_byte('0');
    put_text("2.25 -2 -1.75\nvertex -1.5 -1.25 -1\nendloop\nendfacet\nendsolid\n");
    expect_in_every_chunk(1);
}

/* ENDING TOO EARLY */

static void a_binary_file_cut_short_gives_its_whole_triangles_and_says_so(void) {
    size_t n, whole;
    make_binary("made by hand", '\0', FACETS);
    for (n = 0; n < size && !test_has_failed(); n++) {
        nook_status expected = n < 84u ? NOOK_UNKNOWN_FORMAT : NOOK_TRUNCATED;
        CHECK_EQUAL(read_file(n, 37, NOOK_UNKNOWN), expected);
        CHECK_EQUAL(count, n < 84u ? 0 : (n - 84u) / 50u);
        CHECK_EQUAL(read_file(n, 200, (uint32_t)n), expected);
        CHECK(count <= (n < 84u ? 0 : (n - 84u) / 50u));
    }
    whole = 84u + 50u * FACETS;
    CHECK_EQUAL(size, whole);
    CHECK_EQUAL(read_file(whole, 37, NOOK_UNKNOWN), NOOK_OK);
}

static bool starts_with(const char *text, size_t n, const char *word) {
    size_t i;
    for (i = 0; word[i] != '\0'; i++) {
        if (i >= n || text[i] != word[i]) return false;
    }
    return true;
}

/* Whether the first n bytes of the sample text are a text of their own, and the facets in it. */
static bool cut_is_whole(size_t n, uint32_t *facets) {
    bool whole = false;
    size_t i = 0;
    *facets = 0;
    while (i < n) {
        const char *word = sample_text + i;
        if (*word == ' ' || *word == '\n') {
            i++;
            continue;
        }
        whole = starts_with(word, n - i, "solid") || starts_with(word, n - i, "endsolid");
        if (whole) {
            while (i < n && sample_text[i] != '\n') i++;
            continue;
        }
        if (starts_with(word, n - i, "endfacet")) {
            ++*facets;
            whole = true;
        }
        while (i < n && sample_text[i] != ' ' && sample_text[i] != '\n') i++;
    }
    return whole;
}

static void a_text_cut_short_is_whole_only_between_facets(void) {
    size_t n, i;
    make_text(sample_text);
    for (n = 0; n <= size && !test_has_failed(); n++) {
        for (i = 0; i < 3u; i++) {
            uint32_t facets;
            bool whole = cut_is_whole(n, &facets);
            nook_status status = read_file(n, i == 0 ? 1 : 100, i == 2 ? (uint32_t)n : NOOK_UNKNOWN);
            if (n < 5u) {
                CHECK_EQUAL(status, NOOK_UNKNOWN_FORMAT);
            } else if (whole) {
                CHECK_EQUAL(status, NOOK_OK);
            } else {
                CHECK(status == NOOK_TRUNCATED || status == NOOK_BAD_SYNTAX || status == NOOK_BAD_NUMBER);
            }
            if (!test_has_failed()) expect_facets(facets);
            if (test_has_failed()) {
                print_text("    cut at byte ");
                print_number((uint32_t)n);
                print_text("\n");
                break;
            }
        }
    }
}

static void a_count_that_is_too_small_leaves_bytes_and_says_so(void) {
    make_binary("made by hand", '\0', 2);
    CHECK_EQUAL(read_file(size, 33, NOOK_UNKNOWN), NOOK_OK);
    expect_facets(2);
    CHECK(stl.trailing);
    CHECK_EQUAL(read_file(size, 500, (uint32_t)size), NOOK_OK);
    expect_facets(2);
    CHECK(stl.trailing);

    make_binary("made by hand", '\0', FACETS);
    put_byte('\n');
    CHECK_EQUAL(read_file(size, 1, NOOK_UNKNOWN), NOOK_OK);
    expect_facets(FACETS);
    CHECK(stl.trailing);

    make_binary("solid made by hand", '\0', 0);
    CHECK_EQUAL(read_file(size, 33, NOOK_UNKNOWN), NOOK_OK);
    expect_facets(0);
    CHECK(stl.trailing);
}

static void a_count_that_is_too_large_is_a_truncated_file(void) {
    static const uint32_t counts[] = {4, 1000, 80000000u, 85899345u, 85899346u, 0x7FFFFFFFu, 0xFFFFFFFFu};
    size_t i;
    for (i = 0; i < sizeof counts / sizeof *counts; i++) {
        make_binary("made by hand", '\0', counts[i]);
        CHECK_EQUAL(read_file(size, 64, NOOK_UNKNOWN), NOOK_TRUNCATED);
        /* more than 2^32 bytes may be refused at once, as no offset could name them */
        if (counts[i] < 85899344u || count != 0) expect_facets(FACETS);
        CHECK(stl.where.kind == NOOK_AT_BYTE && stl.where.index <= size);
        CHECK_EQUAL(read_file(size, 64, (uint32_t)size), NOOK_TRUNCATED);
        CHECK(stl.where.kind == NOOK_AT_BYTE && stl.where.index <= size);
    }
    /* 84 + 50 * 85,899,346 is 2^32 + 88 */
    make_binary("made by hand", '\0', 85899346u);
    CHECK_EQUAL(read_file(88, 88, 88), NOOK_TRUNCATED);
    CHECK_EQUAL(count, 0);
}

/* WHAT IS NEITHER */

static void bytes_of_no_format_are_refused(void) {
    static const char *const texts[] = {
        "", "s", "soli", "sold", "facet normal 0 0 0", "# Wavefront\nv 0 0 0\n"};
    size_t i;
    for (i = 0; i < sizeof texts / sizeof *texts; i++) {
        make_text(texts[i]);
        CHECK_EQUAL(read_whole(), NOOK_UNKNOWN_FORMAT);
        CHECK_EQUAL(read_file(size, 1, (uint32_t)size), NOOK_UNKNOWN_FORMAT);
        CHECK_EQUAL(count, 0);
    }
}

/* WRONG COORDINATES */

static void a_bad_coordinate_in_a_binary_file_is_named_by_its_byte(void) {
    static const struct {
        uint32_t bits;
        nook_status status;
    } bad[] = {
        {0x7FC00000u, NOOK_NOT_FINITE},           {0xFFC00000u, NOOK_NOT_FINITE},
        {0x7F800001u, NOOK_NOT_FINITE},           {0x7F800000u, NOOK_NOT_FINITE},
        {0xFF800000u, NOOK_NOT_FINITE},           {0x7F7FFFFFu, NOOK_COORDINATE_TOO_LARGE},
        {0x4E800001u, NOOK_COORDINATE_TOO_LARGE}, {0xCE800001u, NOOK_COORDINATE_TOO_LARGE},
    };
    uint32_t i, f, k, j;
    for (i = 0; i < sizeof bad / sizeof *bad && !test_has_failed(); i++) {
        for (f = 0; f < FACETS; f++) {
            for (k = 0; k < 9u; k++) {
                uint32_t facet = 84u + 50u * f, at = facet + 12u + 4u * k;
                make_binary("made by hand", '\0', FACETS);
                for (j = 0; j < 4u; j++) file[at + j] = (uint8_t)(bad[i].bits >> 8u * j);
                CHECK_EQUAL(read_file(size, 1u + 17u * k, NOOK_UNKNOWN), bad[i].status);
                expect_facets(f);
                CHECK_EQUAL(stl.where.kind, NOOK_AT_BYTE);
                CHECK_EQUAL(stl.where.index,
                            facet + 12u + 12u * (k / 3u)); /* the first byte of that vertex */
            }
        }
    }
}

static void coordinates_of_2_to_the_30_are_the_last_accepted(void) {
    uint32_t j;
    make_binary("made by hand", '\0', FACETS);
    for (j = 0; j < 4u; j++) file[84u + 12u + j] = (uint8_t)(0x4E800000u >> 8u * j);
    for (j = 0; j < 4u; j++) file[84u + 16u + j] = (uint8_t)(0xCE800000u >> 8u * j);
    CHECK_EQUAL(read_whole(), NOOK_OK);
    CHECK_EQUAL(nook_float_bits(got[0][0].x), 0x4E800000u);
    CHECK_EQUAL(nook_float_bits(got[0][0].y), 0xCE800000u);
}

/* A text whose coordinate number k of facet 1 (lines 9 to 15) is `word`; lines end in `end`. */
static void make_bad_vertex(uint32_t k, const char *word, const char *end) {
    uint32_t i;
    make_text("solid bad\n" FACET_0 "facet normal 0 0 1\nouter loop\n");
    for (i = 0; i < 9u; i++) {
        if (i % 3u == 0) put_text("vertex");
        put_byte(' ');
        put_text(i == k ? word : "1.25");
        if (i % 3u == 2u) put_text(end);
    }
    put_text("endloop\nendfacet\n" FACET_2 "endsolid\n");
}

static void a_bad_coordinate_in_a_text_is_named_by_its_line(void) {
    static const struct {
        const char *word;
        nook_status status;
    } bad[] = {
        {"nan", NOOK_NOT_FINITE},
        {"-inf", NOOK_NOT_FINITE},
        {"NaN", NOOK_NOT_FINITE},
        {"Inf", NOOK_NOT_FINITE},
        {"1,5", NOOK_BAD_NUMBER},
        {"1e", NOOK_BAD_NUMBER},
        {"-", NOOK_BAD_NUMBER},
        {"1.2.3", NOOK_BAD_NUMBER},
        {"vertex", NOOK_BAD_NUMBER},
        {"1e39", NOOK_NOT_FINITE},
        {"-1e400", NOOK_NOT_FINITE},
        {"1073741889", NOOK_COORDINATE_TOO_LARGE},
        {"-2e9", NOOK_COORDINATE_TOO_LARGE},
        {"3.4e38", NOOK_COORDINATE_TOO_LARGE},
    };
    uint32_t i, k;
    for (i = 0; i < sizeof bad / sizeof *bad && !test_has_failed(); i++) {
        for (k = 0; k < 9u && !test_has_failed(); k++) {
            make_bad_vertex(k, bad[i].word, (i & 1u) != 0 ? "\r\n" : "\n");
            expect_line(bad[i].status, 11u + k / 3u);
            expect_facets(1);
        }
    }
    for (i = 0; i < 2u; i++) {
        /* the second lies half way to the next float, and even is 2^30 */
        make_bad_vertex(4, i == 0 ? "1073741824" : "1073741888", "\n");
        CHECK_EQUAL(read_whole(), NOOK_OK);
        CHECK_EQUAL(nook_float_bits(got[1][1].y), 0x4E800000u);
    }
}

/* WRONG WORDS */

static void a_wrong_word_is_named_by_its_line(void) {
    static const struct {
        const char *text;
        uint32_t line;
    } bad[] = {
        {"solid x\nfaset normal 0 0 1\n", 2},
        {"solid x\n\n\n  vertex 0 0 0\n", 4},
        {"solid x\r\n" FACET_0 "\r\nendfacet\r\n", 10},
        {"solid x\nfacet\nnormals 0 0 1\n", 3},
        {"solid x\nfacet normal 0 0 1\nouter\nloops\n", 4},
        {"solid x\nfacet normal 0 0 1\nloop\n", 3},
        {"solid x\nfacet normal 0 0 1\nouter loop\nvertexes 0 0 0\n", 4},
        {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\n", 6},
        {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\n", 7},
        {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
         "endfacets\n",
         8},
        {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
         "endsolid\n",
         8},
        {"solid x\nendsolid x\nfacets\n", 3},
        {"solid x\nendsolidx\n", 2},
        {"solid x\nendsolid x\nsolidx\n", 3},
    };
    size_t i;
    for (i = 0; i < sizeof bad / sizeof *bad; i++) {
        make_text(bad[i].text);
        expect_line(NOOK_BAD_SYNTAX, bad[i].line);
        if (test_has_failed()) {
            print_text("    in the text\n");
            print_text(bad[i].text);
            break;
        }
    }
}

static void a_word_of_hundreds_of_letters_is_no_word(void) {
    uint32_t n, before;
    for (before = 0; before < 2u; before++) {
        for (n = 1; n <= 600u && !test_has_failed(); n++) {
            uint32_t i;
            make_text("solid x\n");
            if (before == 0) put_text("facet");
            for (i = 0; i < n; i++) put_byte(before == 0 ? 't' : 'f');
            if (before == 1) put_text("facet");
            put_text(" normal 0 0 1\n");
            CHECK_EQUAL(read_file(size, 19, NOOK_UNKNOWN), NOOK_BAD_SYNTAX);
            CHECK_EQUAL(stl.where.index, 2);
        }
    }
}

static void a_loop_of_four_vertices_is_refused(void) {
    make_text("solid quad\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
              "vertex 0 1 0\nendloop\nendfacet\nendsolid\n");
    expect_line(NOOK_BAD_SYNTAX, 7);
    CHECK_EQUAL(count, 0);
}

/* WRONG BYTES */

/* Read the file as it is and judge only what must hold for any bytes. */
static void expect_no_harm(dice *d) {
    nook_status status =
        read_file(size, 1u + throw_dice(d, 300), throw_dice(d, 2) == 0 ? NOOK_UNKNOWN : (uint32_t)size);
    uint32_t i;
    CHECK(status == NOOK_OK || status == NOOK_BAD_NUMBER || status == NOOK_BAD_SYNTAX ||
          status == NOOK_NOT_FINITE || status == NOOK_COORDINATE_TOO_LARGE || status == NOOK_TRUNCATED ||
          status == NOOK_UNKNOWN_FORMAT);
    /* a facet of a text takes 75 letters at least, the words alone */
    CHECK(count <= size / 50u);
    CHECK(stl.ascii || count == 0 || 84u + 50u * count <= size);
    for (i = 0; i < 3u * count; i++) CHECK_EQUAL(nook_point_status(got[i / 3u][i % 3u]), NOOK_OK);
    if (stl.where.kind == NOOK_AT_BYTE) CHECK(stl.where.index <= size);
    if (stl.where.kind == NOOK_AT_LINE) CHECK(stl.where.index >= 1u && stl.where.index <= size + 1u);
}

static void changed_bytes_never_give_triangles_that_are_not_there(void) {
    dice d = {1904u};
    uint32_t i, k;
    for (i = 0; i < 3000u && !test_has_failed(); i++) {
        if ((i & 1u) != 0) {
            make_text(sample_text);
        } else {
            make_binary((i & 2u) != 0 ? "solid" : "made by hand", (i & 4u) != 0 ? ' ' : '\0', FACETS);
        }
        for (k = throw_dice(&d, 4) + 1u; k > 0; k--) {
            size_t at = throw_dice(&d, (uint32_t)size);
            file[at] =
                (uint8_t)(throw_dice(&d, 2) == 0 ? file[at] ^ 1u << throw_dice(&d, 8) : throw_dice(&d, 256));
        }
        expect_no_harm(&d);
    }
}

static void random_words_never_give_triangles_that_are_not_there(void) {
    static const char *const words[] = {"solid",  "facet", "normal",  "outer",    "loop",
                                        "vertex", "0 0 0", "endloop", "endfacet", "endsolid",
                                        "\n",     "1e5",   "x",       FACET_0};
    dice d = {5150u};
    uint32_t i, k;
    for (i = 0; i < 1000u && !test_has_failed(); i++) {
        make_text("solid\n");
        for (k = throw_dice(&d, 40); k > 0; k--) {
            put_text(words[throw_dice(&d, 14)]);
            put_byte(throw_dice(&d, 4) == 0 ? '\n' : ' ');
        }
        expect_no_harm(&d);
    }
    for (i = 0; i < 500u && !test_has_failed(); i++) {
        size = 0;
        for (k = throw_dice(&d, 400); k > 0; k--) put_byte(throw_dice(&d, 256));
        expect_no_harm(&d);
    }
}

static void two_readers_do_not_know_of_each_other(void) {
    static nook_stl text, binary;
    static uint8_t first[sizeof sample_text];
    size_t i, j = 0, texts = sizeof sample_text - 1u;
    uint32_t text_count = 0, binary_count = 0;
    memcpy(first, sample_text, sizeof sample_text);
    make_binary("made by hand", '\0', FACETS);
    nook_stl_begin(&text, NOOK_UNKNOWN);
    nook_stl_begin(&binary, NOOK_UNKNOWN);
    for (i = 0; i < texts; i++) {
        const uint8_t *at = first + i;
        size_t left = 1;
        nook_point corners[3];
        while (nook_stl_push(&text, &at, &left, corners) == NOOK_TRIANGLE) text_count++;
        if (j == size) continue;
        at = file + j++;
        left = 1;
        while (nook_stl_push(&binary, &at, &left, corners) == NOOK_TRIANGLE) binary_count++;
    }
    CHECK_EQUAL(nook_stl_end(&text), NOOK_OK);
    CHECK_EQUAL(nook_stl_end(&binary), NOOK_OK);
    CHECK_EQUAL(text_count, FACETS);
    CHECK_EQUAL(binary_count, FACETS);
}

static void the_state_of_a_reader_is_at_most_256_bytes(void) { CHECK(sizeof(nook_stl) <= 256u); }

/* A text in one chunk; the last status, and what was read. */
static nook_status read_text(const char *text, size_t length) {
    const uint8_t *at = (const uint8_t *)text;
    nook_point corners[3];
    nook_status status;
    nook_stl_begin(&stl, NOOK_UNKNOWN);
    while ((status = nook_stl_push(&stl, &at, &length, corners)) == NOOK_TRIANGLE) {
    }
    return status == NOOK_MORE ? nook_stl_end(&stl) : status;
}

#define FACET_TEXT(end)                                                                                      \
    "facet normal 0 0 1" end "outer loop" end "vertex 0 0 0" end "vertex 1 0 0" end "vertex 0 1 0" end       \
    "endloop" end "endfacet" end
#define READ(text) read_text((text), sizeof(text) - 1)

static void a_mark_of_utf8_before_a_text_is_skipped(void) {
    CHECK_EQUAL(READ("\xEF\xBB\xBFsolid x\n" FACET_TEXT("\n") "endsolid x\n"), NOOK_OK);
    CHECK_EQUAL(stl.triangles, 1);
    CHECK_EQUAL(stl.ascii, true);
    CHECK_EQUAL(READ("\xEF\xBB\xBFsolid"), NOOK_OK);
    CHECK_EQUAL(READ("\xEF\xBB\xBF"), NOOK_UNKNOWN_FORMAT);
}

static void lines_are_counted_whatever_ends_them(void) {
    CHECK_EQUAL(READ("solid x\r" FACET_TEXT("\r") "facet normal 0 0 1\router loop\rvertex 0 0 bad\r"),
                NOOK_BAD_NUMBER);
    CHECK_EQUAL(stl.where.kind, NOOK_AT_LINE);
    CHECK_EQUAL(stl.where.index, 11);
    CHECK_EQUAL(
        READ("solid x\r\n" FACET_TEXT("\r\n") "facet normal 0 0 1\r\nouter loop\r\nvertex 0 0 bad\r\n"),
        NOOK_BAD_NUMBER);
    CHECK_EQUAL(stl.where.index, 11);
    CHECK_EQUAL(READ("solid x\n\n" FACET_TEXT("\n") "facet normal 0 0 1\nouter loop\nvertex 0 0 bad\n"),
                NOOK_BAD_NUMBER);
    CHECK_EQUAL(stl.where.index, 12);
}

static void a_text_that_stops_in_a_facet_names_its_last_line(void) {
    CHECK_EQUAL(READ("solid x\n" FACET_TEXT("\n") "facet normal"), NOOK_TRUNCATED);
    CHECK_EQUAL(stl.where.index, 9);
    CHECK_EQUAL(READ("solid x\nfacet normal"), NOOK_TRUNCATED);
    CHECK_EQUAL(stl.where.index, 2);
}

static void only_a_word_that_begins_like_nan_or_inf_is_called_not_finite(void) {
    CHECK_EQUAL(READ("solid x\n" FACET_TEXT("\n") "facet normal 0 0 1\nouter loop\nvertex -inf 0 0\n"),
                NOOK_NOT_FINITE);
    CHECK_EQUAL(READ("solid x\n" FACET_TEXT("\n") "facet normal 0 0 1\nouter loop\nvertex 1in 0 0\n"),
                NOOK_BAD_NUMBER);
    CHECK_EQUAL(READ("solid x\n" FACET_TEXT("\n") "facet normal 0 0 1\nouter loop\nvertex 1 i 0\n"),
                NOOK_NOT_FINITE);
}

static void an_empty_chunk_forgets_no_trailing_bytes(void) {
    const uint8_t *at = NULL;
    size_t left = 0;
    nook_point corners[3];
    make_binary("made by hand", '\0', 2);
    CHECK_EQUAL(read_file(size, 33, NOOK_UNKNOWN), NOOK_OK);
    CHECK_EQUAL(nook_stl_push(&stl, &at, &left, corners), NOOK_MORE);
    CHECK(stl.trailing);
}

static void an_empty_chunk_without_an_address_is_harmless(void) {
    nook_point corners[3];
    const uint8_t *at = NULL;
    size_t left = 0;
    nook_stl_begin(&stl, NOOK_UNKNOWN);
    CHECK_EQUAL(nook_stl_push(&stl, &at, &left, corners), NOOK_MORE);
    CHECK_EQUAL(nook_stl_end(&stl), NOOK_UNKNOWN_FORMAT);
}

static const test tests[] = {
    TEST(a_binary_file_is_read_in_every_size_of_chunk),
    TEST(a_text_is_read_in_every_size_of_chunk),
    TEST(a_binary_file_may_begin_with_solid),
    TEST(a_binary_file_of_no_triangle_is_whole),
    TEST(a_text_of_no_triangle_is_whole),
    TEST(letters_may_be_of_either_case),
    TEST(lines_may_end_in_carriage_return_and_line_feed),
    TEST(words_may_be_parted_by_tabs_and_blank_lines),
    TEST(a_facet_may_stand_in_one_line),
    TEST(several_solids_are_joined),
    TEST(endsolid_may_be_missing),
    TEST(names_may_be_missing_or_look_like_words_of_the_format),
    TEST(a_coordinate_may_have_any_number_of_digits),
    TEST(a_binary_file_cut_short_gives_its_whole_triangles_and_says_so),
    TEST(a_text_cut_short_is_whole_only_between_facets),
    TEST(a_count_that_is_too_small_leaves_bytes_and_says_so),
    TEST(a_count_that_is_too_large_is_a_truncated_file),
    TEST(bytes_of_no_format_are_refused),
    TEST(a_bad_coordinate_in_a_binary_file_is_named_by_its_byte),
    TEST(coordinates_of_2_to_the_30_are_the_last_accepted),
    TEST(a_bad_coordinate_in_a_text_is_named_by_its_line),
    TEST(a_wrong_word_is_named_by_its_line),
    TEST(a_word_of_hundreds_of_letters_is_no_word),
    TEST(a_loop_of_four_vertices_is_refused),
    TEST(changed_bytes_never_give_triangles_that_are_not_there),
    TEST(random_words_never_give_triangles_that_are_not_there),
    TEST(two_readers_do_not_know_of_each_other),
    TEST(the_state_of_a_reader_is_at_most_256_bytes),
    TEST(a_mark_of_utf8_before_a_text_is_skipped),
    TEST(lines_are_counted_whatever_ends_them),
    TEST(a_text_that_stops_in_a_facet_names_its_last_line),
    TEST(only_a_word_that_begins_like_nan_or_inf_is_called_not_finite),
    TEST(an_empty_chunk_forgets_no_trailing_bytes),
    TEST(an_empty_chunk_without_an_address_is_harmless),
};

void test_stl(void) { run_tests(tests, sizeof tests / sizeof *tests); }
