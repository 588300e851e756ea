/*
 * File: EcoControlMpc.c
 *
 * Model EcoControlMpc: predictive control that saves energy, called every 500 ms.
 *
 * The road ahead has 50 points at equal distances d. Planned is the speed v at each of them, as e = v^2 / 2: then the
 * acceleration from one point to the next is (e2 - e1) / d. A plan costs
 *
 *     sum over the segments of  w * E  +  (1 - w) * p * T  +  bounds    -    w * q * m * e(last point)
 *
 *     F = m * a + m * g * (sin + ROLLING * cos) + AIR * v^2                  force at the wheels
 *     E = d * (F > 0 ? F * DRIVING : F * RECUPERATION) + d * F^2 * LOSS      energy from the battery
 *     T = d * mean of 1 / v                                                  travel time
 *
 * w is EnergyWeight. p is the price of a second, which follows from the set speed: on a flat road the set speed is the
 * cheapest one if w is NEUTRAL_WEIGHT. With more weight on energy a lower speed is the cheapest. q is the cost of
 * gaining speed again, so that it is not cheaper to be slow at the end of the horizon. Bounds are steep costs: of speeds
 * outside the band around the set speed, of uncomfortable accelerations, of more power than is available.
 *
 * Discrete differential dynamic programming finds the cheapest plan: at each point there are three speeds, that of the
 * last plan and one on either side of it. The cheapest way through them is the next plan; if that is the last one
 * again, the three move closer together. Each step begins with the plan of the previous step. After PASSES passes it
 * gives up: no solution.
 */
#include "EcoControlMpc.h"

#include <math.h>

#define POINTS   EcoControlMpc_POINTS
#define SEGMENTS (POINTS - 1)
#define WIDTH    3 /* speeds at each point, of which */
#define CENTER   1 /* is the one of the last plan */

#define STEP_TIME 0.5  /* s */
#define GRAVITY   9.81 /* m/s^2 */

#define ROLLING        0.01   /* rolling resistance */
#define AIR            0.45   /* N / (m/s)^2: air drag */
#define DRIVING        1.075  /* energy from the battery for energy at the wheels */
#define RECUPERATION   0.70   /* energy to the battery for energy from the wheels */
#define LOSS           2.5e-5 /* 1/N: the square of the force times this is lost */
#define NEUTRAL_WEIGHT 0.6    /* EnergyWeight at which a flat road is driven at the set speed */

#define LOWER_SPEED   0.90     /* share of the set speed */
#define UPPER_SPEED   1.05     /* share of the set speed */
#define LARGEST_ACC   0.8      /* m/s^2 */
#define SMALLEST_ACC  (-1.0)   /* m/s^2 */
#define LARGEST_POWER 150000.0 /* W */
#define SPEED_COST    50.0     /* J / (m^2/s^2)^2 */
#define ACC_COST      2.0e6    /* J / (m/s^2)^2 */
#define FORCE_COST    2.0      /* J / N^2 */
#define TOLERANCE     0.3      /* m/s^2: a plan further beyond a bound is invalid */

#define LARGEST_SLOPE  0.3 /* steeper is implausible */
#define APPROACH_ACC   0.5 /* m/s^2: with which the band is approached from outside */
#define SMALLEST_SPEED 5.0 /* m/s: below, nothing is planned */

#define FIRST_SPREAD 16.0 /* m^2/s^2: between neighboring speeds, without a plan of the step before */
#define NEXT_SPREAD  4.0  /* m^2/s^2: with one */
#define LAST_SPREAD  0.5  /* m^2/s^2: closer is exact enough: the acceleration to 0.05 m/s^2 */
#define PASSES       60   /* largest number of passes */

#define NO_PROPOSAL (-20.0F) /* m/s^2 */

/* Costs and bounds of a step. */
typedef struct {
  real_T Spacing;              /* m */
  real_T Mass;                 /* kg */
  real_T MassPerSpacing;       /* kg/m */
  real_T SmallestChange;       /* m^2/s^2: from one point to the next */
  real_T LargestChange;        /* m^2/s^2 */
  real_T ChangeCost;           /* J / (m^2/s^2)^2: of more or less */
  real_T Weight;               /* of energy, 0 to 1 */
  real_T TimeCost;             /* J/s: a second, weighted */
  real_T EndValue;             /* J / (m^2/s^2): speed at the end, weighted */
  real_T Lower[POINTS];        /* m^2/s^2: the band around the set speed, or the way there */
  real_T Upper[POINTS];        /* m^2/s^2 */
  real_T Resistance[SEGMENTS]; /* N: slope and rolling */
} Problem_T;

/* The speeds that are compared at a point: each with its cost, and with the best one that follows. */
typedef struct {
  real_T Energy[WIDTH]; /* m^2/s^2: half the square of the speed */
  real_T Force[WIDTH];  /* N: the largest one at this speed */
  real_T Cost[WIDTH];   /* J: time and band */
  real_T ToGo[WIDTH];   /* J: from here to the end */
  int32_T Next[WIDTH];
} Stage_T;

static real_T limited(real_T value, real_T lower, real_T upper)
{
  return (value < lower) ? lower : ((value > upper) ? upper : value);
}

/* Distance of a value from its limits; 0 within. */
static real_T beyond(real_T value, real_T lower, real_T upper)
{
  return (value < lower) ? (lower - value) : ((value > upper) ? (value - upper) : 0.0);
}

/* Slope and rolling resistance of every segment; false if the profile is implausible. */
static boolean_T readRoad(const ExtU_EcoControlMpc_T *inputs, Problem_T *problem)
{
  boolean_T isRoad = true;
  int32_T k;
  for (k = 0; k < SEGMENTS; k++) {
    const real_T rise = (real_T)inputs->HorizonAlt[k + 1] - (real_T)inputs->HorizonAlt[k];
    const real_T slope = rise / problem->Spacing;
    const real_T usable = (fabs(slope) <= LARGEST_SLOPE) ? slope : 0.0;
    isRoad = isRoad && (fabs(slope) <= LARGEST_SLOPE);
    problem->Resistance[k] = problem->Mass * GRAVITY * (usable + (ROLLING * sqrt(1.0 - (usable * usable))));
  }
  return isRoad;
}

static void setVehicle(const P_EcoControlMpc_T *parameters, Problem_T *problem)
{
  problem->Spacing = limited((real_T)parameters->HorizonStep, 1.0, 200.0);
  problem->Mass = (real_T)parameters->VehM;
  problem->MassPerSpacing = problem->Mass / problem->Spacing;
  problem->SmallestChange = SMALLEST_ACC * problem->Spacing;
  problem->LargestChange = LARGEST_ACC * problem->Spacing;
  problem->ChangeCost = ACC_COST / (problem->Spacing * problem->Spacing);
}

/* The band that the speed should stay in. A speed outside is led there. */
static void setBand(real_T speed, real_T setSpeed, Problem_T *problem)
{
  const real_T start = 0.5 * speed * speed;
  const real_T lower = 0.5 * (LOWER_SPEED * setSpeed) * (LOWER_SPEED * setSpeed);
  const real_T upper = 0.5 * (UPPER_SPEED * setSpeed) * (UPPER_SPEED * setSpeed);
  int32_T k;
  for (k = 0; k < POINTS; k++) {
    const real_T change = APPROACH_ACC * problem->Spacing * (real_T)k;
    problem->Lower[k] = ((start + change) < lower) ? (start + change) : lower;
    problem->Upper[k] = ((start - change) > upper) ? (start - change) : upper;
  }
}

/* Prices of time and of speed at the end, from the set speed and the weight. */
static void setPrices(const P_EcoControlMpc_T *parameters, real_T setSpeed, Problem_T *problem)
{
  const real_T drag = (problem->Mass * GRAVITY * ROLLING) + (AIR * setSpeed * setSpeed);
  const real_T perForce = DRIVING + (2.0 * drag * LOSS);
  const real_T second = 2.0 * AIR * setSpeed * setSpeed * setSpeed * perForce;
  problem->Weight = limited((real_T)parameters->EnergyWeight, 0.0, 1.0);
  problem->TimeCost = (1.0 - problem->Weight) * second * (NEUTRAL_WEIGHT / (1.0 - NEUTRAL_WEIGHT));
  problem->EndValue = problem->Weight * problem->Mass * perForce;
}

static real_T wheelForce(const Problem_T *problem, int32_T segment, real_T from, real_T to)
{
  return (problem->MassPerSpacing * (to - from)) + problem->Resistance[segment] + (AIR * (from + to));
}

/* Energy from the battery for a meter of road. */
static real_T batteryForce(real_T force)
{
  return (force * ((force > 0.0) ? DRIVING : RECUPERATION)) + (force * force * LOSS);
}

/* Cost of a segment, without that of its points. */
static real_T segmentCost(const Problem_T *problem, int32_T segment, real_T from, real_T to, real_T largestForce)
{
  const real_T force = wheelForce(problem, segment, from, to);
  const real_T overChange = beyond(to - from, problem->SmallestChange, problem->LargestChange);
  const real_T overForce = (force > largestForce) ? (force - largestForce) : 0.0;
  return (problem->Spacing * problem->Weight * batteryForce(force)) + (problem->ChangeCost * overChange * overChange)
         + (FORCE_COST * overForce * overForce);
}

/* The speeds of a point: those of the plan and its neighbors. */
static void setStage(const Problem_T *problem, int32_T point, real_T planned, real_T spread, Stage_T *stage)
{
  const real_T slowest = 0.5 * (0.5 * SMALLEST_SPEED) * (0.5 * SMALLEST_SPEED);
  int32_T i;
  for (i = 0; i < WIDTH; i++) {
    const real_T energy = planned + (spread * (real_T)(i - CENTER));
    const real_T outside = beyond(energy, problem->Lower[point], problem->Upper[point]);
    real_T perSpeed;
    stage->Energy[i] = (energy > slowest) ? energy : slowest;
    perSpeed = 1.0 / sqrt(2.0 * stage->Energy[i]);
    stage->Force[i] = LARGEST_POWER * perSpeed;
    stage->Cost[i] = (problem->Spacing * problem->TimeCost * perSpeed) + (SPEED_COST * outside * outside);
    stage->ToGo[i] = 0.0;
    stage->Next[i] = CENTER;
  }
}

/* The best speed to follow each speed of a point. */
static void chooseNext(const Problem_T *problem, int32_T segment, Stage_T *stage, const Stage_T *next)
{
  int32_T i;
  int32_T j;
  for (i = 0; i < WIDTH; i++) {
    for (j = 0; j < WIDTH; j++) {
      const real_T cost = segmentCost(problem, segment, stage->Energy[i], next->Energy[j], next->Force[j])
                          + (0.5 * (stage->Cost[i] + next->Cost[j])) + next->ToGo[j];
      if ((j == 0) || (cost < stage->ToGo[i])) {
        stage->ToGo[i] = cost;
        stage->Next[i] = j;
      }
    }
  }
}

/* One pass: replaces the plan by the cheapest one near it, and returns whether it has changed. */
static boolean_T improve(const Problem_T *problem, real_T spread, real_T plan[POINTS])
{
  Stage_T stages[POINTS];
  boolean_T changed = false;
  int32_T chosen = CENTER;
  int32_T k;
  for (k = 0; k < POINTS; k++) {
    setStage(problem, k, plan[k], (k == 0) ? 0.0 : spread, &stages[k]);
  }
  for (k = 0; k < WIDTH; k++) {
    stages[SEGMENTS].ToGo[k] = -problem->EndValue * stages[SEGMENTS].Energy[k];
  }
  for (k = SEGMENTS - 1; k >= 0; k--) {
    chooseNext(problem, k, &stages[k], &stages[k + 1]);
  }
  for (k = 0; k < SEGMENTS; k++) {
    chosen = stages[k].Next[chosen];
    changed = changed || (chosen != CENTER);
    plan[k + 1] = stages[k + 1].Energy[chosen];
  }
  return changed;
}

/* Runs passes until the speeds are close enough together; false if that takes too many. */
static boolean_T optimize(const Problem_T *problem, real_T spread, real_T plan[POINTS])
{
  int32_T pass = 0;
  while ((spread > LAST_SPREAD) && (pass < PASSES)) {
    if (!improve(problem, spread, plan)) {
      spread *= 0.25;
    }
    pass++;
  }
  return spread <= LAST_SPREAD;
}

/* Whether the vehicle can follow the plan to the next point. */
static boolean_T isFeasible(const Problem_T *problem, const real_T plan[POINTS])
{
  const real_T acc = (plan[1] - plan[0]) / problem->Spacing;
  const real_T power = wheelForce(problem, 0, plan[0], plan[1]) * sqrt(2.0 * plan[1]);
  const real_T missing = (power - LARGEST_POWER) / (problem->Mass * sqrt(2.0 * plan[1])); /* m/s^2 */
  return (beyond(acc, SMALLEST_ACC, LARGEST_ACC) < TOLERANCE) && (missing < TOLERANCE);
}

/* A first plan: fast to the set speed, or slowly down to it, and on at that. */
static void beginPlan(const Problem_T *problem, real_T speed, real_T setSpeed, real_T plan[POINTS])
{
  const real_T start = 0.5 * speed * speed;
  const real_T end = 0.5 * setSpeed * setSpeed;
  int32_T k;
  for (k = 0; k < POINTS; k++) {
    const real_T way = problem->Spacing * (real_T)k;
    plan[k] = limited(end, start - (APPROACH_ACC * way), start + (LARGEST_ACC * way));
  }
}

/* The plan of the previous step, from the present position of the vehicle. */
static void shiftPlan(const Problem_T *problem, real_T speed, real_T plan[POINTS])
{
  const real_T way = limited((speed * STEP_TIME) / problem->Spacing, 0.0, (real_T)SEGMENTS);
  const int32_T points = (int32_T)way;
  const real_T part = way - (real_T)points;
  int32_T k;
  plan[0] = 0.5 * speed * speed;
  for (k = 1; k < POINTS; k++) {
    const int32_T before = ((k + points) < SEGMENTS) ? (k + points) : SEGMENTS;
    const int32_T after = (before < SEGMENTS) ? (before + 1) : SEGMENTS;
    plan[k] = ((1.0 - part) * plan[before]) + (part * plan[after]);
  }
}

/* Plans from the plan of the previous step; false without a solution. */
static boolean_T solve(const Problem_T *problem, real_T speed, real_T setSpeed, DW_EcoControlMpc_T *state)
{
  const boolean_T continues = (state->PlanValid != false) && (fabs(state->PlanSetSpd - setSpeed) < 0.01);
  boolean_T solved;
  if (continues) {
    shiftPlan(problem, speed, state->Plan);
  } else {
    beginPlan(problem, speed, setSpeed, state->Plan);
  }
  solved = optimize(problem, continues ? NEXT_SPREAD : FIRST_SPREAD, state->Plan);
  state->PlanSetSpd = setSpeed;
  state->PlanValid = true;
  return solved && isFeasible(problem, state->Plan);
}

/* The acceleration up to the next point; NoSolution if there is none. */
static void propose(RT_MODEL_EcoControlMpc_T *const EcoControlMpc_M)
{
  const ExtU_EcoControlMpc_T *inputs = EcoControlMpc_M->inputs;
  const real_T *plan = EcoControlMpc_M->dwork->Plan;
  Problem_T problem;
  setVehicle(EcoControlMpc_M->defaultParam, &problem);
  setPrices(EcoControlMpc_M->defaultParam, (real_T)inputs->SetSpd, &problem);
  setBand((real_T)inputs->EgoSpd, (real_T)inputs->SetSpd, &problem);
  if (readRoad(inputs, &problem)
      && solve(&problem, (real_T)inputs->EgoSpd, (real_T)inputs->SetSpd, EcoControlMpc_M->dwork)) {
    EcoControlMpc_M->outputs->EcoAccProp = (real32_T)((plan[1] - plan[0]) / problem.Spacing);
  } else {
    EcoControlMpc_M->outputs->NoSolution = true;
  }
}

/* Whether a plan is possible: NaN is not a speed. */
static boolean_T isDriving(const ExtU_EcoControlMpc_T *inputs)
{
  return (inputs->EnaMpc != false) && (inputs->HorizonTmo == 0U) && (inputs->EgoSpd >= (real32_T)SMALLEST_SPEED)
         && (inputs->EgoSpd <= 100.0F) && (inputs->SetSpd >= (real32_T)SMALLEST_SPEED) && (inputs->SetSpd <= 100.0F);
}

static boolean_T isFaulty(const ExtU_EcoControlMpc_T *inputs)
{
  return (inputs->AccPropInvalid != 0U) || (inputs->NoSolutionSts != 0U) || (inputs->DeadlineSts != 0U);
}

/* Model step function. A fault withholds the proposal only: a solution has to be found to end it. */
void EcoControlMpc_step(RT_MODEL_EcoControlMpc_T *const EcoControlMpc_M)
{
  const ExtU_EcoControlMpc_T *inputs = EcoControlMpc_M->inputs;
  ExtY_EcoControlMpc_T *outputs = EcoControlMpc_M->outputs;
  outputs->EcoAccProp = NO_PROPOSAL;
  outputs->NoSolution = false;
  outputs->ModeSts = inputs->ModeReq;
  if ((inputs->ModeReq == (uint8_T)EcoControlMpcMode_ACTIVE) && isDriving(inputs)) {
    propose(EcoControlMpc_M);
  } else {
    EcoControlMpc_M->dwork->PlanValid = false;
  }
  if (isFaulty(inputs)) {
    outputs->EcoAccProp = NO_PROPOSAL;
    outputs->ModeSts = (uint8_T)EcoControlMpcMode_FAULT;
  }
}

/* Model initialize function */
void EcoControlMpc_initialize(RT_MODEL_EcoControlMpc_T *const EcoControlMpc_M)
{
  static const DW_EcoControlMpc_T noPlan = { { 0.0 }, 0.0, 0U };
  static const ExtU_EcoControlMpc_T nothing = { { 0.0F }, 0.0F, 0.0F, 0U, 0U, 0U, 0U, 0U, 0U };
  EcoControlMpc_M->errorStatus = 0;
  *EcoControlMpc_M->dwork = noPlan;
  *EcoControlMpc_M->inputs = nothing;
  EcoControlMpc_M->outputs->EcoAccProp = NO_PROPOSAL;
  EcoControlMpc_M->outputs->NoSolution = false;
  EcoControlMpc_M->outputs->ModeSts = (uint8_T)EcoControlMpcMode_OFF;
}

/* Model terminate function: the proposal is withdrawn */
void EcoControlMpc_terminate(RT_MODEL_EcoControlMpc_T *const EcoControlMpc_M)
{
  EcoControlMpc_M->dwork->PlanValid = false;
  EcoControlMpc_M->outputs->EcoAccProp = NO_PROPOSAL;
  EcoControlMpc_M->outputs->ModeSts = (uint8_T)EcoControlMpcMode_OFF;
}
