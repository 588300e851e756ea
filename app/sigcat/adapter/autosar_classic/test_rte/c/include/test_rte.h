/*
 * What the test RTE is made of. Tables are generated from the integration, everything else is the same for all.
 * One core: a runnable runs to its end, unless it says that it takes time. Time is what main gives.
 */
#ifndef TEST_RTE_H
#define TEST_RTE_H

#include <stddef.h>
#include <stdio.h>

#include "Std_Types.h"

/* -- tables, generated ------------------------------------------------------------------------------------------- */

/* An event that is mapped to a task, in the order in which they run: tasks by priority, events by position. */
typedef struct {
    const char *task;
    const char *name;
    uint32 component;
    void (*run)(void);
    uint64 period; /* ns; 0: it is not a timing event */
    uint64 offset;
    boolean is_init;
} TestRte_Event;

typedef enum {
    TEST_RTE_BOOLEAN, TEST_RTE_UINT8, TEST_RTE_SINT8, TEST_RTE_UINT16, TEST_RTE_SINT16, TEST_RTE_UINT32,
    TEST_RTE_SINT32, TEST_RTE_UINT64, TEST_RTE_SINT64, TEST_RTE_FLOAT32, TEST_RTE_FLOAT64
} TestRte_Kind;

typedef struct {
    const char *name;
    sint64 number;
} TestRte_Symbol;

/* A number of a value, and the text before it. */
typedef struct {
    const char *before;
    TestRte_Kind kind;
    uint32 offset;
    const TestRte_Symbol *symbols; /* the last one has no name; NULL: none */
} TestRte_Number;

typedef struct {
    uint32 size;
    uint32 count;
    const TestRte_Number *numbers;
    const char *after;
} TestRte_Shape;

/* What comes from outside: a column of a normalized trace. */
typedef struct {
    const char *name;
    const TestRte_Shape *shape;
    void (*deliver)(const void *value);
    /* With a code of end-to-end protection, and NULL for no message. NULL: the port has no codes. */
    void (*deliver_checked)(const void *value, uint8 code);
} TestRte_Input;

/* A memory of a component. */
typedef struct {
    void *ram;
    uint32 size;
} TestRte_Memory;

typedef struct {
    const char *name;
    const TestRte_Memory *memory;
} TestRte_Block;

/* A function identifier, and the events whose failure takes its permission away. */
typedef struct {
    const char *name;
    const char *const *events; /* the last one is NULL */
} TestRte_Inhibition;

extern const TestRte_Event TestRte_Events[];
extern const uint32 TestRte_EventCount;
extern const char *const TestRte_Components[];
extern const char *const TestRte_Functions[];
extern const uint32 TestRte_ComponentCount;
extern const TestRte_Input TestRte_Inputs[];
extern const uint32 TestRte_InputCount;
extern const TestRte_Block TestRte_Blocks[];
extern const uint32 TestRte_BlockCount;
extern const TestRte_Inhibition TestRte_Inhibitions[];
extern const uint32 TestRte_InhibitionCount;
void TestRte_StartUp(void); /* what the state manager of the ECU calls, in its order; then it runs */
void TestRte_ShutDown(void); /* switches the mode of the ECU for all components */

/* -- operating system -------------------------------------------------------------------------------------------- */

uint64 Os_Now(void);
uint64 Os_NextTime(void); /* when a timing event is due next */
void Os_Begin(uint64 t); /* the time at which everything starts */
void Os_Start(void); /* init events that are mapped to a task are activated */
void Os_StartTiming(void); /* timing events count from now on */
void Os_SetTime(uint64 t); /* timing events that are due by then are activated */
void Os_Activate(uint32 event);
void Os_Run(void); /* until nothing is activated */
void Os_RunBefore(void); /* all that is before the runnable that runs */
void Os_Wait(void (*wait)(uint64 until), uint64 until); /* lets the runnable that runs wait, while others run */
void TestRte_PassTime(uint64 time); /* the runnable that runs takes so long */
const TestRte_Event *Os_Running(void); /* NULL: no runnable does */
void Os_EndComponent(uint32 component); /* nothing of it runs any more */
boolean Os_HasEnded(uint32 component);
void Os_EnterArea(uint32 component);
void Os_ExitArea(uint32 component);
void Os_EnterCalls(uint32 component); /* the area around calls and methods */
void Os_ExitCalls(uint32 component);

/* -- services, which record their calls -------- --------------------------------------------------------------------- */

void TestRte_OpenRecords(const char *sent, const char *told);
void TestRte_CloseRecords(void);
void TestRte_Sent(const char *name, const TestRte_Shape *shape, const void *value);
void TestRte_Told(const char *service, const char *name, const char *value);

Std_ReturnType TestRte_GetTime(uint64 *time);
Std_ReturnType TestRte_GetCycle(uint32 *cycle);
Std_ReturnType Dem_SetEventStatus(const char *event, uint8 status);
Std_ReturnType WdgM_CheckpointReached(const char *entity, const char *checkpoint);
Std_ReturnType NvM_GetErrorStatus(const char *block, uint8 *result);
Std_ReturnType NvM_SetRamBlockStatus(const char *block, boolean has_changed);
void NvM_ReadAll(const char *folder); /* NULL: nothing was stored */
void NvM_WriteAll(const char *folder);
void TestRte_SetCycle(uint32 cycle);

/* -- end-to-end protection, with codes from the trace ------------------------------------------------------------- */

#define TEST_RTE_HARD_ERROR 0x80U /* codes from here on: nothing is delivered */

Std_ReturnType TestRte_Checked(uint8 code, Std_TransformerError *error); /* status of a function that reads */

/* -- texts of values ----------------------------------------------------------------------------------------------- */

boolean TestRte_Read(const char *text, const TestRte_Shape *shape, void *value); /* its numbers, separated by ; */
void TestRte_Write(FILE *file, const TestRte_Shape *shape, const void *value);

/* -- the trace ----------------------------------------------------------------------------------------------------- */

#define TEST_RTE_REFUSED 2 /* status of a program that refuses what it was given */

void Trace_Open(const char *name); /* reads all of it once: an error in it ends the program */
uint64 Trace_Time(void); /* of the row that comes next; UINT64_MAX: there is none */
void Trace_DeliverUntil(uint64 t);
void Trace_Close(void);

#endif /* TEST_RTE_H */
