#include "asking.h"

bool fetch, report;
uint16_t place;
float limit, fetched;
uint8_t status, state;

void asking_init(void)
{
    limit = 0.0F;
}

void asking_step(void)
{
    limit = fetched;
    status = state;
    if (state != 1U) {
        place++;
        fetch = true;
        report = true;
    }
}
