/* check.c -- counting and printing for check.h. */
#include "check.h"

#include <string.h>

#include "nook_port.h"

static uint32_t passed, failed, skipped;
static const char *running;
static bool bad, left_out;

void print_text(const char *text) { nook_port_write(text, strlen(text)); }

void print_number(uint32_t number) {
    char digits[10];
    uint32_t i = sizeof digits;
    do {
        digits[--i] = (char)('0' + number % 10u);
        number /= 10u;
    } while (number != 0);
    nook_port_write(digits + i, sizeof digits - i);
}

void print_hex(uint32_t number) {
    char digits[8];
    uint32_t i = sizeof digits;
    while (i-- > 0) {
        digits[i] = "0123456789abcdef"[number & 15u];
        number >>= 4;
    }
    nook_port_write(digits, sizeof digits);
}

static void print_place(const char *text, const char *file, int line) {
    bad = true;
    print_text(file);
    print_text(":");
    print_number((uint32_t)line);
    print_text(": ");
    print_text(running);
    print_text(": ");
    print_text(text);
}

bool check_true(bool condition, const char *text, const char *file, int line) {
    if (condition) return true;
    print_place(text, file, line);
    print_text("\n");
    return false;
}

bool check_equal(uint32_t got, uint32_t expected, const char *text, const char *file, int line) {
    if (got == expected) return true;
    print_place(text, file, line);
    print_text(" is ");
    print_number(got);
    print_text(", expected ");
    print_number(expected);
    print_text("\n");
    return false;
}

void skip_test(const char *why) {
    left_out = true;
    print_text("SKIPPED ");
    print_text(running);
    print_text(": ");
    print_text(why);
    print_text("\n");
}

bool test_has_failed(void) { return bad; }

uint32_t throw_dice(dice *d, uint32_t sides) {
    d->state ^= d->state << 13;
    d->state ^= d->state >> 17;
    d->state ^= d->state << 5;
    return d->state % sides;
}

void run_tests(const test *tests, size_t count) {
    size_t i;
    for (i = 0; i < count; i++) {
        running = tests[i].name;
        bad = left_out = false;
        tests[i].run();
        failed += bad;
        skipped += !bad && left_out;
        passed += !bad && !left_out;
    }
}

int finish_tests(void) {
    print_number(passed);
    print_text(" passed, ");
    print_number(failed);
    print_text(" failed, ");
    print_number(skipped);
    print_text(" skipped\n");
    return failed != 0 || passed == 0;
}
