#include <stdint.h>

extern float speed;
extern int8_t position;
extern float seat;
extern uint16_t load;
extern uint8_t roof_switch;
extern float brightness;
extern uint8_t no_roof;

extern uint8_t shade;
extern uint8_t font;

void shade_step(void);
void roof_init(void);
void roof_step(void);
void roof_terminate(void);
