/*
 * File: EcoControlMpc_types.h
 *
 * Types of model EcoControlMpc.
 */
#ifndef EcoControlMpc_types_h_
#define EcoControlMpc_types_h_

#include "rtwtypes.h"

/* Points of the altitude profile */
#define EcoControlMpc_POINTS 50

/* Values of ModeReq, without FAULT, and of ModeSts */
typedef enum {
  EcoControlMpcMode_OFF = 0,
  EcoControlMpcMode_STANDBY = 1,
  EcoControlMpcMode_ACTIVE = 2,
  EcoControlMpcMode_FAULT = 3
} EcoControlMpcMode_T;

typedef struct tag_RTM_EcoControlMpc_T RT_MODEL_EcoControlMpc_T;

#endif /* EcoControlMpc_types_h_ */
