#ifndef CHAIN_H
#define CHAIN_H

#include <stdint.h>

typedef struct {
    uint32_t speed;
    uint32_t count;
    uint32_t received;
    uint32_t doubled;
} chain_t;

void chain_step(chain_t *self);
void chain_follow_step(chain_t *self);

#endif /* CHAIN_H */
