/* check.h -- tests without a library: no stdio, no heap, the same on a PC and on a board.
 *
 * A test is a function whose name is the sentence that must be true. A test file lists its tests in
 * a table at its end and hands it to run_tests(). Checks that fail print where, and count their test
 * as failed; the others go on. The last line of a run is "N passed, N failed, N skipped". */
#ifndef CHECK_H
#define CHECK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Bytes of RAM that tests may fill; boards set less, and then arrays and meshes are smaller, by constants
 * at the head of a file. A test that means nothing when smaller calls skip_test(). */
#ifndef NOOK_TEST_RAM
#define NOOK_TEST_RAM 4194304
#endif

#define CHECK(condition) check_true((condition), #condition, __FILE__, __LINE__)
#define CHECK_EQUAL(got, expected)                                                                           \
    check_equal((uint32_t)(got), (uint32_t)(expected), #got, __FILE__, __LINE__)

typedef struct test {
    void (*run)(void);
    const char *name;
} test;
#define TEST(name)                                                                                           \
    { name, #name }

bool check_true(bool condition, const char *text, const char *file, int line);
bool check_equal(uint32_t got, uint32_t expected, const char *text, const char *file, int line);
void skip_test(const char *why);

void print_text(const char *text);
void print_number(uint32_t number);
void print_hex(uint32_t number);

/* Whether the running test has failed a check: to stop a loop at its first bad case. */
bool test_has_failed(void);

void run_tests(const test *tests, size_t count);

/* The closing line; the exit status of the run. */
int finish_tests(void);

/* A repeatable sequence of random numbers (xorshift). */
typedef struct dice {
    uint32_t state;
} dice;
uint32_t throw_dice(dice *d, uint32_t sides);

#endif
