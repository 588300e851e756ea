/*
 * What the driver of a simulation knows of each function: the calls of its adapter, under one name.
 * Values are handed over as bytes: their numbers one after the other, without gaps, as this machine has them.
 */

#ifndef SIGCAT_DRIVER_H
#define SIGCAT_DRIVER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SIGCAT_NONE UINT32_MAX

typedef struct {
    uint32_t init; /* number of the call; SIGCAT_NONE if there is none */
    uint32_t terminate;
    uint32_t first; /* number of the first of its calls */
    void (*restore)(uint32_t item, const unsigned char *bytes);
    bool (*start_up)(uint32_t ignition_cycle);
    void (*start)(uint64_t t);
    void (*receive)(uint32_t receiver, const unsigned char *bytes, uint64_t t);
    uint32_t (*next_call)(uint64_t t); /* from 0; SIGCAT_NONE if none is due */
    uint64_t (*next_time)(void);
    void (*set_input)(uint32_t call, uint64_t t);
    void (*begin)(uint32_t call, uint64_t t);
    void (*run)(uint32_t call);
    void (*get_output)(uint32_t call, uint64_t t);
    void (*supervise)(uint64_t t);
    void (*send)(void); /* hands values to publish to sigcat_sends */
    bool (*serve)(uint32_t method, const unsigned char *arguments, unsigned char *results);
    void (*terminate_at)(uint64_t t);
    void (*store)(void); /* hands values to store to sigcat_stores */
} sigcat_function;

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

void sigcat_sends(uint32_t number, const unsigned char *bytes);
bool sigcat_is_there(uint32_t function); /* whether anything of it is called any more */
bool sigcat_serves(uint32_t function, uint32_t method, const unsigned char *arguments, unsigned char *results);
void sigcat_stores(uint32_t number, const unsigned char *bytes, size_t size);

const unsigned char *sigcat_take(const unsigned char *from, void *to, size_t size);
unsigned char *sigcat_put(unsigned char *to, const void *from, size_t size);

#ifdef __cplusplus
}
#endif

#endif /* SIGCAT_DRIVER_H */
