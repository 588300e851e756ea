/*
 * Functions of times that do not wrap around.
 *
 * Part of sigcat: the same file for each function.
 */

#ifndef SIGCAT_CORE_CLOCK_H
#define SIGCAT_CORE_CLOCK_H

#include "sigcat_core.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The time: one before the last one counts as the last one. */
static inline Sigcat_Ticks Sigcat_Now(Sigcat_Ticks *now, Sigcat_Ticks t)
{
    if (t > *now) {
        *now = t;
    }
    return *now;
}

/* Whether a time is now or over. */
static inline bool Sigcat_IsReached(Sigcat_Ticks time, Sigcat_Ticks now)
{
    return now >= time;
}

/* The newer one of two times that are over. */
static inline Sigcat_Ticks Sigcat_Newer(Sigcat_Ticks a, Sigcat_Ticks b, Sigcat_Ticks now)
{
    (void)now;
    return (a > b) ? a : b;
}

#ifdef __cplusplus
}
#endif

#endif /* SIGCAT_CORE_CLOCK_H */
