#include <stdint.h>
#include <stdbool.h>
extern bool fetch, report;
extern uint16_t place;
extern float limit, fetched;
extern uint8_t status, state;
void asking_init(void);
void asking_step(void);
