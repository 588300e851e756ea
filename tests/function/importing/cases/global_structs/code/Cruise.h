/*
 * File: Cruise.h
 *
 * Code generated for Simulink model 'Cruise'.
 *
 * Model version                  : 1.42
 * Simulink Coder version         : 9.9 (R2023a) 19-Nov-2022
 * C/C++ source code generated on : Mon Mar 04 10:00:00 2024
 *
 * Target selection: ert.tlc
 */

#ifndef RTW_HEADER_Cruise_h_
#define RTW_HEADER_Cruise_h_
#include "rtwtypes.h"
#include "Cruise_types.h"

#ifndef rtmGetErrorStatus
#define rtmGetErrorStatus(rtm)         ((rtm)->errorStatus)
#endif

/* Block states (default storage) for system '<Root>' */
typedef struct {
  real_T Integrator_DSTATE;            /* '<S2>/Integrator' */
} DW_Cruise_T;

/* Invariant block signals (default storage) */
typedef struct {
  const real_T Gain1;                  /* '<S1>/Gain1' */
} ConstB_Cruise_T;

/* External inputs (root inport signals with default storage) */
typedef struct {
  BusInputs Bus;                       /* '<Root>/Bus' */
  real_T HorizonAlt[50];               /* '<Root>/HorizonAlt' */
  CruiseState Wanted;                  /* '<Root>/Wanted' */
} ExtU_Cruise_T;

/* External outputs (root outports fed by signals with default storage) */
typedef struct {
  real_T AccReq;                       /* '<Root>/AccReq' */
  CruiseState State;                   /* '<Root>/State' */
} ExtY_Cruise_T;

/* Parameters (default storage) */
struct P_Cruise_T_ {
  real_T Kp;                           /* Variable: Kp
                                        * Referenced by: '<S2>/Kp'
                                        */
  real32_T Ki;                         /* Integral gain, range 0 to 2
                                        * Referenced by: '<S2>/Ki'
                                        */
  real_T Curve_tableData[3];           /* Expression: [1 2 3]
                                        * Referenced by: '<S3>/Curve'
                                        */
  boolean_T Enable_Value;              /* Computed Parameter: Enable_Value
                                        * Referenced by: '<Root>/Enable'
                                        */
};

typedef struct P_Cruise_T_ P_Cruise_T;

/* Real-time Model Data Structure */
struct tag_RTM_Cruise_T {
  const char_T * volatile errorStatus;
};

/* Block parameters (default storage) */
extern P_Cruise_T Cruise_P;

/* Block states (default storage) */
extern DW_Cruise_T Cruise_DW;
extern const ConstB_Cruise_T Cruise_ConstB;/* constant block i/o */

/* External inputs (root inport signals with default storage) */
extern ExtU_Cruise_T Cruise_U;

/* External outputs (root outports fed by signals with default storage) */
extern ExtY_Cruise_T Cruise_Y;

/* Model entry point functions */
extern void Cruise_initialize(void);
extern void Cruise_step(void);
extern void Cruise_terminate(void);

/* Real-time Model object */
extern RT_MODEL_Cruise_T *const Cruise_M;

#endif
