/*
 * Functions that the adapters of all functions call. The rules are those of docs/reference/adapter.md.
 *
 * Part of sigcat: the same file for each function. Times are those of sigcat_core_time.h. None of these
 * functions has data of its own: what they change is given to them.
 */

#ifndef SIGCAT_CORE_FUNCTIONS_H
#define SIGCAT_CORE_FUNCTIONS_H

#include <float.h>
#include <stddef.h>
#include <string.h>

#include "sigcat_core.h"
#include "sigcat_core_clock.h"

/* Points of measurement (section 13). */
#define SIGCAT_SET_INPUT_BEGINS 0
#define SIGCAT_CALL_BEGINS 1
#define SIGCAT_CALL_ENDS 2
#define SIGCAT_GET_OUTPUT_ENDS 3
#define SIGCAT_SUPERVISES 4

#ifdef __cplusplus
extern "C" {
#endif

/* Each shared library has its own copy of these functions. */
#if defined(__GNUC__) && !defined(_WIN32)
#pragma GCC visibility push(hidden)
#endif

/* A function that is hardly ever called: the compiler keeps its call out of the way. */
#if defined(__GNUC__)
#define SIGCAT_RARE __attribute__((cold))
#else
#define SIGCAT_RARE
#endif

/* -- time (section 1) -- */

static inline Sigcat_Ticks Sigcat_Earlier(Sigcat_Ticks a, Sigcat_Ticks b)
{
    return (a < b) ? a : b;
}

static inline Sigcat_Ticks Sigcat_Later(Sigcat_Ticks a, Sigcat_Ticks b)
{
    return (a > b) ? a : b;
}

/* -- reception (sections 2 and 3) -- */

/* A value has come. */
static inline void Sigcat_Receive(Sigcat_Reception *reception, Sigcat_Ticks now)
{
    reception->time = now;
    reception->count++;
    reception->is_there = true;
}

/* Whether a value is late, checked in each snapshot. It stays late until enough new values have been received. */
void Sigcat_CheckClock(Sigcat_Clock *own_clock, const Sigcat_Reception *reception, Sigcat_Ticks entered,
    Sigcat_Ticks time_out, uint32_t recovery, bool starts_with_first, Sigcat_Ticks now);

/* The place for a value in a ring. A full ring loses its oldest value. */
uint32_t Sigcat_Push(Sigcat_Queue *queue, uint32_t length);

/* Whether a ring has a place. A full one loses the value that comes now. */
bool Sigcat_HasPlace(Sigcat_Queue *queue, uint32_t length);

/* The oldest value has been taken. */
void Sigcat_Pop(Sigcat_Queue *queue, uint32_t length);

/* -- numbers (section 4) -- */

/* Not a number. <math.h> has names that the code of a function may have, too. */
extern const float Sigcat_NanFloat;

/* The number; of a NaN the one with the usual bits. */
static inline float Sigcat_QuietFloat(float value)
{
    return (value == value) ? value : Sigcat_NanFloat;
}

#if SIGCAT_FLOAT_ARITHMETIC == 1

/* Type in which values are converted. */
typedef float Sigcat_Real;

/*
 * value * factor + offset, with twice the digits of a float: each `_rest` is the part of a number that its float
 * does not hold.
 */
float Sigcat_Scaled(float value, float value_rest, float factor, float factor_rest, float offset, float offset_rest);

/* The part of an integer that its float does not hold. */
static inline float Sigcat_RestOfInt32(int32_t value)
{
    const int64_t rest = (int64_t)value - (int64_t)(float)value;
    return (float)rest;
}

static inline float Sigcat_RestOfUint32(uint32_t value)
{
    const int64_t rest = (int64_t)value - (int64_t)(float)value;
    return (float)rest;
}

/* A converted value that no float holds: too large, infinite, or no number. */
SIGCAT_RARE float Sigcat_BeyondFloat(float value, float source);

/* A converted value: finite if its source is. */
static inline float Sigcat_ToFloat(float value, float source)
{
    const bool is_usual = (value >= -FLT_MAX) && (value <= FLT_MAX);

    return is_usual ? value : Sigcat_BeyondFloat(value, source);
}

#else

/* Type in which values are converted. */
typedef double Sigcat_Real;

extern const double Sigcat_NanDouble;

/* Two roundings, never one: the sum is a separate statement. */
static inline double Sigcat_Scaled(double value, double factor, double offset)
{
    const double product = value * factor;
    return product + offset;
}

/* The number; of a NaN the one with the usual bits. */
static inline double Sigcat_QuietDouble(double value)
{
    return (value == value) ? value : Sigcat_NanDouble;
}

/* What no float holds: too large, infinite, or no number. */
SIGCAT_RARE float Sigcat_BeyondFloat(double value);

/* Rounded once; what is finite stays finite. */
static inline float Sigcat_ToFloat(double value)
{
    const bool is_usual = (value >= -(double)FLT_MAX) && (value <= (double)FLT_MAX);

    return is_usual ? (float)value : Sigcat_BeyondFloat(value);
}

#endif

/* To the nearest integer, ties to even, saturated. */
int32_t Sigcat_ToSigned(Sigcat_Real value, int32_t least, int32_t most, int32_t instead_of_nan);
uint32_t Sigcat_ToUnsigned(Sigcat_Real value, uint32_t most, uint32_t instead_of_nan);
int64_t Sigcat_ToInt64(Sigcat_Real value, int64_t instead_of_nan);
uint64_t Sigcat_ToUint64(Sigcat_Real value, uint64_t instead_of_nan);

static inline int8_t Sigcat_ToInt8(Sigcat_Real value, int8_t instead_of_nan)
{
    return (int8_t)Sigcat_ToSigned(value, INT8_MIN, INT8_MAX, instead_of_nan);
}

static inline int16_t Sigcat_ToInt16(Sigcat_Real value, int16_t instead_of_nan)
{
    return (int16_t)Sigcat_ToSigned(value, INT16_MIN, INT16_MAX, instead_of_nan);
}

static inline int32_t Sigcat_ToInt32(Sigcat_Real value, int32_t instead_of_nan)
{
    return Sigcat_ToSigned(value, INT32_MIN, INT32_MAX, instead_of_nan);
}

static inline uint8_t Sigcat_ToUint8(Sigcat_Real value, uint8_t instead_of_nan)
{
    return (uint8_t)Sigcat_ToUnsigned(value, UINT8_MAX, instead_of_nan);
}

static inline uint16_t Sigcat_ToUint16(Sigcat_Real value, uint16_t instead_of_nan)
{
    return (uint16_t)Sigcat_ToUnsigned(value, UINT16_MAX, instead_of_nan);
}

static inline uint32_t Sigcat_ToUint32(Sigcat_Real value, uint32_t instead_of_nan)
{
    return Sigcat_ToUnsigned(value, UINT32_MAX, instead_of_nan);
}

/* An integer, saturated. */
static inline int64_t Sigcat_Int64Within(int64_t value, int64_t least, int64_t most)
{
    return (value < least) ? least : ((value > most) ? most : value);
}

static inline uint64_t Sigcat_Uint64UpTo(uint64_t value, uint64_t most)
{
    return (value > most) ? most : value;
}

static inline int8_t Sigcat_Int64ToInt8(int64_t value)
{
    return (int8_t)Sigcat_Int64Within(value, INT8_MIN, INT8_MAX);
}

static inline int16_t Sigcat_Int64ToInt16(int64_t value)
{
    return (int16_t)Sigcat_Int64Within(value, INT16_MIN, INT16_MAX);
}

static inline int32_t Sigcat_Int64ToInt32(int64_t value)
{
    return (int32_t)Sigcat_Int64Within(value, INT32_MIN, INT32_MAX);
}

static inline uint8_t Sigcat_Int64ToUint8(int64_t value)
{
    return (uint8_t)Sigcat_Int64Within(value, 0, UINT8_MAX);
}

static inline uint16_t Sigcat_Int64ToUint16(int64_t value)
{
    return (uint16_t)Sigcat_Int64Within(value, 0, UINT16_MAX);
}

static inline uint32_t Sigcat_Int64ToUint32(int64_t value)
{
    return (uint32_t)Sigcat_Int64Within(value, 0, UINT32_MAX);
}

static inline uint64_t Sigcat_Int64ToUint64(int64_t value)
{
    return (value < 0) ? 0U : (uint64_t)value;
}

static inline int8_t Sigcat_Uint64ToInt8(uint64_t value)
{
    return (int8_t)Sigcat_Uint64UpTo(value, INT8_MAX);
}

static inline int16_t Sigcat_Uint64ToInt16(uint64_t value)
{
    return (int16_t)Sigcat_Uint64UpTo(value, INT16_MAX);
}

static inline int32_t Sigcat_Uint64ToInt32(uint64_t value)
{
    return (int32_t)Sigcat_Uint64UpTo(value, INT32_MAX);
}

static inline int64_t Sigcat_Uint64ToInt64(uint64_t value)
{
    return (int64_t)Sigcat_Uint64UpTo(value, INT64_MAX);
}

static inline uint8_t Sigcat_Uint64ToUint8(uint64_t value)
{
    return (uint8_t)Sigcat_Uint64UpTo(value, UINT8_MAX);
}

static inline uint16_t Sigcat_Uint64ToUint16(uint64_t value)
{
    return (uint16_t)Sigcat_Uint64UpTo(value, UINT16_MAX);
}

static inline uint32_t Sigcat_Uint64ToUint32(uint64_t value)
{
    return (uint32_t)Sigcat_Uint64UpTo(value, UINT32_MAX);
}

/* -- errors (section 6) -- */

/* The worse of two verdicts: present, absent, not checked. */
static inline Sigcat_Verdict Sigcat_Worse(Sigcat_Verdict a, Sigcat_Verdict b)
{
    return (a > b) ? a : b;
}

/* Whether an error is reported as failed. */
static inline bool Sigcat_HasFailed(const Sigcat_Error *error)
{
    return (error->state == SIGCAT_FAILED) || (error->state == SIGCAT_HEALING);
}

/* Whether an error has a status to report. */
static inline bool Sigcat_IsDecided(const Sigcat_Error *error)
{
    return (error->state != SIGCAT_NOT_TESTED) && (error->state != SIGCAT_PREFAILED);
}

/* Whether an error has failed as often, and in as many ignition cycles, as it takes. */
static inline bool Sigcat_IsConfirmed(const Sigcat_Counts *counts, const Sigcat_ErrorSettings *settings)
{
    return (counts->occurrences >= settings->occurrences) && (counts->ignition_cycles >= settings->ignition_cycles);
}

/*
 * The next state of an error. `has_cause`: another error has failed, and this one with it. `may_heal`: the reset
 * condition holds.
 */
void Sigcat_Evaluate(Sigcat_Error *error, Sigcat_Counts *counts, const Sigcat_ErrorSettings *settings,
    Sigcat_Verdict verdict, bool has_cause, bool may_heal, Sigcat_Ticks now);

/* The mode excludes the call of an error: what was under way ends. */
void Sigcat_Suspend(Sigcat_Error *error);

/* A new ignition cycle: errors that failed in the last one count; those that were tested and passed start again. */
void Sigcat_BeginCycle(Sigcat_Counts *counts);

/* -- schedule (section 9) -- */

/* A sum that stays at the largest number. */
uint32_t Sigcat_Added(uint32_t sum, Sigcat_Ticks more);

/* Number of releases up to now, at least one. The next one is after it: the grid stays, whatever is missed. */
Sigcat_Ticks Sigcat_Release(Sigcat_Ticks *release, Sigcat_Ticks cycle, Sigcat_Ticks now);

/* Releases up to now, and those before it, are dropped and counted. */
void Sigcat_DropUpTo(Sigcat_Ticks *release, uint32_t *dropped, Sigcat_Ticks cycle, Sigcat_Ticks now);
void Sigcat_DropBefore(Sigcat_Ticks *release, uint32_t *dropped, Sigcat_Ticks cycle, Sigcat_Ticks now);

/* -- supervision (section 10) -- */

/* A call runs from now on: its window begins. */
void Sigcat_EnterAlive(Sigcat_Alive *alive, Sigcat_Ticks now);

/* What its windows said is forgotten. */
void Sigcat_ResetAlive(Sigcat_Alive *alive);

/* A window that is over. Each has `least` to `most` ends; if any is needed, a window that passed unseen is bad. */
void Sigcat_CloseWindow(Sigcat_Alive *alive, Sigcat_Ticks length, uint32_t least, uint32_t most, Sigcat_Ticks now);

/* Windows that have closed since this was asked last. */
void Sigcat_CheckWindows(Sigcat_Alive *alive);

#if defined(__GNUC__) && !defined(_WIN32)
#pragma GCC visibility pop
#endif

#ifdef __cplusplus
}

/* A number, put into a variable of the function that may be an enumeration. */
template <typename T, typename N>
static inline void Sigcat_Put(T &variable, N number)
{
    variable = static_cast<T>(number);
}

/* Whether a variable of the function, which may be an enumeration, is not 0. */
template <typename T>
static inline bool Sigcat_IsSet(const T &variable)
{
    return variable != static_cast<T>(0);
}
#endif

#endif /* SIGCAT_CORE_FUNCTIONS_H */
