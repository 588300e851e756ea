/*
 * How the adapters of a program count time: in microseconds, in 32 bits that wrap around.
 *
 * Part of sigcat: the same file for each function.
 */

#ifndef SIGCAT_CORE_TIME_H
#define SIGCAT_CORE_TIME_H

#include <stdint.h>

/* Nanoseconds of a tick. */
#define SIGCAT_TICK_NS 1000

#ifdef __cplusplus
extern "C" {
#endif

/* A time, or the time between two of them. */
typedef uint32_t Sigcat_Ticks;

/* A time that the platform passes. It is not a number: one in another unit does not compile. */
typedef struct {
    Sigcat_Ticks ticks;
} Sigcat_Time;

/*
 * A time on the steady clock of the platform. Its microseconds wrap around at 2^32, no earlier. From its first time on,
 * a core gets at least one in each 2^30 of them, by any function.
 */
static inline Sigcat_Time Sigcat_Microseconds(uint32_t microseconds)
{
    const Sigcat_Time time = { microseconds };
    return time;
}

#ifdef __cplusplus
}
#endif

#endif /* SIGCAT_CORE_TIME_H */
