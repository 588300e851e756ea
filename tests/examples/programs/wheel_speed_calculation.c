/* WheelSpeedCalculation over a pipe: the inputs of a step as doubles in, its outputs as doubles out. */
#include "WheelSpeedCalculation.h"

#include <stdio.h>

typedef struct {
  double front_left;
  double front_right;
  double rear_left;
  double rear_right;
  double mode;
  double rear_left_invalid;
  double range_error_known;
  double front_diameter;
  double rear_diameter;
  double largest_speed;
} Inputs;

typedef struct {
  double front_left;
  double front_right;
  double rear_left;
  double rear_right;
  double mode;
  double range_error;
  double range_errors; /* of the life of the vehicle, as they are stored at the end */
} Outputs;

static void set(const Inputs *given)
{
  whl_in.WhlRotFL = (real32_T)given->front_left;
  whl_in.WhlRotFR = (real32_T)given->front_right;
  whl_in.WhlRotRL = (real32_T)given->rear_left;
  whl_in.WhlRotRR = (real32_T)given->rear_right;
  whl_in.ModeReq = (uint8_T)given->mode;
  whl_in.WhlSpdRLInvalid = (uint8_T)given->rear_left_invalid;
  whl_in.RangeErrSts = (uint8_T)given->range_error_known;
  whl_par.TireDiaFrnt = (real32_T)given->front_diameter;
  whl_par.TireDiaRear = (real32_T)given->rear_diameter;
  whl_par.SpdMax = (real32_T)given->largest_speed;
}

static void tell(void)
{
  Outputs outputs;
  outputs.front_left = (double)whl_out.WhlSpdFL;
  outputs.front_right = (double)whl_out.WhlSpdFR;
  outputs.rear_left = (double)whl_out.WhlSpdRL;
  outputs.rear_right = (double)whl_out.WhlSpdRR;
  outputs.mode = (double)whl_out.ModeSts;
  outputs.range_error = (double)whl_out.RangeErr;
  outputs.range_errors = (double)whl_par.RangeErrCnt;
  (void)fwrite(&outputs, sizeof outputs, 1, stdout);
  (void)fflush(stdout);
}

int main(void)
{
  Inputs inputs;
  WheelSpeedCalculation_step(); /* before it is initialized: does nothing */
  tell();
  whl_par.RangeErrCnt = 7U;
  WheelSpeedCalculation_initialize();
  tell();
  while (fread(&inputs, sizeof inputs, 1, stdin) == 1) {
    set(&inputs);
    WheelSpeedCalculation_step();
    tell();
  }
  WheelSpeedCalculation_terminate();
  tell();
  return 0;
}
