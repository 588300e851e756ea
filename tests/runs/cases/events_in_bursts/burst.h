#include <stdint.h>
extern uint16_t given[4];
extern uint32_t given_count, last, total;
void command_step(void);
