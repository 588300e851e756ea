/*
 * File: WheelSpeedCalculation.h
 *
 * Model WheelSpeedCalculation: speeds of the wheels, called every 10 ms.
 */
#ifndef WheelSpeedCalculation_h_
#define WheelSpeedCalculation_h_

#include "WheelSpeedCalculation_types.h"
#include "rtwtypes.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Block states */
typedef struct {
  uint32_T RangeErrCnt;    /* as in whl_par_T, counted on */
  boolean_T OutOfRange[4]; /* front left, front right, rear left, rear right: in the step before */
  boolean_T IsInitialized;
} DW_WheelSpeedCalculation_T;

extern DW_WheelSpeedCalculation_T WheelSpeedCalculation_DW;

/* Exported signals and parameters */
extern whl_in_T whl_in;
extern whl_out_T whl_out;
extern whl_par_T whl_par;

/* Entry points */
extern void WheelSpeedCalculation_initialize(void);
extern void WheelSpeedCalculation_step(void);
extern void WheelSpeedCalculation_terminate(void);

#ifdef __cplusplus
}
#endif

#endif /* WheelSpeedCalculation_h_ */
