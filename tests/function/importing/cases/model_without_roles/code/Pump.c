#include "Pump.h"
void Pump_Init(Pump_M *m) { m->count = 0; }
void Pump_Step(Pump_M *m) { m->drive->flow = m->sensors->level * (float)m->sensors->mode + m->direct; m->warn = (float)(++m->count); }
