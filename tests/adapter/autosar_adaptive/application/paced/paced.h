#ifndef PACED_H
#define PACED_H

#include <stdint.h>

extern float paced_speed;
extern float paced_slow_speed;
extern uint32_t paced_steps;
extern uint32_t paced_sum;
extern uint8_t paced_odd;
extern int32_t paced_asked;
extern int32_t paced_answer;

void paced_step(void);
void paced_slow_step(void);
void paced_alone_step(void);
void paced_ask(void);

#endif
