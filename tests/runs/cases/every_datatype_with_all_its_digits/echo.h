#include <stdbool.h>
#include <stdint.h>

extern bool in_boolean;
extern bool out_boolean;
extern uint8_t in_uint8;
extern uint8_t out_uint8;
extern int8_t in_int8;
extern int8_t out_int8;
extern uint16_t in_uint16;
extern uint16_t out_uint16;
extern int16_t in_int16;
extern int16_t out_int16;
extern uint32_t in_uint32;
extern uint32_t out_uint32;
extern int32_t in_int32;
extern int32_t out_int32;
extern uint64_t in_uint64;
extern uint64_t out_uint64;
extern int64_t in_int64;
extern int64_t out_int64;
extern float in_float;
extern float out_float;
extern double in_double;
extern double out_double;

void echo_init(void);
void echo_step(void);
void echo_terminate(void);
