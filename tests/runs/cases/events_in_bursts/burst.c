#include "burst.h"
uint16_t given[4];
uint32_t given_count, last, total;
void command_step(void) {
    for (uint32_t i = 0; i < given_count; i++) {
        last = given[i];
        total = total * 31U + given[i];
    }
}
