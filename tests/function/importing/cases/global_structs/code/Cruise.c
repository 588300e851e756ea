#include "Cruise.h"

DW_Cruise_T Cruise_DW;
ExtU_Cruise_T Cruise_U;
ExtY_Cruise_T Cruise_Y;
static RT_MODEL_Cruise_T Cruise_M_;
RT_MODEL_Cruise_T *const Cruise_M = &Cruise_M_;

/* Model step function */
/* Sample time: [0.02s, 0.0s] */
void Cruise_step(void)
{
  Cruise_DW.Integrator_DSTATE += Cruise_P.Ki * Cruise_U.Bus.Ego.VehSpd;
  Cruise_Y.AccReq = Cruise_P.Kp * Cruise_DW.Integrator_DSTATE;
  Cruise_Y.State = Cruise_U.Wanted;
}

void Cruise_initialize(void)
{
  Cruise_DW.Integrator_DSTATE = 0.0;
}

void Cruise_terminate(void)
{
}
