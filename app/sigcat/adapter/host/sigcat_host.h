/*
 * What a host knows of a function: the calls of its adapter, under one name. Hosts are the simulation and an FMU.
 * Values are handed over as bytes: their numbers one after the other, without gaps, as this machine has them.
 */

#ifndef SIGCAT_HOST_H
#define SIGCAT_HOST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SIGCAT_NONE UINT32_MAX

/* What a function hands to its host. */
typedef struct {
    void *self;
    void (*sends)(void *self, uint32_t number, const unsigned char *bytes);
    void (*stores)(void *self, uint32_t number, const unsigned char *bytes, size_t size);
    bool (*is_there)(void *self, uint32_t function); /* whether another function is called any more */
    bool (*serves)(void *self, uint32_t function, uint32_t method, const unsigned char *arguments, unsigned char *results);
} sigcat_host;

typedef struct {
    uint32_t init; /* number of the call; SIGCAT_NONE if there is none */
    uint32_t terminate;
    uint32_t first; /* number of the first of its calls */
    size_t state_size; /* bytes that are its whole state; 0 if they are not, as code with global variables has more */
    void *(*create)(void); /* NULL: no memory is left */
    void (*destroy)(void *state);
    void (*restore)(void *state, uint32_t item, const unsigned char *bytes);
    bool (*start_up)(void *state, uint32_t ignition_cycle);
    void (*start)(void *state, uint64_t t);
    void (*receive)(void *state, uint32_t receiver, const unsigned char *bytes, uint64_t t);
    uint32_t (*next_call)(void *state, uint64_t t); /* from 0; SIGCAT_NONE if none is due */
    uint64_t (*next_time)(const void *state);
    void (*set_input)(void *state, uint32_t call, uint64_t t);
    void (*begin)(void *state, uint32_t call, uint64_t t);
    void (*run)(void *state, uint32_t call);
    void (*get_output)(void *state, uint32_t call, uint64_t t);
    void (*supervise)(void *state, uint64_t t);
    void (*send)(void *state, const sigcat_host *host); /* hands over what is to publish */
    bool (*serve)(void *state, uint32_t method, const unsigned char *arguments, unsigned char *results);
    bool (*set_parameters)(void *state, const unsigned char *bytes); /* all, or none if one is out of its range */
    void (*get_parameters)(const void *state, unsigned char *bytes);
    void (*terminate_at)(void *state, uint64_t t);
    void (*store)(void *state, const sigcat_host *host); /* hands over what is to store */
} sigcat_function;

static inline const unsigned char *sigcat_take(const unsigned char *from, void *to, size_t size)
{
    (void)memcpy(to, from, size);
    return from + size;
}

static inline unsigned char *sigcat_put(unsigned char *to, const void *from, size_t size)
{
    (void)memcpy(to, from, size);
    return to + size;
}

#ifdef __cplusplus
}
#endif

#endif /* SIGCAT_HOST_H */
