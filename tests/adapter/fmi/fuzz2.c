/*
 * Calls functions of an FMU of FMI 2.0 at random, in any phase and with any arguments: `fuzz TOKEN SEED CALLS`.
 * The sanitizers end it at the first fault.
 */

#include "sigcat_fmi2.h"

#include "random_arguments.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

fmi2Component fmi2Instantiate(fmi2String, fmi2Type, fmi2String, fmi2String, const fmi2CallbackFunctions *, fmi2Boolean, fmi2Boolean);
void fmi2FreeInstance(fmi2Component);
fmi2Status fmi2SetupExperiment(fmi2Component, fmi2Boolean, fmi2Real, fmi2Real, fmi2Boolean, fmi2Real);
fmi2Status fmi2EnterInitializationMode(fmi2Component);
fmi2Status fmi2ExitInitializationMode(fmi2Component);
fmi2Status fmi2Terminate(fmi2Component);
fmi2Status fmi2Reset(fmi2Component);
fmi2Status fmi2DoStep(fmi2Component, fmi2Real, fmi2Real, fmi2Boolean);
fmi2Status fmi2GetReal(fmi2Component, const fmi2ValueReference[], size_t, fmi2Real[]);
fmi2Status fmi2SetReal(fmi2Component, const fmi2ValueReference[], size_t, const fmi2Real[]);
fmi2Status fmi2GetInteger(fmi2Component, const fmi2ValueReference[], size_t, fmi2Integer[]);
fmi2Status fmi2SetInteger(fmi2Component, const fmi2ValueReference[], size_t, const fmi2Integer[]);
fmi2Status fmi2GetBoolean(fmi2Component, const fmi2ValueReference[], size_t, fmi2Boolean[]);
fmi2Status fmi2SetBoolean(fmi2Component, const fmi2ValueReference[], size_t, const fmi2Boolean[]);
fmi2Status fmi2GetFMUstate(fmi2Component, fmi2FMUstate *);
fmi2Status fmi2SetFMUstate(fmi2Component, fmi2FMUstate);
fmi2Status fmi2FreeFMUstate(fmi2Component, fmi2FMUstate *);
fmi2Status fmi2SerializedFMUstateSize(fmi2Component, fmi2FMUstate, size_t *);
fmi2Status fmi2SerializeFMUstate(fmi2Component, fmi2FMUstate, fmi2Byte[], size_t);
fmi2Status fmi2DeSerializeFMUstate(fmi2Component, const fmi2Byte[], size_t, fmi2FMUstate *);

#define MOST 8U

static fmi2Component instance;
static fmi2FMUstate state;
static double now;
static unsigned counts[5];
static unsigned progress; /* steps that were accepted */
static fmi2Byte bytes[1U << 16];

static void said(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status, fmi2String category, fmi2String message, ...)
{
    (void)environment;
    (void)name;
    if ((status < fmi2Warning) || (strlen(category) == 0U) || (strlen(message) < 2U)) {
        abort();
    }
}

static void instantiate(const char *token)
{
    static const fmi2CallbackFunctions callbacks = {said, calloc, free, NULL, NULL};
    now = 0.0;
    instance = fmi2Instantiate(
        any(9U) ? "x" : NULL, any(9U) ? fmi2CoSimulation : fmi2ModelExchange, any(9U) ? token : "wrong", NULL,
        any(9U) ? &callbacks : NULL, false, true);
}

static fmi2Status access(void)
{
    fmi2ValueReference references[MOST];
    fmi2Real reals[MOST];
    fmi2Integer integers[MOST];
    const size_t count = any(MOST);
    for (size_t i = 0; i < MOST; i++) {
        references[i] = any(8U) ? any(12U) : any(UINT32_MAX);
        reals[i] = any_number();
        integers[i] = (fmi2Integer)any(2000U) - 1000;
    }
    switch (any(6U)) {
        case 0U: return fmi2GetReal(instance, any(50U) ? references : NULL, count, reals);
        case 1U: return fmi2SetReal(instance, references, count, any(50U) ? reals : NULL);
        case 2U: return fmi2GetInteger(instance, references, count, integers);
        case 3U: return fmi2SetInteger(instance, references, count, integers);
        case 4U: return fmi2GetBoolean(instance, references, count, integers);
        default: return fmi2SetBoolean(instance, references, count, integers);
    }
}

static fmi2Status step(void)
{
    const bool is_right = any(4U) > 0U;
    const double length = is_right ? 0.001 * (double)(1U + any(50U)) : any_number();
    const double start = is_right ? now : any_number();
    const fmi2Status status = (length > 1000.0) ? fmi2Discard : fmi2DoStep(instance, start, length, true);
    if (status == fmi2OK) {
        now = start + length;
        progress++;
    }
    return status;
}

static fmi2Status save(void)
{
    size_t size = 0;
    switch (any(5U)) {
        case 0U: return fmi2GetFMUstate(instance, any(9U) ? &state : NULL);
        case 1U: return fmi2SetFMUstate(instance, state);
        case 2U: return fmi2FreeFMUstate(instance, &state);
        case 3U:
            if ((fmi2SerializedFMUstateSize(instance, state, &size) != fmi2OK) || (size > sizeof(bytes))) {
                return fmi2Error;
            }
            return fmi2SerializeFMUstate(instance, state, bytes, any(4U) ? size : any(sizeof(bytes)));
        default:
            if (any(3U) == 0U) {
                bytes[any(4000U)] ^= 1;
            }
            if (fmi2SerializedFMUstateSize(instance, state, &size) != fmi2OK) {
                size = any(sizeof(bytes));
            }
            return fmi2DeSerializeFMUstate(instance, bytes, size, &state);
    }
}

static fmi2Status call(const char *token)
{
    switch (any(24U)) {
        case 0U:
            if (any(20U) == 0U) {
                (void)fmi2FreeFMUstate(instance, &state);
                fmi2FreeInstance(instance);
                instantiate(token);
            }
            return fmi2OK;
        case 1U: return fmi2SetupExperiment(instance, false, 0.0, any(4U) ? 0.0 : any_number(), any(2U) == 0U, any_number());
        case 2U: return fmi2EnterInitializationMode(instance);
        case 3U: return fmi2ExitInitializationMode(instance);
        case 4U:
            if (any(30U) != 0U) {
                return fmi2OK;
            }
            now = 0.0;
            return any(2U) ? fmi2Reset(instance) : fmi2Terminate(instance);
        case 5U:
        case 6U:
        case 7U: return save();
        case 8U:
        case 9U:
        case 10U:
        case 11U: return step();
        default: return access();
    }
}

int main(int count, char **arguments)
{
    unsigned long calls;
    if (count < 4) {
        return EXIT_FAILURE;
    }
    seed = strtoull(arguments[2], NULL, 10) * UINT64_C(2654435761) + 1U;
    calls = strtoul(arguments[3], NULL, 10);
    for (unsigned long i = 0; i < calls; i++) {
        const fmi2Status status = call(arguments[1]);
        if (status >= fmi2Fatal) {
            return EXIT_FAILURE;
        }
        counts[status]++;
    }
    (void)fmi2FreeFMUstate(instance, &state);
    fmi2FreeInstance(instance);
    free(state);
    (void)printf("%u ok, %u refused, %u steps\n", counts[fmi2OK], counts[fmi2Error], progress);
    return EXIT_SUCCESS;
}
