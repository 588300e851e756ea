#include "slow.h"

float slow_speed;
float slow_out;

void slow_init(void) {}
void slow_step(void) { slow_out = slow_speed; }
void slow_terminate(void) {}
