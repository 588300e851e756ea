#include "chain.h"

void chain_step(chain_t *self)
{
    self->count += 1U + self->speed;
}

void chain_follow_step(chain_t *self)
{
    self->doubled = 2U * self->received;
}
