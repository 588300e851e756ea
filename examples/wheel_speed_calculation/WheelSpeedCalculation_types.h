/*
 * File: WheelSpeedCalculation_types.h
 *
 * Types of model WheelSpeedCalculation.
 */
#ifndef WheelSpeedCalculation_types_h_
#define WheelSpeedCalculation_types_h_

#include "rtwtypes.h"

/* Values of whl_in.ModeReq */
typedef enum {
  WhlModeReq_OFF = 0,
  WhlModeReq_NORMAL = 1,
  WhlModeReq_SERVICE = 2
} WhlModeReq_T;

/* Values of whl_out.ModeSts */
typedef enum {
  WhlModeSts_OFF = 0,
  WhlModeSts_NORMAL = 1,
  WhlModeSts_DEGRADED = 2
} WhlModeSts_T;

typedef struct {
  real32_T WhlRotFL;       /* rad/s, -450.0 to 450.0: angular speed, front left */
  real32_T WhlRotFR;       /* rad/s, -450.0 to 450.0: front right */
  real32_T WhlRotRL;       /* rad/s, -450.0 to 450.0: rear left */
  real32_T WhlRotRR;       /* rad/s, -450.0 to 450.0: rear right */
  uint8_T ModeReq;         /* WhlModeReq_T: requested mode */
  uint8_T WhlSpdRLInvalid; /* 1 = the speed of the rear left wheel has to be replaced */
  uint8_T RangeErrSts;     /* 1 = a speed has been out of range for so long that it counts */
  uint8_T AliveErrSts;     /* 1 = called too rarely or too often */
  uint8_T DeadlineErrSts;  /* 1 = a step has taken too long */
  uint8_T SequenceErrSts;  /* 1 = called out of order */
} whl_in_T;

typedef struct {
  uint16_T WhlSpdFL;  /* 0.01 km/h from -100.0 km/h on: speed, front left */
  uint16_T WhlSpdFR;  /* front right */
  uint16_T WhlSpdRL;  /* rear left */
  uint16_T WhlSpdRR;  /* rear right */
  uint8_T ModeSts;    /* WhlModeSts_T: current mode */
  boolean_T RangeErr; /* 1 = the speed of a wheel is above SpdMax, or none */
} whl_out_T;

typedef struct {
  real32_T TireDiaFrnt; /* mm, 300.0 to 1500.0: diameter of the tires in front */
  real32_T TireDiaRear; /* mm, 300.0 to 1500.0: and at the rear */
  real32_T SpdMax;      /* km/h, 0.0 to 500.0: a wheel that is faster is out of range */
  uint32_T RangeErrCnt; /* how often a wheel came to be out of range, in the life of the vehicle */
} whl_par_T;

#endif /* WheelSpeedCalculation_types_h_ */
