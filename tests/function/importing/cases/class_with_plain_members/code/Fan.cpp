#include "Fan.hpp"
void Fan::initialize() { state_ = 0; }
void Fan::step() { state_ += in.temp; out.flow = state_ * level; counter_++; }
