#include "bounce.h"
uint16_t key, items[2];
uint32_t item_count, sum, total;
void event_step(void) { sum = sum * 31U + key; }
void queue_step(void) { for (uint32_t i = 0; i < item_count; i++) { total = total * 31U + items[i]; } }
