#pragma once
struct wiper_config {
    float threshold; /* Rain above which the wiper is fast. Unit: percent, min 0, max 100 */
    const unsigned int hysteresis;
};
