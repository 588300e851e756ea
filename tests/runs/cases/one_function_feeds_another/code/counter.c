#include "counter.h"

void counter_init(counter_t *self)
{
    self->count = 0;
}

void counter_step(counter_t *self)
{
    const counter_inputs_t *in = self->in;
    if (!in->hold) {
        self->count += COUNTER_STEP;
    }
    self->mean = ((double)in->levels[0] + in->levels[1] + in->levels[2]) / 3.0;
    self->rises = in->trend == 3;
}

void counter_terminate(counter_t *self)
{
    (void)self;
}
