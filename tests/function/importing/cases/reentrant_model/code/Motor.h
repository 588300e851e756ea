/* Code generated for Simulink model 'Motor'. */
#ifndef RTW_HEADER_Motor_h_
#define RTW_HEADER_Motor_h_
#include "rtwtypes.h"

typedef struct tag_RTM RT_MODEL;

/* Block signals and states (default storage) for system '<Root>' */
typedef struct {
  int16_T UnitDelay_DSTATE;            /* '<S2>/Unit Delay' */
} DW;

/* Constant parameters (default storage) */
typedef struct {
  int16_T sin_Table[3];
} ConstP;

/* External inputs (root inport signals with default storage) */
typedef struct {
  boolean_T b_motEna;                  /* '<Root>/b_motEna' */
  int16_T i_phaA;                      /* '<Root>/i_phaA', sfix16_En4 */
  int16_T n_tgt;                       /* '<Root>/n_tgt', scaling 2^-4, unit: rpm */
} ExtU;

/* External outputs (root outports fed by signals with default storage) */
typedef struct {
  int16_T DC_phaA;                     /* '<Root>/DC_phaA' */
} ExtY;

/* Parameters (default storage) */
struct P_ {
  uint16_T cf_nKp;                     /* Variable: cf_nKp, ufix16_En12
                                        * Referenced by: '<S3>/cf_nKp'
                                        */
  int16_T table[4];                    /* Variable: table
                                        * Referenced by: '<S3>/table'
                                        */
};

typedef struct P_ P;

/* Real-time Model Data Structure */
struct tag_RTM {
  P *defaultParam;
  ExtU *inputs;
  ExtY *outputs;
  DW *dwork;
};

/* Constant parameters (default storage) */
extern const ConstP rtConstP;

/* Model entry point functions */
extern void Motor_initialize(RT_MODEL *const rtM);
extern void Motor_step(RT_MODEL *const rtM);

#endif
