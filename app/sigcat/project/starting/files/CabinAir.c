#include "CabinAir.h"

CabinAir_Inputs CabinAir_in;
CabinAir_Outputs CabinAir_out;

void CabinAir_Init(void)
{
  CabinAir_out.isFrontDefrosterActive = false;
}

void CabinAir_Step(void)
{
  /* On above 80 percent, off below 60. */
  if (CabinAir_in.humidity > 80.0f) {
    CabinAir_out.isFrontDefrosterActive = true;
  } else if (CabinAir_in.humidity < 60.0f) {
    CabinAir_out.isFrontDefrosterActive = false;
  }
}
