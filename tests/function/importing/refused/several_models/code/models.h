#pragma once
void a_init(void);
void a_step(void);
void b_init(void);
void b_step(void);
void c_step(void);
