//
// Code generated for Simulink model 'Parking'.
//
// Model version                  : 2.1
//
#ifndef Parking_h_
#define Parking_h_
#include <cmath>
#include "rtwtypes.h"

// Class declaration for model Parking
namespace assist {
class Parking final
{
  // public data and function members
 public:
  // Block states (default storage) for system '<Root>'
  struct DW_Parking_T {
    real_T Delay_DSTATE;               // '<Root>/Delay'
  };

  // External inputs (root inport signals with default storage)
  struct ExtU_Parking_T {
    real_T VehSpd;                     // '<Root>/VehSpd'
    real_T ObjDst[4];                  // '<Root>/ObjDst' [m] [0,5]
  };

  // External outputs (root outports fed by signals with default storage)
  struct ExtY_Parking_T {
    boolean_T Warn;                    // '<Root>/Warn'
  };

  // Parameters (default storage)
  struct P_Parking_T {
    real_T Limit;                      // Variable: Limit
                                       //  Referenced by: '<Root>/Limit'
  };

  // Copy Constructor
  Parking(Parking const&) = delete;

  // External inputs
  ExtU_Parking_T Parking_U;

  // External outputs
  ExtY_Parking_T Parking_Y;

  // Tunable parameters
  static P_Parking_T Parking_P;

  // model initialize function
  void initialize();

  // model step function
  void step();                         // Sample time: [0.05s, 0.0s]

  // model terminate function
  static void terminate();

  Parking();
  ~Parking();

 private:
  DW_Parking_T Parking_DW;
};
}
#endif
