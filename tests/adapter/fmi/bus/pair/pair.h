#ifndef PAIR_H
#define PAIR_H

#include <stdint.h>

typedef struct {
    double time;
    double speed;
    int32_t answer;
} wheel_t;

typedef struct {
    double speed;
    int32_t answer;
    int32_t count;
} display_t;

void wheel_step(wheel_t *self);
void display_step(display_t *self);

#endif /* PAIR_H */
