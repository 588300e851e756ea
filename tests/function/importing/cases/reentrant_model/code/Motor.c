#include "Motor.h"
#include <limits.h>
#if ( ULONG_MAX != (0xFFFFFFFFUL) ) || ( LONG_MAX != (0x7FFFFFFF) )
#error Code was generated for compiler with different sized ulong/long.
#endif

const ConstP rtConstP = { { 0, 1, 2 } };

/* Model step function */
void Motor_step(RT_MODEL *const rtM)
{
  P *rtP = ((P *) rtM->defaultParam);
  DW *rtDW = ((DW *) rtM->dwork);
  ExtU *rtU = (ExtU *) rtM->inputs;
  ExtY *rtY = (ExtY *) rtM->outputs;
  if (rtU->b_motEna) {
    rtDW->UnitDelay_DSTATE += (int16_T)(rtP->cf_nKp * (rtU->n_tgt - rtU->i_phaA));
  }
  rtY->DC_phaA = rtDW->UnitDelay_DSTATE + rtP->table[1] + rtConstP.sin_Table[0];
}

void Motor_initialize(RT_MODEL *const rtM)
{
  rtM->dwork->UnitDelay_DSTATE = 0;
}
