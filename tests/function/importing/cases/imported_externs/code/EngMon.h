/*
 * Code generated for Simulink model 'EngMon'.
 */
#ifndef ENGMON_H
#define ENGMON_H
#include "rtwtypes.h"
#include "rtw_continuous.h"

/* Imported (extern) block signals */
extern real_T EngSpd;                  /* '<Root>/EngSpd' */
extern int16_T OilTemp;                /* '<Root>/OilTemp'
                                        * Oil temperature in degC, fixdt(1,16,0.1,-40)
                                        */
extern uint8_T Buffer[4][2];           /* '<Root>/Buffer' */

/* Imported (extern) states */
extern uint16_T Shared;                /* '<S1>/Data Store Memory' */

/* Block states (default storage) */
extern struct { real_T Delay; } EngMon_DW;

/*
 * Exported Global Signals
 *
 * Note: Exported global signals are block signals with an exported global
 * storage class designation.
 */
extern boolean_T OverSpd;              /* '<S1>/Relational Operator' */
extern real32_T Load;                  /* '<Root>/Load' */

/* Exported global parameters */
extern real_T SpdMax;                  /* Variable: SpdMax
                                        * Referenced by: '<S1>/SpdMax'
                                        */
extern const real_T Fixed;             /* Variable: Fixed */

/* Exported data declaration */

/* Declaration for custom storage class: ImportFromFile */
extern uint16_T Unused;
extern volatile uint8_T Ignition;      /* '<Root>/Ignition' */

/* Model entry point functions */
extern void EngMon_initialize(void);
extern void EngMon_step(void);         /* Sample time: [0.1s, 0.0s] */

#endif
