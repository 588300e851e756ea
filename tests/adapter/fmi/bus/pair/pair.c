#include "pair.h"

void wheel_step(wheel_t *self)
{
    self->time += 0.25;
    self->speed = self->time + (double)self->answer;
}

void display_step(display_t *self)
{
    self->count += 1;
    self->answer = (int32_t)(self->speed / 2.0) + self->count;
}
