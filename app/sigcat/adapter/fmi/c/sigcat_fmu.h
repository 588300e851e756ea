/* Tables of an FMU: its functions, its variables by value reference, and what is sent to whom. */

#ifndef SIGCAT_FMU_H
#define SIGCAT_FMU_H

#include "sigcat_host.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    SIGCAT_FLOAT32,
    SIGCAT_FLOAT64,
    SIGCAT_INT8,
    SIGCAT_UINT8,
    SIGCAT_INT16,
    SIGCAT_UINT16,
    SIGCAT_INT32,
    SIGCAT_UINT32,
    SIGCAT_INT64,
    SIGCAT_UINT64,
    SIGCAT_BOOLEAN
} sigcat_type;

typedef enum { SIGCAT_TIME, SIGCAT_INPUT, SIGCAT_OUTPUT, SIGCAT_PARAMETER } sigcat_causality;

/* A variable; its value reference is its index. */
typedef struct {
    sigcat_causality causality;
    sigcat_type type; /* in which it is stored */
    bool is_enumeration; /* FMI has 64 bits for it, whatever it is stored in */
    uint32_t owner; /* number of the input, the output, or the function whose parameter it is */
    uint32_t offset; /* of its first byte among the values of an instance */
    uint32_t count; /* elements */
} sigcat_variable;

/* What a function receives. */
typedef struct {
    uint32_t function;
    uint32_t receiver; /* its number among those of the function */
    uint32_t offset; /* of its value; nothing is there for one that a function of the FMU sends */
    uint32_t variable; /* the first input of this name: all of them are one variable */
} sigcat_input;

/* What a function sends, and the inputs of others that get it. */
typedef struct {
    uint32_t offset;
    uint32_t size;
    uint32_t count;
    const uint32_t *inputs;
} sigcat_output;

/* A call of the function, for scheduled execution; the value reference of its clock follows those of the variables. */
typedef struct {
    bool is_inside; /* whether a signal of the same function triggers it: it runs in the activation that sends the signal */
} sigcat_call;

/* What a bus hands to the FMU. */
typedef struct {
    void *self;
    void (*take)(void *self, uint32_t variable, const unsigned char *bytes); /* a value of an input */
} sigcat_bus_host;

/* A bus, whose operations are in two binary variables with a clock each. */
typedef struct {
    size_t state_size;
    void (*start)(void *state);
    bool (*set_received)(void *state, const unsigned char *bytes, size_t size); /* false: they are too many */
    const unsigned char *(*get_received)(const void *state, size_t *size);
    void (*receive)(void *state, uint64_t now, const sigcat_bus_host *host); /* hands over the values that were received */
    void (*send_value)(void *state, uint32_t output, const unsigned char *bytes);
    void (*flush)(void *state, uint64_t now); /* makes frames of the values that are due */
    uint64_t (*next_time)(const void *state); /* when a value that waits is due */
    const unsigned char *(*get_sent)(const void *state, size_t *size);
    bool (*clear_sent)(void *state); /* false: frames were lost */
} sigcat_bus;

/* Value references of a bus follow those of the variables, in this order. */
typedef enum { SIGCAT_RX_CLOCK, SIGCAT_RX_DATA, SIGCAT_TX_CLOCK, SIGCAT_TX_DATA, SIGCAT_BUS_VARIABLES } sigcat_bus_variable;

typedef struct {
    const char *token;
    uint32_t function_count;
    const sigcat_function *const *functions;
    const uint32_t *parameters; /* of each function, the offset of its parameters, which are in the order of the function */
    uint32_t variable_count;
    const sigcat_variable *variables;
    uint32_t input_count;
    const sigcat_input *inputs;
    uint32_t output_count;
    const sigcat_output *outputs;
    uint32_t value_count; /* bytes of the values of an instance */
    const unsigned char *values; /* in the beginning */
    bool is_single; /* whether a process has one instance, as its code has global variables */
    bool is_copied; /* whether its state can be saved */
    bool is_scheduled; /* whether the importer activates its calls; it has one function then */
    uint32_t call_count;
    const sigcat_call *calls;
    const sigcat_bus *bus; /* NULL without one */
} sigcat_fmu;

extern const sigcat_fmu sigcat_model;

#ifdef __cplusplus
}
#endif

#endif /* SIGCAT_FMU_H */
