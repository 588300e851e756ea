#include "Damper.h"
ExtU_Damper_T Damper_U;
ExtY_Damper_T Damper_Y;
static void filtered(real_T *value);
static void filtered(real_T *value) { *value *= 0.5; }
void Damper_step0(void)
{
  Damper_Y.Force = 2.0 * Damper_U.Fast;
  filtered(&Damper_Y.Force);
}
void Damper_step1(void)
{
  Damper_Y.Level = Damper_U.Slow;
}
void Damper_initialize(void) {}
void Damper_terminate(void) {}
