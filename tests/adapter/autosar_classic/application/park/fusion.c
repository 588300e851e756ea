#include "park.h"
echo_t echoes[3]; uint32_t echo_count; int8_t temperature; float distance[4];
void fusion_init(void) { for (int i = 0; i < 4; i++) { distance[i] = 9.0F; } }
void fusion_step(void)
{
    for (uint32_t i = 0; i < echo_count; i++) { distance[echoes[i].Sensor % 4U] = echoes[i].Range + (float)temperature * 0.01F; }
}
