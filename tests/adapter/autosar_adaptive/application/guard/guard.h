#ifndef GUARD_H
#define GUARD_H

#include <stdint.h>

extern float guard_speed;
extern uint8_t guard_broken;

void guard_step(void);

#endif
