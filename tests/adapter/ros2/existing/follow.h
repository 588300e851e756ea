#include <stdint.h>
extern double speed, wanted;
extern uint8_t gear_in, gear_out;
void follow_step(void);
