#pragma once
double clamp(double value, double low, double high);
static void hidden_step(void);
void footstep(void);
