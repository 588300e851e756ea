/* Code generated for Simulink model 'RailP'. */
#pragma once
#include "rtwtypes.h"

typedef int16_T Volt_mV;

/* Real-time Model Data Structure */
struct tag_RTM_RailP_T {
  const char_T *errorStatus;
};

/* Imported (extern) block signals */
extern Volt_mV RailP_uRaw;             /* '<Root>/RailP_uRaw'
                                        * Raw value of rail pressure in V, slope 0.001
                                        */

/* Imported (extern) states */
extern boolean_T Faults[100];
                           /* Simulink.Signal object 'Faults'
                            * State of each fault
                            */

/*
 * Exported Global Signals
 *
 * Note: Exported global signals are block signals with an exported global
 * storage class designation.
 *
 */
extern real32_T RailP_pLin;            /* '<S2>/Switch'
                                        * Fuel pressure, bar
                                        */
extern boolean_T RailP_bFinalDef;      /* '<S2>/Logical Operator' */

/* Model entry point functions */
extern void RailP_initialize(void);
extern void RailP_terminate(void);

/* Exported entry point functions */
extern void RailP_1kHz(void);
