/* Values as texts: of a trace, and of what is recorded. A text of a list or a mapping has the order of its declaration. */
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

static boolean is_whole(const char *word)
{
    const char *const rest = word + ((*word == '-' || *word == '+') ? 1 : 0);
    return (*rest != '\0' && rest[strspn(rest, "0123456789")] == '\0') ? TRUE : FALSE;
}

static uint64 whole(const char *word)
{
    if (is_whole(word) == FALSE) {
        return (uint64)(sint64)strtod(word, NULL);
    }
    return (*word == '-') ? (uint64)strtoll(word, NULL, 10) : (uint64)strtoull(word, NULL, 10);
}

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

static boolean put(const char *word, const TestRte_Number *number, unsigned char *value)
{
    uint64 bits = 0U;
    float64 wide = 0.0;
    float32 narrow = 0.0F;
    const void *from = &bits; /* of a little-endian machine */
    char *end = NULL;
    if (number->kind >= TEST_RTE_FLOAT32) {
        wide = strtod(word, &end);
        narrow = (float32)wide;
        if (end == word || *end != '\0') {
            return FALSE;
        }
        from = (number->kind == TEST_RTE_FLOAT32) ? (const void *)&narrow : (const void *)&wide;
    } else if (number->kind == TEST_RTE_BOOLEAN && (is_alike(word, "true") != FALSE || is_alike(word, "false") != FALSE)) {
        bits = (tolower((unsigned char)*word) == 't') ? 1U : 0U;
    } else if (symbol(word, number->symbols, &bits) == FALSE) {
        (void)strtod(word, &end);
        if (end == word || *end != '\0') {
            return FALSE;
        }
        bits = whole(word);
    }
    (void)memcpy(&value[number->offset], from, sizes[number->kind]);
    return TRUE;
}

static const char *skipped(const char *text)
{
    return text + strspn(text, " \t[]{},");
}

/* The next word that is no key. */
static const char *next_word(const char *text, char *word)
{
    for (;;) {
        text = skipped(text);
        const boolean is_quoted = (*text == '"') ? TRUE : FALSE;
        text += (is_quoted != FALSE) ? 1 : 0;
        const size_t length = (is_quoted != FALSE) ? strcspn(text, "\"") : strcspn(text, " \t,]}:");
        if (length == 0U || length >= LONGEST) {
            return NULL;
        }
        (void)memcpy(word, text, length);
        word[length] = '\0';
        text += length + ((is_quoted != FALSE && text[length] == '"') ? 1U : 0U);
        text += strspn(text, " \t");
        if (*text != ':') {
            return text;
        }
        text++;
    }
}

boolean TestRte_Read(const char *text, const TestRte_Shape *shape, void *value)
{
    char word[LONGEST];
    for (uint32 i = 0U; i < shape->count; i++) {
        text = next_word(text, word);
        if (text == NULL || put(word, &shape->numbers[i], value) == FALSE) {
            return FALSE;
        }
    }
    return (*skipped(text) == '\0') ? TRUE : FALSE;
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

static void write_number(FILE *file, const TestRte_Number *number, const unsigned char *value, boolean is_inner)
{
    uint64 bits = 0U;
    float32 narrow = 0.0F;
    float64 wide = 0.0;
    (void)memcpy(&bits, &value[number->offset], sizes[number->kind]);
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

static void write_quoted(FILE *file, const char *text)
{
    for (; *text != '\0'; text++) {
        (void)fputs((*text == '"') ? "\"\"" : (const char[]){*text, '\0'}, file);
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
