/*
 * How the adapters of a program count time: in nanoseconds, in 64 bits.
 *
 * Part of sigcat: the same file for each function.
 */

#ifndef SIGCAT_CORE_TIME_H
#define SIGCAT_CORE_TIME_H

#include <stdint.h>

/* Nanoseconds of a tick. */
#define SIGCAT_TICK_NS 1

/* A time, or the time between two of them. */
typedef uint64_t Sigcat_Ticks;

#endif /* SIGCAT_CORE_TIME_H */
