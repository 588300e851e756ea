/*
 * Types of FMI 2.0 (Functional Mock-up Interface) for co-simulation, as the standard names them.
 * With FMI2_FUNCTION_PREFIX the names of the functions begin with it, for FMUs that are linked into one program.
 */

#ifndef SIGCAT_FMI2_H
#define SIGCAT_FMI2_H

#include "sigcat_fmi3.h"

#ifdef __cplusplus
extern "C" {
#endif

#ifdef FMI2_FUNCTION_PREFIX
#define SIGCAT_JOIN_2(a, b) a##b
#define SIGCAT_PREFIXED_2(a, b) SIGCAT_JOIN_2(a, b)
#define FMI2(name) SIGCAT_PREFIXED_2(FMI2_FUNCTION_PREFIX, fmi2##name)
#else
#define FMI2(name) fmi2##name
#endif

typedef void *fmi2Component;
typedef void *fmi2ComponentEnvironment;
typedef void *fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean;
typedef const char *fmi2String;
typedef char fmi2Byte;
typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef enum { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated } fmi2StatusKind;
typedef void (*fmi2CallbackLogger)(
    fmi2ComponentEnvironment environment, fmi2String instanceName, fmi2Status status, fmi2String category, fmi2String message, ...);
typedef struct {
    fmi2CallbackLogger logger;
    void *(*allocateMemory)(size_t count, size_t size);
    void (*freeMemory)(void *memory);
    void (*stepFinished)(fmi2ComponentEnvironment environment, fmi2Status status);
    fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;

#ifdef __cplusplus
}
#endif

#endif /* SIGCAT_FMI2_H */
