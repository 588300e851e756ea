/* Code generated for Simulink model 'Locks'. */
#pragma once
#include "rtwtypes.h"
extern boolean_T IsLocked;             /* '<Root>/IsLocked' */
extern uint8_T Request;                /* '<Root>/Request' */

/* Model entry point functions */
extern void Locks_initialize(void);

/* Exported entry point function */
extern void Locks_10ms(void);

/* Exported entry point function */
extern void Locks_OnRequest(void);
