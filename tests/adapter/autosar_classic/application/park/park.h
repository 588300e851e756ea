#ifndef PARK_H
#define PARK_H
#include <stdbool.h>
#include <stdint.h>
typedef struct { uint8_t Sensor; float Range; } echo_t;
typedef struct { uint16_t Speeds[4]; bool IsSliding; } wheels_t;
extern echo_t echoes[3], shown_echo;
extern uint32_t echo_count, screen;
extern int8_t temperature;
extern float distance[4];
extern uint16_t near_distance[4];
extern wheels_t wheels, plan_wheels, shown_wheels;
extern uint16_t brake, old_count, shown_brake, ask_old;
extern int32_t curve;
extern uint8_t mode_in, mode_out, no_parking, why, ask_why, ask_state;
extern bool ask;
void fusion_init(void); void fusion_step(void); void planner_guard(void); void planner_plan(void); void planner_reset(void); void hmi_step(void);
#endif
