/* Two instances of EcoControlMpc over a pipe: the inputs of a step as doubles in, its outputs as doubles out. */
#include "EcoControlMpc.h"

#include <stdio.h>

typedef struct {
  double instance; /* 0 or 1 */
  double is_enabled;
  double speed;
  double set_speed;
  double mode;
  double invalid;
  double horizon_missing;
  double mass;
  double spacing;
  double energy_weight;
  double altitudes[EcoControlMpc_POINTS];
} Inputs;

typedef struct {
  double proposal;
  double mode;
  double no_solution;
} Outputs;

typedef struct {
  RT_MODEL_EcoControlMpc_T model;
  P_EcoControlMpc_T parameters;
  ExtU_EcoControlMpc_T inputs;
  ExtY_EcoControlMpc_T outputs;
  DW_EcoControlMpc_T states;
} Instance;

static Instance instances[2];

static void begin(Instance *instance)
{
  instance->model.defaultParam = &instance->parameters;
  instance->model.inputs = &instance->inputs;
  instance->model.outputs = &instance->outputs;
  instance->model.dwork = &instance->states;
  EcoControlMpc_initialize(&instance->model);
}

static void set(Instance *instance, const Inputs *given)
{
  int point;
  instance->inputs.EnaMpc = (boolean_T)given->is_enabled;
  instance->inputs.EgoSpd = (real32_T)given->speed;
  instance->inputs.SetSpd = (real32_T)given->set_speed;
  instance->inputs.ModeReq = (uint8_T)given->mode;
  instance->inputs.AccPropInvalid = (uint8_T)given->invalid;
  instance->inputs.HorizonTmo = (uint8_T)given->horizon_missing;
  instance->parameters.VehM = (real32_T)given->mass;
  instance->parameters.HorizonStep = (real32_T)given->spacing;
  instance->parameters.EnergyWeight = (real32_T)given->energy_weight;
  for (point = 0; point < EcoControlMpc_POINTS; point++) {
    instance->inputs.HorizonAlt[point] = (real32_T)given->altitudes[point];
  }
}

static void tell(const Instance *instance)
{
  Outputs outputs;
  outputs.proposal = (double)instance->outputs.EcoAccProp;
  outputs.mode = (double)instance->outputs.ModeSts;
  outputs.no_solution = (double)instance->outputs.NoSolution;
  (void)fwrite(&outputs, sizeof outputs, 1, stdout);
  (void)fflush(stdout);
}

int main(void)
{
  Inputs inputs;
  begin(&instances[0]);
  begin(&instances[1]);
  tell(&instances[0]);
  while (fread(&inputs, sizeof inputs, 1, stdin) == 1) {
    Instance *instance = &instances[(inputs.instance > 0.5) ? 1 : 0];
    set(instance, &inputs);
    EcoControlMpc_step(&instance->model);
    tell(instance);
  }
  EcoControlMpc_terminate(&instances[0].model);
  EcoControlMpc_terminate(&instances[1].model);
  tell(&instances[0]);
  return 0;
}
