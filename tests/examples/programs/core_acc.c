/* CoreAcc over a pipe: the inputs of a step as doubles in, its outputs as doubles out. */
#include "CoreAcc.h"

#include <stdio.h>

typedef struct {
  double brake_pressure;
  double steering_angle;
  double acceleration;
  double speed;
  double mass;
  double set_speed;
  double is_enabled;
  double unit;
  double distance;
  double proposal;
  double mode;
  double invalid;
  double brake_missing;
  double angle_missing;
  double proposal_missing;
  double largest_lateral_acceleration;
} Inputs;

typedef struct {
  double request;
  double mode;
  double status;
} Outputs;

static void set(const Inputs *given)
{
  Bus_ACCIn_T *bus = &core_inputs.bus_ACCIn;
  bus->Bus_Veh.BrkCylP = given->brake_pressure;
  bus->Bus_Veh.SteerWhlAg = given->steering_angle;
  bus->Bus_Veh.EgoVehALgt = given->acceleration;
  bus->Bus_Veh.EgoVehSpd = given->speed;
  bus->Bus_Cust.EgoVehMass = given->mass;
  bus->Bus_Cust.SetSpd = (real32_T)given->set_speed;
  bus->Bus_Cust.EnaGACC = (boolean_T)given->is_enabled;
  bus->Bus_Cust.EgoVehDshbSpdUnit = (uint8_T)given->unit;
  bus->Bus_Obj.ObjDst = (real32_T)given->distance;
  core_inputs.bus_MPCOut.EcoAccProp = (real32_T)given->proposal;
  bus->Bus_Sts.ModeReq = (uint8_T)given->mode;
  bus->Bus_Sts.AccReqInvalid = (uint8_T)given->invalid;
  bus->Bus_Sts.BrkPTmo = (uint8_T)given->brake_missing;
  bus->Bus_Sts.SteerAgTmo = (uint8_T)given->angle_missing;
  bus->Bus_Sts.EcoAccPropTmo = (uint8_T)given->proposal_missing;
  core_params.ALatMax = (real32_T)given->largest_lateral_acceleration;
}

static void tell(void)
{
  Outputs outputs;
  outputs.request = (double)core_outputs.bus_ACCOut.AccReq;
  outputs.mode = (double)core_outputs.bus_ACCOut.ModeSts;
  outputs.status = (double)AsmAcc_AccIntSts;
  (void)fwrite(&outputs, sizeof outputs, 1, stdout);
  (void)fflush(stdout);
}

int main(void)
{
  Inputs inputs;
  CoreAcc_initialize();
  tell();
  while (fread(&inputs, sizeof inputs, 1, stdin) == 1) {
    set(&inputs);
    CoreAcc_step();
    tell();
  }
  CoreAcc_terminate();
  tell();
  return 0;
}
