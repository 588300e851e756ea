/* Random arguments of the functions of an FMU, from `seed`. */

#include <stdint.h>

static uint64_t seed;

static uint32_t any(uint32_t below)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (uint32_t)(seed >> 11) % below;
}

static double any_number(void)
{
    static const double edges[] = {0.0, -0.0, 1e308, -1e308, 0.01, -0.01, 9e6, 1e-12};
    const uint32_t which = any(16U);
    const double zero = 0.0;
    if (which == 0U) {
        return zero / zero;
    }
    return (which <= 8U) ? edges[which - 1U] : (double)any(1000U) / 10.0;
}
