#include "Motor.h"

static RT_MODEL rtM_;
static RT_MODEL *const rtMPtr = &rtM_;
static P rtP = { 4096U, { 1, 2, 3, 4 } };
static DW rtDW;
static ExtU rtU;
static ExtY rtY;

int main(void)
{
  RT_MODEL *const rtM = rtMPtr;
  rtM->defaultParam = &rtP;
  rtM->dwork = &rtDW;
  rtM->inputs = &rtU;
  rtM->outputs = &rtY;
  Motor_initialize(rtM);
  Motor_step(rtM);
  return 0;
}
