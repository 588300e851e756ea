/* Prints what it sees, whenever it has changed. */

#include "guard.h"

#include <stdio.h>

float guard_speed;
uint8_t guard_broken;

void guard_step(void)
{
    static float speed;
    static uint8_t broken;

    if ((guard_speed < speed) || (guard_speed > speed) || (guard_broken != broken)) {
        speed = guard_speed;
        broken = guard_broken;
        printf("speed %.1f, %s\n", (double)speed, (broken != 0U) ? "broken" : "sound");
        (void)fflush(stdout);
    }
}
