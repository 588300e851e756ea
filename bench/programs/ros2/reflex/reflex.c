#include "reflex.h"

float reflex_speed;
float reflex_half;

void reflex_step(void)
{
  reflex_half = reflex_speed / 2.0F;
}
