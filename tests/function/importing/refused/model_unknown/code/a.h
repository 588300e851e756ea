#pragma once
void a_init(void);
void a_step(void);
