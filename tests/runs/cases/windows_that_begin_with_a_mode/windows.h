#ifndef WINDOWS_H
#define WINDOWS_H
#include <stdint.h>
extern uint8_t pedal;
extern uint8_t sum;
extern uint8_t mode;
void windows_first(void);
void windows_step(void);
#endif
