#pragma once
#include "rtwtypes.h"
typedef struct { real32_T Dst; real32_T Spd; } Object;
typedef struct { Object Obj[2]; uint8_T Count; } FusionInputs;
typedef struct { real32_T Nearest; } FusionOutputs;
extern FusionInputs fusion_inputs;
extern FusionOutputs fusion_outputs;
void fusion_init(void);
void fusion_step(void); /* every 40 ms */
void fusion_terminate(void);
