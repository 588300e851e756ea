#include "calls.h"
bool fetch, reset;
uint16_t place, place_in, places;
float limit, fetched;
uint8_t state, reset_state, state_out;
void client_step(void)
{
    limit = fetched + (float)places;
    state_out = (uint8_t)(state * 10U + reset_state);
    fetch = place_in != place;
    reset = place_in == 7U;
    place = place_in;
}
