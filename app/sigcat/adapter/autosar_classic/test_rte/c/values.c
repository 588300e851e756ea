/* Values as texts: of a trace, and of a recording. A text of a list or a mapping has the order of its declaration. */
#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "test_rte.h"

#define LONGEST 256U

static const uint32 sizes[] = {1U, 1U, 1U, 2U, 2U, 4U, 4U, 8U, 8U, 4U, 8U};

/* -- reading ----------------------------------------------------------------------------------------------------- */

static char wanted[128]; /* what a number must be */

/* Whether they are equal but for the case of letters. */
static boolean is_alike(const char *one, const char *other)
{
    while (*one != '\0' && tolower((unsigned char)*one) == tolower((unsigned char)*other)) {
        one++;
        other++;
    }
    return (*one == '\0' && *other == '\0') ? TRUE : FALSE;
}

static boolean symbol(const char *word, const TestRte_Symbol *symbols, uint64 *number)
{
    for (; symbols != NULL && symbols->name != NULL; symbols++) {
        if (strcmp(word, symbols->name) == 0) {
            *number = (uint64)symbols->number;
            return TRUE;
        }
    }
    return FALSE;
}

static boolean is_signed(TestRte_Kind kind)
{
    return (kind == TEST_RTE_SINT8 || kind == TEST_RTE_SINT16 || kind == TEST_RTE_SINT32 || kind == TEST_RTE_SINT64) ? TRUE : FALSE;
}

static uint64 greatest(TestRte_Kind kind)
{
    const uint32 unused = 64U - (8U * sizes[kind]) + ((is_signed(kind) != FALSE) ? 1U : 0U);
    return (kind == TEST_RTE_BOOLEAN) ? 1U : (UINT64_MAX >> unused);
}

static sint64 least(TestRte_Kind kind)
{
    return (is_signed(kind) != FALSE) ? (-(sint64)greatest(kind) - 1) : 0;
}

static boolean is_decimal(const char *word)
{
    char *end = NULL;
    (void)strtod(word, &end);
    return (end != word && *end == '\0' && word[strspn(word, "0123456789+-.eE")] == '\0') ? TRUE : FALSE;
}

/* A whole number within the range of its kind, also as tables write it that know no other: 3.0. */
static boolean whole(const char *word, TestRte_Kind kind, uint64 *number)
{
    const char *const digits = word + ((*word == '-' || *word == '+') ? 1 : 0);
    const boolean is_plain = (*digits != '\0' && digits[strspn(digits, "0123456789")] == '\0') ? TRUE : FALSE;
    const float64 wide = strtod(word, NULL);
    (void)snprintf(wanted, sizeof(wanted), "must be a whole number from %" PRId64 " to %" PRIu64, least(kind), greatest(kind));
    if (is_decimal(word) == FALSE || (is_plain == FALSE && (floor(wide) != wide || fabs(wide) > 9007199254740992.0))) {
        return FALSE;
    }
    errno = 0;
    if (wide < 0.0) {
        const sint64 found = (is_plain != FALSE) ? strtoll(word, NULL, 10) : (sint64)wide;
        *number = (uint64)found;
        return (errno == 0 && found >= least(kind)) ? TRUE : FALSE;
    }
    *number = (is_plain != FALSE) ? strtoull(digits, NULL, 10) : (uint64)wide;
    return (errno == 0 && *number <= greatest(kind)) ? TRUE : FALSE;
}

static boolean boolean_of(const char *word, uint64 *number)
{
    if (is_alike(word, "true") != FALSE || is_alike(word, "false") != FALSE) {
        *number = (tolower((unsigned char)*word) == 't') ? 1U : 0U;
        return TRUE;
    }
    const boolean is_right = whole(word, TEST_RTE_BOOLEAN, number);
    (void)snprintf(wanted, sizeof(wanted), "must be true or false");
    return is_right;
}

static boolean floating(const char *word, TestRte_Kind kind, float64 *number)
{
    const char *const name = word + ((*word == '-' || *word == '+') ? 1 : 0);
    const boolean is_named =
        (is_alike(name, "nan") != FALSE || is_alike(name, "inf") != FALSE || is_alike(name, "infinity") != FALSE) ? TRUE : FALSE;
    *number = strtod(word, NULL);
    (void)snprintf(wanted, sizeof(wanted), "must be a number%s", (kind == TEST_RTE_FLOAT32) ? " that a float holds" : "");
    if (is_named != FALSE) {
        return TRUE;
    }
    const boolean is_held = (isinf(*number) == 0 && (kind == TEST_RTE_FLOAT64 || isinf((float32)*number) == 0)) ? TRUE : FALSE;
    return (is_decimal(word) != FALSE && is_held != FALSE) ? TRUE : FALSE;
}

static boolean put(const char *word, const TestRte_Number *number, unsigned char *value)
{
    uint64 bits = 0U;
    float64 wide = 0.0;
    float32 narrow = 0.0F;
    const void *from = &bits; /* of a little-endian machine */
    boolean is_right = TRUE;
    if (number->kind >= TEST_RTE_FLOAT32) {
        is_right = floating(word, number->kind, &wide);
        narrow = (is_right != FALSE) ? (float32)wide : 0.0F;
        from = (number->kind == TEST_RTE_FLOAT32) ? (const void *)&narrow : (const void *)&wide;
    } else if (number->kind == TEST_RTE_BOOLEAN) {
        is_right = boolean_of(word, &bits);
    } else if (symbol(word, number->symbols, &bits) == FALSE) {
        is_right = whole(word, number->kind, &bits);
        if (is_right == FALSE && number->symbols != NULL) {
            (void)snprintf(wanted, sizeof(wanted), "must be one of its names, or a number that its datatype holds");
        }
    }
    (void)memcpy(&value[number->offset], from, sizes[number->kind]);
    return is_right;
}

static const char *without_spaces(const char *text)
{
    return text + strspn(text, " \t");
}

/* What stands before a number or after the last one, with any spaces between; NULL if something else does. */
static const char *after(const char *text, const char *expected)
{
    for (; text != NULL && *expected != '\0'; expected++) {
        text = without_spaces(text);
        text = (*text == *expected) ? (text + 1) : NULL;
    }
    return text;
}

/* A number or a name: the rest of the text, or within a list or a mapping to what ends it. */
static const char *take_word(const char *text, char *word, boolean is_inner)
{
    text = without_spaces(text);
    const boolean is_quoted = (is_inner != FALSE && *text == '"') ? TRUE : FALSE;
    text += (is_quoted != FALSE) ? 1 : 0;
    const size_t length = strcspn(text, (is_quoted != FALSE) ? "\"" : (is_inner != FALSE) ? ",]} \t" : " \t");
    if (length == 0U || length >= LONGEST) {
        return NULL;
    }
    (void)memcpy(word, text, length);
    word[length] = '\0';
    text += length;
    if (is_quoted == FALSE) {
        return text;
    }
    return (*text == '"') ? (text + 1) : NULL;
}

const char *TestRte_Read(const char *text, const TestRte_Shape *shape, void *value)
{
    static const char form[] = "must be a list or a mapping of JSON, with its members in the order of their declaration";
    char word[LONGEST];
    const boolean is_inner = (*shape->after != '\0') ? TRUE : FALSE;
    for (uint32 i = 0U; i < shape->count; i++) {
        text = after(text, shape->numbers[i].before);
        text = (text != NULL) ? take_word(text, word, is_inner) : NULL;
        if (text == NULL) {
            return (is_inner != FALSE) ? form : "must be a value";
        }
        if (put(word, &shape->numbers[i], value) == FALSE) {
            return wanted;
        }
    }
    text = after(text, shape->after);
    if (text == NULL || *without_spaces(text) != '\0') {
        return (is_inner != FALSE) ? form : "must be one value";
    }
    return NULL;
}

/* -- writing ----------------------------------------------------------------------------------------------------- */

static void write_float(FILE *file, float64 number, int digits, boolean is_inner)
{
    if (isnan(number)) {
        (void)fputs((is_inner != FALSE) ? "NaN" : "nan", file);
    } else if (isinf(number)) {
        (void)fprintf(file, "%s%s", (number < 0.0) ? "-" : "", (is_inner != FALSE) ? "Infinity" : "inf");
    } else {
        (void)fprintf(file, "%.*g", digits, number);
    }
}

static sint64 signed_number(TestRte_Kind kind, uint64 bits)
{
    switch (kind) {
    case TEST_RTE_SINT8: return (sint8)bits;
    case TEST_RTE_SINT16: return (sint16)bits;
    case TEST_RTE_SINT32: return (sint32)bits;
    default: return (sint64)bits;
    }
}

static void write_quoted(FILE *file, const char *text)
{
    for (; *text != '\0'; text++) {
        (void)fputs((*text == '"') ? "\"\"" : (const char[]){*text, '\0'}, file);
    }
}

/* The name of a number; NULL: it has none. */
static const char *name_of(uint64 bits, const TestRte_Number *number)
{
    for (const TestRte_Symbol *each = number->symbols; each != NULL && each->name != NULL; each++) {
        if (each->number == signed_number(number->kind, bits)) {
            return each->name;
        }
    }
    return NULL;
}

static void write_number(FILE *file, const TestRte_Number *number, const unsigned char *value, boolean is_inner)
{
    uint64 bits = 0U;
    float32 narrow = 0.0F;
    float64 wide = 0.0;
    (void)memcpy(&bits, &value[number->offset], sizes[number->kind]);
    const char *const name = (is_inner != FALSE) ? NULL : name_of(bits, number); /* JSON has numbers */
    if (name != NULL) {
        const char *const quote = (strpbrk(name, ",\"") != NULL) ? "\"" : "";
        (void)fputs(quote, file);
        write_quoted(file, name);
        (void)fputs(quote, file);
        return;
    }
    (void)memcpy(&narrow, &value[number->offset], sizeof(narrow) < sizes[number->kind] ? sizeof(narrow) : sizes[number->kind]);
    switch (number->kind) {
    case TEST_RTE_BOOLEAN: (void)fputs((bits != 0U) ? "true" : "false", file); break;
    case TEST_RTE_FLOAT32: write_float(file, (float64)narrow, 9, is_inner); break;
    case TEST_RTE_FLOAT64:
        (void)memcpy(&wide, &bits, sizeof(wide));
        write_float(file, wide, 17, is_inner);
        break;
    case TEST_RTE_SINT8:
    case TEST_RTE_SINT16:
    case TEST_RTE_SINT32:
    case TEST_RTE_SINT64: (void)fprintf(file, "%" PRId64, signed_number(number->kind, bits)); break;
    default: (void)fprintf(file, "%" PRIu64, bits); break;
    }
}

void TestRte_Write(FILE *file, const TestRte_Shape *shape, const void *value)
{
    const boolean is_inner = (*shape->after != '\0') ? TRUE : FALSE;
    (void)fputs((is_inner != FALSE) ? "\"" : "", file);
    for (uint32 i = 0U; i < shape->count; i++) {
        write_quoted(file, shape->numbers[i].before);
        write_number(file, &shape->numbers[i], value, is_inner);
    }
    write_quoted(file, shape->after);
    (void)fputs((is_inner != FALSE) ? "\"" : "", file);
}
