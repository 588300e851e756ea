/* Channels of a mixer. */
#ifndef MIXER_H_
#define MIXER_H_

struct Pair { float left; float right; };

typedef struct { double level; int gain; } Channel;

extern struct Pair Limits[2];
extern Channel Channels[3];
extern double Sum;

void Mixer_initialize(void);
void Mixer_step(void);

#endif
