#ifndef EgoCar_h_
#define EgoCar_h_
#include "rtwtypes.h"

class EgoCar final
{
 public:
  struct ExtU_EgoCar_T {
    real_T v_lead;                     // '<Root>/v_lead'
  };
  struct ExtY_EgoCar_T {
    real_T a_ego;                      // '<Root>/a_ego'
  };
  void setExternalInputs(const ExtU_EgoCar_T *pExtU)
  {
    EgoCar_U = *pExtU;
  }
  const ExtY_EgoCar_T &getExternalOutputs() const
  {
    return EgoCar_Y;
  }
  void initialize();
  void step();
  static void terminate();

 private:
  ExtU_EgoCar_T EgoCar_U;
  ExtY_EgoCar_T EgoCar_Y;
};
#endif
