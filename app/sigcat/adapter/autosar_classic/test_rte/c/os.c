/* The operating system of the test RTE: events in the order of their tasks, one after the other. */
#include <stdlib.h>

#include "test_rte.h"

#define NEVER UINT64_MAX

static uint64 now;
static boolean *is_activated;
static uint64 *due; /* of each event */
static boolean *has_ended; /* of each component */
static uint32 *depth; /* of the exclusive area of each component */

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

void Os_Run(void)
{
    uint32 i = 0U;
    while (i < TestRte_EventCount) {
        const TestRte_Event *const event = &TestRte_Events[i];
        i++;
        if (is_activated[i - 1U] != FALSE) {
            is_activated[i - 1U] = FALSE;
            i = 0U; /* what it activates may run before what comes next */
            if (has_ended[event->component] == FALSE) {
                event->run();
            }
        }
    }
}

void Os_EndComponent(uint32 component)
{
    has_ended[component] = TRUE;
}

boolean Os_HasEnded(uint32 component)
{
    return has_ended[component];
}

void Os_EnterArea(uint32 component)
{
    depth[component]++;
    if (depth[component] != 1U) {
        (void)fprintf(stderr, "%s enters its exclusive area twice.\n", TestRte_Components[component]);
        abort();
    }
}

void Os_ExitArea(uint32 component)
{
    depth[component]--;
    if (depth[component] != 0U) {
        (void)fprintf(stderr, "%s leaves an exclusive area that it is not in.\n", TestRte_Components[component]);
        abort();
    }
}
