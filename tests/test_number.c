/* test_number.c -- decimal text to float.
 *
 * Three judges that know nothing of the parser: cases worked out by hand, a grammar written as a
 * matcher of ten lines and tried on every short string, and exact decimal expansions. A float and the
 * midpoint to the next one are m * 2^e, whose decimal digits a small big-integer printer writes out in
 * full: the text must come back as that float, or at the midpoint as its even neighbour. */
#include "check.h"
#include "rooms.h"

#include <string.h>

#include "nook.h"

#define LONGEST 5300u
static char text[LONGEST + 1u];
static size_t length;

static void start_text(void) { length = 0; }

static void add_byte(char byte) {
    if (length < LONGEST) text[length++] = byte;
}

static void add_text(const char *more) {
    while (*more != '\0') add_byte(*more++);
}

static void add_many(char byte, uint32_t count) {
    while (count-- > 0) add_byte(byte);
}

static void add_integer(int32_t number) {
    char digits[10];
    uint32_t i = 0, rest = number < 0 ? 0u - (uint32_t)number : (uint32_t)number;
    if (number < 0) add_byte('-');
    do {
        digits[i++] = (char)('0' + rest % 10u);
        rest /= 10u;
    } while (rest != 0);
    while (i > 0) add_byte(digits[--i]);
}

/* Parse text[length], as a whole and byte by byte; both must agree. */
static nook_status parse(uint32_t *bits) {
    nook_number number;
    float whole = 7.0f, pieces = 7.0f;
    size_t i;
    nook_status status = nook_parse_float(text, length, &whole), pushed = NOOK_OK;
    nook_number_begin(&number);
    for (i = 0; i < length && pushed == NOOK_OK; i++) pushed = nook_number_push(&number, text[i]);
    if (pushed == NOOK_OK) pushed = nook_number_value(&number, &pieces);
    CHECK_EQUAL(pushed, status);
    *bits = nook_float_bits(whole);
    if (status == NOOK_OK) CHECK_EQUAL(nook_float_bits(pieces), *bits);
    return status;
}

/* Whether text[length] is read as the float of these bits; infinity means that it is refused. */
static void expect_bits(uint32_t bits) {
    uint32_t got;
    nook_status status = parse(&got);
    bool good;
    if ((bits & 0x7FFFFFFFu) == 0x7F800000u) {
        good = CHECK_EQUAL(status, NOOK_NOT_FINITE);
    } else {
        good = CHECK_EQUAL(status, NOOK_OK) && CHECK_EQUAL(got, bits);
    }
    if (!good && length < 300u) {
        text[length] = '\0';
        print_text("    the text was ");
        print_text(text);
        print_text("\n");
    }
}

typedef struct number_case {
    const char *text;
    uint32_t bits;
} number_case;

#define HALF_LEAST_DENORMAL                                                                                  \
    "7.00649232162408535461864791644958065640130970938257885878534141944895541342930300743319094181060791"   \
    "015625"
#define NO_FLOAT 0x7F800000u

static const number_case good_numbers[] = {
    {"0", 0},
    {"-0", 0x80000000u},
    {"+0", 0},
    {"-0.0e5", 0x80000000u},
    {"0e999999999999", 0},
    {"-0e999999999999", 0x80000000u},
    {"0e-999999999999", 0},
    {"1", 0x3F800000u},
    {"+1", 0x3F800000u},
    {"-1", 0xBF800000u},
    {"5.", 0x40A00000u},
    {".5", 0x3F000000u},
    {"+.5", 0x3F000000u},
    {"-.5e1", 0xC0A00000u},
    {"5.e1", 0x42480000u},
    {"00012.5000", 0x41480000u},
    {"1e+5", 0x47C35000u},
    {"1E-5", 0x3727C5ACu},
    {"1e5", 0x47C35000u},
    {"1e0000000000000000000005", 0x47C35000u},
    {"1e-0", 0x3F800000u},
    {"0.1", 0x3DCCCCCDu},
    {"0.3", 0x3E99999Au},
    {"123.456", 0x42F6E979u},
    {"1e10", 0x501502F9u},
    {"1e22", 0x64078678u},
    {"8388608", 0x4B000000u},
    {"8388608.5", 0x4B000000u},
    {"8388609.5", 0x4B000002u},
    {"16777215", 0x4B7FFFFFu},
    {"16777216", 0x4B800000u},
    {"16777217", 0x4B800000u},
    {"16777217.0", 0x4B800000u},
    {"16777217.00000000000000000000001", 0x4B800001u},
    {"16777218", 0x4B800001u},
    {"16777219", 0x4B800002u},
    {"16777218.99999999999999999999999", 0x4B800001u},
    {"33554433", 0x4C000000u},
    {"33554434", 0x4C000000u},
    {"33554438", 0x4C000002u},
    {"4294967295", 0x4F800000u},
    {"18446744073709551615", 0x5F800000u},
    {"18446744073709551616", 0x5F800000u},
    {"1073741824", 0x4E800000u},
    /* the largest float, and half a step above it: 2^128 - 2^103, where even is infinity */
    {"3.4028234663852886e38", 0x7F7FFFFFu},
    {"340282346638528859811704183484516925440", 0x7F7FFFFFu},
    {"3.4028235677973365e38", 0x7F7FFFFFu},
    {"3.4028235677973366e38", 0x7F7FFFFFu},
    {"340282356779733661637539395458142568447", 0x7F7FFFFFu},
    {"340282356779733661637539395458142568447.999999", 0x7F7FFFFFu},
    {"340282356779733661637539395458142568448", NO_FLOAT},
    {"-340282356779733661637539395458142568448", NO_FLOAT},
    {"3.4028235677973367e38", NO_FLOAT},
    {"3.5e38", NO_FLOAT},
    {"1e39", NO_FLOAT},
    {"-1e39", NO_FLOAT},
    {"1e400", NO_FLOAT},
    {"1e999999999999", NO_FLOAT},
    {"-1e+999999999999", NO_FLOAT},
    {"1e2147483648", NO_FLOAT},
    {"1e4294967295", NO_FLOAT},
    {"1e4294967296", NO_FLOAT},
    {"1e4294967297", NO_FLOAT},
    {"0.000001e4294967303", NO_FLOAT},
    {"1e18446744073709551616", NO_FLOAT},
    /* the least normal and the denormals */
    {"1.17549435082228750796873653722224567781866555677208752150875170627841725945472717285156e-38",
     0x00800000u},
    {"1.17549435e-38", 0x00800000u},
    {"1.1754942e-38", 0x007FFFFFu},
    {"1.17549428e-38", 0x007FFFFFu},
    {"5.877472e-39", 0x00400000u},
    {"1e-40", 0x000116C2u},
    {"1e-44", 0x00000007u},
    {"1e-45", 0x00000001u},
    {"-1e-45", 0x80000001u},
    {"1.4e-45", 0x00000001u},
    {"2.1e-45", 0x00000001u}, /* one and a half of them is 2.1019e-45 */
    {"2.2e-45", 0x00000002u},
    {HALF_LEAST_DENORMAL "e-46", 0},
    {"-" HALF_LEAST_DENORMAL "e-46", 0x80000000u},
    {HALF_LEAST_DENORMAL "000e-46", 0},
    {HALF_LEAST_DENORMAL "1e-46", 0x00000001u},
    {HALF_LEAST_DENORMAL "0000000000000000000000001e-46", 0x00000001u},
    {"7e-46", 0},
    {"7.1e-46", 0x00000001u},
    {"1e-46", 0},
    {"-1e-46", 0x80000000u},
    {"1e-400", 0},
    {"1e-999999999999", 0},
    {"-1e-999999999999", 0x80000000u},
    {"1e-2147483648", 0},
    {"1e-2147483649", 0},
    {"1e-4294967296", 0},
    {"123456e-4294967295", 0},
    {"1e-18446744073709551616", 0},
};

static void numbers_worked_out_by_hand_are_read_to_the_bit(void) {
    size_t i;
    for (i = 0; i < sizeof good_numbers / sizeof *good_numbers; i++) {
        start_text();
        add_text(good_numbers[i].text);
        expect_bits(good_numbers[i].bits);
    }
}

static const char *const bad_numbers[] = {
    "",     "-",   "+",     ".",      "-.",  "+.",  "e",    "e5",    ".e5",   "-e5",      "1e",    "1e+",
    "1e-",  "1.e", "1.2.3", "1..2",   "..5", "--1", "+-1",  "-+1",   "1e5.0", "1e5e5",    "1e--5", "1e+-5",
    "1e5+", "1-",  "1+1",   "3.1+e2", "nan", "NaN", "-nan", "inf",   "Inf",   "infinity", "0x10",  "1x",
    "1,5",  "1 ",  " 1",    "1\t",    "\n1", "1f",  "1d5",  "1_000", "\x80",  "1\xFF",    "1e5 ",  "e",
};

static void text_that_is_no_number_is_refused(void) {
    size_t i;
    uint32_t bits;
    for (i = 0; i < sizeof bad_numbers / sizeof *bad_numbers; i++) {
        start_text();
        add_text(bad_numbers[i]);
        if (!CHECK_EQUAL(parse(&bits), NOOK_BAD_NUMBER)) {
            print_text("    the text was ");
            print_text(bad_numbers[i]);
            print_text("\n");
        }
    }
    start_text();
    add_byte('1');
    add_byte('\0');
    CHECK_EQUAL(parse(&bits), NOOK_BAD_NUMBER);
}

static bool is_digit(char byte) { return byte >= '0' && byte <= '9'; }

/* The grammar of a number: whether s[n] is one, and whether one begins with s[n]. */
static void match_number(const char *s, size_t n, bool *whole, bool *begins) {
    size_t i = 0, before = 0, after = 0, power = 0;
    *whole = *begins = false;
    if (i < n && (s[i] == '+' || s[i] == '-')) i++;
    for (; i < n && is_digit(s[i]); i++) before++;
    if (i < n && s[i] == '.') {
        for (i++; i < n && is_digit(s[i]); i++) after++;
    }
    if (i == n) {
        *begins = true;
        *whole = before + after > 0;
        return;
    }
    if (before + after == 0 || (s[i] != 'e' && s[i] != 'E')) return;
    i++;
    if (i < n && (s[i] == '+' || s[i] == '-')) i++;
    for (; i < n && is_digit(s[i]); i++) power++;
    *begins = i == n;
    *whole = i == n && power > 0;
}

static void every_short_string_is_judged_as_the_grammar_says(void) {
    static const char letters[] = "+-.07eEx";
    uint32_t size, code, rest;
    for (size = 0; size <= 5u; size++) {
        for (code = 0; code < 1u << 3u * size && !test_has_failed(); code++) {
            nook_number number;
            nook_status pushed = NOOK_OK;
            float value;
            bool whole, begins;
            char s[6];
            size_t i;
            for (i = 0, rest = code; i < size; i++, rest >>= 3) s[i] = letters[rest & 7u];
            match_number(s, size, &whole, &begins);
            CHECK((nook_parse_float(s, size, &value) != NOOK_BAD_NUMBER) == whole);
            nook_number_begin(&number);
            for (i = 0; i < size && pushed == NOOK_OK; i++) pushed = nook_number_push(&number, s[i]);
            CHECK_EQUAL(pushed, begins ? NOOK_OK : NOOK_BAD_NUMBER);
        }
    }
}

static void a_number_can_be_valued_after_every_byte(void) {
    static const char letters[] = "-0120.0345e-0012";
    nook_number number;
    size_t i;
    nook_number_begin(&number);
    for (i = 0; i + 1u < sizeof letters; i++) {
        float so_far = 7.0f, whole = 7.0f;
        CHECK_EQUAL(nook_number_push(&number, letters[i]), NOOK_OK);
        CHECK_EQUAL(nook_number_value(&number, &so_far), nook_parse_float(letters, i + 1u, &whole));
        CHECK_EQUAL(nook_float_bits(so_far), nook_float_bits(whole));
    }
}

static void thousands_of_zeros_change_nothing(void) {
    start_text();
    add_many('0', 5000);
    add_text("1.5");
    expect_bits(0x3FC00000u);

    start_text();
    add_many('0', 5000);
    expect_bits(0);

    start_text();
    add_text("1.5");
    add_many('0', 5000);
    expect_bits(0x3FC00000u);

    start_text();
    add_text("-0.");
    add_many('0', 5000);
    expect_bits(0x80000000u);

    start_text();
    add_text("0.");
    add_many('0', 200);
    add_text("1e201");
    expect_bits(0x3F800000u);

    start_text();
    add_text("0.");
    add_many('0', 5000);
    add_text("25e5001");
    expect_bits(0x40200000u);

    start_text();
    add_text("25");
    add_many('0', 5000);
    add_text("e-5001");
    expect_bits(0x40200000u);

    start_text();
    add_text("-25");
    add_many('0', 5000);
    add_text(".e-5001");
    expect_bits(0xC0200000u);

    start_text();
    add_text("1e-");
    add_many('0', 5000);
    add_text("1");
    expect_bits(0x3DCCCCCDu);
}

/* As if the digits before had been pushed: 2^30 of them take too long on a board. */
static void a_thousand_million_digits_do_not_wrap_the_power_of_ten(void) {
    nook_number number;
    float value = 7.0f;
    uint32_t i;
    nook_number_begin(&number);
    for (i = 0; i < 116; i++) CHECK_EQUAL(nook_number_push(&number, '1'), NOOK_OK);
    CHECK_EQUAL(number.scale, 1);
    number.scale = 0x3FFFFFFE;
    for (i = 0; i < 3; i++) CHECK_EQUAL(nook_number_push(&number, '0'), NOOK_OK);
    CHECK_EQUAL(number.scale, 0x3FFFFFFF);
    CHECK_EQUAL(nook_number_value(&number, &value), NOOK_NOT_FINITE);

    nook_number_begin(&number);
    CHECK_EQUAL(nook_number_push(&number, '.'), NOOK_OK);
    number.scale = -0x3FFFFFFE;
    for (i = 0; i < 3; i++) CHECK_EQUAL(nook_number_push(&number, '0'), NOOK_OK);
    CHECK_EQUAL(nook_number_push(&number, '1'), NOOK_OK);
    CHECK_EQUAL(number.scale, -0x3FFFFFFF);
    CHECK_EQUAL(nook_number_value(&number, &value), NOOK_OK);
    CHECK_EQUAL(nook_float_bits(value), 0);
}

static void thousands_of_digits_are_read_to_the_last(void) {
    start_text();
    add_text("0.");
    add_many('3', 5000);
    expect_bits(0x3EAAAAABu);

    start_text();
    add_many('6', 5000);
    add_text("e-5000");
    expect_bits(0x3F2AAAABu);

    start_text();
    add_many('9', 5000);
    add_text("E-5000");
    expect_bits(0x3F800000u);

    start_text();
    add_many('9', 5000);
    expect_bits(NO_FLOAT);

    start_text();
    add_many('9', 5000);
    add_text("e-5100");
    expect_bits(0);

    start_text();
    add_text("16777217.");
    add_many('0', 5000);
    expect_bits(0x4B800000u);
    add_byte('1');
    expect_bits(0x4B800001u);

    start_text();
    add_text("16777218.");
    add_many('9', 5000);
    expect_bits(0x4B800001u);
    start_text();
    add_text("16777219");
    add_many('0', 5000);
    add_text("e-5000");
    expect_bits(0x4B800002u);

    start_text();
    add_text("340282356779733661637539395458142568447.");
    add_many('9', 5000);
    expect_bits(0x7F7FFFFFu);

    start_text();
    add_text(HALF_LEAST_DENORMAL);
    add_many('0', 5000);
    add_text("1e-46");
    expect_bits(1);
    start_text();
    add_text("0.");
    add_many('0', 5000);
    add_byte('1');
    add_text("e-999999999999");
    expect_bits(0);
}

/* DECIMALS WITHOUT ROUNDING. value = 0.d[0]d[1]...d[n-1] * 10^point, d[0] not 0. */
#define MOST_DIGITS 130u
typedef struct decimal {
    char d[MOST_DIGITS];
    uint32_t n;
    int32_t point;
} decimal;

#define LIMBS 15u
#define BASE 1000000000u

static void multiply(uint32_t limb[LIMBS], uint32_t factor) {
    uint64_t carry = 0;
    uint32_t i;
    for (i = 0; i < LIMBS; i++) {
        carry += (uint64_t)limb[i] * factor;
        limb[i] = (uint32_t)(carry % BASE);
        carry /= BASE;
    }
}

/* The decimal of m * 2^e, exactly, less `less` units of its last place (before trailing zeros go). */
static void expand(decimal *out, uint32_t m, int32_t e, uint32_t less) {
    uint32_t limb[LIMBS] = {0}, i, k, start;
    char all[LIMBS * 9u];
    int32_t scale = e < 0 ? e : 0;
    limb[0] = m % BASE;
    limb[1] = m / BASE;
    for (; e > 0; e--) multiply(limb, 2);
    for (; e < 0; e++) multiply(limb, 5);
    for (i = 0; less != 0 && i < LIMBS; i++) {
        less = limb[i] < 1u;
        limb[i] = less != 0 ? BASE - 1u : limb[i] - 1u;
    }
    for (i = 0; i < LIMBS; i++) {
        uint32_t rest = limb[LIMBS - 1u - i];
        for (k = 9; k > 0; k--, rest /= 10u) all[9u * i + k - 1u] = (char)('0' + rest % 10u);
    }
    for (start = 0; start < sizeof all && all[start] == '0'; start++) continue;
    out->n = 0;
    for (i = start; i < sizeof all && out->n < MOST_DIGITS; i++) out->d[out->n++] = all[i];
    out->point = (int32_t)out->n + scale;
    while (out->n > 0 && out->d[out->n - 1u] == '0') out->n--;
}

/* |float of bits| as m * 2^e; half: the midpoint to the next one. */
static void expand_float(decimal *out, uint32_t bits, bool half, uint32_t less) {
    uint32_t exponent = bits >> 23 & 0xFFu, m = bits & 0x7FFFFFu;
    int32_t e = exponent == 0 ? -149 : (int32_t)exponent - 150;
    if (exponent != 0) m |= 0x800000u;
    if (half) {
        expand(out, 2u * m + 1u, e - 1, less);
    } else {
        expand(out, m, e, less);
    }
}

/* Order of two decimals: below, equal or above as negative, 0, positive. */
static int compare(const decimal *a, const decimal *b) {
    uint32_t i;
    if (a->n == 0 || b->n == 0) return (a->n != 0) - (b->n != 0);
    if (a->point != b->point) return a->point < b->point ? -1 : 1;
    for (i = 0; i < a->n || i < b->n; i++) {
        char x = i < a->n ? a->d[i] : '0', y = i < b->n ? b->d[i] : '0';
        if (x != y) return x < y ? -1 : 1;
    }
    return 0;
}

/* Write a decimal with `shift` digits before its point (negative: zeros after it) and the exponent
 * that makes up for it; without an exponent if that is zero. more: further digits at the end. */
static void write_decimal(const decimal *value, int32_t shift, uint32_t zeros, const char *more) {
    int32_t i, n = (int32_t)value->n;
    add_many('0', zeros);
    for (i = shift < 0 ? shift : 0; i < n || i < shift; i++) {
        if (i == shift) add_byte('.');
        add_byte(i >= 0 && i < n ? value->d[i] : '0');
    }
    if (*more != '\0' && i <= shift) add_byte('.');
    add_text(more);
    if (value->point != shift) {
        add_byte('e');
        add_integer(value->point - shift);
    }
}

/* The same value in several spellings, each with its own sign. */
static void expect_decimal(const decimal *value, const char *more, uint32_t bits, dice *d) {
    int32_t plain = value->point;
    start_text();
    write_decimal(value, plain, 1, more);
    expect_bits(bits);
    start_text();
    add_byte('-');
    write_decimal(value, 1, 0, more);
    expect_bits(bits | 0x80000000u);
    start_text();
    add_byte('+');
    write_decimal(value, (int32_t)throw_dice(d, 250) - 125, throw_dice(d, 40), more);
    expect_bits(bits);
}

static uint32_t finite_bits(dice *d) {
    uint32_t bits = throw_dice(d, 0xFFFFFFFFu) >> 1;
    switch (throw_dice(d, 8)) {
    case 0: bits &= 0x007FFFFFu; break;              /* denormal */
    case 1: bits &= 0x000000FFu; break;              /* one of the least */
    case 2: bits |= 0x007FFFFFu; break;              /* the next is a power of two */
    case 3: bits &= 0x7F800000u; break;              /* a power of two */
    case 4: bits = 0x3F000000u + (bits >> 4); break; /* near 1 */
    default: break;
    }
    return bits >= 0x7F800000u ? bits & 0x7F7FFFFFu : bits;
}

static void an_exact_expansion_comes_back_as_its_float(void) {
    dice d = {20240517u};
    uint32_t i;
    for (i = 0; i < 1000u && !test_has_failed(); i++) {
        decimal value;
        uint32_t bits = finite_bits(&d);
        if (bits == 0) continue;
        expand_float(&value, bits, false, 0);
        expect_decimal(&value, "", bits, &d);
    }
}

static void an_exact_midpoint_goes_to_the_even_neighbour(void) {
    dice d = {77777u};
    uint32_t i;
    for (i = 0; i < 1000u && !test_has_failed(); i++) {
        decimal value;
        uint32_t bits = finite_bits(&d);
        expand_float(&value, bits, true, 0);
        expect_decimal(&value, "", bits + (bits & 1u), &d);
    }
}

static void a_midpoint_with_one_more_digit_goes_up(void) {
    dice d = {4242u};
    uint32_t i;
    for (i = 0; i < 700u && !test_has_failed(); i++) {
        decimal value;
        uint32_t bits = finite_bits(&d);
        expand_float(&value, bits, true, 0);
        expect_decimal(&value, (i & 1u) != 0 ? "1" : "00000000000000000001", bits + 1u, &d);
    }
}

static void just_below_a_midpoint_goes_down(void) {
    dice d = {990u};
    uint32_t i;
    for (i = 0; i < 700u && !test_has_failed(); i++) {
        decimal value;
        uint32_t bits = finite_bits(&d);
        if (bits == 0) bits = 1;
        expand_float(&value, bits, true, 1);
        expect_decimal(&value, "", bits, &d);
    }
}

static void nine_digits_are_enough_to_name_a_float(void) {
    dice d = {8080u};
    uint32_t i, k;
    for (i = 0; i < 1500u && !test_has_failed(); i++) {
        decimal value;
        uint32_t bits = finite_bits(&d);
        if (bits == 0) continue;
        expand_float(&value, bits, false, 0);
        if (value.n > 9u) {
            bool up = value.d[9] >= '5';
            for (k = 9; up && k > 0; k--) {
                up = value.d[k - 1u] == '9';
                value.d[k - 1u] = up ? '0' : (char)(value.d[k - 1u] + 1);
            }
            value.n = 9;
            if (up) {
                value.d[0] = '1';
                value.n = 1;
                value.point++;
            }
        }
        start_text();
        write_decimal(&value, 1, 0, "");
        expect_bits(bits);
    }
}

/* Decimals as people write them: the float must be one that no other float is nearer to. */
static void short_decimals_lie_between_the_midpoints_about_their_float(void) {
    dice d = {31337u};
    uint32_t i, bits;
    for (i = 0; i < 3000u && !test_has_failed(); i++) {
        static const uint32_t ranges[4] = {100u, 100000u, 100000000u, 4000000000u};
        decimal written, below, above;
        uint32_t m = 1u + throw_dice(&d, ranges[i & 3u]);
        int32_t ten = (i & 4u) != 0 ? -(int32_t)throw_dice(&d, 10) : (int32_t)throw_dice(&d, 78) - 50;
        int low, high;
        expand(&written, m, 0, 0);
        written.point += ten;
        start_text();
        write_decimal(&written, (int32_t)written.n, 0, "");
        if (parse(&bits) != NOOK_OK) {
            expand(&above, 0x1FFFFFFu, 103, 0);
            CHECK(compare(&written, &above) >= 0);
            continue;
        }
        CHECK(bits < 0x7F800000u);
        if (test_has_failed()) break;
        expand_float(&above, bits, true, 0);
        high = compare(&written, &above);
        CHECK(high < 0 || (high == 0 && (bits & 1u) == 0));
        if (bits == 0) continue;
        expand_float(&below, bits - 1u, true, 0);
        low = compare(&written, &below);
        CHECK(low > 0 || (low == 0 && (bits & 1u) == 0));
    }
}

static void a_number_being_read_stays_small(void) { CHECK(sizeof(nook_number) <= 60u); }

static const test tests[] = {
    TEST(numbers_worked_out_by_hand_are_read_to_the_bit),
    TEST(text_that_is_no_number_is_refused),
    TEST(every_short_string_is_judged_as_the_grammar_says),
    TEST(a_number_can_be_valued_after_every_byte),
    TEST(thousands_of_zeros_change_nothing),
    TEST(thousands_of_digits_are_read_to_the_last),
    TEST(a_thousand_million_digits_do_not_wrap_the_power_of_ten),
    TEST(an_exact_expansion_comes_back_as_its_float),
    TEST(an_exact_midpoint_goes_to_the_even_neighbour),
    TEST(a_midpoint_with_one_more_digit_goes_up),
    TEST(just_below_a_midpoint_goes_down),
    TEST(nine_digits_are_enough_to_name_a_float),
    TEST(short_decimals_lie_between_the_midpoints_about_their_float),
    TEST(a_number_being_read_stays_small),
};

void test_number(void) { run_tests(tests, sizeof tests / sizeof *tests); }
