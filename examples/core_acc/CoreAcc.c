/*
 * File: CoreAcc.c
 *
 * Model CoreAcc: adaptive cruise control, called every 50 ms.
 *
 * Four controllers each request an acceleration: one keeps the set speed, one keeps the time gap to the vehicle
 * ahead, one limits the lateral acceleration in curves, and the predictive control proposes one that saves energy. The
 * proposal replaces the set speed as long as the speed stays near it. The smallest request is used. It changes only
 * as fast as is comfortable.
 */
#include "CoreAcc.h"

#include <math.h>

#define STEP_TIME 0.05 /* s */

#define NO_ANGLE             (-15.99) /* rad: at or below, there is no steering wheel angle */
#define NO_ACCELERATION      (-19.99) /* m/s^2: at or below, there is no acceleration */
#define LARGEST_ANGLE        17.0     /* rad: above, it is invalid */
#define LARGEST_ACCELERATION 21.0     /* m/s^2 */
#define LARGEST_SPEED        100.0    /* m/s */
#define LARGEST_DISTANCE     1000.0   /* m */
#define LOST_STEPS           10U      /* a signal that is missing as long as this is lost */

#define DRIVER_BRAKES 2.0 /* bar */

#define SPEED_GAIN     0.35 /* 1/s */
#define CURVE_GAIN     0.8  /* 1/s */
#define GAP_GAIN       0.10 /* 1/s^2 */
#define SPEED_REL_GAIN 0.55 /* 1/s */

#define TIME_GAP       1.8    /* s */
#define STANDSTILL_GAP 4.0    /* m */
#define HOLD_SPEED     0.2    /* m/s: below, the vehicle stands */
#define HOLD_GAP       1.5    /* m beyond the gap at standstill: below, close enough to stand */
#define START_GAP      2.5    /* m beyond the gap at standstill: the vehicle ahead has left */
#define HOLD_REQUEST   (-1.0) /* m/s^2 */

#define SPEED_BRAKING        (-2.0)   /* m/s^2: hardest braking for the set speed */
#define CURVE_BRAKING        (-2.5)   /* m/s^2: hardest braking for a curve */
#define NEEDED_BRAKING       (-1.5)   /* m/s^2: if harder, only the distance decides */
#define ECO_LOWER            0.88     /* share of the set speed, below which the proposal is not used */
#define ECO_UPPER            1.06     /* share of the set speed, above which it is not used */
#define NO_LIMIT             100.0    /* m/s^2, m/s: no controller requests less */
#define LARGEST_POWER        150000.0 /* W */
#define STEERING_RATIO       15.0     /* steering wheel to wheels */
#define WHEELBASE            3.0      /* m */
#define CHARACTERISTIC_SPEED 28.0     /* m/s, of the understeering single-track model */
#define SMALLEST_CURVATURE   0.0002   /* 1/m: less is straight */

#define TRACK_SAMPLES 10U /* memory of the filter of the distance */
#define TRACK_JUMP    6.0 /* m: a distance that jumps by more is that of another vehicle */

/* An acceleration, and the state in which it is requested. */
typedef struct {
  real_T Acc;    /* m/s^2 */
  uint8_T State; /* AccIntSts_T */
} Request_T;

DW_CoreAcc_T CoreAcc_DW;
core_inputs_T core_inputs;
core_outputs_T core_outputs;
core_params_T core_params = { 3.0F };
uint8_T AsmAcc_AccIntSts;

static real_T limited(real_T value, real_T lower, real_T upper)
{
  return (value < lower) ? lower : ((value > upper) ? upper : value);
}

/* A comfortable value depends on the speed: one value up to 5 m/s, another from 20 m/s on, linear between them. */
static real_T bySpeed(real_T slow, real_T fast)
{
  return slow + ((fast - slow) * limited((CoreAcc_DW.EgoSpd - 5.0) / 15.0, 0.0, 1.0));
}

static real_T largestAcc(void)
{
  const real_T speed = (CoreAcc_DW.EgoSpd > 5.0) ? CoreAcc_DW.EgoSpd : 5.0;
  const real_T comfortable = bySpeed(2.0, 1.2);
  const real_T mass = core_inputs.bus_ACCIn.Bus_Cust.EgoVehMass;
  const real_T possible = (mass > 1.0) ? (LARGEST_POWER / (mass * speed)) : comfortable;
  return (possible < comfortable) ? possible : comfortable;
}

/* NaN is not usable either. */
static boolean_T isUsable(real_T value, real_T none, real_T largest)
{
  return (value > none) && (value < largest);
}

static boolean_T angleUsable(void)
{
  return (core_inputs.bus_ACCIn.Bus_Sts.SteerAgTmo == 0U)
         && isUsable(core_inputs.bus_ACCIn.Bus_Veh.SteerWhlAg, NO_ANGLE, LARGEST_ANGLE);
}

static boolean_T proposalUsable(void)
{
  return (core_inputs.bus_ACCIn.Bus_Sts.EcoAccPropTmo == 0U)
         && isUsable((real_T)core_inputs.bus_MPCOut.EcoAccProp, NO_ACCELERATION, LARGEST_ACCELERATION);
}

/* Keeps the last usable speed. */
static void readSpeed(void)
{
  const real_T speed = core_inputs.bus_ACCIn.Bus_Veh.EgoVehSpd;
  if ((speed >= 0.0) && (speed <= LARGEST_SPEED)) {
    CoreAcc_DW.EgoSpd = speed;
    CoreAcc_DW.SpdLost = 0U;
  } else if (CoreAcc_DW.SpdLost < LOST_STEPS) {
    CoreAcc_DW.SpdLost++;
  }
}

static real_T ownAcc(void)
{
  const real_T acc = core_inputs.bus_ACCIn.Bus_Veh.EgoVehALgt;
  return isUsable(acc, NO_ACCELERATION, LARGEST_ACCELERATION) ? acc : CoreAcc_DW.AccReq;
}

/* Expected distance of the vehicle ahead: its speed stays, the own speed changes with the own acceleration. */
static void predictObject(void)
{
  CoreAcc_DW.ObjDst += (STEP_TIME * CoreAcc_DW.ObjSpdRel);
  CoreAcc_DW.ObjSpdRel -= (STEP_TIME * ownAcc());
}

/* Least squares over the samples so far, then over a fading memory of TRACK_SAMPLES (alpha-beta filter). */
static void correctObject(real_T distance)
{
  const real_T count = (real_T)CoreAcc_DW.ObjCnt;
  const real_T alpha = (2.0 * ((2.0 * count) - 1.0)) / (count * (count + 1.0));
  const real_T beta = 6.0 / (count * (count + 1.0));
  const real_T residual = distance - CoreAcc_DW.ObjDst;
  CoreAcc_DW.ObjDst += (alpha * residual);
  CoreAcc_DW.ObjSpdRel += ((CoreAcc_DW.ObjCnt > 1U) ? ((beta * residual) / STEP_TIME) : 0.0);
  CoreAcc_DW.ObjCnt = (uint8_T)((CoreAcc_DW.ObjCnt < TRACK_SAMPLES) ? (CoreAcc_DW.ObjCnt + 1U) : TRACK_SAMPLES);
}

static void beginObject(real_T distance)
{
  CoreAcc_DW.ObjDst = distance;
  CoreAcc_DW.ObjSpdRel = 0.0;
  CoreAcc_DW.ObjCnt = 2U;
}

/* Estimates distance and closing speed; a vehicle that is not seen for a moment is assumed to drive on. */
static void trackObject(void)
{
  const real_T distance = (real_T)core_inputs.bus_ACCIn.Bus_Obj.ObjDst;
  predictObject();
  if (!isUsable(distance, 0.0, LARGEST_DISTANCE)) {
    CoreAcc_DW.ObjLost = (uint8_T)((CoreAcc_DW.ObjLost < LOST_STEPS) ? (CoreAcc_DW.ObjLost + 1U) : LOST_STEPS);
    CoreAcc_DW.ObjCnt = (CoreAcc_DW.ObjLost < LOST_STEPS) ? CoreAcc_DW.ObjCnt : (uint8_T)0U;
  } else {
    CoreAcc_DW.ObjLost = 0U;
    if ((CoreAcc_DW.ObjCnt == 0U) || (fabs(distance - CoreAcc_DW.ObjDst) > TRACK_JUMP)) {
      beginObject(distance);
    } else {
      correctObject(distance);
    }
  }
}

/* The set speed in whole units of the dashboard: the function keeps the speed that the driver reads there. */
static real_T setSpeed(void)
{
  const uint8_T unit = core_inputs.bus_ACCIn.Bus_Cust.EgoVehDshbSpdUnit;
  const real_T given = (real_T)core_inputs.bus_ACCIn.Bus_Cust.SetSpd;
  const real_T speed = isUsable(given, 0.0, LARGEST_SPEED) ? given : 0.0;
  if (unit == (uint8_T)SpdUnit_KM_PER_HOUR) {
    CoreAcc_DW.SpdUnit = 1.0 / 3.6;
  } else if (unit == (uint8_T)SpdUnit_MI_PER_HOUR) {
    CoreAcc_DW.SpdUnit = 0.44704;
  } else {
    /* unknown in the map: the unit stays */
  }
  return (real_T)(int32_T)((speed / CoreAcc_DW.SpdUnit) + 0.5) * CoreAcc_DW.SpdUnit;
}

/* The speed at which the present curve has the largest lateral acceleration. */
static real_T curveSpeed(void)
{
  const real_T slip = CoreAcc_DW.EgoSpd / CHARACTERISTIC_SPEED;
  const real_T angle = fabs(core_inputs.bus_ACCIn.Bus_Veh.SteerWhlAg) / STEERING_RATIO;
  const real_T curvature = angle / (WHEELBASE * (1.0 + (slip * slip)));
  return (curvature > SMALLEST_CURVATURE) ? sqrt((real_T)core_params.ALatMax / curvature) : NO_LIMIT;
}

static Request_T forSpeed(real_T speed)
{
  const real_T error = speed - CoreAcc_DW.EgoSpd;
  const Request_T request = { SPEED_GAIN * error, (uint8_T)AccIntSts_Speed };
  return request;
}

/* The proposal, led back to the set speed where it would leave it. */
static Request_T forEco(real_T speed)
{
  const real_T lower = SPEED_GAIN * ((ECO_LOWER * speed) - CoreAcc_DW.EgoSpd);
  const real_T upper = SPEED_GAIN * ((ECO_UPPER * speed) - CoreAcc_DW.EgoSpd);
  const real_T proposed = (real_T)core_inputs.bus_MPCOut.EcoAccProp;
  const Request_T request = { limited(proposed, lower, upper), (uint8_T)AccIntSts_Eco };
  return request;
}

static Request_T forCurve(void)
{
  const real_T acc = angleUsable() ? (CURVE_GAIN * (curveSpeed() - CoreAcc_DW.EgoSpd)) : NO_LIMIT;
  const Request_T request = { (acc < CURVE_BRAKING) ? CURVE_BRAKING : acc, (uint8_T)AccIntSts_Curve };
  return request;
}

/* Braking that is just enough to be as slow as the vehicle ahead before the gap at standstill is reached. */
static real_T neededAcc(void)
{
  const real_T room = CoreAcc_DW.ObjDst - STANDSTILL_GAP;
  const real_T speed = CoreAcc_DW.ObjSpdRel;
  return (speed < 0.0) ? ((-speed * speed) / (2.0 * ((room > 1.0) ? room : 1.0))) : 0.0;
}

static real_T gapAcc(void)
{
  const real_T gap = STANDSTILL_GAP + (TIME_GAP * CoreAcc_DW.EgoSpd);
  const real_T forGap = limited(GAP_GAIN * (CoreAcc_DW.ObjDst - gap), bySpeed(-2.5, -1.0), NO_LIMIT);
  const real_T needed = neededAcc();
  real_T acc = forGap + (SPEED_REL_GAIN * CoreAcc_DW.ObjSpdRel);
  if ((needed < NEEDED_BRAKING) && ((1.2 * needed) < acc)) {
    acc = 1.2 * needed;
  }
  return acc;
}

static boolean_T standsBehind(void)
{
  const boolean_T stands = (CoreAcc_DW.State == (uint8_T)AccIntSts_Standstill);
  return (CoreAcc_DW.EgoSpd < HOLD_SPEED) && (CoreAcc_DW.ObjDst < (STANDSTILL_GAP + (stands ? START_GAP : HOLD_GAP)));
}

static Request_T forObject(void)
{
  Request_T request = { NO_LIMIT, (uint8_T)AccIntSts_Follow };
  if (CoreAcc_DW.ObjCnt == 0U) {
    /* none ahead */
  } else if (standsBehind()) {
    request.Acc = HOLD_REQUEST;
    request.State = (uint8_T)AccIntSts_Standstill;
  } else {
    request.Acc = gapAcc();
  }
  return request;
}

static Request_T smaller(Request_T one, Request_T other)
{
  return (other.Acc < one.Acc) ? other : one;
}

/* Arbitration: the proposal or the set speed, the curve, the vehicle ahead. */
static Request_T arbitrate(real_T speed)
{
  Request_T request = proposalUsable() ? forEco(speed) : forSpeed(speed);
  request.Acc = limited(request.Acc, SPEED_BRAKING, largestAcc());
  request = smaller(smaller(request, forCurve()), forObject());
  request.Acc = limited(request.Acc, bySpeed(-5.0, -3.5), largestAcc());
  return request;
}

/* Limits the jerk; braking may build up twice as fast as anything else. */
static real_T comfortable(real_T acc)
{
  const real_T change = STEP_TIME * bySpeed(5.0, 2.5);
  return limited(acc, CoreAcc_DW.AccReq - (2.0 * change), CoreAcc_DW.AccReq + change);
}

/* State of the failure management. */
static boolean_T isFaulty(void)
{
  const Bus_Sts_T *known = &core_inputs.bus_ACCIn.Bus_Sts;
  return (known->AccReqInvalid != 0U) || (known->BrkPTmo != 0U) || (known->Alive != 0U);
}

/*
 * Control begins when it becomes allowed. Once the driver brakes, the speed is lost or there is a fault, the vehicle
 * is the driver's until control is switched off and on again.
 */
static void engage(real_T speed)
{
  const boolean_T allowed = (core_inputs.bus_ACCIn.Bus_Sts.ModeReq == (uint8_T)CoreAccMode_ACTIVE)
                            && (core_inputs.bus_ACCIn.Bus_Cust.EnaGACC != false) && (speed > 0.0);
  const boolean_T released =
      (core_inputs.bus_ACCIn.Bus_Veh.BrkCylP > DRIVER_BRAKES) || (CoreAcc_DW.SpdLost >= LOST_STEPS) || isFaulty();
  const boolean_T begins = allowed && (CoreAcc_DW.Allowed == false);
  CoreAcc_DW.Engaged = allowed && !released && (begins || (CoreAcc_DW.Engaged != false));
  CoreAcc_DW.Allowed = allowed;
}

static void control(real_T speed)
{
  const boolean_T controlled =
      (CoreAcc_DW.State >= (uint8_T)AccIntSts_Speed) && (CoreAcc_DW.State <= (uint8_T)AccIntSts_Curve);
  const Request_T request = arbitrate(speed);
  CoreAcc_DW.AccReq = controlled ? CoreAcc_DW.AccReq : limited(ownAcc(), bySpeed(-5.0, -3.5), largestAcc());
  CoreAcc_DW.AccReq = comfortable(request.Acc);
  CoreAcc_DW.State = request.State;
}

static void standBy(void)
{
  CoreAcc_DW.AccReq = 0.0;
  if (isFaulty()) {
    CoreAcc_DW.State = (uint8_T)AccIntSts_Fault;
  } else {
    CoreAcc_DW.State = (uint8_T)((CoreAcc_DW.Allowed != false) ? AccIntSts_Released : AccIntSts_Standby);
  }
}

static uint8_T modeOut(void)
{
  uint8_T mode = (uint8_T)CoreAccMode_STANDBY;
  if (core_inputs.bus_ACCIn.Bus_Sts.ModeReq == (uint8_T)CoreAccMode_OFF) {
    mode = (uint8_T)CoreAccMode_OFF;
  } else if (CoreAcc_DW.State == (uint8_T)AccIntSts_Fault) {
    mode = (uint8_T)CoreAccMode_FAULT;
  } else if (CoreAcc_DW.Engaged != false) {
    mode = (uint8_T)CoreAccMode_ACTIVE;
  } else {
    /* stands by */
  }
  return mode;
}

static uint8_T status(void)
{
  const boolean_T warn = !angleUsable() && (CoreAcc_DW.State < (uint8_T)AccIntSts_Curve);
  return (uint8_T)(CoreAcc_DW.State + (warn ? (uint8_T)AccIntSts_NoCurveLimit : 0U));
}

/* Model step function */
void CoreAcc_step(void)
{
  const real_T speed = setSpeed();
  readSpeed();
  trackObject();
  engage(speed);
  if (CoreAcc_DW.Engaged != false) {
    control(speed);
  } else {
    standBy();
  }
  core_outputs.bus_ACCOut.AccReq = (real32_T)CoreAcc_DW.AccReq;
  core_outputs.bus_ACCOut.ModeSts = modeOut();
  AsmAcc_AccIntSts = status();
}

/* Model initialize function */
void CoreAcc_initialize(void)
{
  static const DW_CoreAcc_T start = { 0.0, 0.0, 0.0, 1.0 / 3.6, 0.0, 0U, 0U, 0U, 0U, 0U, 0U };
  static const core_inputs_T nothing = {
    { { 0.0, -16.0, -20.0, 0.0 }, { 2495.0, 0.0F, 0U, 0U }, { 0.0F }, { 0U, 0U, 0U, 0U, 0U, 0U } }, { -20.0F }
  };
  CoreAcc_DW = start;
  core_inputs = nothing;
  core_outputs.bus_ACCOut.AccReq = 0.0F;
  core_outputs.bus_ACCOut.ModeSts = (uint8_T)CoreAccMode_OFF;
  AsmAcc_AccIntSts = (uint8_T)AccIntSts_NotStarted;
}

/* Model terminate function: the request is withdrawn */
void CoreAcc_terminate(void)
{
  core_outputs.bus_ACCOut.AccReq = 0.0F;
  core_outputs.bus_ACCOut.ModeSts = (uint8_T)CoreAccMode_OFF;
}
