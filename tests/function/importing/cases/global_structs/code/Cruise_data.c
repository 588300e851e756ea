#include "Cruise.h"

const ConstB_Cruise_T Cruise_ConstB = { 2.0 };

P_Cruise_T Cruise_P = {
  0.5,
  0.1F,
  { 1.0, 2.0, 3.0 },
  1
};
