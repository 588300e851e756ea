/* Tables of a CAN bus of an FMU: its messages, their signals, and the variables that these carry (FMI-LS-BUS 1.0). */

#ifndef SIGCAT_BUS_H
#define SIGCAT_BUS_H

#include "sigcat_bus_sizes.h"
#include "sigcat_fmu.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum { SIGCAT_UNSIGNED, SIGCAT_SIGNED, SIGCAT_REAL } sigcat_encoding;

/* The numbers of a multiplexer that select a signal. */
typedef struct {
    uint32_t signal; /* the multiplexer */
    uint32_t count;
    const uint64_t *numbers;
} sigcat_selector;

typedef struct {
    uint32_t identifier;
    bool is_extended;
    bool is_fd;
    uint32_t length; /* bytes */
    uint32_t first_signal;
    uint32_t signal_count;
} sigcat_message;

typedef struct {
    uint32_t message;
    uint32_t start; /* of little endian, its lowest bit; of big endian, its highest bit, counted from the highest of the first byte */
    uint32_t length; /* bits */
    uint32_t size; /* bytes of a frame that holds it */
    bool is_big;
    sigcat_encoding encoding;
    double factor;
    double offset;
    double minimum; /* -INFINITY without one */
    double maximum; /* INFINITY without one */
    double step; /* from one number to the next; 0 of a real number */
    uint64_t initial; /* its bits before a value is sent */
    uint32_t selector_count;
    const sigcat_selector *selectors;
} sigcat_signal;

/* A number that has a value of its own, or none. */
typedef struct {
    double given;
    double meant;
    bool has_value;
} sigcat_item;

/* A signal of a message, and a variable that gets its values, or gives them. */
typedef struct {
    uint32_t signal;
    bool is_sent;
    uint32_t variable; /* its value reference; of one that is sent, the number of the output */
    uint32_t part; /* what is sent in one frame has one number */
    sigcat_type type; /* of the variable */
    double (*formula)(double x); /* NULL: the number is the value */
    bool is_rounded; /* whether the formula needs a finite number */
    bool is_listed; /* whether only listed numbers have a value */
    bool on_change;
    bool is_attempt; /* whether the interval begins with each attempt */
    uint64_t interval; /* ns */
    uint32_t item_count;
    const sigcat_item *items;
    uint32_t allowed_count; /* 0: all values are */
    const double *allowed;
} sigcat_mapping;

extern const sigcat_message sigcat_messages[SIGCAT_BUS_MESSAGES];
extern const sigcat_signal sigcat_signals[SIGCAT_BUS_SIGNALS];
extern const sigcat_mapping sigcat_mappings[SIGCAT_BUS_MAPPINGS];
extern const sigcat_bus sigcat_can;

#ifdef __cplusplus
}
#endif

#endif /* SIGCAT_BUS_H */
