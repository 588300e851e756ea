#include "EngMon.h"

boolean_T OverSpd;
real32_T Load;
real_T SpdMax = 6500.0;
const real_T Fixed = 2.0;

void EngMon_step(void)
{
  OverSpd = (boolean_T)(EngSpd > SpdMax && Ignition != 0);
  Shared++;
  EngMon_DW.Delay = EngSpd;
  Load = (real32_T)(EngSpd / SpdMax * Fixed + OilTemp + Buffer[0][0]);
}

void EngMon_initialize(void)
{
  OverSpd = 0;
}
