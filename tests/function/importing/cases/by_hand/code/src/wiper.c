#include "wiper.h"

struct wiper_inputs wiper_in;
struct wiper_outputs wiper_out;
struct wiper_config wiper_cfg = {.threshold = 42.5f, .hysteresis = 3};

int wiper_init(void) { return 0; }
void wiper_step_10ms(void) {
    wiper_out.mode = wiper_in.rain_intensity > wiper_cfg.threshold ? WIPER_FAST : WIPER_SLOW;
}
void wiper_deinit(void) {}
