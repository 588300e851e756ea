/*
 * Functions that the adapters of all functions call. The rules are those of docs/reference/adapter.md.
 *
 * Part of sigcat: the same file for each function. Compile it with -ffp-contract=off. Times are those of
 * sigcat_core_time.h.
 */

#include "sigcat_core_functions.h"

#include <math.h>

#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD != 0)
#error "sigcat: doubles must be evaluated as doubles"
#endif
#if defined(__FAST_MATH__)
#error "sigcat: -ffast-math changes results"
#endif

#if SIGCAT_TICK_NS != 1
/* -- time (section 1) -- */

void Sigcat_CountsInTicks(void)
{
    /* nothing to do: it is there to be linked */
}
#endif

/* -- reception (sections 2 and 3) -- */

void Sigcat_CheckClock(Sigcat_Clock *own_clock, const Sigcat_Reception *reception, Sigcat_Ticks entered,
    Sigcat_Ticks time_out, uint32_t recovery, bool starts_with_first, Sigcat_Ticks now)
{
    const bool is_there = reception->is_there;
    const Sigcat_Ticks last = is_there ? Sigcat_Newer(reception->time, entered, now) : entered;

    if ((is_there || !starts_with_first) && ((now - last) > time_out)) {
        own_clock->is_late = true;
        own_clock->count = reception->count;
    } else if (own_clock->is_late && ((reception->count - own_clock->count) >= recovery)) {
        own_clock->is_late = false;
    } else {
        /* as before */
    }
    if (own_clock->is_late) {
        own_clock->verdict = SIGCAT_PRESENT;
    } else {
        own_clock->verdict = is_there ? SIGCAT_ABSENT : SIGCAT_NOT_JUDGED;
    }
}

uint32_t Sigcat_Push(Sigcat_Queue *queue, uint32_t length)
{
    if (queue->waiting == length) {
        Sigcat_Pop(queue, length);
        queue->is_overflown = true;
    }
    queue->waiting++;
    return (queue->first + queue->waiting - 1U) % length;
}

bool Sigcat_HasPlace(Sigcat_Queue *queue, uint32_t length)
{
    const bool has_place = queue->waiting < length;

    queue->is_overflown = queue->is_overflown || !has_place;
    return has_place;
}

void Sigcat_Pop(Sigcat_Queue *queue, uint32_t length)
{
    queue->first = (queue->first + 1U) % length;
    queue->waiting--;
}

/* -- numbers (section 4) -- */

const float Sigcat_NanFloat = NAN;

#if SIGCAT_FLOAT_ARITHMETIC == 1

/* The upper half of the digits: the product of two halves is exact. */
static float UpperHalf(float value)
{
    uint32_t bits;
    float half;

    (void)memcpy(&bits, &value, sizeof(bits));
    bits &= 0xFFFFF000U;
    (void)memcpy(&half, &bits, sizeof(half));
    return half;
}

/* Larger ones are not split: a product of their halves could be infinite, and the offset does not change them. */
static const float LargestSplit = 8.507059e37F;

float Sigcat_Scaled(float value, float value_rest, float factor, float factor_rest, float offset, float offset_rest)
{
    const float product = value * factor;
    float result = product;

    if ((product >= -LargestSplit) && (product <= LargestSplit)) {
        const float upper = UpperHalf(value);
        const float lower = value - upper;
        const float factor_upper = UpperHalf(factor);
        const float factor_lower = factor - factor_upper;
        /* What the rounding of the product lost, exactly (Dekker). */
        const float upper_lost = ((upper * factor_upper) - product) + (upper * factor_lower);
        const float product_lost = (upper_lost + (lower * factor_upper)) + (lower * factor_lower);
        const float product_rest = product_lost + ((value * factor_rest) + (value_rest * factor));
        /* What the rounding of the sum lost, exactly (Knuth). */
        const float sum = product + offset;
        const float added = sum - product;
        const float sum_lost = (product - (sum - added)) + (offset - added);

        result = sum + (sum_lost + (product_rest + offset_rest));
    }
    return result;
}

float Sigcat_BeyondFloat(float value, float source)
{
    const bool is_finite = (source >= -FLT_MAX) && (source <= FLT_MAX);
    float found;

    if (value > 0.0F) {
        found = is_finite ? FLT_MAX : INFINITY;
    } else if (value < 0.0F) {
        found = is_finite ? -FLT_MAX : -INFINITY;
    } else {
        found = NAN;
    }
    return found;
}

/* From here on, each float is an integer. */
static const float Whole = 8388608.0F;

/* The nearest integer, ties to even: a sum with this number has no digits after the point. */
static float RoundedToEven(float value)
{
    float rounded = value;

    if ((value >= 0.0F) && (value < Whole)) {
        const float sum = value + Whole;
        rounded = sum - Whole;
    } else if ((value < 0.0F) && (value > -Whole)) {
        const float sum = value - Whole;
        rounded = sum + Whole;
    } else {
        /* it is an integer */
    }
    return rounded;
}

#else

const double Sigcat_NanDouble = (double)NAN;

float Sigcat_BeyondFloat(double value)
{
    float found;

    if (value > DBL_MAX) {
        found = INFINITY;
    } else if (value < -DBL_MAX) {
        found = -INFINITY;
    } else if (value > 0.0) {
        found = FLT_MAX;
    } else if (value < 0.0) {
        found = -FLT_MAX;
    } else {
        found = NAN;
    }
    return found;
}

/* The nearest integer, ties to even. */
static int64_t RoundedToEven(double value)
{
    int64_t whole = (int64_t)value;
    const double rest = value - (double)whole;
    const bool is_odd = (whole % 2) != 0;

    if ((rest > 0.5) || ((rest == 0.5) && is_odd)) {
        whole++;
    } else if ((rest < -0.5) || ((rest == -0.5) && is_odd)) {
        whole--;
    } else {
        /* it is the nearest one */
    }
    return whole;
}

#endif

int32_t Sigcat_ToSigned(Sigcat_Real value, int32_t least, int32_t most, int32_t instead_of_nan)
{
    int32_t rounded;

    if (value != value) {
        rounded = instead_of_nan;
    } else if (value <= (Sigcat_Real)least) {
        rounded = least;
    } else if (value >= (Sigcat_Real)most) {
        rounded = most;
    } else {
        rounded = (int32_t)RoundedToEven(value);
    }
    return rounded;
}

uint32_t Sigcat_ToUnsigned(Sigcat_Real value, uint32_t most, uint32_t instead_of_nan)
{
    uint32_t rounded;

    if (value != value) {
        rounded = instead_of_nan;
    } else if (value <= (Sigcat_Real)0) {
        rounded = 0U;
    } else if (value >= (Sigcat_Real)most) {
        rounded = most;
    } else {
        rounded = (uint32_t)RoundedToEven(value);
    }
    return rounded;
}

int64_t Sigcat_ToInt64(Sigcat_Real value, int64_t instead_of_nan)
{
    int64_t rounded;

    if (value != value) {
        rounded = instead_of_nan;
    } else if (value <= -(Sigcat_Real)9223372036854775808.0) {
        rounded = INT64_MIN;
    } else if (value >= (Sigcat_Real)INT64_MAX) {
        rounded = INT64_MAX;
    } else {
        rounded = (int64_t)RoundedToEven(value);
    }
    return rounded;
}

uint64_t Sigcat_ToUint64(Sigcat_Real value, uint64_t instead_of_nan)
{
    uint64_t rounded;

    if (value != value) {
        rounded = instead_of_nan;
    } else if (value <= (Sigcat_Real)0) {
        rounded = 0U;
    } else if (value >= (Sigcat_Real)UINT64_MAX) {
        rounded = UINT64_MAX;
    } else {
        /* Larger ones are whole. */
        rounded = (value < (Sigcat_Real)INT64_MAX) ? (uint64_t)RoundedToEven(value) : (uint64_t)value;
    }
    return rounded;
}

/* -- errors: debounce by maturation and reset times, and confirmation (section 6) -- */

/* The table of states. */
static Sigcat_ErrorState NextState(const Sigcat_Error *error, Sigcat_Verdict verdict, bool may_heal)
{
    const bool has_failed = Sigcat_HasFailed(error);
    Sigcat_ErrorState next = error->state;

    if (verdict == SIGCAT_PRESENT) {
        next = has_failed ? SIGCAT_FAILED : SIGCAT_PREFAILED;
    } else if ((verdict == SIGCAT_ABSENT) && !has_failed) {
        next = SIGCAT_PASSED;
    } else if (verdict == SIGCAT_ABSENT) {
        next = may_heal ? SIGCAT_HEALING : SIGCAT_FAILED;
    } else {
        /* not evaluated */
    }
    return next;
}

void Sigcat_Evaluate(Sigcat_Error *error, Sigcat_Counts *counts, const Sigcat_ErrorSettings *settings,
    Sigcat_Verdict verdict, bool has_cause, bool may_heal, Sigcat_Ticks now)
{
    const bool had_failed = Sigcat_HasFailed(error);
    const Sigcat_ErrorState next = has_cause ? SIGCAT_FAILED : NextState(error, verdict, may_heal);

    if (next != error->state) {
        error->before = error->state;
        error->state = next;
        error->since = now;
    }
    if ((error->state == SIGCAT_PREFAILED) && ((now - error->since) >= settings->maturation)) {
        error->state = SIGCAT_FAILED;
    }
    if ((error->state == SIGCAT_HEALING) && ((now - error->since) >= settings->reset)) {
        error->state = SIGCAT_PASSED;
    }
    if (Sigcat_HasFailed(error) && !had_failed && (counts->occurrences < UINT16_MAX)) {
        counts->occurrences++;
    }
    counts->is_tested = counts->is_tested || (error->state != SIGCAT_NOT_TESTED);
    counts->has_failed = counts->has_failed || Sigcat_HasFailed(error);
    error->is_confirmed = Sigcat_IsConfirmed(counts, settings);
}

void Sigcat_Suspend(Sigcat_Error *error)
{
    if (error->state == SIGCAT_PREFAILED) {
        error->state = error->before;
    } else if (error->state == SIGCAT_HEALING) {
        error->state = SIGCAT_FAILED;
    } else {
        /* as it is */
    }
}

void Sigcat_BeginCycle(Sigcat_Counts *counts)
{
    if (counts->has_failed) {
        if (counts->ignition_cycles < UINT16_MAX) {
            counts->ignition_cycles++;
        }
    } else if (counts->is_tested) {
        counts->ignition_cycles = 0U;
    } else {
        /* nothing is known of it */
    }
    counts->has_failed = false;
    counts->is_tested = false;
}

/* -- schedule (section 9) -- */

uint32_t Sigcat_Added(uint32_t sum, Sigcat_Ticks more)
{
    return (more > ((Sigcat_Ticks)UINT32_MAX - sum)) ? UINT32_MAX : (sum + (uint32_t)more);
}

Sigcat_Ticks Sigcat_Release(Sigcat_Ticks *release, Sigcat_Ticks cycle, Sigcat_Ticks now)
{
    const Sigcat_Ticks releases = ((now - *release) / cycle) + 1U;

    *release += releases * cycle;
    return releases;
}

void Sigcat_DropUpTo(Sigcat_Ticks *release, uint32_t *dropped, Sigcat_Ticks cycle, Sigcat_Ticks now)
{
    if (Sigcat_IsReached(*release, now)) {
        *dropped = Sigcat_Added(*dropped, Sigcat_Release(release, cycle, now));
    }
}

void Sigcat_DropBefore(Sigcat_Ticks *release, uint32_t *dropped, Sigcat_Ticks cycle, Sigcat_Ticks now)
{
    if (!Sigcat_IsReached(now, *release)) {
        *dropped = Sigcat_Added(*dropped, Sigcat_Release(release, cycle, now - 1U));
    }
}

/* -- supervision (section 10) -- */

void Sigcat_EnterAlive(Sigcat_Alive *alive, Sigcat_Ticks now)
{
    Sigcat_ResetAlive(alive);
    alive->window = now;
    alive->ends = 0U;
}

void Sigcat_ResetAlive(Sigcat_Alive *alive)
{
    alive->verdict = SIGCAT_NOT_JUDGED;
    alive->has_closed = false;
    alive->is_bad = false;
}

void Sigcat_CloseWindow(Sigcat_Alive *alive, Sigcat_Ticks length, uint32_t least, uint32_t most, Sigcat_Ticks now)
{
    if (Sigcat_IsReached(alive->window + length, now)) {
        const Sigcat_Ticks windows = (now - alive->window) / length;
        const bool is_missed = (least > 0U) && (windows > 1U);

        alive->is_bad = alive->is_bad || (alive->ends > most) || (alive->ends < least) || is_missed;
        alive->has_closed = true;
        alive->window += windows * length;
        alive->ends = 0U;
    }
}

void Sigcat_CheckWindows(Sigcat_Alive *alive)
{
    if (alive->has_closed) {
        alive->verdict = alive->is_bad ? SIGCAT_PRESENT : SIGCAT_ABSENT;
        alive->has_closed = false;
        alive->is_bad = false;
    }
}
