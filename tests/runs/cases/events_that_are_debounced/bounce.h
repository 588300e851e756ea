#include <stdint.h>
extern uint16_t key, items[2];
extern uint32_t item_count, sum, total;
void event_step(void);
void queue_step(void);
