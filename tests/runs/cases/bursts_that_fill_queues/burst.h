#include <stdint.h>
extern uint8_t amount;
extern uint16_t items[8], taken[2], frames[2];
extern uint32_t item_count, taken_count, frame_count, sum;
void sender_step(void);
void old_step(void);
