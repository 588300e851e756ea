/*
 * Runs functions in simulated time: `driver INPUT START END IGNITION_CYCLE`.
 *
 * INPUT has records of a time, an entry and a value, by time. What happens is written to standard output, as records of
 * a tag, a number and a time. Times are in nanoseconds. What the functions print goes to standard error.
 */

#if !defined(_WIN32)
#define _POSIX_C_SOURCE 200809L
#endif

#include "sigcat_driver.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if defined(_WIN32)
#include <fcntl.h>
#include <io.h>
#define dup _dup
#define dup2 _dup2
#define fdopen _fdopen
#else
#include <sys/resource.h>
#include <unistd.h>
#endif

#define ROUNDS 100000U /* of calls at one time; after so many, they trigger each other without end */

typedef struct {
    uint64_t ends;
    uint32_t call;
    bool is_busy;
    bool is_gone; /* nothing of it is called any more, not even its end */
} running;

static FILE *input;
static FILE *results;
static uint64_t now;
static bool has_sent;
static running *running_calls;
static uint64_t *durations; /* of calls */

static struct {
    uint64_t time;
    uint32_t entry;
    unsigned char *value;
    bool is_there;
} next;

/* -- what happens ------------------------------------------------------------------------------------------------ */

static void tell(char tag, uint32_t number)
{
    unsigned char record[13];
    record[0] = (unsigned char)tag;
    (void)memcpy(&record[1], &number, sizeof(number));
    (void)memcpy(&record[5], &now, sizeof(now));
    if (fwrite(record, sizeof(record), 1, results) != 1) {
        exit(EXIT_FAILURE); /* nobody reads any more */
    }
}

static void tell_value(char tag, uint32_t number, const unsigned char *bytes, size_t size)
{
    tell(tag, number);
    if (size > 0 && fwrite(bytes, size, 1, results) != 1) {
        exit(EXIT_FAILURE);
    }
}

/* Everything up to here is known, whatever the function does. */
static void tell_call(uint32_t call)
{
    tell('B', call);
    (void)fflush(results);
}

static void tell_row(uint32_t call)
{
    if (has_sent || (call != SIGCAT_NONE)) {
        tell('E', call);
    }
    has_sent = false;
}

void sigcat_sends(uint32_t number, const unsigned char *bytes)
{
    const sigcat_exit *sent = &sigcat_exits[number];
    tell_value('S', number, bytes, sent->size);
    has_sent = true;
    for (uint32_t i = 0; i < sent->count; i++) {
        const sigcat_entry *entry = &sigcat_entries[sent->entries[i]];
        sigcat_functions[entry->function]->receive(entry->number, bytes, now);
    }
}

bool sigcat_is_there(uint32_t function)
{
    return !running_calls[function].is_gone;
}

bool sigcat_serves(uint32_t function, uint32_t method, const unsigned char *arguments, unsigned char *results)
{
    return sigcat_functions[function]->serve(method, arguments, results);
}

void sigcat_stores(uint32_t number, const unsigned char *bytes, size_t size)
{
    tell_value('K', number, bytes, size);
}

const unsigned char *sigcat_take(const unsigned char *from, void *to, size_t size)
{
    (void)memcpy(to, from, size);
    return from + size;
}

unsigned char *sigcat_put(unsigned char *to, const void *from, size_t size)
{
    (void)memcpy(to, from, size);
    return to + size;
}

/* -- the trace --------------------------------------------------------------------------------------------------- */

static void read_next(void)
{
    next.is_there = fread(&next.time, sizeof(next.time), 1, input) == 1
        && fread(&next.entry, sizeof(next.entry), 1, input) == 1
        && next.entry < sigcat_entry_count
        && fread(next.value, sigcat_entries[next.entry].size, 1, input) == 1;
}

static void take(void)
{
    const sigcat_entry *entry = &sigcat_entries[next.entry];
    const sigcat_function *function = sigcat_functions[entry->function];
    if (entry->kind == SIGCAT_GONE) {
        running_calls[entry->function].is_gone = true;
        running_calls[entry->function].is_busy = false;
    } else if (entry->kind == SIGCAT_VALUE) {
        function->receive(entry->number, next.value, now);
    } else if (entry->kind == SIGCAT_DURATION) {
        (void)memcpy(&durations[entry->number], next.value, sizeof(uint64_t));
    } else {
        function->restore(entry->number, next.value);
    }
}

static void take_stored(void)
{
    while (next.is_there && sigcat_entries[next.entry].kind == SIGCAT_STORED) {
        take();
        read_next();
    }
}

static void receive_values(void)
{
    while (next.is_there && next.time <= now) {
        take();
        read_next();
    }
}

/* -- calls ------------------------------------------------------------------------------------------------------- */

static void supervise_function(uint32_t function)
{
    sigcat_functions[function]->supervise(now);
    sigcat_functions[function]->send();
    tell_row(SIGCAT_NONE);
}

/* Whether something is sent. */
static bool end_call(uint32_t function)
{
    running *call = &running_calls[function];
    sigcat_functions[function]->get_output(call->call, now);
    sigcat_functions[function]->send();
    call->is_busy = false;
    const bool sends = has_sent;
    tell_row(sigcat_functions[function]->first + call->call);
    return sends;
}

/* A call that took time: others take what it sends before the next one of the function begins. Whether they have to. */
static bool end_slow_call(uint32_t function)
{
    const bool sends = end_call(function);
    if (sends) {
        supervise_function(function);
    }
    return sends;
}

static void run_call(uint32_t function, uint32_t call)
{
    const sigcat_function *called = sigcat_functions[function];
    const uint32_t number = called->first + call;

    called->set_input(call, now);
    called->begin(call, now);
    called->send();
    tell_call(number);
    called->run(call);
    tell('D', number);

    running_calls[function].call = call;
    running_calls[function].is_busy = true;
    running_calls[function].ends = now + durations[number];
    if (durations[number] == 0) {
        (void)end_call(function);
    } else {
        tell_row(SIGCAT_NONE);
    }
}

/* Functions take turns, in the order of the set; one whose call takes time waits for its end. */
static bool run_calls_once(void)
{
    bool any = false;
    for (uint32_t i = 0; i < sigcat_function_count; i++) {
        if (running_calls[i].is_busy && running_calls[i].ends <= now && end_slow_call(i)) {
            any = true;
            continue;
        }
        if (!running_calls[i].is_busy && !running_calls[i].is_gone) {
            const uint32_t call = sigcat_functions[i]->next_call(now);
            if (call != SIGCAT_NONE) {
                run_call(i, call);
                any = true;
            }
        }
    }
    return any;
}

static bool run_calls(void)
{
    uint32_t rounds = 0;
    while (rounds < ROUNDS && run_calls_once()) {
        rounds++;
    }
    return rounds < ROUNDS;
}

static void supervise(void)
{
    for (uint32_t i = 0; i < sigcat_function_count; i++) {
        if (!running_calls[i].is_gone) {
            supervise_function(i);
        }
    }
}

/* -- time -------------------------------------------------------------------------------------------------------- */

static uint64_t earlier(uint64_t a, uint64_t b)
{
    return (a < b) ? a : b;
}

static uint64_t next_time(void)
{
    uint64_t found = next.is_there ? next.time : UINT64_MAX;
    for (uint32_t i = 0; i < sigcat_function_count; i++) {
        const uint64_t time = sigcat_functions[i]->next_time();
        if (time > now && !running_calls[i].is_gone) { /* what has passed is asked for again when anything happens */
            found = earlier(found, time);
        }
        if (running_calls[i].is_busy) {
            found = earlier(found, running_calls[i].ends);
        }
    }
    return found;
}

static void begin(uint32_t ignition_cycle)
{
    take_stored();
    for (uint32_t i = 0; i < sigcat_function_count; i++) {
        const sigcat_function *function = sigcat_functions[i];
        tell_call(function->init);
        if (!function->start_up(ignition_cycle)) {
            tell('F', i);
        }
        tell('D', function->init);
    }
    for (uint32_t i = 0; i < sigcat_function_count; i++) {
        sigcat_functions[i]->start(now);
        sigcat_functions[i]->send();
        tell_row(sigcat_functions[i]->init);
    }
}

static bool run_until(uint64_t end)
{
    while (now <= end) {
        receive_values();
        if (!run_calls()) {
            return false;
        }
        supervise();
        now = next_time();
    }
    now = end;
    return true;
}

static void finish(void)
{
    for (uint32_t i = 0; i < sigcat_function_count; i++) {
        const sigcat_function *function = sigcat_functions[i];
        if (running_calls[i].is_gone) {
            continue;
        }
        tell_call(function->terminate);
        function->terminate_at(now);
        tell('D', function->terminate);
        function->send();
        tell_row(function->terminate);
        function->store();
    }
}

/* -- the process ------------------------------------------------------------------------------------------------- */

static bool open_files(const char *name)
{
    const int own = dup(1);
    (void)dup2(2, 1);
#if defined(_WIN32)
    (void)_setmode(own, _O_BINARY);
#else
    const struct rlimit none = {0, 0};
    (void)setrlimit(RLIMIT_CORE, &none);
#endif
    results = fdopen(own, "wb");
    input = fopen(name, "rb");
    return results != NULL && input != NULL;
}

static bool make_room(void)
{
    running_calls = calloc(sigcat_function_count, sizeof(*running_calls));
    durations = calloc((size_t)sigcat_call_count + 1U, sizeof(*durations));
    next.value = malloc(sigcat_largest);
    return running_calls != NULL && durations != NULL && next.value != NULL;
}

int main(int count, char **arguments)
{
    if (count != 5 || !open_files(arguments[1]) || !make_room()) {
        return EXIT_FAILURE;
    }
    now = strtoull(arguments[2], NULL, 10);
    const uint64_t end = strtoull(arguments[3], NULL, 10);
    read_next();
    begin((uint32_t)strtoul(arguments[4], NULL, 10));
    if (run_until(end)) {
        finish();
        tell('Z', 0);
    } else {
        tell('L', 0);
    }
    return (fclose(results) == 0) ? EXIT_SUCCESS : EXIT_FAILURE;
}
