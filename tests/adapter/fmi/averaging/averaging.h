#ifndef AVERAGING_H
#define AVERAGING_H

#include <stdint.h>

typedef struct {
    float speed;
    float acceleration;
    float weight;
    double mean;
    float last[4];
    uint32_t count;
} averaging_t;

void averaging_init(averaging_t *self);
void averaging_step(averaging_t *self);

#endif
