#include "Cruise.h"
#include <stdio.h>

void rt_OneStep(void);
void rt_OneStep(void)
{
  Cruise_step();
}

int main(void)
{
  Cruise_initialize();
  rt_OneStep();
  Cruise_terminate();
  return 0;
}
