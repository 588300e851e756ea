#include "roof.h"

float speed;
int8_t position;
float seat;
uint16_t load;
uint8_t roof_switch;
float brightness;
uint8_t no_roof;

void roof_init(void)
{
    roof_switch = 0U;
}

void roof_step(void)
{
    roof_switch = ((speed > 100.0F) || (load > 1000U)) ? 1U : 2U;
    brightness = (float)position + (10.0F * seat) + ((float)load / 1000.0F) + ((no_roof != 0U) ? 40.0F : 0.0F);
}

void roof_terminate(void)
{
}

uint8_t shade;
uint8_t font;

void shade_step(void)
{
    font = (uint8_t)(shade % 3U);
}
