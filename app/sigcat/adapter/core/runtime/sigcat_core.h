/*
 * What the adapters of all functions hold. The rules are those of docs/reference/adapter.md.
 *
 * Part of sigcat: the same file for each function. Times are those of sigcat_core_time.h.
 */

#ifndef SIGCAT_CORE_H
#define SIGCAT_CORE_H

#include <stdbool.h>
#include <stdint.h>

#include "sigcat_core_arithmetic.h"
#include "sigcat_core_time.h"

/* An adapter and this file belong together if both have the same number. */
#define SIGCAT_CORE_VERSION 1

#ifdef __cplusplus
extern "C" {
#endif

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
    Sigcat_Ticks since; /* when it began */
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

/* Times that debounce an error, and counts that confirm it. */
typedef struct {
    Sigcat_Ticks maturation;
    Sigcat_Ticks reset;
    uint32_t occurrences;
    uint32_t ignition_cycles;
} Sigcat_ErrorSettings;

/* When a value was received last, and how many there were. */
typedef struct {
    Sigcat_Ticks time;
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
    Sigcat_Ticks window; /* its beginning */
    uint32_t ends; /* in this window */
    bool has_closed; /* whether one has since it was checked */
    bool is_bad; /* whether one of those was */
} Sigcat_Alive;

#ifdef __cplusplus
}
#endif

#endif /* SIGCAT_CORE_H */
