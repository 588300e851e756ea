#include "__NAME__.h"

__NAME___Inputs __NAME___in;
__NAME___Parameters __NAME___par = {0.5f};
__NAME___Outputs __NAME___out;

void __NAME___Init(void)
{
  __NAME___out.mode = __NAME___OUT_OFF;
}

void __NAME___Step(void)
{
  if (__NAME___in.isInvalid) {
    __NAME___out.mode = __NAME___OUT_FAULT;
    return;
  }
  __NAME___out.mode = __NAME___in.mode == __NAME___IN_ON ? __NAME___OUT_ON : __NAME___OUT_OFF;
  /* To do: compute the outputs from __NAME___in.speed and __NAME___par.gain. */
}

void __NAME___Terminate(void)
{
}
