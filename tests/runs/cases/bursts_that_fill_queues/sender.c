#include "burst.h"
uint8_t amount;
uint16_t items[8];
uint32_t item_count;
void sender_step(void)
{
    static uint16_t next = 1;
    for (item_count = 0; item_count < amount && item_count < 8; item_count++) {
        items[item_count] = next++;
    }
}
