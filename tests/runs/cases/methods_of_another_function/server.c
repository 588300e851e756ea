#include "calls.h"
uint16_t server_place, server_places;
float server_limit;
uint32_t asked;
uint8_t server_mode;
static uint32_t count;
void server_step(void) { asked = count; }
void server_fetch(void) { count++; server_limit = (float)server_place * 1.5F; server_places += server_place; }
void server_reset(void) { count = 100; server_places = 0; }
