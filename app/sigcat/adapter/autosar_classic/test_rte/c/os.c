/* The operating system of the test RTE: events in the order of their tasks, one after the other. */
#include <stdlib.h>

#include "test_rte.h"

#define NEVER UINT64_MAX
#define NONE UINT32_MAX

static uint64 now;
static boolean *is_activated;
static uint64 *due; /* of each event */
static boolean *has_ended; /* of each component */
static uint32 *depth; /* of the exclusive area of each component */
static uint32 *calls; /* in the area around calls and methods, of each component */
static boolean *runs_again; /* each event of a component that waits: what it does meanwhile starts no call */
static uint32 running = NONE; /* the event that runs */
static boolean has_waited; /* whether the runnable that ended last took time */
static boolean *waits; /* each event: its runnable has begun, and takes time */

static void *zeros(size_t count, size_t size)
{
    void *made = calloc(count + 1U, size);
    if (made == NULL) {
        abort();
    }
    return made;
}

uint64 Os_Now(void)
{
    return now;
}

uint64 Os_NextTime(void)
{
    uint64 next = NEVER;
    for (uint32 i = 0U; i < TestRte_EventCount; i++) {
        if (due[i] < next) {
            next = due[i];
        }
    }
    return next;
}

void Os_Begin(uint64 t)
{
    now = t;
}

void Os_Start(void)
{
    is_activated = zeros(TestRte_EventCount, sizeof(*is_activated));
    due = zeros(TestRte_EventCount, sizeof(*due));
    has_ended = zeros(TestRte_ComponentCount, sizeof(*has_ended));
    depth = zeros(TestRte_ComponentCount, sizeof(*depth));
    calls = zeros(TestRte_ComponentCount, sizeof(*calls));
    runs_again = zeros(TestRte_EventCount, sizeof(*runs_again));
    waits = zeros(TestRte_EventCount, sizeof(*waits));
    for (uint32 i = 0U; i < TestRte_EventCount; i++) {
        due[i] = NEVER;
        is_activated[i] = TestRte_Events[i].is_init;
    }
}

void Os_StartTiming(void)
{
    Os_Run(); /* what init events in tasks have activated, before time begins */
    for (uint32 i = 0U; i < TestRte_EventCount; i++) {
        if (TestRte_Events[i].period > 0U) {
            due[i] = now + TestRte_Events[i].offset;
        }
    }
}

void Os_SetTime(uint64 t)
{
    now = t;
    for (uint32 i = 0U; i < TestRte_EventCount; i++) {
        while (due[i] <= now) { /* one that is late runs once */
            is_activated[i] = TRUE;
            due[i] += TestRte_Events[i].period;
        }
    }
}

void Os_Activate(uint32 event)
{
    is_activated[event] = TRUE;
}

/* A runnable never runs twice at a time, whichever of its events comes. */
static boolean is_held(uint32 event)
{
    for (uint32 i = 0U; i < TestRte_EventCount; i++) {
        if (waits[i] != FALSE && TestRte_Events[i].run == TestRte_Events[event].run) {
            return TRUE;
        }
    }
    return FALSE;
}

static boolean is_waiting(uint32 component)
{
    for (uint32 i = 0U; i < TestRte_EventCount; i++) {
        if (waits[i] != FALSE && TestRte_Events[i].component == component) {
            return TRUE;
        }
    }
    return FALSE;
}

static void run(uint32 event)
{
    const TestRte_Event *const one = &TestRte_Events[event];
    const uint32 before = running;
    if (has_ended[one->component] == FALSE) {
        runs_again[event] = is_waiting(one->component);
        running = event;
        one->run();
        running = before;
    }
}

/* A component whose runnable took time lets all others run that are due, before it runs again. */
static void run_first(uint32 count)
{
    uint32 last = NONE;
    uint32 i = 0U;
    while (i < count || last != NONE) {
        if (i == count) {
            last = NONE;
            i = 0U;
        } else if (TestRte_Events[i].component == last || is_activated[i] == FALSE || is_held(i) != FALSE) {
            i++;
        } else {
            is_activated[i] = FALSE;
            has_waited = FALSE;
            run(i);
            last = (has_waited != FALSE) ? TestRte_Events[i].component : last;
            i = 0U; /* activated runnables may run before the next one */
        }
    }
}

void Os_Run(void)
{
    run_first(TestRte_EventCount);
}

void Os_RunBefore(void)
{
    run_first(running);
}

void Os_Wait(void (*wait)(uint64 until), uint64 until)
{
    const uint32 event = running;
    waits[event] = TRUE;
    Os_Run(); /* what is due already, too */
    wait(until);
    running = event;
    Os_RunBefore();
    waits[event] = FALSE;
    has_waited = TRUE;
    for (uint32 i = 0U; i < TestRte_EventCount; i++) {
        if (TestRte_Events[i].component == TestRte_Events[event].component && runs_again[i] != FALSE) {
            runs_again[i] = FALSE;
            is_activated[i] = TRUE;
        }
    }
}

const TestRte_Event *Os_Running(void)
{
    return (running < TestRte_EventCount) ? &TestRte_Events[running] : NULL;
}

void Os_EndComponent(uint32 component)
{
    has_ended[component] = TRUE;
}

boolean Os_HasEnded(uint32 component)
{
    return has_ended[component];
}

static void enter(uint32 *areas, uint32 component, boolean may_nest)
{
    areas[component]++;
    if (areas[component] != 1U && may_nest == FALSE) {
        (void)fprintf(stderr, "%s enters its exclusive area twice.\n", TestRte_Components[component]);
        abort();
    }
}

static void leave(uint32 *areas, uint32 component)
{
    if (areas[component] == 0U) {
        (void)fprintf(stderr, "%s leaves an exclusive area that it is not in.\n", TestRte_Components[component]);
        abort();
    }
    areas[component]--;
}

void Os_EnterArea(uint32 component)
{
    enter(depth, component, FALSE);
}

void Os_ExitArea(uint32 component)
{
    leave(depth, component);
}

/* A call that takes time has done its work before it waits: a method may be served meanwhile. */
void Os_EnterCalls(uint32 component)
{
    enter(calls, component, is_waiting(component));
}

void Os_ExitCalls(uint32 component)
{
    leave(calls, component);
}
