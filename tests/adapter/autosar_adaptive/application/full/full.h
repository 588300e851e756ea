/* The code of Full, as a compiler has to see it. */
#ifndef FULL_H
#define FULL_H

#include <stdbool.h>
#include <stdint.h>

typedef struct { double Lat; float Lon; uint8_t Kind; int16_t vals[3]; } Point;
typedef struct {
    float speed; double q[4]; uint32_t n; uint8_t gear; int8_t arr[5]; Point p; bool en; uint64_t big; int32_t rst;
    float imm; uint8_t mode; uint8_t errst; uint8_t react; double lone; float back;
} In;
typedef struct {
    float acc; uint16_t scaled; uint8_t gear; float many[4]; uint8_t nmany; uint8_t err; uint8_t mode; Point p; int64_t i64;
} Out;
typedef struct { float k; double tab[3]; uint32_t cnt; uint8_t kind; } Par;
typedef struct { uint8_t req; double arg; uint8_t st; float res; int32_t off_a; float off_r; } Met;

extern In g_in;
extern Out g_out;
extern Par g_par;
extern Met g_met;

int full_init(void);
void full_step(void);
void full_event(void);
void full_term(void);
void full_offered(void);

#endif
