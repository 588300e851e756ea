#ifndef COUNTER_H
#define COUNTER_H

#include <stdbool.h>
#include <stdint.h>

typedef struct { float levels[3]; uint8_t trend; uint8_t hold; } counter_inputs_t;
typedef struct { counter_inputs_t *in; uint32_t count; double mean; bool rises; } counter_t;

void counter_init(counter_t *self);
void counter_step(counter_t *self);
void counter_terminate(counter_t *self);

#endif
