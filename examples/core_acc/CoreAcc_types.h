/*
 * File: CoreAcc_types.h
 *
 * Buses of model CoreAcc.
 */
#ifndef CoreAcc_types_h_
#define CoreAcc_types_h_

#include "rtwtypes.h"

/* Values of bus_ACCIn.Bus_Cust.EgoVehDshbSpdUnit */
typedef enum {
  SpdUnit_KM_PER_HOUR = 0,
  SpdUnit_MI_PER_HOUR = 1,
  SpdUnit_NOT_IN_MAP = 3
} SpdUnit_T;

/* Values of Bus_Sts.ModeReq, without FAULT, and of bus_ACCOut.ModeSts */
typedef enum {
  CoreAccMode_OFF = 0,
  CoreAccMode_STANDBY = 1,
  CoreAccMode_ACTIVE = 2,
  CoreAccMode_FAULT = 3
} CoreAccMode_T;

/*
 * Values of AsmAcc_AccIntSts. While the steering wheel angle is not usable, curves do not limit the speed and the
 * driver is warned: Standby to Standstill are then told as their number + AccIntSts_NoCurveLimit.
 */
typedef enum {
  AccIntSts_NotStarted = 0, /* no step yet */
  AccIntSts_Standby = 1,    /* off, or no set speed */
  AccIntSts_Released = 2,   /* handed over to the driver, who has to switch it on again */
  AccIntSts_Speed = 3,      /* holds the set speed */
  AccIntSts_Eco = 4,        /* follows the proposal of the predictive control */
  AccIntSts_Follow = 5,     /* follows the vehicle ahead */
  AccIntSts_Standstill = 6, /* stands behind the vehicle ahead */
  AccIntSts_Curve = 7,      /* slower than the set speed for a curve */
  AccIntSts_Fault = 8,      /* safety reaction */
  AccIntSts_NoCurveLimit = 8
} AccIntSts_T;

typedef struct {
  real_T BrkCylP;    /* bar, -30.0 to 276.9: pressure in the master cylinder, from the driver's foot */
  real_T SteerWhlAg; /* rad, -16.0 to 16.766: steering wheel angle, left is positive; -16.0 = not available */
  real_T EgoVehALgt; /* m/s^2, -20.0 to 20.94: longitudinal acceleration; -20.0 = not available */
  real_T EgoVehSpd;  /* m/s, 0.0 to 100.0: speed */
} Bus_Veh_T;

typedef struct {
  real_T EgoVehMass;         /* kg: mass of the vehicle */
  real32_T SetSpd;           /* m/s, 0.0 to 70.0: speed set by the driver; 0 = none */
  boolean_T EnaGACC;         /* switched on by the driver */
  uint8_T EgoVehDshbSpdUnit; /* SpdUnit_T: unit in which the driver reads speeds */
} Bus_Cust_T;

typedef struct {
  real32_T ObjDst; /* m: distance to the vehicle ahead; 0 = none */
} Bus_Obj_T;

typedef struct {
  uint8_T ModeReq;       /* CoreAccMode_T: requested mode */
  uint8_T AccReqInvalid; /* 1 = the acceleration request must not be used */
  uint8_T BrkPTmo;       /* 1 = the brake pressure is missing */
  uint8_T SteerAgTmo;    /* 1 = the steering wheel angle is missing */
  uint8_T EcoAccPropTmo; /* 1 = the proposal is missing */
  uint8_T Alive;         /* 1 = called too rarely or too often */
} Bus_Sts_T;

typedef struct {
  Bus_Veh_T Bus_Veh;
  Bus_Cust_T Bus_Cust;
  Bus_Obj_T Bus_Obj;
  Bus_Sts_T Bus_Sts;
} Bus_ACCIn_T;

typedef struct {
  real32_T EcoAccProp; /* m/s^2, -20.0 to 20.94: proposed acceleration; -20.0 = none */
} Bus_MPCOut_T;

typedef struct {
  Bus_ACCIn_T bus_ACCIn;
  Bus_MPCOut_T bus_MPCOut;
} core_inputs_T;

typedef struct {
  real32_T AccReq; /* m/s^2, -20.0 to 20.94: acceleration requested from the powertrain */
  uint8_T ModeSts; /* CoreAccMode_T: current mode */
} Bus_ACCOut_T;

typedef struct {
  Bus_ACCOut_T bus_ACCOut;
} core_outputs_T;

typedef struct {
  real32_T ALatMax; /* m/s^2, 0.5 to 8.0: largest lateral acceleration */
} core_params_T;

#endif /* CoreAcc_types_h_ */
