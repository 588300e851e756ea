/* The rules of docs/reference/adapter.md, one by one, on functions that all cores share. Returns 1 at the first that fails. */

#include <math.h>
#include <stdio.h>

#include "sigcat_core_functions.h"

#define HOLDS(condition) \
    do { \
        if (!(condition)) { \
            (void)printf("%s:%d: %s\n", __FILE__, __LINE__, #condition); \
            return 1; \
        } \
    } while (0)

#if SIGCAT_TICK_NS > 1
#include "tick_cases.h"
#else
static int time_never_goes_back(void)
{
    uint64_t now = 5U;

    HOLDS(Sigcat_Now(&now, 7U) == 7U);
    HOLDS(Sigcat_Now(&now, 3U) == 7U);
    HOLDS(Sigcat_Now(&now, 7U) == 7U);
    HOLDS(Sigcat_Added(1U, UINT64_MAX) == UINT32_MAX);
    return 0;
}

static int time_wraps_around(void)
{
    return 0;
}
#endif

static int times_have_an_order(void)
{
    HOLDS(Sigcat_Earlier(1U, 2U) == 1U && Sigcat_Earlier(2U, 1U) == 1U);
    HOLDS(Sigcat_Later(1U, 2U) == 2U && Sigcat_Later(2U, 1U) == 2U);
    HOLDS(Sigcat_IsReached(5U, 5U) && Sigcat_IsReached(5U, 6U) && !Sigcat_IsReached(5U, 4U));
    HOLDS(Sigcat_Newer(1U, 2U, 3U) == 2U && Sigcat_Newer(2U, 1U, 3U) == 2U);
    return 0;
}

static int a_value_is_late_after_its_time_out(void)
{
    Sigcat_Clock clock = { SIGCAT_NOT_JUDGED, 0U, false };
    Sigcat_Reception reception = { 0U, 0U, false };

    Sigcat_CheckClock(&clock, &reception, 100U, 50U, 2U, false, 150U);
    HOLDS(!clock.is_late && clock.verdict == SIGCAT_NOT_JUDGED);
    Sigcat_CheckClock(&clock, &reception, 100U, 50U, 2U, false, 151U);
    HOLDS(clock.is_late && clock.verdict == SIGCAT_PRESENT);
    Sigcat_Receive(&reception, 152U);
    HOLDS(reception.time == 152U && reception.count == 1U && reception.is_there);
    Sigcat_CheckClock(&clock, &reception, 100U, 50U, 2U, false, 153U);
    HOLDS(clock.is_late);
    Sigcat_Receive(&reception, 154U);
    Sigcat_CheckClock(&clock, &reception, 100U, 50U, 2U, false, 155U);
    HOLDS(!clock.is_late && clock.verdict == SIGCAT_ABSENT);
    Sigcat_CheckClock(&clock, &reception, 300U, 50U, 2U, false, 350U);
    HOLDS(!clock.is_late);
    Sigcat_CheckClock(&clock, &reception, 0U, 50U, 2U, false, 204U);
    HOLDS(!clock.is_late);
    Sigcat_CheckClock(&clock, &reception, 0U, 50U, 2U, false, 205U);
    HOLDS(clock.is_late && clock.count == 2U);
    Sigcat_Receive(&reception, 206U);
    Sigcat_CheckClock(&clock, &reception, 0U, 50U, 2U, false, 300U);
    Sigcat_Receive(&reception, 301U);
    Sigcat_CheckClock(&clock, &reception, 0U, 50U, 2U, false, 302U);
    HOLDS(clock.is_late); /* late again: one more value is needed */
    return 0;
}

static int a_clock_may_start_with_the_first_value(void)
{
    Sigcat_Clock clock = { SIGCAT_NOT_JUDGED, 0U, false };
    Sigcat_Reception reception = { 0U, 0U, false };

    Sigcat_CheckClock(&clock, &reception, 0U, 50U, 1U, true, 1000U);
    HOLDS(!clock.is_late && clock.verdict == SIGCAT_NOT_JUDGED);
    Sigcat_Receive(&reception, 1000U);
    Sigcat_CheckClock(&clock, &reception, 0U, 50U, 1U, true, 1051U);
    HOLDS(clock.is_late);
    return 0;
}

static int a_full_queue_loses_its_oldest_value(void)
{
    Sigcat_Queue queue = { 0U, 0U, false };

    HOLDS(Sigcat_Push(&queue, 2U) == 0U && Sigcat_Push(&queue, 2U) == 1U && !queue.is_overflown);
    HOLDS(Sigcat_Push(&queue, 2U) == 0U && queue.first == 1U && queue.waiting == 2U && queue.is_overflown);
    Sigcat_Pop(&queue, 2U);
    HOLDS(queue.first == 0U && queue.waiting == 1U);
    queue.first = 2U;
    HOLDS(Sigcat_Push(&queue, 5U) == 3U && Sigcat_Push(&queue, 5U) == 4U && Sigcat_Push(&queue, 5U) == 0U);
    Sigcat_Pop(&queue, 5U);
    HOLDS(queue.first == 3U && queue.waiting == 3U);
    return 0;
}

static int a_full_queue_may_lose_the_value_that_comes(void)
{
    Sigcat_Queue queue = { 0U, 0U, false };

    HOLDS(Sigcat_HasPlace(&queue, 1U) && !queue.is_overflown);
    (void)Sigcat_Push(&queue, 1U);
    HOLDS(!Sigcat_HasPlace(&queue, 1U) && queue.is_overflown);
    Sigcat_Pop(&queue, 1U);
    HOLDS(Sigcat_HasPlace(&queue, 1U) && queue.is_overflown); /* until a snapshot has seen it */
    return 0;
}

#if SIGCAT_FLOAT_ARITHMETIC == 1
#include "float_cases.h"
#else
static int converted_numbers_are_rounded_once(void)
{
    HOLDS(Sigcat_Scaled(3.0, 2.0, 0.5) == 6.5);
    HOLDS(Sigcat_ToFloat(1e300) == FLT_MAX && Sigcat_ToFloat(-1e300) == -FLT_MAX);
    HOLDS(isinf(Sigcat_ToFloat((double)INFINITY)) && Sigcat_ToFloat((double)INFINITY) > 0.0F);
    HOLDS(isinf(Sigcat_ToFloat(-(double)INFINITY)) && Sigcat_ToFloat(-(double)INFINITY) < 0.0F);
    HOLDS(isnan(Sigcat_ToFloat((double)NAN)));
    HOLDS(Sigcat_ToFloat(0.1) == 0.1F && Sigcat_ToFloat((double)FLT_MAX) == FLT_MAX);
    HOLDS(Sigcat_ToFloat(-(double)FLT_MAX) == -FLT_MAX);
    HOLDS(Sigcat_BeyondFloat(DBL_MAX) == FLT_MAX && Sigcat_BeyondFloat(-DBL_MAX) == -FLT_MAX);
    HOLDS(Sigcat_QuietFloat(2.0F) == 2.0F && isnan(Sigcat_QuietFloat(NAN)));
    HOLDS(Sigcat_QuietDouble(2.0) == 2.0 && isnan(Sigcat_QuietDouble((double)NAN)));
    return 0;
}

static int ties_go_to_the_even_integer(void)
{
    HOLDS(Sigcat_ToInt8(0.5, 9) == 0 && Sigcat_ToInt8(1.5, 9) == 2 && Sigcat_ToInt8(2.5, 9) == 2);
    HOLDS(Sigcat_ToInt8(-0.5, 9) == 0 && Sigcat_ToInt8(-1.5, 9) == -2 && Sigcat_ToInt8(-2.5, 9) == -2);
    HOLDS(Sigcat_ToInt8(0.51, 9) == 1 && Sigcat_ToInt8(0.49, 9) == 0);
    HOLDS(Sigcat_ToInt8(-0.51, 9) == -1 && Sigcat_ToInt8(-0.49, 9) == 0);
    HOLDS(Sigcat_ToUint8(0.5, 9U) == 0U && Sigcat_ToUint8(1.5, 9U) == 2U);
    return 0;
}

static int integers_saturate(void)
{
    HOLDS(Sigcat_ToInt8(-129.0, 9) == -128 && Sigcat_ToInt8(128.0, 9) == 127 && Sigcat_ToInt8((double)NAN, 9) == 9);
    HOLDS(Sigcat_ToInt8(-128.0, 9) == -128 && Sigcat_ToInt8(127.0, 9) == 127 && Sigcat_ToInt8(126.4, 9) == 126);
    HOLDS(Sigcat_ToInt16(-32769.0, 9) == -32768 && Sigcat_ToInt16(32768.0, 9) == 32767);
    HOLDS(Sigcat_ToInt32(-2147483649.0, 9) == INT32_MIN && Sigcat_ToInt32(2147483648.0, 9) == INT32_MAX);
    HOLDS(Sigcat_ToInt64(-1e19, 9) == INT64_MIN && Sigcat_ToInt64(1e19, 9) == INT64_MAX);
    HOLDS(Sigcat_ToInt64(-9223372036854775808.0, 9) == INT64_MIN);
    HOLDS(Sigcat_ToInt64(9223372036854775808.0, 9) == INT64_MAX);
    HOLDS(Sigcat_ToInt64(2.5, 9) == 2 && Sigcat_ToInt64((double)NAN, 9) == 9);
    HOLDS(Sigcat_ToUint8(-1.0, 9U) == 0U && Sigcat_ToUint8(256.0, 9U) == 255U);
    HOLDS(Sigcat_ToUint8((double)NAN, 9U) == 9U && Sigcat_ToUint8(254.0, 9U) == 254U);
    HOLDS(Sigcat_ToUint16(65536.0, 9U) == 65535U && Sigcat_ToUint32(4294967296.0, 9U) == UINT32_MAX);
    HOLDS(Sigcat_ToUint32(4294967294.0, 9U) == 4294967294U);
    HOLDS(Sigcat_ToUint64(-1.0, 9U) == 0U && Sigcat_ToUint64(1e20, 9U) == UINT64_MAX);
    HOLDS(Sigcat_ToUint64(18446744073709551616.0, 9U) == UINT64_MAX);
    HOLDS(Sigcat_ToUint64(18446744073709549568.0, 9U) == UINT64_C(18446744073709549568));
    HOLDS(Sigcat_ToUint64(9223372036854775808.0, 9U) == UINT64_C(9223372036854775808));
    HOLDS(Sigcat_ToUint64(3.5, 9U) == 4U && Sigcat_ToUint64((double)NAN, 9U) == 9U);
    return 0;
}
#endif

static int wide_integers_saturate(void)
{
    HOLDS(Sigcat_Int64ToInt8(-129) == -128 && Sigcat_Int64ToInt8(128) == 127 && Sigcat_Int64ToInt8(5) == 5);
    HOLDS(Sigcat_Int64ToInt16(40000) == 32767 && Sigcat_Int64ToInt32(INT64_MIN) == INT32_MIN);
    HOLDS(Sigcat_Int64ToUint8(-1) == 0U && Sigcat_Int64ToUint16(70000) == 65535U);
    HOLDS(Sigcat_Int64ToUint32(INT64_MAX) == UINT32_MAX);
    HOLDS(Sigcat_Int64ToUint64(-1) == 0U && Sigcat_Int64ToUint64(7) == 7U);
    HOLDS(Sigcat_Uint64ToInt8(200U) == 127 && Sigcat_Uint64ToInt16(40000U) == 32767 && Sigcat_Uint64ToInt16(7U) == 7);
    HOLDS(Sigcat_Uint64ToInt32(UINT64_MAX) == INT32_MAX && Sigcat_Uint64ToInt64(UINT64_MAX) == INT64_MAX);
    HOLDS(Sigcat_Uint64ToUint8(300U) == 255U && Sigcat_Uint64ToUint16(70000U) == 65535U);
    HOLDS(Sigcat_Uint64ToUint32(UINT64_MAX) == UINT32_MAX);
    return 0;
}

static const Sigcat_ErrorSettings TEN = { 10U, 20U, 2U, 1U };
static const Sigcat_ErrorSettings AT_ONCE = { 0U, 0U, 1U, 0U };

static int an_error_matures_heals_and_is_confirmed(void)
{
    Sigcat_Error error = { SIGCAT_NOT_TESTED, SIGCAT_NOT_TESTED, 0U, SIGCAT_NOT_JUDGED, false, false };
    Sigcat_Counts counts = { 0U, 0U, false, false };

    Sigcat_Evaluate(&error, &counts, &TEN, SIGCAT_NOT_JUDGED, false, true, 100U);
    HOLDS(error.state == SIGCAT_NOT_TESTED && !counts.is_tested && !Sigcat_IsDecided(&error));
    Sigcat_Evaluate(&error, &counts, &TEN, SIGCAT_ABSENT, false, true, 100U);
    HOLDS(error.state == SIGCAT_PASSED && counts.is_tested && !counts.has_failed && Sigcat_IsDecided(&error));
    Sigcat_Evaluate(&error, &counts, &TEN, SIGCAT_PRESENT, false, true, 200U);
    HOLDS(error.state == SIGCAT_PREFAILED && error.before == SIGCAT_PASSED && !Sigcat_IsDecided(&error));
    Sigcat_Evaluate(&error, &counts, &TEN, SIGCAT_PRESENT, false, true, 209U);
    HOLDS(error.state == SIGCAT_PREFAILED && !Sigcat_HasFailed(&error));
    Sigcat_Evaluate(&error, &counts, &TEN, SIGCAT_PRESENT, false, true, 210U);
    HOLDS(error.state == SIGCAT_FAILED && counts.occurrences == 1U && counts.has_failed && Sigcat_HasFailed(&error));
    Sigcat_Evaluate(&error, &counts, &TEN, SIGCAT_ABSENT, false, false, 220U);
    HOLDS(error.state == SIGCAT_FAILED);
    Sigcat_Evaluate(&error, &counts, &TEN, SIGCAT_ABSENT, false, true, 230U);
    HOLDS(error.state == SIGCAT_HEALING && Sigcat_HasFailed(&error) && Sigcat_IsDecided(&error));
    Sigcat_Evaluate(&error, &counts, &TEN, SIGCAT_PRESENT, false, true, 240U);
    HOLDS(error.state == SIGCAT_FAILED && counts.occurrences == 1U);
    Sigcat_Evaluate(&error, &counts, &TEN, SIGCAT_ABSENT, false, true, 250U);
    Sigcat_Evaluate(&error, &counts, &TEN, SIGCAT_ABSENT, false, true, 269U);
    HOLDS(error.state == SIGCAT_HEALING);
    Sigcat_Evaluate(&error, &counts, &TEN, SIGCAT_NOT_JUDGED, false, true, 270U);
    HOLDS(error.state == SIGCAT_PASSED && counts.has_failed && !error.is_confirmed);
    Sigcat_BeginCycle(&counts);
    HOLDS(counts.ignition_cycles == 1U && !counts.has_failed && !counts.is_tested);
    Sigcat_Evaluate(&error, &counts, &TEN, SIGCAT_ABSENT, true, true, 300U);
    HOLDS(error.state == SIGCAT_FAILED && counts.occurrences == 2U && error.is_confirmed);
    return 0;
}

static int counts_stay_at_their_largest_number(void)
{
    Sigcat_Error error = { SIGCAT_PASSED, SIGCAT_PASSED, 0U, SIGCAT_NOT_JUDGED, false, false };
    Sigcat_Counts counts = { UINT16_MAX, UINT16_MAX, true, true };

    Sigcat_BeginCycle(&counts);
    HOLDS(counts.ignition_cycles == UINT16_MAX);
    Sigcat_Evaluate(&error, &counts, &AT_ONCE, SIGCAT_PRESENT, false, true, 1U);
    HOLDS(error.state == SIGCAT_FAILED && counts.occurrences == UINT16_MAX && error.is_confirmed);
    Sigcat_Evaluate(&error, &counts, &AT_ONCE, SIGCAT_ABSENT, false, true, 2U);
    HOLDS(error.state == SIGCAT_PASSED);
    return 0;
}

static int a_cycle_without_a_failure_starts_again(void)
{
    Sigcat_Counts passed = { 3U, 2U, false, true };
    Sigcat_Counts unknown = { 3U, 2U, false, false };

    Sigcat_BeginCycle(&passed);
    Sigcat_BeginCycle(&unknown);
    HOLDS(passed.ignition_cycles == 0U && passed.occurrences == 3U && !passed.is_tested);
    HOLDS(unknown.ignition_cycles == 2U);
    HOLDS(Sigcat_IsConfirmed(&unknown, &TEN));
    unknown.ignition_cycles = 1U;
    HOLDS(Sigcat_IsConfirmed(&unknown, &TEN));
    unknown.ignition_cycles = 0U;
    HOLDS(!Sigcat_IsConfirmed(&unknown, &TEN));
    return 0;
}

static int what_is_under_way_ends_with_the_mode(void)
{
    Sigcat_Error maturing = { SIGCAT_PREFAILED, SIGCAT_PASSED, 0U, SIGCAT_NOT_JUDGED, false, false };
    Sigcat_Error healing = { SIGCAT_HEALING, SIGCAT_FAILED, 0U, SIGCAT_NOT_JUDGED, false, false };
    Sigcat_Error passed = { SIGCAT_PASSED, SIGCAT_FAILED, 0U, SIGCAT_NOT_JUDGED, false, false };

    Sigcat_Suspend(&maturing);
    Sigcat_Suspend(&healing);
    Sigcat_Suspend(&passed);
    HOLDS(maturing.state == SIGCAT_PASSED && healing.state == SIGCAT_FAILED && passed.state == SIGCAT_PASSED);
    HOLDS(Sigcat_Worse(SIGCAT_PRESENT, SIGCAT_ABSENT) == SIGCAT_PRESENT);
    HOLDS(Sigcat_Worse(SIGCAT_NOT_JUDGED, SIGCAT_ABSENT) == SIGCAT_ABSENT);
    return 0;
}

static int the_grid_of_releases_stays(void)
{
    Sigcat_Ticks release = 100U;
    uint32_t dropped = 0U;

    HOLDS(Sigcat_Release(&release, 50U, 100U) == 1U && release == 150U);
    HOLDS(Sigcat_Release(&release, 50U, 260U) == 3U && release == 300U);
    Sigcat_DropUpTo(&release, &dropped, 50U, 299U);
    HOLDS(release == 300U && dropped == 0U);
    Sigcat_DropUpTo(&release, &dropped, 50U, 300U);
    HOLDS(release == 350U && dropped == 1U);
    Sigcat_DropBefore(&release, &dropped, 50U, 350U);
    HOLDS(release == 350U && dropped == 1U);
    Sigcat_DropBefore(&release, &dropped, 50U, 400U);
    HOLDS(release == 400U && dropped == 2U);
    Sigcat_DropBefore(&release, &dropped, 50U, 401U);
    HOLDS(release == 450U && dropped == 3U);
    HOLDS(Sigcat_Added(UINT32_MAX - 2U, 2U) == UINT32_MAX && Sigcat_Added(1U, 2U) == 3U);
    HOLDS(Sigcat_Added(UINT32_MAX - 2U, 3U) == UINT32_MAX && Sigcat_Added(1U, UINT32_MAX) == UINT32_MAX);
    return 0;
}

static int a_window_has_as_many_ends_as_declared(void)
{
    Sigcat_Alive alive;

    Sigcat_EnterAlive(&alive, 100U);
    HOLDS(alive.verdict == SIGCAT_NOT_JUDGED && alive.window == 100U && alive.ends == 0U && !alive.has_closed);
    Sigcat_CheckWindows(&alive);
    HOLDS(alive.verdict == SIGCAT_NOT_JUDGED);
    alive.ends = 2U;
    Sigcat_CloseWindow(&alive, 50U, 2U, 3U, 149U);
    HOLDS(!alive.has_closed && alive.ends == 2U);
    Sigcat_CloseWindow(&alive, 50U, 2U, 3U, 150U);
    HOLDS(alive.has_closed && !alive.is_bad && alive.window == 150U && alive.ends == 0U);
    Sigcat_CheckWindows(&alive);
    HOLDS(alive.verdict == SIGCAT_ABSENT && !alive.has_closed);
    alive.ends = 4U;
    Sigcat_CloseWindow(&alive, 50U, 2U, 3U, 200U);
    HOLDS(alive.is_bad);
    alive.ends = 3U;
    Sigcat_CloseWindow(&alive, 50U, 2U, 3U, 250U);
    HOLDS(alive.is_bad); /* until it is checked */
    Sigcat_CheckWindows(&alive);
    HOLDS(alive.verdict == SIGCAT_PRESENT && !alive.is_bad);
    alive.ends = 1U;
    Sigcat_CloseWindow(&alive, 50U, 2U, 3U, 300U);
    HOLDS(alive.is_bad);
    Sigcat_ResetAlive(&alive);
    HOLDS(!alive.is_bad && !alive.has_closed && alive.verdict == SIGCAT_NOT_JUDGED);
    alive.ends = 2U;
    Sigcat_CloseWindow(&alive, 50U, 2U, 3U, 400U);
    HOLDS(alive.is_bad && alive.window == 400U); /* nobody saw the second window */
    Sigcat_ResetAlive(&alive);
    alive.ends = 3U;
    Sigcat_CloseWindow(&alive, 50U, 2U, 3U, 450U);
    HOLDS(!alive.is_bad);
    Sigcat_CloseWindow(&alive, 25U, 0U, 3U, 500U);
    HOLDS(!alive.is_bad && alive.has_closed && alive.window == 500U);
    return 0;
}

int main(void)
{
    return time_never_goes_back()
        || time_wraps_around()
        || times_have_an_order()
        || a_value_is_late_after_its_time_out()
        || a_clock_may_start_with_the_first_value()
        || a_full_queue_loses_its_oldest_value()
        || a_full_queue_may_lose_the_value_that_comes()
        || converted_numbers_are_rounded_once()
        || ties_go_to_the_even_integer()
        || integers_saturate()
        || wide_integers_saturate()
        || an_error_matures_heals_and_is_confirmed()
        || counts_stay_at_their_largest_number()
        || a_cycle_without_a_failure_starts_again()
        || what_is_under_way_ends_with_the_mode()
        || the_grid_of_releases_stays()
        || a_window_has_as_many_ends_as_declared();
}
