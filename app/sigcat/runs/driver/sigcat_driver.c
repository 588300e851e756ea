/*
 * Runs functions in simulated time: `driver INPUT RESULTS START END IGNITION_CYCLE ECHO MEMORY FILES`.
 *
 * INPUT has records of an entry and a value, by time; the entry SIGCAT_NONE has the time of those that follow.
 * RESULTS is a file that both processes map: records of a tag, a number, a time and a value. No descriptor leads to it.
 * ECHO is 1 if RESULTS repeats what is received. MEMORY and FILES limit, in bytes, what the process may allocate beyond
 * what it starts with, and the size of a file that it writes; 0: unlimited. Times are in nanoseconds. What the
 * functions print goes to standard error.
 */

#if !defined(_WIN32)
#define _POSIX_C_SOURCE 200809L
#endif

#include "sigcat_driver.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#if defined(_WIN32)
#include <io.h>
#include <windows.h>
#include <fcntl.h>
#else
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

#define SIGCAT_RING_HEAD 128U /* bytes before those of the ring: how many were written, and how many were taken */
#define ROUNDS 100000U /* of calls at one time; after so many, they trigger each other without end */

typedef struct {
    void *state;
    uint64_t ends;
    uint32_t call;
    bool is_busy;
    bool is_gone; /* nothing of it is called any more, not even its end */
} running;

static uint64_t now;
static uint64_t rows; /* that were reported */
static bool is_echoing;
static bool has_sent;
static running *running_calls;
static uint64_t *durations; /* of calls */

static struct {
    uint64_t time;
    uint32_t entry;
    const unsigned char *value;
    bool is_there;
} next;

/* -- what happens ------------------------------------------------------------------------------------------------ */

/* A ring that the process that reads it maps, too: what is in it stays there, however this one ends. */
static struct {
    uint64_t *written; /* bytes in all */
    const uint64_t *taken;
    unsigned char *bytes;
    uint64_t size;
} results;

static void wait_for_room(uint64_t written)
{
#if defined(_WIN32)
    while (written - __atomic_load_n(results.taken, __ATOMIC_ACQUIRE) >= results.size) {
        Sleep(1U);
    }
#else
    static pid_t reader;
    if (reader == 0) {
        reader = getppid();
    }
    while (written - __atomic_load_n(results.taken, __ATOMIC_ACQUIRE) >= results.size) {
        const struct timespec moment = {0, 50000};
        if (getppid() != reader) {
            _exit(EXIT_FAILURE); /* the reader has gone */
        }
        (void)nanosleep(&moment, NULL);
    }
#endif
}

static void put(const void *bytes, size_t size)
{
    const unsigned char *from = bytes;
    uint64_t written = *results.written;
    while (size > 0U) {
        uint64_t room;
        wait_for_room(written);
        room = results.size - (written - __atomic_load_n(results.taken, __ATOMIC_ACQUIRE));
        room = (room < size) ? room : size;
        room = (room < results.size - written % results.size) ? room : results.size - written % results.size;
        (void)memcpy(&results.bytes[written % results.size], from, room);
        from += room;
        size -= room;
        written += room;
        __atomic_store_n(results.written, written, __ATOMIC_RELEASE);
    }
}

static void report(char tag, uint32_t number)
{
    unsigned char record[13];
    record[0] = (unsigned char)tag;
    (void)memcpy(&record[1], &number, sizeof(number));
    (void)memcpy(&record[5], &now, sizeof(now));
    put(record, sizeof(record));
}

static void report_value(char tag, uint32_t number, const unsigned char *bytes, size_t size)
{
    report(tag, number);
    put(bytes, size);
}

/* Rows are numbered: the process that reads them knows if one is missing. */
static void report_row(uint32_t call)
{
    if (has_sent || (call != SIGCAT_NONE)) {
        report_value('E', call, (const unsigned char *)&rows, sizeof(rows));
        rows++;
    }
    has_sent = false;
}

static void sends(void *self, uint32_t number, const unsigned char *bytes)
{
    const sigcat_exit *sent = &sigcat_exits[number];
    (void)self;
    report_value('S', number, bytes, sent->size);
    has_sent = true;
    for (uint32_t i = 0; i < sent->count; i++) {
        const sigcat_entry *entry = &sigcat_entries[sent->entries[i]];
        sigcat_functions[entry->function]->receive(running_calls[entry->function].state, entry->number, bytes, now);
    }
}

static void stores(void *self, uint32_t number, const unsigned char *bytes, size_t size)
{
    (void)self;
    report_value('K', number, bytes, size);
}

static bool is_there(void *self, uint32_t function)
{
    (void)self;
    return !running_calls[function].is_gone;
}

static bool serves(void *self, uint32_t function, uint32_t method, const unsigned char *arguments, unsigned char *answer)
{
    (void)self;
    return sigcat_functions[function]->serve(running_calls[function].state, method, arguments, answer);
}

static const sigcat_host host = {NULL, sends, stores, is_there, serves};

/* -- the trace --------------------------------------------------------------------------------------------------- */

static struct {
    int file;
    unsigned char *bytes;
    size_t size, at, end;
} input;

/* So many bytes, which stay until the next ones are asked for; NULL at the end of the file. */
static const unsigned char *read_bytes(size_t size)
{
    const unsigned char *found;
    while (input.end - input.at < size) {
        long count;
        (void)memmove(input.bytes, &input.bytes[input.at], input.end - input.at);
        input.end -= input.at;
        input.at = 0;
        count = (long)read(input.file, &input.bytes[input.end], (unsigned)(input.size - input.end));
        if (count < 0) {
            _exit(EXIT_FAILURE);
        }
        if (count == 0) {
            return NULL;
        }
        input.end += (size_t)count;
    }
    found = &input.bytes[input.at];
    input.at += size;
    return found;
}

static bool read_entry(void)
{
    const unsigned char *found = read_bytes(sizeof(next.entry));
    if (found != NULL) {
        (void)memcpy(&next.entry, found, sizeof(next.entry));
    }
    return found != NULL;
}

static void read_next(void)
{
    next.is_there = read_entry();
    while (next.is_there && next.entry == SIGCAT_NONE) {
        const unsigned char *found = read_bytes(sizeof(next.time));
        if (found != NULL) {
            (void)memcpy(&next.time, found, sizeof(next.time));
        }
        next.is_there = found != NULL && read_entry();
    }
    if (next.is_there) {
        next.value = (next.entry < sigcat_entry_count) ? read_bytes(sigcat_entries[next.entry].size) : NULL;
        if (next.value == NULL) {
            _exit(EXIT_FAILURE);
        }
    }
}

static void take(void)
{
    const sigcat_entry *entry = &sigcat_entries[next.entry];
    const sigcat_function *function = sigcat_functions[entry->function];
    void *const state = running_calls[entry->function].state;
    if (entry->kind == SIGCAT_GONE) {
        running_calls[entry->function].is_gone = true;
        running_calls[entry->function].is_busy = false;
    } else if (entry->kind == SIGCAT_VALUE) {
        if (is_echoing) {
            report_value('R', next.entry, next.value, entry->size);
        }
        function->receive(state, entry->number, next.value, now);
    } else if (entry->kind == SIGCAT_DURATION) {
        (void)memcpy(&durations[entry->number], next.value, sizeof(uint64_t));
    } else {
        function->restore(state, entry->number, next.value);
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
    void *const state = running_calls[function].state;
    sigcat_functions[function]->supervise(state, now);
    sigcat_functions[function]->send(state, &host);
    report_row(SIGCAT_NONE);
}

/* Whether something is sent. */
static bool end_call(uint32_t function)
{
    running *call = &running_calls[function];
    sigcat_functions[function]->get_output(call->state, call->call, now);
    sigcat_functions[function]->send(call->state, &host);
    call->is_busy = false;
    const bool sends = has_sent;
    report_row(sigcat_functions[function]->first + call->call);
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
    void *const state = running_calls[function].state;

    called->set_input(state, call, now);
    called->begin(state, call, now);
    called->send(state, &host);
    report('B', number);
    called->run(state, call);
    report('D', number);

    running_calls[function].call = call;
    running_calls[function].is_busy = true;
    running_calls[function].ends = now + durations[number];
    if (durations[number] == 0) {
        (void)end_call(function);
    } else {
        report_row(SIGCAT_NONE);
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
            const uint32_t call = sigcat_functions[i]->next_call(running_calls[i].state, now);
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
        const uint64_t time = sigcat_functions[i]->next_time(running_calls[i].state);
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
        report('B', function->init);
        if (!function->start_up(running_calls[i].state, ignition_cycle)) {
            report('F', i);
        }
        report('D', function->init);
    }
    for (uint32_t i = 0; i < sigcat_function_count; i++) {
        sigcat_functions[i]->start(running_calls[i].state, now);
        sigcat_functions[i]->send(running_calls[i].state, &host);
        report_row(sigcat_functions[i]->init);
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
        report('B', function->terminate);
        function->terminate_at(running_calls[i].state, now);
        report('D', function->terminate);
        function->send(running_calls[i].state, &host);
        report_row(function->terminate);
        function->store(running_calls[i].state, &host);
    }
}

/* -- the process ------------------------------------------------------------------------------------------------- */

#if defined(_WIN32)
static bool map_results(const char *name)
{
    const HANDLE file = CreateFileA(name, GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, NULL,
                                    OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, NULL);
    const HANDLE mapping = CreateFileMappingA(file, NULL, PAGE_READWRITE, 0, 0, NULL);
    results.size = (uint64_t)GetFileSize(file, NULL) - SIGCAT_RING_HEAD;
    results.written = mapping != NULL ? MapViewOfFile(mapping, FILE_MAP_ALL_ACCESS, 0, 0, 0) : NULL;
    return results.written != NULL;
}

static bool open_input(const char *name)
{
    input.file = _open(name, _O_RDONLY | _O_BINARY);
    return input.file >= 0;
}

static void limit(uint64_t memory, uint64_t files)
{
    (void)memory; /* a job object would be it */
    (void)files;
}
#else
static bool map_results(const char *name)
{
    struct stat status;
    const int file = open(name, O_RDWR | O_CLOEXEC);
    void *mapped = MAP_FAILED;
    if (file >= 0 && fstat(file, &status) == 0) {
        results.size = (uint64_t)status.st_size - SIGCAT_RING_HEAD;
        mapped = mmap(NULL, (size_t)status.st_size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        (void)close(file);
    }
    results.written = (mapped != MAP_FAILED) ? mapped : NULL;
    return mapped != MAP_FAILED;
}

/* The trace is read by a descriptor above those that the process may open from then on. */
static bool open_input(const char *name)
{
    struct rlimit files;
    const int low = open(name, O_RDONLY | O_CLOEXEC);
    if (low < 0 || getrlimit(RLIMIT_NOFILE, &files) != 0 || files.rlim_cur < 64U) {
        return false;
    }
    files.rlim_cur = (files.rlim_cur > 4096U) ? 4096U : files.rlim_cur;
    input.file = fcntl(low, F_DUPFD_CLOEXEC, (int)files.rlim_cur - 1);
    (void)close(low);
    files.rlim_cur--;
    return input.file >= 0 && setrlimit(RLIMIT_NOFILE, &files) == 0;
}

static uint64_t bytes_at_start(void)
{
    unsigned long pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (file != NULL) {
        (void)fscanf(file, "%lu", &pages);
        (void)fclose(file);
    }
    return (uint64_t)pages * (uint64_t)sysconf(_SC_PAGESIZE);
}

static void limit_one(int what, uint64_t most)
{
    struct rlimit found;
    if (getrlimit(what, &found) == 0 && (rlim_t)most < found.rlim_max) {
        found.rlim_cur = (rlim_t)most;
        found.rlim_max = (rlim_t)most;
        (void)setrlimit(what, &found);
    }
}

static void limit(uint64_t memory, uint64_t files)
{
    limit_one(RLIMIT_CORE, 0U);
    if (memory > 0U) {
        limit_one(RLIMIT_AS, bytes_at_start() + memory);
    }
    if (files > 0U) {
        limit_one(RLIMIT_FSIZE, files);
    }
}
#endif

static bool open_files(const char *trace, const char *ring)
{
    if (!map_results(ring) || !open_input(trace)) {
        return false;
    }
    results.taken = &results.written[SIGCAT_RING_HEAD / 2U / sizeof(uint64_t)];
    results.bytes = (unsigned char *)results.written + SIGCAT_RING_HEAD;
    return true;
}

static bool make_room(void)
{
    running_calls = calloc(sigcat_function_count, sizeof(*running_calls));
    durations = calloc((size_t)sigcat_call_count + 1U, sizeof(*durations));
    input.size = (sigcat_largest > 65536U) ? sigcat_largest : 65536U;
    input.bytes = malloc(input.size);
    return running_calls != NULL && durations != NULL && input.bytes != NULL;
}

static bool create_functions(void)
{
    bool is_whole = true;
    for (uint32_t i = 0; i < sigcat_function_count; i++) {
        running_calls[i].state = sigcat_functions[i]->create();
        is_whole = is_whole && running_calls[i].state != NULL;
    }
    return is_whole;
}

int main(int count, char **arguments)
{
    if (count != 9 || !open_files(arguments[1], arguments[2]) || !make_room() || !create_functions()) {
        return EXIT_FAILURE;
    }
    now = strtoull(arguments[3], NULL, 10);
    const uint64_t end = strtoull(arguments[4], NULL, 10);
    is_echoing = arguments[6][0] == '1';
    limit(strtoull(arguments[7], NULL, 10), strtoull(arguments[8], NULL, 10));
    read_next();
    begin((uint32_t)strtoul(arguments[5], NULL, 10));
    if (run_until(end)) {
        finish();
        report('Z', 0);
    } else {
        report('L', 0);
    }
    return EXIT_SUCCESS;
}
