/*
 * The functions of FMI 2.0 for co-simulation, over those of FMI 3.0 in sigcat_fmu.c.
 *
 * FMI 2.0 has four types of variables. Real has floating-point numbers, and integers that 32 bits with a sign do not hold.
 */

#include "sigcat_fmi2.h"
#include "sigcat_fmu.h"

#include <float.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* Functions of sigcat_fmu.c. */
fmi3Instance FMI3(InstantiateCoSimulation)(
    fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean, fmi3Boolean, fmi3Boolean, const fmi3ValueReference[], size_t,
    fmi3InstanceEnvironment, fmi3LogMessageCallback, fmi3IntermediateUpdateCallback);
void FMI3(FreeInstance)(fmi3Instance);
fmi3Status FMI3(SetDebugLogging)(fmi3Instance, fmi3Boolean, size_t, const fmi3String[]);
fmi3Status FMI3(EnterInitializationMode)(fmi3Instance, fmi3Boolean, fmi3Float64, fmi3Float64, fmi3Boolean, fmi3Float64);
fmi3Status FMI3(ExitInitializationMode)(fmi3Instance);
fmi3Status FMI3(Terminate)(fmi3Instance);
fmi3Status FMI3(Reset)(fmi3Instance);
fmi3Status FMI3(DoStep)(
    fmi3Instance, fmi3Float64, fmi3Float64, fmi3Boolean, fmi3Boolean *, fmi3Boolean *, fmi3Boolean *, fmi3Float64 *);
fmi3Status FMI3(GetFMUState)(fmi3Instance, fmi3FMUState *);
fmi3Status FMI3(SetFMUState)(fmi3Instance, fmi3FMUState);
fmi3Status FMI3(FreeFMUState)(fmi3Instance, fmi3FMUState *);
fmi3Status FMI3(SerializedFMUStateSize)(fmi3Instance, fmi3FMUState, size_t *);
fmi3Status FMI3(SerializeFMUState)(fmi3Instance, fmi3FMUState, fmi3Byte[], size_t);
fmi3Status FMI3(DeserializeFMUState)(fmi3Instance, const fmi3Byte[], size_t, fmi3FMUState *);
#define ACCESSED(name) \
    fmi3Status FMI3(Get##name)(fmi3Instance, const fmi3ValueReference[], size_t, fmi3##name[], size_t); \
    fmi3Status FMI3(Set##name)(fmi3Instance, const fmi3ValueReference[], size_t, const fmi3##name[], size_t);
ACCESSED(Float32)
ACCESSED(Float64)
ACCESSED(Int8)
ACCESSED(UInt8)
ACCESSED(Int16)
ACCESSED(UInt16)
ACCESSED(Int32)
ACCESSED(UInt32)
ACCESSED(Int64)
ACCESSED(UInt64)
ACCESSED(Boolean)

typedef struct {
    fmi3Instance inner;
    fmi2CallbackLogger logger;
    fmi2ComponentEnvironment environment;
    char *name;
    fmi2Boolean has_tolerance;
    fmi2Real tolerance;
    fmi2Real start;
    fmi2Boolean has_stop;
    fmi2Real stop;
} component;

/* -- messages ---------------------------------------------------------------------------------------------------- */

static void forwarded(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message)
{
    const component *const self = (const component *)environment;
    if (self->logger != NULL) {
        self->logger(self->environment, self->name, (fmi2Status)status, category, message);
    }
}

static fmi2Status refused(fmi2Component instance, const char *message)
{
    if (instance != NULL) {
        forwarded(instance, fmi3Error, "logStatusError", message);
    }
    return fmi2Error;
}

static fmi3Instance inner_of(fmi2Component instance)
{
    return (instance == NULL) ? NULL : ((const component *)instance)->inner;
}

/* -- life -------------------------------------------------------------------------------------------------------- */

static void free_component(component *self)
{
    free(self->name);
    free(self);
}

static component *new_component(fmi2String name, const fmi2CallbackFunctions *functions)
{
    component *const self = (component *)calloc(1U, sizeof(component));
    const size_t size = strlen(name) + 1U;
    if (self != NULL) {
        self->logger = functions->logger;
        self->environment = functions->componentEnvironment;
        self->name = (char *)malloc(size);
        if (self->name == NULL) {
            free_component(self);
            return NULL;
        }
        (void)memcpy(self->name, name, size);
    }
    return self;
}

SIGCAT_EXPORT const char *FMI2(GetTypesPlatform)(void)
{
    return "default";
}

SIGCAT_EXPORT const char *FMI2(GetVersion)(void)
{
    return "2.0";
}

SIGCAT_EXPORT fmi2Status FMI2(SetDebugLogging)(fmi2Component c, fmi2Boolean loggingOn, size_t nCategories, const fmi2String categories[])
{
    return (fmi2Status)FMI3(SetDebugLogging)(inner_of(c), loggingOn != 0, nCategories, categories);
}

SIGCAT_EXPORT fmi2Component FMI2(Instantiate)(
    fmi2String instanceName, fmi2Type fmuType, fmi2String fmuGUID, fmi2String fmuResourceLocation,
    const fmi2CallbackFunctions *functions, fmi2Boolean visible, fmi2Boolean loggingOn)
{
    component *self;
    (void)fmuResourceLocation;
    if ((instanceName == NULL) || (functions == NULL)) {
        return NULL;
    }
    self = new_component(instanceName, functions);
    if (self == NULL) {
        return NULL;
    }
    if (fmuType == fmi2CoSimulation) {
        self->inner = FMI3(InstantiateCoSimulation)(
            instanceName, fmuGUID, "", visible != 0, loggingOn != 0, false, false, NULL, 0U, self, forwarded, NULL);
    } else {
        (void)refused(self, "This FMU is for co-simulation.");
    }
    if (self->inner == NULL) {
        free_component(self);
        self = NULL;
    }
    return self;
}

SIGCAT_EXPORT void FMI2(FreeInstance)(fmi2Component c)
{
    if (c != NULL) {
        FMI3(FreeInstance)(inner_of(c));
        free_component((component *)c);
    }
}

SIGCAT_EXPORT fmi2Status FMI2(SetupExperiment)(
    fmi2Component c, fmi2Boolean toleranceDefined, fmi2Real tolerance, fmi2Real startTime, fmi2Boolean stopTimeDefined,
    fmi2Real stopTime)
{
    component *const self = (component *)c;
    if (self == NULL) {
        return fmi2Error;
    }
    self->has_tolerance = toleranceDefined;
    self->tolerance = tolerance;
    self->start = startTime;
    self->has_stop = stopTimeDefined;
    self->stop = stopTime;
    return fmi2OK;
}

SIGCAT_EXPORT fmi2Status FMI2(EnterInitializationMode)(fmi2Component c)
{
    const component *const self = (const component *)c;
    if (self == NULL) {
        return fmi2Error;
    }
    return (fmi2Status)FMI3(EnterInitializationMode)(
        self->inner, self->has_tolerance != 0, self->tolerance, self->start, self->has_stop != 0, self->stop);
}

SIGCAT_EXPORT fmi2Status FMI2(ExitInitializationMode)(fmi2Component c)
{
    return (fmi2Status)FMI3(ExitInitializationMode)(inner_of(c));
}

SIGCAT_EXPORT fmi2Status FMI2(Terminate)(fmi2Component c)
{
    return (fmi2Status)FMI3(Terminate)(inner_of(c));
}

SIGCAT_EXPORT fmi2Status FMI2(Reset)(fmi2Component c)
{
    return (fmi2Status)FMI3(Reset)(inner_of(c));
}

SIGCAT_EXPORT fmi2Status FMI2(DoStep)(
    fmi2Component c, fmi2Real currentCommunicationPoint, fmi2Real communicationStepSize,
    fmi2Boolean noSetFMUStatePriorToCurrentPoint)
{
    fmi3Boolean event = false;
    fmi3Boolean terminate = false;
    fmi3Boolean early = false;
    fmi3Float64 last = 0.0;
    return (fmi2Status)FMI3(DoStep)(
        inner_of(c), currentCommunicationPoint, communicationStepSize, noSetFMUStatePriorToCurrentPoint != 0, &event, &terminate,
        &early, &last);
}

/* -- values ------------------------------------------------------------------------------------------------------ */

typedef enum { NONE, REAL, INTEGER, BOOLEAN } kind;

static kind kind_of(fmi2ValueReference reference)
{
    if (reference >= sigcat_model.variable_count) {
        return NONE;
    }
    if (sigcat_model.variables[reference].is_enumeration) {
        return INTEGER;
    }
    switch (sigcat_model.variables[reference].type) {
        case SIGCAT_FLOAT32:
        case SIGCAT_FLOAT64:
        case SIGCAT_UINT32:
        case SIGCAT_INT64:
        case SIGCAT_UINT64: return REAL;
        case SIGCAT_BOOLEAN: return BOOLEAN;
        default: return INTEGER;
    }
}

/* Whether every variable is there and has the type; a message says which is not so. */
static bool are_of(fmi2Component c, kind wanted, const fmi2ValueReference references[], size_t count, const void *values)
{
    if ((c == NULL) || ((count > 0U) && ((references == NULL) || (values == NULL)))) {
        (void)refused(c, "Value references and values must be there.");
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        const kind found = kind_of(references[i]);
        if (found != wanted) {
            (void)refused(
                c, (found == NONE) ? "A value reference is not one of modelDescription.xml."
                                   : "A variable has another type in modelDescription.xml.");
            return false;
        }
    }
    return true;
}

#define READ(name, result) \
    do { \
        fmi3##name read = 0; \
        status = FMI3(Get##name)(inner, &reference, 1U, &read, 1U); \
        *(result) = read; \
    } while (0)

/* A number within the limits, or an error. */
#define WRITE(name, fits, value) \
    do { \
        if (fits) { \
            const fmi3##name written = (fmi3##name)(value); \
            status = FMI3(Set##name)(inner, &reference, 1U, &written, 1U); \
        } \
    } while (0)

static fmi3Status get_real(fmi3Instance inner, fmi3ValueReference reference, fmi2Real *to)
{
    fmi3Status status = fmi3Error;
    switch (sigcat_model.variables[reference].type) {
        case SIGCAT_FLOAT32: READ(Float32, to); break;
        case SIGCAT_FLOAT64: READ(Float64, to); break;
        case SIGCAT_UINT32: READ(UInt32, to); break;
        case SIGCAT_INT64: {
            int64_t number = 0;
            READ(Int64, &number);
            *to = (fmi2Real)number;
            break;
        }
        default: {
            uint64_t number = 0;
            READ(UInt64, &number);
            *to = (fmi2Real)number;
            break;
        }
    }
    return status;
}

static bool is_whole(fmi2Real value, fmi2Real least, fmi2Real beyond)
{
    if (!((value >= least) && (value < beyond))) {
        return false;
    }
    return (value < 0.0) ? ((fmi2Real)(int64_t)value == value) : ((fmi2Real)(uint64_t)value == value);
}

static fmi3Status set_real(fmi3Instance inner, fmi3ValueReference reference, fmi2Real value)
{
    const bool is_finite = (value - value) == 0.0;
    fmi3Status status = fmi3Error;
    switch (sigcat_model.variables[reference].type) {
        case SIGCAT_FLOAT32: WRITE(Float32, !is_finite || ((value <= FLT_MAX) && (value >= -FLT_MAX)), value); break;
        case SIGCAT_FLOAT64: WRITE(Float64, true, value); break;
        case SIGCAT_UINT32: WRITE(UInt32, is_whole(value, 0.0, 4294967296.0), value); break;
        case SIGCAT_INT64: WRITE(Int64, is_whole(value, -9223372036854775808.0, 9223372036854775808.0), value); break;
        default: WRITE(UInt64, is_whole(value, 0.0, 18446744073709551616.0), value); break;
    }
    return status;
}

static fmi3Status get_integer(fmi3Instance inner, fmi3ValueReference reference, fmi2Integer *to)
{
    const sigcat_variable *const variable = &sigcat_model.variables[reference];
    fmi3Status status = fmi3Error;
    if (variable->is_enumeration) {
        int64_t number = 0;
        READ(Int64, &number);
        *to = (fmi2Integer)number;
        return ((number >= INT_MIN) && (number <= INT_MAX)) ? status : fmi3Error;
    }
    switch (variable->type) {
        case SIGCAT_INT8: READ(Int8, to); break;
        case SIGCAT_UINT8: READ(UInt8, to); break;
        case SIGCAT_INT16: READ(Int16, to); break;
        case SIGCAT_UINT16: READ(UInt16, to); break;
        default: READ(Int32, to); break;
    }
    return status;
}

static fmi3Status set_integer(fmi3Instance inner, fmi3ValueReference reference, fmi2Integer value)
{
    const sigcat_variable *const variable = &sigcat_model.variables[reference];
    fmi3Status status = fmi3Error;
    if (variable->is_enumeration) {
        WRITE(Int64, true, value);
        return status;
    }
    switch (variable->type) {
        case SIGCAT_INT8: WRITE(Int8, (value >= INT8_MIN) && (value <= INT8_MAX), value); break;
        case SIGCAT_UINT8: WRITE(UInt8, (value >= 0) && (value <= UINT8_MAX), value); break;
        case SIGCAT_INT16: WRITE(Int16, (value >= INT16_MIN) && (value <= INT16_MAX), value); break;
        case SIGCAT_UINT16: WRITE(UInt16, (value >= 0) && (value <= UINT16_MAX), value); break;
        default: WRITE(Int32, true, value); break;
    }
    return status;
}

static fmi3Status get_boolean(fmi3Instance inner, fmi3ValueReference reference, fmi2Boolean *to)
{
    fmi3Status status = fmi3Error;
    READ(Boolean, to);
    return status;
}

static fmi3Status set_boolean(fmi3Instance inner, fmi3ValueReference reference, fmi2Boolean value)
{
    fmi3Status status = fmi3Error;
    WRITE(Boolean, true, value != 0);
    return status;
}

#define ACCESS(name, kind, get_one, set_one) \
    SIGCAT_EXPORT fmi2Status FMI2(Get##name)(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2##name value[]) \
    { \
        fmi3Status status = are_of(c, kind, vr, nvr, value) ? fmi3OK : fmi3Error; \
        for (size_t i = 0; (i < nvr) && (status == fmi3OK); i++) { \
            status = get_one(inner_of(c), vr[i], &value[i]); \
        } \
        return (fmi2Status)status; \
    } \
    SIGCAT_EXPORT fmi2Status FMI2(Set##name)(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2##name value[]) \
    { \
        fmi3Status status = are_of(c, kind, vr, nvr, value) ? fmi3OK : fmi3Error; \
        for (size_t i = 0; (i < nvr) && (status == fmi3OK); i++) { \
            status = set_one(inner_of(c), vr[i], value[i]); \
            if (status == fmi3Error) { \
                (void)refused(c, "A value was refused: it cannot be set now, or does not fit its datatype."); \
            } \
        } \
        return (fmi2Status)status; \
    }

ACCESS(Real, REAL, get_real, set_real)
ACCESS(Integer, INTEGER, get_integer, set_integer)
ACCESS(Boolean, BOOLEAN, get_boolean, set_boolean)

/* -- state ------------------------------------------------------------------------------------------------------- */

SIGCAT_EXPORT fmi2Status FMI2(GetFMUstate)(fmi2Component c, fmi2FMUstate *FMUstate)
{
    return (fmi2Status)FMI3(GetFMUState)(inner_of(c), FMUstate);
}

SIGCAT_EXPORT fmi2Status FMI2(SetFMUstate)(fmi2Component c, fmi2FMUstate FMUstate)
{
    return (fmi2Status)FMI3(SetFMUState)(inner_of(c), FMUstate);
}

SIGCAT_EXPORT fmi2Status FMI2(FreeFMUstate)(fmi2Component c, fmi2FMUstate *FMUstate)
{
    return (fmi2Status)FMI3(FreeFMUState)(inner_of(c), FMUstate);
}

SIGCAT_EXPORT fmi2Status FMI2(SerializedFMUstateSize)(fmi2Component c, fmi2FMUstate FMUstate, size_t *size)
{
    return (fmi2Status)FMI3(SerializedFMUStateSize)(inner_of(c), FMUstate, size);
}

SIGCAT_EXPORT fmi2Status FMI2(SerializeFMUstate)(fmi2Component c, fmi2FMUstate FMUstate, fmi2Byte serializedState[], size_t size)
{
    return (fmi2Status)FMI3(SerializeFMUState)(inner_of(c), FMUstate, (fmi3Byte *)serializedState, size);
}

SIGCAT_EXPORT fmi2Status FMI2(DeSerializeFMUstate)(
    fmi2Component c, const fmi2Byte serializedState[], size_t size, fmi2FMUstate *FMUstate)
{
    return (fmi2Status)FMI3(DeserializeFMUState)(inner_of(c), (const fmi3Byte *)serializedState, size, FMUstate);
}

/* -- what this FMU does not offer, as its modelDescription.xml says ----------------------------------------------- */

/* Arguments have the names of the standard, and none is used. */
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
#define NOT_OFFERED(name, ...) \
    SIGCAT_EXPORT fmi2Status FMI2(name)(__VA_ARGS__) \
    { \
        return refused(c, "This FMU does not offer the function that was called."); \
    }

NOT_OFFERED(GetString, fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2String value[])
NOT_OFFERED(SetString, fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2String value[])
NOT_OFFERED(GetDirectionalDerivative, fmi2Component c, const fmi2ValueReference vUnknown_ref[], size_t nUnknown, const
    fmi2ValueReference vKnown_ref[], size_t nKnown, const fmi2Real dvKnown[], fmi2Real dvUnknown[])
NOT_OFFERED(SetRealInputDerivatives, fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2Integer order[], const
    fmi2Real value[])
NOT_OFFERED(GetRealOutputDerivatives, fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2Integer order[],
    fmi2Real value[])
NOT_OFFERED(CancelStep, fmi2Component c)
NOT_OFFERED(GetStatus, fmi2Component c, const fmi2StatusKind s, fmi2Status *value)
NOT_OFFERED(GetRealStatus, fmi2Component c, const fmi2StatusKind s, fmi2Real *value)
NOT_OFFERED(GetIntegerStatus, fmi2Component c, const fmi2StatusKind s, fmi2Integer *value)
NOT_OFFERED(GetBooleanStatus, fmi2Component c, const fmi2StatusKind s, fmi2Boolean *value)
NOT_OFFERED(GetStringStatus, fmi2Component c, const fmi2StatusKind s, fmi2String *value)

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
