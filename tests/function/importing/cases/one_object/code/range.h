#pragma once
#include <stdint.h>


typedef struct {
    struct { double soc; double consumption; /* Unit: kWh/100km */ } in;
    struct { uint32_t range; /* Unit: km */ } out;
    double filtered;
} RangeEstimator;

int range_init(RangeEstimator *self);
int range_update(RangeEstimator *self);
