/* Prints the state of its error, whenever it has changed. */

#include "follow.h"

#include <stdio.h>

uint32_t follow_steps;
uint8_t follow_dep;

void follow_step(void)
{
    static uint8_t dep = 7;

    if (dep != follow_dep) {
        dep = follow_dep;
        printf("dep %u\n", (unsigned)dep);
        (void)fflush(stdout);
    }
}
