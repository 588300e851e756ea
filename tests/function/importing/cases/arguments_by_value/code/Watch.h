#pragma once
#include "rtwtypes.h"
typedef struct { real_T State; } DW_Watch_T;
typedef struct tag_RTM_Watch_T { DW_Watch_T *dwork; } RT_MODEL_Watch_T;
extern void Watch_initialize(RT_MODEL_Watch_T *const Watch_M, boolean_T *Watch_U_Start, uint8_T *Watch_Y_Seconds);
extern void Watch_step(RT_MODEL_Watch_T *const Watch_M, boolean_T Watch_U_Start, uint8_T *Watch_Y_Seconds);
