#include <stdint.h>

typedef struct { float X; double Y; } point_t;
typedef struct { uint8_t Kind; uint16_t Speed; point_t Position; } object_t;

extern object_t ahead_in, nearest;
extern point_t around_in[2], seen[2];
extern uint8_t lanes_in[2], lanes[2];
extern uint16_t last[2];
extern uint32_t last_count;

void objects_init(void);
void objects_step(void);
void objects_terminate(void);
