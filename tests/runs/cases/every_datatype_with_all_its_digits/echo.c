#include "echo.h"

bool in_boolean;
bool out_boolean;
uint8_t in_uint8;
uint8_t out_uint8;
int8_t in_int8;
int8_t out_int8;
uint16_t in_uint16;
uint16_t out_uint16;
int16_t in_int16;
int16_t out_int16;
uint32_t in_uint32;
uint32_t out_uint32;
int32_t in_int32;
int32_t out_int32;
uint64_t in_uint64;
uint64_t out_uint64;
int64_t in_int64;
int64_t out_int64;
float in_float;
float out_float;
double in_double;
double out_double;

void echo_init(void) {}

void echo_step(void)
{
    out_boolean = in_boolean;
    out_uint8 = in_uint8;
    out_int8 = in_int8;
    out_uint16 = in_uint16;
    out_int16 = in_int16;
    out_uint32 = in_uint32;
    out_int32 = in_int32;
    out_uint64 = in_uint64;
    out_int64 = in_int64;
    out_float = in_float;
    out_double = in_double;
}

void echo_terminate(void) {}
