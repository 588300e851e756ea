#ifndef MIRROR_H
#define MIRROR_H

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    float in_speed;
    int16_t in_temperature;
    int8_t in_gear;
    bool in_ison;
    float in_force;
    int32_t in_turn;
    uint16_t in_first;
    int16_t in_second;
    double in_exact;
    uint64_t in_wide;
    float wish_speed;
    int16_t wish_temperature;
    int8_t wish_gear;
    bool wish_ison;
    float wish_force;
    int32_t wish_turn;
    uint16_t wish_first;
    int16_t wish_second;
    double wish_exact;
    uint64_t wish_wide;
    float out_speed;
    int16_t out_temperature;
    int8_t out_gear;
    bool out_ison;
    float out_force;
    int32_t out_turn;
    uint16_t out_first;
    int16_t out_second;
    double out_exact;
    uint64_t out_wide;
} mirror_t;

void mirror_step(mirror_t *self);

#endif /* MIRROR_H */
