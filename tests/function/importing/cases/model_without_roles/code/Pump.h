#pragma once
#include <stdint.h>
typedef struct { float level; /* [percent] */ unsigned mode : 3; uint8_t gear; /* 0.5 degC, offset 20 */ } Sensors_T;
typedef struct { float flow; } Drive_T;
typedef struct { Sensors_T *sensors; Drive_T *drive; float direct; float warn; int32_t count; } Pump_M;
void Pump_Init(Pump_M *m);
void Pump_Step(Pump_M *m);
