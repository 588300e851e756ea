/* The variables and calls that function.yaml declares. An adapter writes the inputs before each call, and reads the
   outputs after it. */
#ifndef __NAME___H
#define __NAME___H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { __NAME___IN_OFF, __NAME___IN_ON };
enum { __NAME___OUT_OFF, __NAME___OUT_ON, __NAME___OUT_FAULT };

typedef struct {
  float speed;    /* Vehicle.Speed, km/h */
  bool isInvalid; /* __NAME__Invalid_SftyCondSts: the outputs are not valid */
  uint8_t mode;   /* __NAME___Mode_In */
} __NAME___Inputs;

typedef struct {
  float gain; /* Vehicle.Function.__NAME__.Parameter.Gain, 0 to 1 */
} __NAME___Parameters;

typedef struct {
  uint8_t mode; /* __NAME___Mode_Out */
} __NAME___Outputs;

extern __NAME___Inputs __NAME___in;
extern __NAME___Parameters __NAME___par;
extern __NAME___Outputs __NAME___out;

void __NAME___Init(void);
void __NAME___Step(void); /* every 20 ms */
void __NAME___Terminate(void);

#ifdef __cplusplus
}
#endif

#endif
