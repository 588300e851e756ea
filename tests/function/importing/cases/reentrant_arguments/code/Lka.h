#ifndef LKA_H
#define LKA_H
#include "rtwtypes.h"

typedef struct {
  real32_T State;
} DW_Lka_T;

/* External inputs (root inport signals with default storage) */
typedef struct {
  real32_T LatAcc;                     /* '<Root>/LatAcc' m/s^2 */
  real32_T Curvature;                  /* '<Root>/Curvature' */
} ExtU_Lka_T;

/* External outputs (root outports fed by signals with default storage) */
typedef struct {
  real32_T SteerTq;                    /* '<Root>/SteerTq' [Nm] [-5,5] */
} ExtY_Lka_T;

typedef struct tag_RTM_Lka_T {
  const char_T *errorStatus;
  DW_Lka_T *dwork;
} RT_MODEL_Lka_T;

/* Model entry point functions */
extern void Lka_initialize(RT_MODEL_Lka_T *const Lka_M, ExtU_Lka_T *Lka_U, ExtY_Lka_T *Lka_Y);
extern void Lka_step(RT_MODEL_Lka_T *const Lka_M, ExtU_Lka_T *Lka_U, ExtY_Lka_T *Lka_Y);
extern void Lka_terminate(RT_MODEL_Lka_T *const Lka_M);

#endif
