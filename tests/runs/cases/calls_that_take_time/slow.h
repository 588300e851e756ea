extern float slow_speed;
extern float slow_out;
void slow_init(void);
void slow_step(void);
void slow_terminate(void);
