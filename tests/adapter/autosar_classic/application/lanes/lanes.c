#include "lanes.h"
float yaw_rate, heading;
uint16_t markings[4];
uint32_t marking_count, marking_sum;
int16_t offset, plan;
uint8_t lane_mode, keep_off;
void monitor_step(void)
{
    heading = yaw_rate;
    for (uint32_t i = 0; i < marking_count; i++) { marking_sum = marking_sum * 31U + markings[i]; }
}
void plan_step(void) { plan = offset; }
