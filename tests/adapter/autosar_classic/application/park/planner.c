#include "park.h"
uint16_t near_distance[4]; wheels_t wheels, plan_wheels; uint16_t brake, old_count; int32_t curve; uint8_t mode_in, mode_out, no_parking, why;
static uint16_t count;
void planner_guard(void)
{
    brake = (uint16_t)(no_parking * 1000U + wheels.Speeds[1] + (near_distance[2] < 1000U ? 100U : 0U));
    count++;
    mode_out = mode_in;
}
void planner_plan(void) { curve = (int32_t)plan_wheels.Speeds[0] - (int32_t)plan_wheels.Speeds[3]; }
void planner_reset(void) { old_count = count; count = why; }
