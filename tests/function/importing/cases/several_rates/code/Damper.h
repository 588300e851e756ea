#ifndef DAMPER_H
#define DAMPER_H
#include "rtwtypes.h"
typedef struct { real_T Fast; real_T Slow; } ExtU_Damper_T;
typedef struct { real_T Force; real_T Level; } ExtY_Damper_T;
extern ExtU_Damper_T Damper_U;
extern ExtY_Damper_T Damper_Y;
extern void Damper_initialize(void);
extern void Damper_step0(void);        /* Sample time: [0.005s, 0.0s] */
extern void Damper_step1(void);        /* Sample time: [0.1s, 0.0s] */
extern void Damper_terminate(void);
#endif
