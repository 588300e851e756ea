/*
 * File: EcoControlMpc.h
 *
 * Model EcoControlMpc: predictive control that saves energy, called every 500 ms. Reentrant: one RT_MODEL for each
 * instance.
 */
#ifndef EcoControlMpc_h_
#define EcoControlMpc_h_

#include "EcoControlMpc_types.h"
#include "rtwtypes.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Block states */
typedef struct {
  real_T Plan[EcoControlMpc_POINTS]; /* m^2/s^2: half the square of the planned speed at each point */
  real_T PlanSetSpd;                 /* m/s: set speed that the plan is for */
  boolean_T PlanValid;               /* whether the plan is one to start from */
} DW_EcoControlMpc_T;

/* External inputs */
typedef struct {
  real32_T HorizonAlt[EcoControlMpc_POINTS]; /* m, -500.0 to 9000.0: altitude of the road ahead, from the vehicle on */
  real32_T EgoSpd;                           /* m/s, 0.0 to 100.0: speed */
  real32_T SetSpd;                           /* m/s, 0.0 to 70.0: speed set by the driver; 0 = none */
  boolean_T EnaMpc;                          /* switched on by the driver */
  uint8_T ModeReq;                           /* EcoControlMpcMode_T: requested mode */
  uint8_T AccPropInvalid;                    /* 1 = the proposal must not be used */
  uint8_T HorizonTmo;                        /* 1 = the altitude profile is missing */
  uint8_T NoSolutionSts;                     /* 1 = no solution for so long that it counts */
  uint8_T DeadlineSts;                       /* 1 = a step has taken too long */
} ExtU_EcoControlMpc_T;

/* External outputs */
typedef struct {
  real32_T EcoAccProp;  /* m/s^2, -20.0 to 20.94: proposed acceleration; -20.0 = none */
  uint8_T ModeSts;      /* EcoControlMpcMode_T: current mode */
  boolean_T NoSolution; /* 1 = the optimization has found none */
} ExtY_EcoControlMpc_T;

/* Parameters */
struct P_EcoControlMpc_T_ {
  real32_T VehM;         /* kg: mass of the vehicle */
  real32_T HorizonStep;  /* m, 1.0 to 200.0: distance between points of the horizon */
  real32_T EnergyWeight; /* 0.0 to 1.0: weight of energy against travel time */
};

typedef struct P_EcoControlMpc_T_ P_EcoControlMpc_T;

/* Real-time model: what belongs to an instance */
struct tag_RTM_EcoControlMpc_T {
  const char_T *errorStatus;
  P_EcoControlMpc_T *defaultParam;
  ExtU_EcoControlMpc_T *inputs;
  ExtY_EcoControlMpc_T *outputs;
  DW_EcoControlMpc_T *dwork;
};

/* Entry points */
extern void EcoControlMpc_initialize(RT_MODEL_EcoControlMpc_T *const EcoControlMpc_M);
extern void EcoControlMpc_step(RT_MODEL_EcoControlMpc_T *const EcoControlMpc_M);
extern void EcoControlMpc_terminate(RT_MODEL_EcoControlMpc_T *const EcoControlMpc_M);

#ifdef __cplusplus
}
#endif

#endif /* EcoControlMpc_h_ */
