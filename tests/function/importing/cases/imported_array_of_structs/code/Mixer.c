#include "Mixer.h"

double Sum;

void Mixer_initialize(void) {
    Sum = 0;
}

void Mixer_step(void) {
    Sum = Channels[0].level + Channels[1].level * Channels[1].gain + Channels[2].level + Limits[1].left;
}
