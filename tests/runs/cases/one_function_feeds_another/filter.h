#ifndef FILTER_H
#define FILTER_H

#include <stdint.h>

typedef struct { double speed; uint8_t mode; } filter_in_t;
typedef struct { float levels[3]; uint8_t trend; uint8_t stands; uint8_t mode; } filter_out_t;

extern filter_in_t filter_in;
extern filter_out_t filter_out;

void filter_init(void);
void filter_step(void);
void filter_terminate(void);

#endif
