/*
 * Plays a trace to the test RTE, and records what the components send, and calls of services:
 *
 *     test_rte MODE TRACE RECORDED SERVICES LENGTH_NS [-n FOLDER] [-i CYCLE] [FUNCTION@TIME_NS...]
 *
 * Time begins with the first row, and ends LENGTH_NS after it. MODE is `lock` (as fast as possible) or `free` (in real
 * time). FOLDER is where blocks are kept, CYCLE the number of the ignition cycle. From its time on, nothing of a function
 * runs any more. What cannot be understood is refused before anything is written, with a status of 2.
 */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "Rte_Main.h"
#include "test_rte.h"

#define SECOND 1000000000U
#define FIRST_OPTION 6

typedef struct {
    boolean is_free;
    const char *trace;
    const char *sent;
    const char *told;
    uint64 length;
    const char *folder;
    uint64 *ends; /* of each component, when it ends */
} request;

/* -- what is asked for --------------------------------------------------------------------------------------------- */

static void refuse(const char *what, const char *found)
{
    (void)fprintf(stderr, "test_rte: %s, not \"%s\"\n", what, found);
    exit(TEST_RTE_REFUSED);
}

static uint64 number_of(const char *text, uint64 most, const char *what)
{
    errno = 0;
    const uint64 found = strtoull(text, NULL, 10);
    if (*text == '\0' || text[strspn(text, "0123456789")] != '\0' || errno != 0 || found > most) {
        refuse(what, text);
    }
    return found;
}

static void take_end(const char *text, request *asked)
{
    const char *const at = strrchr(text, '@');
    const size_t length = (at != NULL) ? (size_t)(at - text) : 0U;
    for (uint32 i = 0U; at != NULL && i < TestRte_ComponentCount; i++) {
        if (strlen(TestRte_Functions[i]) == length && strncmp(TestRte_Functions[i], text, length) == 0) {
            asked->ends[i] = number_of(at + 1, UINT64_MAX - 1U, "The time of an end must be in ns");
            return;
        }
    }
    (void)fprintf(stderr, "test_rte: What follows LENGTH_NS must be -n FOLDER, -i CYCLE or FUNCTION@TIME_NS of");
    for (uint32 i = 0U; i < TestRte_ComponentCount; i++) {
        (void)fprintf(stderr, "%s %s", (i > 0U) ? "," : "", TestRte_Functions[i]);
    }
    (void)fprintf(stderr, ", not \"%s\"\n", text);
    exit(TEST_RTE_REFUSED);
}

static const char *folder_of(const char *name)
{
    struct stat about;
    if (stat(name, &about) != 0 || !S_ISDIR(about.st_mode)) {
        refuse("What -n names must be a folder", name);
    }
    return name;
}

static void take_options(int count, char **arguments, request *asked)
{
    for (int i = FIRST_OPTION; i < count; i++) {
        const boolean is_option = (strcmp(arguments[i], "-n") == 0 || strcmp(arguments[i], "-i") == 0) ? TRUE : FALSE;
        if (is_option == FALSE) {
            take_end(arguments[i], asked);
        } else if (i + 1 == count) {
            refuse("A value must follow", arguments[i]);
        } else if (arguments[i][1] == 'n') {
            i++;
            asked->folder = folder_of(arguments[i]);
        } else {
            i++;
            TestRte_SetCycle((uint32)number_of(arguments[i], UINT32_MAX, "The number of the ignition cycle must be whole"));
        }
    }
}

static request asked_for(int count, char **arguments)
{
    request asked = {0};
    if (count < FIRST_OPTION) {
        (void)fprintf(stderr, "usage: test_rte MODE TRACE RECORDED SERVICES LENGTH_NS [-n FOLDER] [-i CYCLE] [FUNCTION@TIME_NS...]\n");
        exit(TEST_RTE_REFUSED);
    }
    asked.is_free = (strcmp(arguments[1], "free") == 0) ? TRUE : FALSE;
    if (asked.is_free == FALSE && strcmp(arguments[1], "lock") != 0) {
        refuse("MODE must be lock or free", arguments[1]);
    }
    asked.trace = arguments[2];
    asked.sent = arguments[3];
    asked.told = arguments[4];
    if (strcmp(asked.sent, asked.trace) == 0 || strcmp(asked.told, asked.trace) == 0 || strcmp(asked.sent, asked.told) == 0) {
        refuse("TRACE, RECORDED and SERVICES must be three files", asked.told);
    }
    asked.length = number_of(arguments[5], INT64_MAX, "LENGTH_NS must be a whole number of ns");
    asked.ends = calloc(TestRte_ComponentCount + 1U, sizeof(*asked.ends));
    if (asked.ends == NULL) {
        abort();
    }
    for (uint32 i = 0U; i < TestRte_ComponentCount; i++) {
        asked.ends[i] = UINT64_MAX;
    }
    take_options(count, arguments, &asked);
    return asked;
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

/* Ends the components whose time has come, and says when the next one's does. */
static uint64 end_components(const uint64 *ends, uint64 t)
{
    uint64 next = UINT64_MAX;
    for (uint32 i = 0U; i < TestRte_ComponentCount; i++) {
        if (ends[i] <= t) {
            Os_EndComponent(i);
        } else {
            next = earlier(next, ends[i]);
        }
    }
    return next;
}

static struct {
    request asked;
    struct timespec start;
    uint64 begin;
    uint64 end;
    uint64 next_end; /* when a component ends next */
} played;

static uint64 next_time(void)
{
    return earlier(earlier(Trace_Time(), Os_NextTime()), played.next_end);
}

static void set_time(uint64 t)
{
    if (played.asked.is_free != FALSE) {
        wait_until(&played.start, t - played.begin);
    }
    played.next_end = end_components(played.asked.ends, t);
    Os_SetTime(t);
    Trace_DeliverUntil(t);
}

static void play_before(uint64 until)
{
    for (uint64 t = next_time(); t < until; t = next_time()) {
        set_time(t);
        Os_Run();
    }
}

static void finish(void)
{
    Os_SetTime(played.end);
    TestRte_ShutDown();
    Os_Run();
    (void)Rte_Stop();
    NvM_WriteAll(played.asked.folder);
    TestRte_CloseRecords();
    Trace_Close();
    free(played.asked.ends);
    exit(EXIT_SUCCESS);
}

static void play(void)
{
    (void)clock_gettime(CLOCK_MONOTONIC, &played.start);
    played.begin = Os_Now();
    played.end = played.begin + played.asked.length;
    played.next_end = UINT64_MAX;
    play_before(played.end + 1U);
    finish();
}

/* A run may end while a runnable takes time: it does not come to its end then. */
static void pass_until(uint64 until)
{
    play_before((until <= played.end) ? until : (played.end + 1U));
    if (until > played.end) {
        finish();
    }
    set_time(until);
}

void TestRte_PassTime(uint64 time)
{
    Os_Wait(pass_until, Os_Now() + time);
}

/* -- a crash ------------------------------------------------------------------------------------------------------- */

static const int deadly[] = {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV};

static void say(const char *text)
{
    const ssize_t written = write(STDERR_FILENO, text, strlen(text));
    (void)written; /* no reader is left */
}

/* A runnable that crashes says nothing itself. */
static void tell_crash(int number)
{
    const TestRte_Event *const event = Os_Running();
    char digits[21] = {0};
    size_t first = sizeof(digits) - 1U;
    uint64 rest = Os_Now();
    do {
        first--;
        digits[first] = (char)('0' + (int)(rest % 10U));
        rest /= 10U;
    } while (rest > 0U);
    if (event != NULL) {
        say(event->name);
        say(" did not return, at ");
    } else {
        say("No runnable was running, at ");
    }
    say(&digits[first]);
    say(" ns\n");
    (void)raise(number); /* it ends the process when this returns */
}

static void tell_crashes(void)
{
    struct sigaction action = {0};
    action.sa_handler = tell_crash;
    action.sa_flags = (int)SA_RESETHAND;
    for (size_t i = 0U; i < sizeof(deadly) / sizeof(deadly[0]); i++) {
        (void)sigaction(deadly[i], &action, NULL);
    }
}

/* -- the process --------------------------------------------------------------------------------------------------- */

int main(int count, char **arguments)
{
    played.asked = asked_for(count, arguments);
    tell_crashes();
    Trace_Open(played.asked.trace);
    TestRte_OpenRecords(played.asked.sent, played.asked.told);
    NvM_ReadAll(played.asked.folder);
    Os_Begin((Trace_Time() != UINT64_MAX) ? Trace_Time() : 0U);
    TestRte_StartUp();
    play();
}
