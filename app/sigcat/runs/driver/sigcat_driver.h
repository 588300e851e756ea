/* Tables of the driver of a simulation: the functions of a set, where values go, and what is sent to whom. */

#ifndef SIGCAT_DRIVER_H
#define SIGCAT_DRIVER_H

#include "sigcat_host.h"

/* Where a record of the input goes. */
typedef struct {
    enum { SIGCAT_VALUE, SIGCAT_DURATION, SIGCAT_STORED, SIGCAT_GONE } kind;
    uint32_t function;
    uint32_t number; /* of the receiver, the call, what is stored, or the function that is gone */
    uint32_t size;
} sigcat_entry;

/* What is sent, and the entries that get it. */
typedef struct {
    uint32_t size;
    uint32_t count;
    const uint32_t *entries;
} sigcat_exit;

extern const sigcat_function *const sigcat_functions[];
extern const uint32_t sigcat_function_count;
extern const sigcat_entry sigcat_entries[];
extern const uint32_t sigcat_entry_count;
extern const sigcat_exit sigcat_exits[];
extern const uint32_t sigcat_call_count;
extern const uint32_t sigcat_largest;

#endif /* SIGCAT_DRIVER_H */
