/* Values as texts: of a normalized trace, and of a recording. */
#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "test_rte.h"

static const uint32 sizes[] = {1U, 1U, 1U, 2U, 2U, 4U, 4U, 8U, 8U, 4U, 8U};
static const TestRte_Symbol words[] = {{"true", 1}, {"false", 0}, {NULL, 0}};

static boolean is_signed(TestRte_Kind kind)
{
    return (kind == TEST_RTE_SINT8 || kind == TEST_RTE_SINT16 || kind == TEST_RTE_SINT32 || kind == TEST_RTE_SINT64) ? TRUE : FALSE;
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

/* -- reading ----------------------------------------------------------------------------------------------------- */

/* Whether an integer of a kind has these bits. */
static boolean is_held(TestRte_Kind kind, uint64 bits, boolean is_negative)
{
    const uint32 unused = 64U - (8U * sizes[kind]) + ((is_signed(kind) != FALSE) ? 1U : 0U);
    if (is_negative != FALSE) {
        return (is_signed(kind) != FALSE && signed_number(kind, bits) == (sint64)bits) ? TRUE : FALSE;
    }
    return (bits <= (UINT64_MAX >> unused)) ? TRUE : FALSE;
}

/* The number of a name; FALSE: it is none. */
static boolean symbol(const char *text, size_t length, const TestRte_Symbol *symbols, uint64 *number)
{
    for (; symbols != NULL && symbols->name != NULL; symbols++) {
        if (strncmp(text, symbols->name, length) == 0 && symbols->name[length] == '\0') {
            *number = (uint64)symbols->number;
            return TRUE;
        }
    }
    return FALSE;
}

/* The bits of a number that ends where it should. They are those of a little-endian machine. */
static boolean number(const char *text, const char *last, TestRte_Kind kind, uint64 *bits)
{
    char *end = NULL;
    boolean is_right = TRUE;
    errno = 0;
    if (kind == TEST_RTE_FLOAT32) {
        const float32 narrow = strtof(text, &end);
        is_right = (errno == 0 || isinf(narrow) == 0) ? TRUE : FALSE; /* small numbers are reported, too */
        (void)memcpy(bits, &narrow, sizeof(narrow));
    } else if (kind == TEST_RTE_FLOAT64) {
        const float64 wide = strtod(text, &end);
        is_right = (errno == 0 || isinf(wide) == 0) ? TRUE : FALSE;
        (void)memcpy(bits, &wide, sizeof(wide));
    } else {
        const boolean is_negative = (*text == '-') ? TRUE : FALSE;
        *bits = (is_negative != FALSE) ? (uint64)strtoll(text, &end, 10) : strtoull(text, &end, 10);
        is_right = (errno == 0 && is_held(kind, *bits, is_negative) != FALSE) ? TRUE : FALSE;
    }
    return (is_right != FALSE && end == last && isspace((unsigned char)*text) == 0) ? TRUE : FALSE;
}

/* Reads a number, or its name, up to a semicolon or the end. Returns where it ends; NULL: it is none of its kind. */
static const char *take(const char *text, const TestRte_Number *of, unsigned char *value)
{
    const size_t length = strcspn(text, ";");
    const TestRte_Symbol *const symbols = (of->kind == TEST_RTE_BOOLEAN) ? words : of->symbols;
    uint64 bits = 0U;
    const boolean is_name = symbol(text, length, symbols, &bits);
    if (is_name == FALSE && (length == 0U || of->kind == TEST_RTE_BOOLEAN || number(text, &text[length], of->kind, &bits) == FALSE)) {
        return NULL;
    }
    (void)memcpy(&value[of->offset], &bits, sizes[of->kind]);
    return &text[length];
}

boolean TestRte_Read(const char *text, const TestRte_Shape *shape, void *value)
{
    for (uint32 i = 0U; i < shape->count; i++) {
        text = (i > 0U && *text == ';') ? (text + 1) : text;
        text = take(text, &shape->numbers[i], value);
        if (text == NULL) {
            return FALSE;
        }
    }
    return (*text == '\0') ? TRUE : FALSE;
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
    const char *const name = name_of(bits, number);
    if (name != NULL) {
        const char *const quote = (is_inner != FALSE) ? "\"\"" : "\"";
        (void)fprintf(file, "%s%s%s", quote, name, quote); /* no name has a quote */
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
