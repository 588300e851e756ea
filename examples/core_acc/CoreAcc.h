/*
 * File: CoreAcc.h
 *
 * Model CoreAcc: adaptive cruise control, called every 50 ms.
 */
#ifndef CoreAcc_h_
#define CoreAcc_h_

#include "CoreAcc_types.h"
#include "rtwtypes.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Block states */
typedef struct {
  real_T EgoSpd;     /* m/s: last usable speed */
  real_T ObjDst;     /* m: distance to the vehicle ahead, filtered */
  real_T ObjSpdRel;  /* m/s: its speed less the own one */
  real_T SpdUnit;    /* m/s: one unit of the dashboard */
  real_T AccReq;     /* m/s^2: request of the step before */
  uint8_T SpdLost;   /* steps without a usable speed */
  uint8_T ObjCnt;    /* samples of the vehicle ahead; 0 = none ahead */
  uint8_T ObjLost;   /* steps without a sample of it */
  uint8_T State;     /* AccIntSts_T of the step before */
  boolean_T Allowed; /* whether control was allowed in the step before */
  boolean_T Engaged; /* whether control has not been handed over to the driver */
} DW_CoreAcc_T;

extern DW_CoreAcc_T CoreAcc_DW;

/* Exported signals and parameters */
extern core_inputs_T core_inputs;
extern core_outputs_T core_outputs;
extern core_params_T core_params;
extern uint8_T AsmAcc_AccIntSts;

/* Entry points */
extern void CoreAcc_initialize(void);
extern void CoreAcc_step(void);
extern void CoreAcc_terminate(void);

#ifdef __cplusplus
}
#endif

#endif /* CoreAcc_h_ */
