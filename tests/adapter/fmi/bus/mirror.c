#include "mirror.h"

void mirror_step(mirror_t *self)
{
    self->out_speed = self->wish_speed;
    self->out_temperature = self->wish_temperature;
    self->out_gear = self->wish_gear;
    self->out_ison = self->wish_ison;
    self->out_force = self->wish_force;
    self->out_turn = self->wish_turn;
    self->out_first = self->wish_first;
    self->out_second = self->wish_second;
    self->out_exact = self->wish_exact;
    self->out_wide = self->wish_wide;
}
