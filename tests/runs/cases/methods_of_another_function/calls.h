#include <stdbool.h>
#include <stdint.h>
extern bool fetch, reset;
extern uint16_t place, place_in, places, server_place, server_places;
extern float limit, fetched, server_limit;
extern uint8_t state, reset_state, state_out, server_mode;
extern uint32_t asked;
void client_step(void);
void server_step(void);
void server_fetch(void);
void server_reset(void);
