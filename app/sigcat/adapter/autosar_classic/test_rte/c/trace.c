/* A normalized trace, as `sigcat normalize` writes it: rows of a time in ns and of values. All of it is read once before
 * anything runs, so that a damaged row leaves nothing half played. */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "test_rte.h"

#define CODE ":e2e" /* end of the name of a column with codes; the next column has their values */

static struct {
    const char *name;
    FILE *file;
    char *line;
    size_t room;
    uint64 number; /* of the line */
    char *header;
    char **names; /* of the columns: parts of the header */
    char **cells; /* parts of the line */
    uint32 count; /* of columns */
    uint64 time; /* of the row that comes next */
    void *value; /* with room for every input */
} from;

static void fail(const char *column, const char *what)
{
    (void)fprintf(stderr, "test_rte: %s, line %" PRIu64 ": %s must %s\n", from.name, from.number, column, what);
    exit(TEST_RTE_REFUSED);
}

static void *room_for(size_t count, size_t size)
{
    void *const made = calloc(count, size);
    if (made == NULL) {
        fail("The trace", "fit into memory");
    }
    return made;
}

/* -- rows ---------------------------------------------------------------------------------------------------------- */

static boolean read_line(void)
{
    const ssize_t length = getline(&from.line, &from.room, from.file);
    from.number++;
    if (length > 0 && from.line[strcspn(from.line, "\n")] != '\n') {
        fail("The row", "end with a line break, and have no byte of 0");
    }
    from.line[(length > 0) ? (length - 1) : 0] = '\0';
    return (length > 0) ? TRUE : FALSE;
}

/* Ends each cell of a line, and returns how many there are. */
static uint32 split(char *at, char **cells, uint32 most)
{
    uint32 count = 0U;
    for (; at != NULL; count++) {
        if (count < most) {
            cells[count] = at;
        }
        at = strchr(at, '\t');
        if (at != NULL) {
            *at = '\0';
            at++;
        }
    }
    return count;
}

static void read_next(void)
{
    static const TestRte_Number number[] = {{"", TEST_RTE_UINT64, 0U, NULL}};
    static const TestRte_Shape time = {sizeof(from.time), 1U, number, ""};
    const uint64 last = from.time;
    if (read_line() == FALSE) {
        from.time = UINT64_MAX;
    } else if (split(from.line, from.cells, from.count) != from.count) {
        fail("The row", "have as many cells as the header");
    } else if (TestRte_Read(from.cells[0], &time, &from.time) == FALSE || from.time < last) {
        fail("The time", "be a whole number of ns, and not before that of the row above");
    }
}

/* -- values -------------------------------------------------------------------------------------------------------- */

/* The cell of the codes of a column; empty if it has none. */
static const char *code_cell(uint32 column)
{
    const char *const before = from.names[column - 1U];
    const size_t length = strlen(from.names[column]);
    const boolean is_code = (strncmp(before, from.names[column], length) == 0 && strcmp(&before[length], CODE) == 0) ? TRUE : FALSE;
    return (is_code != FALSE) ? from.cells[column - 1U] : "";
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

/* A code without a value: no message was received, but the functions that read the port return the code. */
static void take(const TestRte_Input *input, const char *cell, const char *code_text, boolean is_delivered)
{
    static const TestRte_Number number[] = {{"", TEST_RTE_UINT8, 0U, NULL}};
    static const TestRte_Shape one = {1U, 1U, number, ""};
    uint8 code = 0U;
    (void)memset(from.value, 0, input->shape->size);
    if (*cell != '\0' && TestRte_Read(cell, input->shape, from.value) == FALSE) {
        fail(input->name, "have a value of its datatype");
    }
    if (*code_text != '\0' && TestRte_Read(code_text, &one, &code) == FALSE) {
        fail(input->name, "have a code from 0 to 255");
    }
    if (is_delivered != FALSE && (*cell != '\0' || *code_text != '\0')) {
        deliver(input, (*cell != '\0') ? from.value : NULL, code);
    }
}

/* A column may be received by several components: each has an input of that name. */
static void take_row(boolean is_delivered)
{
    for (uint32 i = 1U; i < from.count; i++) {
        for (uint32 k = 0U; k < TestRte_InputCount; k++) {
            if (strcmp(from.names[i], TestRte_Inputs[k].name) == 0) {
                take(&TestRte_Inputs[k], from.cells[i], code_cell(i), is_delivered);
            }
        }
    }
}

/* -- the file ------------------------------------------------------------------------------------------------------ */

static void read_header(void)
{
    if (read_line() == FALSE) {
        fail("The trace", "have a header");
    }
    from.header = from.line;
    from.line = NULL;
    from.room = 0U;
    from.count = 1U;
    for (const char *at = from.header; *at != '\0'; at++) {
        from.count += (*at == '\t') ? 1U : 0U;
    }
    from.names = room_for(from.count, sizeof(*from.names));
    from.cells = room_for(from.count, sizeof(*from.cells));
    (void)split(from.header, from.names, from.count);
    if (strcmp(from.names[0], "time_ns") != 0) {
        fail("The trace", "be normalized, with time_ns as its first column: `sigcat normalize` writes it");
    }
}

static boolean is_received(uint32 column)
{
    for (uint32 k = 0U; k < TestRte_InputCount; k++) {
        const TestRte_Input *const input = &TestRte_Inputs[k];
        const size_t length = strlen(input->name);
        const char *const end = &from.names[column][length];
        if (strncmp(from.names[column], input->name, length) == 0 && (*end == '\0' || strcmp(end, CODE) == 0)) {
            return TRUE;
        }
    }
    return FALSE;
}

static void tell_others(void)
{
    for (uint32 i = 1U; i < from.count; i++) {
        if (is_received(i) == FALSE) {
            (void)fprintf(stderr, "test_rte: %s: %s is left out: no component receives it\n", from.name, from.names[i]);
        }
    }
}

void Trace_Open(const char *name)
{
    size_t largest = 1U;
    for (uint32 k = 0U; k < TestRte_InputCount; k++) {
        largest = (TestRte_Inputs[k].shape->size > largest) ? TestRte_Inputs[k].shape->size : largest;
    }
    from.name = name;
    from.file = fopen(name, "r");
    from.value = room_for(1U, largest);
    if (from.file == NULL) {
        (void)fprintf(stderr, "test_rte: %s cannot be read: %s\n", name, strerror(errno));
        exit(TEST_RTE_REFUSED);
    }
    read_header();
    tell_others();
    for (read_next(); from.time != UINT64_MAX; read_next()) {
        take_row(FALSE);
    }
    rewind(from.file);
    from.number = 0U;
    from.time = 0U;
    (void)read_line(); /* the header again */
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
    free(from.header);
    free(from.names);
    free(from.cells);
    free(from.value);
    (void)fclose(from.file);
}
