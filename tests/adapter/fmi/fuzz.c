/*
 * Calls functions of an FMU at random, in any phase and with any arguments: `fuzz TOKEN SEED CALLS USAGE`.
 * USAGE is `steps` for co-simulation, or `clocks` for scheduled execution.
 * The sanitizers end it at the first fault.
 */

#include "sigcat_fmi3.h"

#include "random_arguments.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

fmi3Instance fmi3InstantiateCoSimulation(
    fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean, fmi3Boolean, fmi3Boolean, const fmi3ValueReference[], size_t,
    fmi3InstanceEnvironment, fmi3LogMessageCallback, fmi3IntermediateUpdateCallback);
fmi3Instance fmi3InstantiateScheduledExecution(
    fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean, fmi3InstanceEnvironment, fmi3LogMessageCallback, fmi3ClockUpdateCallback,
    fmi3LockPreemptionCallback, fmi3UnlockPreemptionCallback);
void fmi3FreeInstance(fmi3Instance);
fmi3Status fmi3EnterInitializationMode(fmi3Instance, fmi3Boolean, fmi3Float64, fmi3Float64, fmi3Boolean, fmi3Float64);
fmi3Status fmi3ExitInitializationMode(fmi3Instance);
fmi3Status fmi3Terminate(fmi3Instance);
fmi3Status fmi3Reset(fmi3Instance);
fmi3Status fmi3DoStep(fmi3Instance, fmi3Float64, fmi3Float64, fmi3Boolean, fmi3Boolean *, fmi3Boolean *, fmi3Boolean *, fmi3Float64 *);
fmi3Status fmi3GetFloat64(fmi3Instance, const fmi3ValueReference[], size_t, fmi3Float64[], size_t);
fmi3Status fmi3SetFloat32(fmi3Instance, const fmi3ValueReference[], size_t, const fmi3Float32[], size_t);
fmi3Status fmi3GetFloat32(fmi3Instance, const fmi3ValueReference[], size_t, fmi3Float32[], size_t);
fmi3Status fmi3SetInt64(fmi3Instance, const fmi3ValueReference[], size_t, const fmi3Int64[], size_t);
fmi3Status fmi3GetInt64(fmi3Instance, const fmi3ValueReference[], size_t, fmi3Int64[], size_t);
fmi3Status fmi3GetFMUState(fmi3Instance, fmi3FMUState *);
fmi3Status fmi3SetFMUState(fmi3Instance, fmi3FMUState);
fmi3Status fmi3FreeFMUState(fmi3Instance, fmi3FMUState *);
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance, fmi3FMUState, size_t *);
fmi3Status fmi3SerializeFMUState(fmi3Instance, fmi3FMUState, fmi3Byte[], size_t);
fmi3Status fmi3DeserializeFMUState(fmi3Instance, const fmi3Byte[], size_t, fmi3FMUState *);
fmi3Status fmi3EnterEventMode(fmi3Instance);
fmi3Status fmi3EnterStepMode(fmi3Instance);
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance, fmi3Boolean *, fmi3Boolean *, fmi3Boolean *, fmi3Boolean *, fmi3Boolean *, fmi3Float64 *);
fmi3Status fmi3ActivateModelPartition(fmi3Instance, fmi3ValueReference, fmi3Float64);
fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance, size_t *);

#define MOST 8U

static void said(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message)
{
    (void)environment;
    if ((status < fmi3Warning) || (strlen(category) == 0U) || (strlen(message) < 10U)) {
        abort();
    }
}

static fmi3Instance instance;
static fmi3FMUState state;
static double now;
static unsigned counts[5];
static fmi3Byte bytes[1U << 16];
static bool has_clocks;
static bool is_locked;
static unsigned depth;
static unsigned progress; /* steps and activations that were accepted */

static fmi3Status access(void)
{
    fmi3ValueReference references[MOST];
    double doubles[MOST];
    float floats[MOST];
    int64_t integers[MOST];
    const size_t count = any(MOST);
    const size_t values = any(2U) ? count : any(MOST);
    for (size_t i = 0; i < MOST; i++) {
        references[i] = any(8U) ? any(12U) : any(UINT32_MAX);
        doubles[i] = any_number();
        floats[i] = (float)any(1000U);
        integers[i] = (int64_t)any(UINT32_MAX) - 1000;
    }
    switch (any(5U)) {
        case 0U: return fmi3GetFloat64(instance, any(50U) ? references : NULL, count, doubles, values);
        case 1U: return fmi3SetFloat32(instance, references, count, any(50U) ? floats : NULL, values);
        case 2U: return fmi3GetFloat32(instance, references, count, floats, values);
        case 3U: return fmi3SetInt64(instance, references, count, integers, values);
        default: return fmi3GetInt64(instance, references, count, integers, values);
    }
}

static fmi3Status step(void)
{
    fmi3Boolean event = false;
    fmi3Boolean end = false;
    fmi3Boolean early = false;
    double last = 0.0;
    const bool is_right = any(4U) > 0U;
    const double length = is_right ? 0.001 * (double)(1U + any(50U)) : any_number();
    const fmi3Status status = (length > 1000.0) ? fmi3Discard
        : fmi3DoStep(instance, is_right ? now : any_number(), length, true, &event, &end, &early, any(50U) ? &last : NULL);
    now = (status == fmi3OK) ? last : now;
    progress += (status == fmi3OK) ? 1U : 0U;
    return status;
}

static fmi3Status activate(void)
{
    const bool is_right = any(8U) > 0U;
    const double time = now + ((double)any(20U) / 1000.0);
    const fmi3Status status =
        fmi3ActivateModelPartition(instance, is_right ? any(16U) : any(UINT32_MAX), is_right ? time : any_number());
    if ((status == fmi3OK) && is_right) {
        now = time;
        progress++;
    }
    return status;
}

static void lock(void)
{
    if (is_locked) {
        abort();
    }
    is_locked = true;
}

/* Another task preempts the one that has unlocked, sometimes. */
static void unlock(void)
{
    if (!is_locked) {
        abort();
    }
    is_locked = false;
    if ((depth == 0U) && (any(3U) == 0U)) {
        depth++;
        (void)activate();
        depth--;
    }
}

static void instantiate(const char *token)
{
    const char *const name = any(9U) ? "x" : NULL;
    const char *const given = any(9U) ? token : "wrong";
    now = 0.0;
    if (has_clocks != (any(9U) == 0U)) {
        instance = fmi3InstantiateScheduledExecution(
            name, given, NULL, false, true, NULL, said, NULL, any(9U) ? lock : NULL, any(9U) ? unlock : NULL);
    } else {
        instance = fmi3InstantiateCoSimulation(name, given, NULL, false, true, any(2U) == 0U, false, NULL, 0U, NULL, said, NULL);
    }
}

static fmi3Status save(void)
{
    size_t size = 0;
    switch (any(5U)) {
        case 0U: return fmi3GetFMUState(instance, any(9U) ? &state : NULL);
        case 1U: return fmi3SetFMUState(instance, state);
        case 2U: return fmi3FreeFMUState(instance, &state);
        case 3U:
            if ((fmi3SerializedFMUStateSize(instance, state, &size) != fmi3OK) || (size > sizeof(bytes))) {
                return fmi3Error;
            }
            return fmi3SerializeFMUState(instance, state, bytes, any(4U) ? size : any(sizeof(bytes)));
        default:
            if (any(3U) == 0U) {
                bytes[any(4000U)] ^= 1U;
            }
            if (fmi3SerializedFMUStateSize(instance, state, &size) != fmi3OK) {
                size = any(sizeof(bytes));
            }
            return fmi3DeserializeFMUState(instance, bytes, size, &state);
    }
}

static fmi3Status change_mode(void)
{
    fmi3Boolean flags[5] = {false, false, false, false, false};
    double next = 0.0;
    switch (any(3U)) {
        case 0U: return fmi3EnterEventMode(instance);
        case 1U: return fmi3EnterStepMode(instance);
        default:
            return fmi3UpdateDiscreteStates(
                instance, any(50U) ? &flags[0] : NULL, &flags[1], &flags[2], &flags[3], &flags[4], any(50U) ? &next : NULL);
    }
}

static fmi3Status call(const char *token)
{
    size_t found = 0;
    switch (any(24U)) {
        case 0U:
            if (any(20U) == 0U) {
                (void)fmi3FreeFMUState(instance, &state);
                fmi3FreeInstance(instance);
                instantiate(token);
            }
            return fmi3OK;
        case 1U: return fmi3EnterInitializationMode(instance, false, 0.0, any(4U) ? 0.0 : any_number(), any(2U) == 0U, any_number());
        case 2U: return fmi3ExitInitializationMode(instance);
        case 3U: return any(30U) ? change_mode() : fmi3Terminate(instance);
        case 4U:
            if (any(30U) == 0U) {
                now = 0.0;
                return fmi3Reset(instance);
            }
            return activate();
        case 5U: return fmi3GetNumberOfContinuousStates(instance, &found);
        case 6U:
        case 7U:
        case 8U: return save();
        case 9U:
        case 10U:
        case 11U:
        case 12U: return (has_clocks != (any(9U) == 0U)) ? activate() : step();
        default: return access();
    }
}

int main(int count, char **arguments)
{
    unsigned long calls;
    if (count != 5) {
        return EXIT_FAILURE;
    }
    seed = strtoull(arguments[2], NULL, 10) * UINT64_C(2654435761) + 1U;
    has_clocks = strcmp(arguments[4], "clocks") == 0;
    calls = strtoul(arguments[3], NULL, 10);
    for (unsigned long i = 0; i < calls; i++) {
        const fmi3Status status = call(arguments[1]);
        if ((status < fmi3OK) || (status >= fmi3Fatal)) {
            return EXIT_FAILURE;
        }
        counts[status]++;
    }
    (void)fmi3FreeFMUState(instance, &state);
    fmi3FreeInstance(instance);
    free(state);
    (void)printf("%u ok, %u refused, %u steps\n", counts[fmi3OK], counts[fmi3Error], progress);
    return EXIT_SUCCESS;
}
