/* What the code of the small functions has. */
#ifndef SMALL_H
#define SMALL_H

#include <stdint.h>

extern float small_value;
extern float small_in[13];
extern float small_out[2];
extern uint8_t small_request;

void small_step(void);
void small_method(void);

#endif
