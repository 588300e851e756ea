#ifndef RTW_HEADER_Cruise_types_h_
#define RTW_HEADER_Cruise_types_h_
#include "rtwtypes.h"

/* Buses of the model */
typedef struct {
  real_T VehSpd;                       /* Vehicle speed [m/s] [0,70] */
  real32_T SteerWhlAg;                 /* Unit: deg  Range: -720..720 */
  boolean_T BrkPedPrsd;                /* Whether the brake pedal is pressed */
} BusVehicle;

typedef struct {
  BusVehicle Ego;                      /* '<Root>/Vehicle' */
  uint8_T GearPos;
} BusInputs;

typedef enum {
  CruiseState_Off = 0,                 /* Default value */
  CruiseState_Standby,
  CruiseState_Active = 5
} CruiseState;

typedef struct tag_RTM_Cruise_T RT_MODEL_Cruise_T;

#endif
