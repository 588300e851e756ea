/*
 * Hands random and damaged operations to an FMU with a bus, in event mode: `fuzz TOKEN SEED ROUNDS FIRST`. FIRST is the value reference
 * of Rx_Clock. The sanitizers end it at the first fault; it ends itself if an answer is not made of operations.
 */

#include "sigcat_fmi3.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

fmi3Instance fmi3InstantiateCoSimulation(
    fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean, fmi3Boolean, fmi3Boolean, const fmi3ValueReference[], size_t,
    fmi3InstanceEnvironment, fmi3LogMessageCallback, fmi3IntermediateUpdateCallback);
void fmi3FreeInstance(fmi3Instance);
fmi3Status fmi3EnterInitializationMode(fmi3Instance, fmi3Boolean, fmi3Float64, fmi3Float64, fmi3Boolean, fmi3Float64);
fmi3Status fmi3ExitInitializationMode(fmi3Instance);
fmi3Status fmi3DoStep(fmi3Instance, fmi3Float64, fmi3Float64, fmi3Boolean, fmi3Boolean *, fmi3Boolean *, fmi3Boolean *, fmi3Float64 *);
fmi3Status fmi3EnterEventMode(fmi3Instance);
fmi3Status fmi3EnterStepMode(fmi3Instance);
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance, fmi3Boolean *, fmi3Boolean *, fmi3Boolean *, fmi3Boolean *, fmi3Boolean *, fmi3Float64 *);
fmi3Status fmi3GetClock(fmi3Instance, const fmi3ValueReference[], size_t, fmi3Clock[]);
fmi3Status fmi3SetClock(fmi3Instance, const fmi3ValueReference[], size_t, const fmi3Clock[]);
fmi3Status fmi3GetBinary(fmi3Instance, const fmi3ValueReference[], size_t, size_t[], fmi3Binary[], size_t);
fmi3Status fmi3SetBinary(fmi3Instance, const fmi3ValueReference[], size_t, const size_t[], const fmi3Binary[], size_t);

#define MOST 70000U

static uint64_t seed;
static unsigned format_errors;
static unsigned frames;

static uint32_t any(uint32_t below)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (uint32_t)(seed >> 11) % below;
}

static uint32_t number_at(const fmi3Byte *bytes)
{
    return bytes[0] | ((uint32_t)bytes[1] << 8) | ((uint32_t)bytes[2] << 16) | ((uint32_t)bytes[3] << 24);
}

/* An operation of a known or unknown code, with a length that is right, wrong by a little or anything. */
static size_t put_operation(fmi3Byte *to)
{
    static const uint32_t codes[] = {1U, 0x10U, 0x10U, 0x10U, 0x11U, 0x11U, 0x12U, 0x20U, 0x30U, 0x31U, 0x40U, 0x41U, 0x42U, 0x99U};
    static const uint32_t identifiers[] = {257U, 300U, 301U, 419361024U, 0x7FFU, 0x800U, 0xFFFFFFFFU};
    const uint32_t code = codes[any(14U)];
    const uint32_t fixed = (code == 0x11U) ? 17U : (code == 0x12U) ? 22U : 16U;
    const uint32_t data = any(10U);
    const uint32_t size = fixed + data;
    const uint32_t identifier = identifiers[any(7U)];
    uint32_t said = size;
    for (uint32_t i = 0; i < size; i++) {
        to[i] = (fmi3Byte)any(256U);
    }
    if (any(8U) == 0U) {
        said = (any(2U) == 0U) ? any(40U) : (any(2U) == 0U) ? 0xFFFFFFFFU : (uint32_t)seed;
    }
    for (uint32_t i = 0; i < 4U; i++) {
        to[i] = (fmi3Byte)(code >> (8U * i));
        to[4U + i] = (fmi3Byte)(said >> (8U * i));
        to[8U + i] = (fmi3Byte)(identifier >> (8U * i));
    }
    for (uint32_t i = 12; i < (fixed - 2U); i++) {
        to[i] = (fmi3Byte)any(3U);
    }
    to[12] = (fmi3Byte)((identifier > 0x7FFU) ? 1U : any(2U) * any(2U));
    to[fixed - 2U] = (fmi3Byte)((any(10U) == 0U) ? any(256U) : data);
    to[fixed - 1U] = (fmi3Byte)((any(20U) == 0U) ? any(256U) : 0U);
    return size;
}

static void check_sent(fmi3Instance instance, fmi3ValueReference first)
{
    const fmi3ValueReference clock = first + 2U;
    const fmi3ValueReference data = first + 3U;
    fmi3Clock is_active = false;
    fmi3Binary bytes = NULL;
    size_t size = 0;
    size_t at = 0;
    if ((fmi3GetClock(instance, &clock, 1U, &is_active) != fmi3OK) || (fmi3GetBinary(instance, &data, 1U, &size, &bytes, 1U) != fmi3OK)
        || (is_active != (size > 0U))) {
        abort();
    }
    while (at < size) {
        const uint32_t length = ((size - at) >= 8U) ? number_at(&bytes[at + 4U]) : 0U;
        if ((length < 8U) || (length > (size - at))) {
            abort();
        }
        format_errors += (number_at(&bytes[at]) == 1U) ? 1U : 0U;
        frames += (number_at(&bytes[at]) == 0x10U) ? 1U : 0U;
        at += length;
    }
}

int main(int count, char **arguments)
{
    static fmi3Byte bytes[MOST + 100U];
    const fmi3ValueReference first = (fmi3ValueReference)strtoul(arguments[4], NULL, 10);
    const fmi3ValueReference data = first + 1U;
    fmi3Instance instance =
        fmi3InstantiateCoSimulation("f", arguments[1], NULL, false, false, true, false, NULL, 0U, NULL, NULL, NULL);
    const unsigned rounds = (unsigned)strtoul(arguments[3], NULL, 10);
    double now = 0.0;
    (void)count;
    seed = strtoull(arguments[2], NULL, 10) * 2654435761U + 1U;
    if ((instance == NULL) || (fmi3EnterInitializationMode(instance, false, 0.0, 0.0, false, 0.0) != fmi3OK)
        || (fmi3ExitInitializationMode(instance) != fmi3OK)) {
        return 2;
    }
    for (unsigned i = 0; i < rounds; i++) {
        const fmi3Clock active = any(20U) != 0U;
        const uint32_t most = (any(50U) == 0U) ? 3000U : any(6U);
        fmi3Boolean found[5];
        double time;
        size_t size = 0;
        fmi3Binary given = bytes;
        if (any(5U) == 0U) {
            size = any((any(10U) == 0U) ? MOST : 200U);
            for (size_t k = 0; k < size; k++) {
                bytes[k] = (fmi3Byte)any(256U);
            }
        } else {
            for (uint32_t k = 0; (k < most) && (size < MOST - 100U); k++) {
                size += put_operation(&bytes[size]);
            }
            size -= (any(5U) == 0U) ? any(8U) % (size + 1U) : 0U;
        }
        (void)fmi3SetClock(instance, &first, 1U, &active);
        if ((fmi3SetBinary(instance, &data, 1U, &size, &given, 1U) == fmi3OK) != (size <= 65536U)) {
            abort();
        }
        (void)memset(bytes, 0xEE, sizeof(bytes));
        if (fmi3UpdateDiscreteStates(instance, &found[0], &found[1], &found[2], &found[3], &found[4], &time) > fmi3Warning) {
            abort();
        }
        check_sent(instance, first);
        (void)fmi3UpdateDiscreteStates(instance, &found[0], &found[1], &found[2], &found[3], &found[4], &time);
        (void)fmi3EnterStepMode(instance);
        (void)fmi3DoStep(instance, now, 0.01, true, &found[0], &found[1], &found[2], &time);
        now = (i + 1U) * 0.01;
        (void)fmi3EnterEventMode(instance);
    }
    fmi3FreeInstance(instance);
    (void)printf("%u format errors, %u frames\n", format_errors, frames);
    return 0;
}
