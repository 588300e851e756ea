/* A trace: rows of a CSV file, each with a time in seconds and the values that come then. All of it is read once before
 * anything runs, so that a fault in it leaves nothing half played. */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "test_rte.h"

#define SECOND 1000000000U
#define LATEST 9223372036.0 /* s */
#define DIGITS "0123456789"
#define CODE ":e2e" /* ending of the name of a column with codes of end-to-end protection */

/* A column: the input that takes its values, and its partner: the column of codes for values, of values for codes. */
typedef struct {
    const char *input; /* NULL: no component receives it */
    boolean has_codes;
    uint32 partner; /* 0: there is none */
} Column;

static struct {
    const char *name;
    FILE *file;
    char *line;
    size_t room;
    uint64 number; /* of the line */
    char **cells;
    uint32 places; /* for cells */
    uint32 count; /* of cells */
    Column *columns; /* of each cell */
    uint32 columns_count;
    uint64 time; /* of the row that comes next */
    void *value; /* with room for every input */
} from;

/* -- errors in it -------- ------------------------------------------------------------------------------------------ */

static void fail(const char *column, const char *what, const char *found)
{
    (void)fprintf(stderr, "test_rte: %s, line %" PRIu64 ": %s %s", from.name, from.number, column, what);
    (void)fprintf(stderr, (found != NULL) ? ", not \"%.60s\"\n" : "%s\n", (found != NULL) ? found : "");
    exit(TEST_RTE_REFUSED);
}

/* -- rows ------------------------------------------------------------------------------------------------------------ */

/* A cell ends at a comma; one in quotes at its quote, and a quote within is doubled. What follows it, or NULL. */
static char *take_cell(char *at, char **cell)
{
    char *to = at;
    *cell = at;
    if (*at != '"') {
        at += strcspn(at, ",");
        to = at;
    } else {
        for (at++; *at != '\0' && (*at != '"' || at[1] == '"'); at++) {
            at += (*at == '"') ? 1 : 0;
            *to = *at;
            to++;
        }
        if (*at != '"' || (at[1] != ',' && at[1] != '\0')) {
            fail("The row", "must close each quote at the end of its cell", NULL);
        }
        at++;
    }
    const char separator = *at;
    *to = '\0';
    return (separator == ',') ? (at + 1) : NULL;
}

static void *grown(void *room, size_t size)
{
    void *const made = realloc(room, size);
    if (made == NULL) {
        fail("The trace", "must fit into memory", NULL);
    }
    return made;
}

static void split(void)
{
    from.count = 0U;
    for (char *at = from.line; at != NULL; from.count++) {
        if (from.count == from.places) {
            from.places = (2U * from.places) + 16U;
            from.cells = grown(from.cells, from.places * sizeof(*from.cells));
        }
        at = take_cell(at, &from.cells[from.count]);
    }
}

/* The next line that is not empty, without what ends it. */
static boolean read_line(void)
{
    static const char mark[] = "\xef\xbb\xbf";
    for (;;) {
        const ssize_t length = getline(&from.line, &from.room, from.file);
        if (length <= 0) {
            return FALSE;
        }
        from.number++;
        if (strlen(from.line) != (size_t)length) {
            fail("The row", "must be text, without a byte of 0", NULL);
        }
        if (from.number == 1U && strncmp(from.line, mark, 3U) == 0) {
            (void)memmove(from.line, &from.line[3], (size_t)length - 2U);
        }
        from.line[strcspn(from.line, "\r\n")] = '\0';
        if (from.line[0] != '\0') {
            return TRUE;
        }
    }
}

static boolean read_row(void)
{
    if (read_line() == FALSE) {
        return FALSE;
    }
    split();
    return TRUE;
}

/* Seconds, exactly if they have no more than nine decimals. */
static uint64 nanoseconds(const char *text)
{
    const size_t whole = strspn(text, DIGITS);
    const size_t decimals = (text[whole] == '.') ? strspn(&text[whole + 1U], DIGITS) : 0U;
    const size_t plain = whole + ((text[whole] == '.') ? 1U : 0U) + decimals;
    char *end = NULL;
    const double seconds = strtod(text, &end);
    const boolean is_number = (*text != '\0' && *end == '\0' && text[strspn(text, DIGITS "+-.eE")] == '\0') ? TRUE : FALSE;
    if (is_number == FALSE || !(seconds >= 0.0) || seconds > LATEST) {
        fail("The time", "must be in seconds, from 0 on", text);
    }
    if (text[plain] != '\0' || decimals > 9U) {
        return (uint64)llround(seconds * (double)SECOND);
    }
    uint64 found = strtoull(text, NULL, 10) * SECOND;
    uint64 unit = SECOND / 10U;
    for (size_t i = 0U; i < decimals; i++) {
        found += unit * (uint64)(text[whole + 1U + i] - '0');
        unit /= 10U;
    }
    return found;
}

static void read_next(void)
{
    from.time = (read_row() != FALSE) ? nanoseconds(from.cells[0]) : UINT64_MAX;
}

/* -- columns --------------------------------------------------------------------------------------------------------- */

/* Whether the name of a column is that of an input with an ending. */
static boolean is_of(const char *name, const TestRte_Input *input, const char *ending)
{
    const size_t length = strlen(input->name);
    return (strncmp(name, input->name, length) == 0 && strcmp(&name[length], ending) == 0) ? TRUE : FALSE;
}

static Column column_of(const char *name)
{
    Column found = {NULL, FALSE, 0U};
    for (uint32 k = 0U; k < TestRte_InputCount && found.input == NULL; k++) {
        const TestRte_Input *const input = &TestRte_Inputs[k];
        found.has_codes = (input->deliver_checked != NULL && is_of(name, input, CODE) != FALSE) ? TRUE : FALSE;
        found.input = (found.has_codes != FALSE || is_of(name, input, "") != FALSE) ? input->name : NULL;
    }
    return found;
}

static void find_partner(uint32 of)
{
    for (uint32 k = 1U; k < of; k++) {
        const Column *const other = &from.columns[k];
        if (other->input != NULL && other->input == from.columns[of].input && other->has_codes != from.columns[of].has_codes) {
            from.columns[k].partner = of;
            from.columns[of].partner = k;
        }
    }
}

/* Columns without a receiver are left out, and named. */
static void read_header(boolean is_told)
{
    if (read_row() == FALSE) {
        fail("The first line", "must name the columns", NULL);
    }
    if (strcmp(from.cells[0], "time") != 0) {
        fail("The first column", "must be time", from.cells[0]);
    }
    from.columns_count = from.count;
    from.columns = grown(from.columns, from.count * sizeof(*from.columns));
    for (uint32 i = 1U; i < from.count; i++) {
        from.columns[i] = column_of(from.cells[i]);
        for (uint32 k = 0U; k < i; k++) {
            if (strcmp(from.cells[k], from.cells[i]) == 0) {
                fail("A column", "must be in the header only once", from.cells[i]);
            }
        }
        if (from.columns[i].input != NULL) {
            find_partner(i);
        } else if (strcmp(from.cells[i], "call") != 0 && is_told != FALSE) {
            (void)fprintf(stderr, "test_rte: %s: %s is left out: no component receives it\n", from.name, from.cells[i]);
        }
    }
}

/* -- values ---------------------------------------------------------------------------------------------------------- */

/* A code of end-to-end protection: 51, or 0x33. */
static uint8 code_of(uint32 cell)
{
    const char *const text = from.cells[cell];
    const boolean is_hex = (text[0] == '0' && (text[1] == 'x' || text[1] == 'X')) ? TRUE : FALSE;
    const char *const digits = (is_hex != FALSE) ? &text[2] : text;
    const size_t length = strspn(digits, (is_hex != FALSE) ? DIGITS "abcdefABCDEF" : DIGITS);
    const unsigned long code = strtoul(digits, NULL, (is_hex != FALSE) ? 16 : 10);
    if (length == 0U || length > 3U || digits[length] != '\0' || code > 255U) {
        fail(from.columns[cell].input, "must have a code from 0 to 255, such as 0x33, in its column" CODE, text);
    }
    return (uint8)code;
}

/* A component whose port has no codes takes only what the RTE delivers without an error. */
static void deliver(const TestRte_Input *input, const void *value, uint8 code)
{
    if (input->deliver_checked != NULL) {
        input->deliver_checked(value, code);
    } else if (value != NULL && code == 0U) {
        input->deliver(value);
    }
}

/* A column may be received by several components: each has an input of that name. */
static void take(uint32 cell, uint8 code, boolean is_delivered)
{
    for (uint32 k = 0U; k < TestRte_InputCount; k++) {
        const TestRte_Input *const input = &TestRte_Inputs[k];
        if (strcmp(input->name, from.columns[cell].input) == 0) {
            (void)memset(from.value, 0, input->shape->size);
            const char *const wrong = TestRte_Read(from.cells[cell], input->shape, from.value);
            if (wrong != NULL) {
                fail(input->name, wrong, from.cells[cell]);
            }
            if (is_delivered != FALSE) {
                deliver(input, from.value, code);
            }
        }
    }
}

static boolean is_given(uint32 cell)
{
    return (cell != 0U && from.cells[cell][0] != '\0') ? TRUE : FALSE;
}

/* A code without a value in its row: no message was received, but the functions that read the port return the code. */
static void take_code(uint32 cell, boolean is_delivered)
{
    const uint8 code = code_of(cell);
    for (uint32 k = 0U; k < TestRte_InputCount && is_delivered != FALSE; k++) {
        if (strcmp(TestRte_Inputs[k].name, from.columns[cell].input) == 0) {
            deliver(&TestRte_Inputs[k], NULL, code);
        }
    }
}

static void take_row(boolean is_delivered)
{
    for (uint32 i = 1U; i < from.count; i++) {
        const Column *const of = &from.columns[i];
        const boolean has_partner = is_given(of->partner);
        if (of->input == NULL || is_given(i) == FALSE) {
            continue;
        }
        if (of->has_codes == FALSE) {
            take(i, (has_partner != FALSE) ? code_of(of->partner) : 0U, is_delivered);
        } else if (has_partner == FALSE) {
            take_code(i, is_delivered);
        }
    }
}

static void check_rows(void)
{
    uint64 last = 0U;
    for (read_next(); from.time != UINT64_MAX; read_next()) {
        if (from.count != from.columns_count) {
            fail("The row", "must have as many cells as the header", NULL);
        }
        if (from.time < last) {
            fail("The time", "must not be before that of the row above", from.cells[0]);
        }
        last = from.time;
        take_row(FALSE);
    }
}

/* -- what the program asks ------------------------------------------------------------------------------------------- */

void Trace_Open(const char *name)
{
    size_t largest = 1U;
    for (uint32 k = 0U; k < TestRte_InputCount; k++) {
        largest = (TestRte_Inputs[k].shape->size > largest) ? TestRte_Inputs[k].shape->size : largest;
    }
    from.name = name;
    from.file = fopen(name, "r");
    from.value = grown(NULL, largest);
    if (from.file == NULL || fseek(from.file, 0L, SEEK_SET) != 0 || fgetc(from.file) == EOF) {
        (void)fprintf(stderr, "test_rte: %s cannot be read as a trace: %s\n", name, (errno != 0) ? strerror(errno) : "it is empty");
        exit(TEST_RTE_REFUSED);
    }
    rewind(from.file);
    read_header(TRUE);
    check_rows();
    rewind(from.file);
    from.number = 0U;
    read_header(FALSE);
    read_next();
}

uint64 Trace_Time(void)
{
    return from.time;
}

void Trace_DeliverUntil(uint64 t)
{
    while (from.time <= t) {
        take_row(TRUE);
        read_next();
    }
}

void Trace_Close(void)
{
    free(from.line);
    free(from.cells);
    free(from.columns);
    free(from.value);
    (void)fclose(from.file);
}
