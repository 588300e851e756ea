#ifndef WIPER_H
#define WIPER_H
extern float RainLevel;       /* Rain, see chapter [3,4] of the manual [%] [0,100] */
extern float WiperSpeed;      /* Speed of the wiper */
extern float *Curve;          /* Points of the curve */
extern const float Threshold; /* Rain from which the wiper runs */
extern const float Limit;     /* Largest speed */
extern const float Unused;    /* No step reads it */
void Wiper_init(void);
void Wiper_step(void);
#endif
