#include "burst.h"
uint16_t taken[2], frames[2];
uint32_t taken_count, frame_count, sum;
void old_step(void)
{
    for (uint32_t i = 0; i < taken_count; i++) { sum = sum * 31U + taken[i]; }
    for (uint32_t i = 0; i < frame_count; i++) { sum = sum * 37U + frames[i]; }
}
