#pragma once
#include "rtwtypes.h"
#include "BusBattery.h"

typedef struct {
  BusBattery Battery;
  real_T Current;                      /* [A] */
} ExtU_Charger_T;

typedef struct {
  real_T Power;                        /* [kW] [0,22] */
} ExtY_Charger_T;

extern ExtU_Charger_T Charger_U;
extern ExtY_Charger_T Charger_Y;
extern void Charger_initialize(void);
extern void Charger_step(void);
extern void Charger_terminate(void);
