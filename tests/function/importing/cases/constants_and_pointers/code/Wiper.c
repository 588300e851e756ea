#include "Wiper.h"
static float points[2];
float RainLevel;
float WiperSpeed;
float *Curve = points;
const float Threshold = 10.0F;
const float Limit = 60.0F;
const float Unused = 1.0F;
void Wiper_init(void) {}
void Wiper_step(void)
{
    WiperSpeed = (RainLevel > Threshold) ? Curve[0] : Limit;
}
