#include "park.h"
wheels_t shown_wheels; echo_t shown_echo; uint16_t shown_brake, ask_old; uint32_t screen; uint8_t ask_why, ask_state; bool ask;
void hmi_step(void)
{
    screen = screen * 31U + shown_brake + shown_wheels.Speeds[2] + shown_echo.Sensor + ask_old + ask_state;
    ask_why = (uint8_t)screen;
    ask = (screen % 3U) == 0U;
}
