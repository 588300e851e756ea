/*
 * Plays a trace to the test RTE, and records what the components send, and what services are told:
 *
 *     test_rte MODE TRACE SENT TOLD LENGTH_NS [-n FOLDER] [-i CYCLE] [FUNCTION@TIME_NS...]
 *
 * Time begins with the first row, and ends LENGTH_NS after it. MODE is `lock` (as fast as it goes) or `free` (in real time). FOLDER is where blocks are kept, CYCLE the number of the
 * ignition cycle. From its time on, nothing of a function runs any more.
 */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "Rte_Main.h"
#include "test_rte.h"

#define COLUMNS 4096U
#define SECOND 1000000000U

typedef struct {
    FILE *file;
    char *line;
    size_t room;
    const TestRte_Input *columns[COLUMNS];
    char *cells[COLUMNS];
    uint32 count;
    uint64 time; /* of the row that comes next */
    uint64 number; /* of its line */
} trace;

typedef struct {
    uint32 component;
    uint64 time;
    boolean has_come;
} end_of_component;

static void fail(const trace *of, const char *what, const char *detail)
{
    (void)fprintf(stderr, "test_rte: line %" PRIu64 ": %s %s\n", of->number, what, detail);
    exit(EXIT_FAILURE);
}

/* -- the trace ----------------------------------------------------------------------------------------------------- */

/* A cell ends at a comma; one in quotes at its quote, and a quote within is doubled. */
static char *take_cell(char *at, char **cell)
{
    char *to = at;
    *cell = at;
    if (*at != '"') {
        at += strcspn(at, ",\r\n");
        to = at;
    } else {
        for (at++; *at != '\0' && (*at != '"' || at[1] == '"'); at++) {
            at += (*at == '"') ? 1 : 0;
            *to = *at;
            to++;
        }
        at += (*at == '"') ? 1 : 0;
    }
    const char separator = *at;
    *to = '\0';
    return (separator == ',') ? (at + 1) : NULL;
}

static boolean read_row(trace *from)
{
    from->number++;
    if (getline(&from->line, &from->room, from->file) <= 0) {
        return FALSE;
    }
    char *at = from->line;
    for (from->count = 0U; at != NULL && from->count < COLUMNS; from->count++) {
        at = take_cell(at, &from->cells[from->count]);
    }
    return TRUE;
}

/* Seconds, exactly. */
static uint64 nanoseconds(const char *text)
{
    char *end = NULL;
    uint64 found = strtoull(text, &end, 10) * SECOND;
    if (*end == '.') {
        uint64 unit = SECOND / 10U;
        for (end++; *end >= '0' && *end <= '9'; end++) {
            found += unit * (uint64)(*end - '0');
            unit /= 10U;
        }
    }
    return (*end == '\0') ? found : (uint64)(strtod(text, NULL) * (double)SECOND + 0.5);
}

static void read_next(trace *from)
{
    from->time = (read_row(from) != FALSE) ? nanoseconds(from->cells[0]) : UINT64_MAX;
}

static trace opened(const char *name)
{
    trace made = {0};
    made.file = fopen(name, "r");
    if (made.file == NULL || read_row(&made) == FALSE) {
        fail(&made, "this cannot be read:", name);
    }
    for (uint32 i = 1U; i < made.count; i++) {
        for (uint32 k = 0U; k < TestRte_InputCount; k++) {
            if (strcmp(made.cells[i], TestRte_Inputs[k].name) == 0) {
                made.columns[i] = &TestRte_Inputs[k];
            }
        }
    }
    return made;
}

/* A column may be received by several components: each has an input of that name. */
static void deliver(trace *from, uint32 cell)
{
    union { uint64 aligned; unsigned char bytes[1]; } *value = NULL;
    for (uint32 k = 0U; k < TestRte_InputCount; k++) {
        const TestRte_Input *const input = &TestRte_Inputs[k];
        if (strcmp(input->name, from->columns[cell]->name) == 0) {
            value = calloc(1U, input->shape->size + sizeof(*value));
            if (value == NULL || TestRte_Read(from->cells[cell], input->shape, value) == FALSE) {
                fail(from, input->name, from->cells[cell]);
            }
            input->deliver(value);
            free(value);
        }
    }
}

static void deliver_until(trace *from, uint64 t)
{
    while (from->time <= t) {
        for (uint32 i = 1U; i < from->count; i++) {
            if (from->columns[i] != NULL && from->cells[i][0] != '\0') {
                deliver(from, i);
            }
        }
        read_next(from);
    }
}

/* -- time ---------------------------------------------------------------------------------------------------------- */

static void wait_until(const struct timespec *start, uint64 t)
{
    const uint64 since = (uint64)start->tv_nsec + t;
    const struct timespec until = {start->tv_sec + (time_t)(since / SECOND), (long)(since % SECOND)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL) != 0) {
    }
}

static uint64 earlier(uint64 a, uint64 b)
{
    return (a < b) ? a : b;
}

static void play(trace *from, uint64 length, boolean is_free, end_of_component *ends, uint32 count)
{
    struct timespec start;
    (void)clock_gettime(CLOCK_MONOTONIC, &start);
    const uint64 begin = Os_Now();
    const uint64 end = begin + length;
    uint64 t = earlier(from->time, Os_NextTime());
    while (t <= end) {
        if (is_free != FALSE) {
            wait_until(&start, t - begin);
        }
        uint64 next_end = UINT64_MAX;
        for (uint32 i = 0U; i < count; i++) {
            if (ends[i].time <= t) {
                Os_EndComponent(ends[i].component);
            } else {
                next_end = earlier(next_end, ends[i].time);
            }
        }
        Os_SetTime(t);
        deliver_until(from, t);
        Os_Run();
        t = earlier(earlier(from->time, Os_NextTime()), next_end);
    }
    Os_SetTime(end);
}

/* -- the process --------------------------------------------------------------------------------------------------- */

static end_of_component end_of(const char *text)
{
    const char *const at = strchr(text, '@');
    const size_t length = (at != NULL) ? (size_t)(at - text) : 0U;
    for (uint32 i = 0U; at != NULL && i < TestRte_ComponentCount; i++) {
        if (strlen(TestRte_Functions[i]) == length && strncmp(TestRte_Functions[i], text, length) == 0) {
            return (end_of_component){i, strtoull(at + 1, NULL, 10), FALSE};
        }
    }
    (void)fprintf(stderr, "test_rte: this is no function with a time: %s\n", text);
    exit(EXIT_FAILURE);
}

int main(int count, char **arguments)
{
    end_of_component ends[COLUMNS];
    uint32 end_count = 0U;
    const char *folder = NULL;
    if (count < 6 || TestRte_OpenRecords(arguments[3], arguments[4]) == FALSE) {
        (void)fprintf(stderr, "test_rte MODE TRACE SENT TOLD LENGTH_NS [-n FOLDER] [-i CYCLE] [FUNCTION@TIME_NS...]\n");
        return EXIT_FAILURE;
    }
    for (int i = 6; i < count; i++) {
        if (strcmp(arguments[i], "-n") == 0 && i + 1 < count) {
            i++;
            folder = arguments[i];
        } else if (strcmp(arguments[i], "-i") == 0 && i + 1 < count) {
            i++;
            TestRte_SetCycle((uint32)strtoul(arguments[i], NULL, 10));
        } else if (end_count < COLUMNS) {
            ends[end_count] = end_of(arguments[i]);
            end_count++;
        }
    }
    trace from = opened(arguments[2]);
    read_next(&from);
    NvM_ReadAll(folder);
    Os_Begin((from.time != UINT64_MAX) ? from.time : 0U);
    TestRte_StartUp();
    play(&from, strtoull(arguments[5], NULL, 10), (strcmp(arguments[1], "free") == 0) ? TRUE : FALSE, ends, end_count);
    TestRte_ShutDown();
    Os_Run();
    (void)Rte_Stop();
    NvM_WriteAll(folder);
    TestRte_CloseRecords();
    free(from.line);
    (void)fclose(from.file);
    return EXIT_SUCCESS;
}
