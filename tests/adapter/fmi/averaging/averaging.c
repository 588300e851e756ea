#include "averaging.h"

void averaging_init(averaging_t *self)
{
    self->mean = 0.0;
    self->count = 0U;
}

void averaging_step(averaging_t *self)
{
    self->last[self->count % 4U] = self->speed + 0.01f * self->acceleration;
    self->count++;
    self->mean += ((double)self->speed - self->mean) * (double)self->weight;
}
