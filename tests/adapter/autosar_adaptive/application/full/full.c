/* The code of Full does nothing, but its initialization fails if FULL_FAILS is in the environment. */
#include "full.h"

#include <stdlib.h>

In g_in;
Out g_out;
Par g_par;
Met g_met;

int full_init(void) { return getenv("FULL_FAILS") != NULL; }
void full_step(void) { g_par.cnt++; }
void full_event(void) {}
void full_term(void) {}
void full_offered(void) { g_met.off_r = (float)g_met.off_a; }

/* Hooks of the project. */
struct Full_Adapter;
void project_pre(struct Full_Adapter *self);
void project_post(struct Full_Adapter *self);
void project_pre(struct Full_Adapter *self) { (void)self; }
void project_post(struct Full_Adapter *self) { (void)self; }
