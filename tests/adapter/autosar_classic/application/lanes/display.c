#include "lanes.h"
float shown_heading;
uint16_t shown_marking;
uint32_t shown_count, shown;
void display_step(void)
{
    if (shown_count != 0U) { shown = shown * 31U + shown_marking; }
}
