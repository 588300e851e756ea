#ifndef LANES_H
#define LANES_H
#include <stdint.h>
extern float yaw_rate, heading;
extern uint16_t markings[4];
extern uint32_t marking_count, marking_sum;
extern int16_t offset, plan;
extern uint8_t lane_mode, keep_off;
extern float shown_heading;
extern uint16_t shown_marking;
extern uint32_t shown_count, shown;
void monitor_step(void);
void plan_step(void);
void display_step(void);
#endif
