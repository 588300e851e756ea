#include "filter.h"

#include <stdio.h>

filter_in_t filter_in;
filter_out_t filter_out;

void filter_init(void)
{
    filter_out.trend = 8;
}

void filter_step(void)
{
    const float next = 0.5F * (filter_out.levels[0] + (float)(filter_in.speed * 3.6));
    printf("what a function prints is no result\n");
    filter_out.trend = (next > filter_out.levels[0]) ? 9 : ((next < filter_out.levels[0]) ? 7 : 8);
    filter_out.levels[2] = filter_out.levels[1];
    filter_out.levels[1] = filter_out.levels[0];
    filter_out.levels[0] = next;
    filter_out.stands = (filter_in.speed < 0.1);
    filter_out.mode = filter_in.mode;
}

void filter_terminate(void)
{
}
