#include "Fan.h"
void Fan_Init(void) {  }
void Fan_Step(const Fan_In *in, Fan_Out *out) { out->flow = in->level * in->mode + in->gear; out->state = in->on; }
