#include "Locks.h"
boolean_T IsLocked;
void Locks_10ms(void) { IsLocked = (boolean_T)(Request > 1); }
void Locks_OnRequest(void) { IsLocked = (boolean_T)(Request != 0); }
void Locks_initialize(void) {}
