/*
 * Functions of times that are ticks in 32 bits, which wrap around.
 *
 * Part of sigcat: the same file for each function.
 */

#ifndef SIGCAT_CORE_CLOCK_H
#define SIGCAT_CORE_CLOCK_H

#include "sigcat_core.h"

/* Half of the range: a time that is less ahead is later than another one. */
#define SIGCAT_HALF UINT32_C(0x80000000)

/* Times that are over stay about as near as this, which is longer than each declared time. */
#define SIGCAT_KEPT UINT32_C(0x20000000)

#ifdef __cplusplus
extern "C" {
#endif

/* In the shared file of cores with ticks alone: with that of others, a program does not link. */
void Sigcat_CountsInTicks(void);

/* Whether a time is now or over. */
static inline bool Sigcat_IsReached(Sigcat_Ticks time, Sigcat_Ticks now)
{
    return (now - time) < SIGCAT_HALF;
}

/* The newer one of two times that are over. */
static inline Sigcat_Ticks Sigcat_Newer(Sigcat_Ticks a, Sigcat_Ticks b, Sigcat_Ticks now)
{
    const Sigcat_Ticks age_of_a = now - a;
    const Sigcat_Ticks age_of_b = now - b;

    return (age_of_a < age_of_b) ? a : b;
}

/* Ticks until a time; none if it is over. */
static inline Sigcat_Ticks Sigcat_Until(Sigcat_Ticks time, Sigcat_Ticks now)
{
    return Sigcat_IsReached(time, now) ? 0U : (time - now);
}

/*
 * The time: one before the last one counts as the last one. Any may be the first one. Returns whether times that are
 * long over have to be kept near.
 */
static inline bool Sigcat_Advance(Sigcat_Ticks *now, bool *has_time, Sigcat_Time t)
{
    const Sigcat_Ticks last = *has_time ? *now : t.ticks;

    *now = Sigcat_IsReached(last, t.ticks) ? t.ticks : last;
    *has_time = true;
    return (last / SIGCAT_KEPT) != (*now / SIGCAT_KEPT);
}

/* A time that is long over comes nearer, so that it stays over. */
static inline void Sigcat_KeepNear(Sigcat_Ticks *time, Sigcat_Ticks now)
{
    if ((now - *time) > SIGCAT_KEPT) {
        *time = now - SIGCAT_KEPT;
    }
}

/* A window that began long ago comes nearer by whole windows. More than one of them stay to be closed. */
static inline void Sigcat_KeepWindowNear(Sigcat_Ticks *window, Sigcat_Ticks length, Sigcat_Ticks now)
{
    const Sigcat_Ticks age = Sigcat_IsReached(*window, now) ? (now - *window) : 0U;

    if (age > SIGCAT_KEPT) {
        *window += ((age / length) - 2U) * length;
    }
}

/* Skipped releases are counted: it is known now what has become of them. The count stays at the largest number. */
static inline void Sigcat_CountSkipped(uint32_t *count, uint32_t *skipped)
{
    *count = (*skipped > (UINT32_MAX - *count)) ? UINT32_MAX : (*count + *skipped);
    *skipped = 0U;
}

/* Releases that are long over are skipped. One of them stays, and the grid. */
static inline void Sigcat_CatchUp(Sigcat_Ticks *release, uint32_t *skipped, Sigcat_Ticks cycle, Sigcat_Ticks now)
{
    const Sigcat_Ticks late = Sigcat_IsReached(*release, now) ? (now - *release) : 0U;

    if (late > SIGCAT_KEPT) {
        uint32_t releases = (late / cycle) - 1U;

        *release += releases * cycle;
        Sigcat_CountSkipped(skipped, &releases);
    }
}

#ifdef __cplusplus
}
#endif

#endif /* SIGCAT_CORE_CLOCK_H */
