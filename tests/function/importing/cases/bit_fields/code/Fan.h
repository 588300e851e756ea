#pragma once
#include <stdint.h>
typedef struct { float level; /* [percent] */ unsigned mode : 3; uint8_t gear; /* 0.5 degC, offset 20 */ unsigned on : 1; } Fan_In;
typedef struct { float flow; unsigned state : 2; } Fan_Out;
void Fan_Init(void);
void Fan_Step(const Fan_In *in, Fan_Out *out);
