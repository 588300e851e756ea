#ifndef CABIN_AIR_H
#define CABIN_AIR_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
  float humidity; /* Vehicle.Cabin.Humidity, percent */
} CabinAir_Inputs;

typedef struct {
  bool isFrontDefrosterActive; /* Vehicle.Cabin.HVAC.IsFrontDefrosterActive */
} CabinAir_Outputs;

extern CabinAir_Inputs CabinAir_in;
extern CabinAir_Outputs CabinAir_out;

void CabinAir_Init(void);
void CabinAir_Step(void); /* every 100 ms */

#ifdef __cplusplus
}
#endif

#endif
