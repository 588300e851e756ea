/*
 * File: WheelSpeedCalculation.c
 *
 * Model WheelSpeedCalculation: speeds of the wheels, called every 10 ms.
 *
 * The speed of a wheel is its angular speed times half its diameter. One that is above SpdMax, or no number, is a range
 * error. While the failure management says that the speed of the rear left wheel is invalid, the other wheels stand in
 * for it.
 */
#include "WheelSpeedCalculation.h"

#include <math.h>

#define WHEELS      4
#define FRONT_LEFT  0
#define FRONT_RIGHT 1
#define REAR_LEFT   2
#define REAR_RIGHT  3

#define SPEED_OF_TURNING 0.0018   /* km/h for rad/s and mm */
#define PER_SPEED        100.0    /* steps of the outputs, for km/h */
#define SMALLEST_SPEED   (-100.0) /* km/h: the output is 0 */
#define LARGEST_OUTPUT   65535.0
#define LARGEST_COUNT    0xFFFFFFFFU

DW_WheelSpeedCalculation_T WheelSpeedCalculation_DW;
whl_in_T whl_in;
whl_out_T whl_out;
whl_par_T whl_par = { 650.0F, 650.0F, 360.0F, 0U };

/* Speeds in km/h */
static void calculate(real_T speed[WHEELS])
{
  const real_T front = (real_T)whl_par.TireDiaFrnt * SPEED_OF_TURNING;
  const real_T rear = (real_T)whl_par.TireDiaRear * SPEED_OF_TURNING;
  speed[FRONT_LEFT] = (real_T)whl_in.WhlRotFL * front;
  speed[FRONT_RIGHT] = (real_T)whl_in.WhlRotFR * front;
  speed[REAR_LEFT] = (real_T)whl_in.WhlRotRL * rear;
  speed[REAR_RIGHT] = (real_T)whl_in.WhlRotRR * rear;
}

/* NaN is out of range, too. */
static boolean_T isInRange(real_T speed)
{
  return fabs(speed) <= (real_T)whl_par.SpdMax;
}

/* Returns whether any wheel is out of range, and counts how often this begins. */
static boolean_T checkRange(const real_T speed[WHEELS])
{
  boolean_T isError = false;
  int32_T i;
  for (i = 0; i < WHEELS; i++) {
    const boolean_T outside = !isInRange(speed[i]);
    if (outside && (WheelSpeedCalculation_DW.OutOfRange[i] == false)
        && (WheelSpeedCalculation_DW.RangeErrCnt < LARGEST_COUNT)) {
      WheelSpeedCalculation_DW.RangeErrCnt++;
    }
    WheelSpeedCalculation_DW.OutOfRange[i] = outside;
    isError = isError || outside;
  }
  return isError;
}

/*
 * The rear left wheel, from the others: in a curve, left and right differ at the rear by what they differ in front.
 * Without all three of them it is the mean of those that are in range.
 */
static real_T rearLeftFromOthers(const real_T speed[WHEELS])
{
  static const int32_T others[] = { FRONT_LEFT, FRONT_RIGHT, REAR_RIGHT };
  real_T sum = 0.0;
  real_T count = 0.0;
  int32_T i;
  for (i = 0; i < 3; i++) {
    if (isInRange(speed[others[i]])) {
      sum += speed[others[i]];
      count += 1.0;
    }
  }
  if (count > 2.5) {
    return (speed[REAR_RIGHT] + speed[FRONT_LEFT]) - speed[FRONT_RIGHT];
  }
  return (count > 0.5) ? (sum / count) : 0.0;
}

/* What is no number stands still; what does not fit is the smallest or largest output. */
static uint16_T output(real_T speed)
{
  const real_T steps = ((speed - SMALLEST_SPEED) * PER_SPEED) + 0.5;
  real_T fitting = -SMALLEST_SPEED * PER_SPEED;
  if (steps <= 0.0) {
    fitting = 0.0;
  } else if (steps > LARGEST_OUTPUT) {
    fitting = LARGEST_OUTPUT;
  } else if (steps > 0.0) {
    fitting = steps;
  } else {
    /* no number */
  }
  return (uint16_T)fitting;
}

static boolean_T isDegraded(void)
{
  return (whl_out.RangeErr != false) || (whl_in.WhlSpdRLInvalid != 0U) || (whl_in.RangeErrSts != 0U)
         || (whl_in.AliveErrSts != 0U) || (whl_in.DeadlineErrSts != 0U) || (whl_in.SequenceErrSts != 0U);
}

static uint8_T modeSts(void)
{
  uint8_T mode = (uint8_T)WhlModeSts_OFF;
  if (whl_in.ModeReq != (uint8_T)WhlModeReq_OFF) {
    mode = (uint8_T)(isDegraded() ? WhlModeSts_DEGRADED : WhlModeSts_NORMAL);
  }
  return mode;
}

/* Model step function. Nothing is replaced on a test stand, where each wheel turns alone. */
void WheelSpeedCalculation_step(void)
{
  real_T speed[WHEELS];
  if (WheelSpeedCalculation_DW.IsInitialized == false) {
    return;
  }
  calculate(speed);
  whl_out.RangeErr = checkRange(speed);
  if ((whl_in.WhlSpdRLInvalid != 0U) && (whl_in.ModeReq != (uint8_T)WhlModeReq_SERVICE)) {
    speed[REAR_LEFT] = rearLeftFromOthers(speed);
  }
  whl_out.WhlSpdFL = output(speed[FRONT_LEFT]);
  whl_out.WhlSpdFR = output(speed[FRONT_RIGHT]);
  whl_out.WhlSpdRL = output(speed[REAR_LEFT]);
  whl_out.WhlSpdRR = output(speed[REAR_RIGHT]);
  whl_out.ModeSts = modeSts();
}

/* Model initialize function */
void WheelSpeedCalculation_initialize(void)
{
  static const whl_in_T still = { 0.0F, 0.0F, 0.0F, 0.0F, 0U, 0U, 0U, 0U, 0U, 0U };
  static const DW_WheelSpeedCalculation_T start = { 0U, { 0U, 0U, 0U, 0U }, 1U };
  const whl_out_T none = { output(0.0), output(0.0), output(0.0), output(0.0), (uint8_T)WhlModeSts_OFF, 0U };
  whl_in = still;
  whl_out = none;
  WheelSpeedCalculation_DW = start;
  WheelSpeedCalculation_DW.RangeErrCnt = whl_par.RangeErrCnt;
}

/* Model terminate function: the count is kept for the next start */
void WheelSpeedCalculation_terminate(void)
{
  whl_par.RangeErrCnt = WheelSpeedCalculation_DW.RangeErrCnt;
  whl_out.ModeSts = (uint8_T)WhlModeSts_OFF;
  WheelSpeedCalculation_DW.IsInitialized = false;
}
