/*
 * What the adapters of all functions hold. The rules are those of docs/reference/adapter.md.
 *
 * Part of sigcat: the same file for each function. All times are in microseconds.
 */

#ifndef SIGCAT_CORE_H
#define SIGCAT_CORE_H

#include <stdbool.h>
#include <stdint.h>

#include "sigcat_core_arithmetic.h"

/* An adapter and this file belong together if both have the same number. */
#define SIGCAT_CORE_VERSION 1

#ifdef __cplusplus
extern "C" {
#endif

/* Nanoseconds of a tick. */
#define SIGCAT_TICK_NS 1000

/* A time that the platform passes. It is not a number: one in another unit does not compile. */
typedef struct {
    uint32_t ticks;
} Sigcat_Time;

/*
 * A time on the steady clock of the platform. Its microseconds wrap around after 32 bits, so a core that runs
 * gets at least one time in each 2^30 of them.
 */
static inline Sigcat_Time Sigcat_Microseconds(uint32_t microseconds)
{
    const Sigcat_Time time = { microseconds };
    return time;
}

/* Whether an error is there. The larger one is the worse one. */
typedef enum {
    SIGCAT_NOT_JUDGED = 0,
    SIGCAT_ABSENT,
    SIGCAT_PRESENT
} Sigcat_Verdict;

/* Origin of the value of an input or a parameter (sections 3 and 5). */
typedef enum {
    SIGCAT_INIT,
    SIGCAT_RECEIVED,
    SIGCAT_DEFAULT,
    SIGCAT_REPLACEMENT
} Sigcat_Origin;

/* State of an error (section 6). */
typedef enum {
    SIGCAT_NOT_TESTED = 0,
    SIGCAT_PASSED,
    SIGCAT_PREFAILED,
    SIGCAT_FAILED,
    SIGCAT_HEALING
} Sigcat_ErrorState;

/* Reply to a request (section 12). */
typedef enum {
    SIGCAT_OK,
    SIGCAT_EXCLUDED, /* the mode excludes it, or init has failed */
    SIGCAT_BAD_ARGUMENT
} Sigcat_Reply;

/* An error. */
typedef struct {
    Sigcat_ErrorState state;
    Sigcat_ErrorState before; /* the last one */
    uint32_t since; /* when it began */
    Sigcat_Verdict variable; /* what the function says */
    bool is_confirmed; /* for the fault memory */
    bool is_sent;
} Sigcat_Error;

/* Counts of an error, over ignition cycles; the flags are of this one. */
typedef struct {
    uint16_t occurrences;
    uint16_t ignition_cycles;
    bool has_failed;
    bool is_tested;
} Sigcat_Counts;

/* Times that debounce an error, in microseconds, and counts that confirm it. */
typedef struct {
    uint32_t maturation;
    uint32_t reset;
    uint32_t occurrences;
    uint32_t ignition_cycles;
} Sigcat_ErrorSettings;

/* When a value was received last, and how many there were. */
typedef struct {
    uint32_t time;
    uint32_t count;
    bool is_there;
} Sigcat_Reception;

/* Whether a value is late (section 3). */
typedef struct {
    Sigcat_Verdict verdict;
    uint32_t count;
    bool is_late;
} Sigcat_Clock;

/* Places of a ring of values that wait. */
typedef struct {
    uint32_t first;
    uint32_t waiting;
    bool is_overflown;
} Sigcat_Queue;

/* How often a call ends in each window of time (section 10). */
typedef struct {
    Sigcat_Verdict verdict;
    uint32_t window; /* its beginning */
    uint32_t ends; /* in this window */
    bool has_closed; /* whether one has since it was checked */
    bool is_bad; /* whether one of those was */
} Sigcat_Alive;

#ifdef __cplusplus
}
#endif

#endif /* SIGCAT_CORE_H */
