#include "objects.h"

object_t ahead_in, nearest;
point_t around_in[2], seen[2];
uint8_t lanes_in[2], lanes[2];
uint16_t last[2];
uint32_t last_count;

void objects_init(void) {}

void objects_step(void)
{
    nearest = ahead_in;
    for (int i = 0; i < 2; i++) {
        seen[i] = around_in[1 - i];
        lanes[i] = lanes_in[1 - i];
    }
    last[0] = last[1];
    last[1] = nearest.Speed;
    last_count = 2;
}

void objects_terminate(void) {}
