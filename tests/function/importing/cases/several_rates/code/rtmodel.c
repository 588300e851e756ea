#include "Damper.h"
void Damper_step(int tid);
void Damper_step(int tid)
{
  switch (tid) {
   case 0:
    Damper_step0();
    break;
   default:
    Damper_step1();
  }
}
