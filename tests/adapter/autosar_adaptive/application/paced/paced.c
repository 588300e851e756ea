/* The slow step ends when the urgent one has run three times more. If that does not run, it gives up after some seconds. */

#include "paced.h"

#include <stdio.h>
#include <time.h>

float paced_speed;
float paced_slow_speed;
uint32_t paced_steps;
uint32_t paced_sum;
uint8_t paced_odd;
int32_t paced_asked;
int32_t paced_answer;
static uint32_t steps;
static int runs_alone;

void paced_step(void)
{
    paced_steps++;
    paced_odd = (uint8_t)((paced_steps / 100U) % 2U);
    if (__atomic_load_n(&runs_alone, __ATOMIC_RELAXED) != 0) {
        printf("not alone\n");
        (void)fflush(stdout);
    }
    (void)__atomic_add_fetch(&steps, 1U, __ATOMIC_RELAXED);
}

void paced_slow_step(void)
{
    static int count;
    const uint32_t before = __atomic_load_n(&steps, __ATOMIC_RELAXED);

    const time_t began = time(NULL);

    while ((__atomic_load_n(&steps, __ATOMIC_RELAXED) - before) < 3U) {
        if ((time(NULL) - began) > 5) {
            printf("blocked\n");
            (void)fflush(stdout);
            return;
        }
    }
    paced_sum += 3U;
    count++;
    printf("slow step %d\n", count);
    (void)fflush(stdout);
}

void paced_alone_step(void)
{
    __atomic_store_n(&runs_alone, 1, __ATOMIC_RELAXED);
    __atomic_store_n(&runs_alone, 0, __ATOMIC_RELAXED);
}

void paced_ask(void)
{
    paced_answer = paced_asked + (int32_t)paced_steps;
}
