#include "windows.h"
uint8_t pedal;
uint8_t sum;
uint8_t mode;
void windows_first(void)
{
    sum = pedal;
}
void windows_step(void)
{
    sum++;
}
