/** Rain-dependent wiper control. */
#ifndef WIPER_H
#define WIPER_H

#include <stdbool.h>
#include <stdint.h>
#include "wiper_config.h"

#define NUMBER_OF_SENSORS (2 * 2)

typedef enum { WIPER_OFF, WIPER_SLOW, WIPER_FAST = 4 } wiper_mode_t;

struct wiper_inputs {
    /** Rain intensity. Unit: %  Range: 0..100 */
    float rain_intensity;

    /** Vehicle speed. Unit: km/h  Range: 0..250 */
    float vehicle_speed;

    uint16_t raw[NUMBER_OF_SENSORS]; /* Resolution: 0.25 */
    bool ignition_on : 1;
    void *user_data;
};

struct wiper_outputs {
    wiper_mode_t mode;  // wanted mode
};

extern struct wiper_inputs wiper_in;
extern struct wiper_outputs wiper_out;
extern struct wiper_config wiper_cfg;

int wiper_init(void);
void wiper_step_10ms(void);
void wiper_deinit(void);

#endif
