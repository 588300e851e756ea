#ifndef FOLLOW_H
#define FOLLOW_H

#include <stdint.h>

extern uint32_t follow_steps;
extern uint8_t follow_dep;

void follow_step(void);

#endif
