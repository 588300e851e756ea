#include "follow.h"
double speed, wanted;
uint8_t gear_in, gear_out;
void follow_step(void) { wanted = speed + 0.5; gear_out = gear_in; }
