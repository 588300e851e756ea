/* What the function of the bench takes, gives and does, in m/s. */
#ifndef REFLEX_H
#define REFLEX_H

#ifdef __cplusplus
extern "C" {
#endif

extern float reflex_speed;
extern float reflex_half;
void reflex_step(void);

#ifdef __cplusplus
}
#endif

#endif
