/* What is different where times are ticks of 32 bits: they wrap around. Included by cases.c. */

#if SIGCAT_TICK_NS == 1000
#define AT Sigcat_Microseconds
#else
#define AT Sigcat_Milliseconds
#endif

static int time_never_goes_back(void)
{
    uint32_t now = 0U;
    bool has_time = false;

    HOLDS(!Sigcat_Advance(&now, &has_time, AT(0xFFFFFFF0U)));
    HOLDS(now == 0xFFFFFFF0U && has_time); /* any may be the first one */
    HOLDS(!Sigcat_Advance(&now, &has_time, AT(0xFFFFFFE0U)) && now == 0xFFFFFFF0U);
    HOLDS(!Sigcat_Advance(&now, &has_time, AT(0xFFFFFFF1U)) && now == 0xFFFFFFF1U);
    HOLDS(Sigcat_Advance(&now, &has_time, AT(2U)) && now == 2U);
    HOLDS(!Sigcat_Advance(&now, &has_time, AT(0xFFFFFFFFU)) && now == 2U);
    HOLDS(!Sigcat_Advance(&now, &has_time, AT(SIGCAT_KEPT - 1U)) && now == (SIGCAT_KEPT - 1U));
    HOLDS(Sigcat_Advance(&now, &has_time, AT(SIGCAT_KEPT)) && now == SIGCAT_KEPT);
    HOLDS(Sigcat_Advance(&now, &has_time, AT(SIGCAT_KEPT + 0x7FFFFFFFU)));
    HOLDS(!Sigcat_Advance(&now, &has_time, AT(SIGCAT_KEPT - 1U)) && now == 0x9FFFFFFFU);
    return 0;
}

static int a_time_is_reached_across_the_wrap(void)
{
    HOLDS(Sigcat_IsReached(0xFFFFFFFFU, 0U) && !Sigcat_IsReached(0U, 0xFFFFFFFFU));
    HOLDS(Sigcat_IsReached(1U, 0x80000000U) && !Sigcat_IsReached(0U, 0x80000000U));
    HOLDS(Sigcat_Newer(0xFFFFFFFFU, 1U, 3U) == 1U && Sigcat_Newer(1U, 0xFFFFFFFFU, 3U) == 1U);
    HOLDS(Sigcat_Until(3U, 0xFFFFFFFEU) == 5U && Sigcat_Until(0xFFFFFFFEU, 3U) == 0U && Sigcat_Until(7U, 7U) == 0U);
    return 0;
}

static int what_is_over_stays_over(void)
{
    uint32_t time = 100U;

    Sigcat_KeepNear(&time, 100U + SIGCAT_KEPT);
    HOLDS(time == 100U);
    Sigcat_KeepNear(&time, 101U + SIGCAT_KEPT);
    HOLDS(time == 101U);
    Sigcat_KeepNear(&time, 50U); /* nearly the whole range later */
    HOLDS(time == (50U - SIGCAT_KEPT));
    return 0;
}

static int releases_that_are_long_over_are_counted_once(void)
{
    uint32_t release = 0xFFFFFF00U;
    uint32_t skipped = 0U;
    uint32_t missed = 5U;

    Sigcat_CatchUp(&release, &skipped, 0x10000000U, 0xFFFFFEFFU); /* it is to come */
    HOLDS(release == 0xFFFFFF00U && skipped == 0U);
    Sigcat_CatchUp(&release, &skipped, 0x1000U, SIGCAT_KEPT - 0x100U); /* as long as it may stay */
    HOLDS(release == 0xFFFFFF00U && skipped == 0U);
    Sigcat_CatchUp(&release, &skipped, 0x1000U, SIGCAT_KEPT - 0xFFU);
    HOLDS(release == (0xFFFFFF00U + (0x1FFFFU * 0x1000U)) && skipped == 0x1FFFFU);
    HOLDS(Sigcat_Release(&release, 0x1000U, SIGCAT_KEPT - 0xFFU) == 2U); /* overrun */
    HOLDS(release == (0xFFFFFF00U + (0x20001U * 0x1000U)));
    Sigcat_CountSkipped(&missed, &skipped);
    HOLDS(missed == 0x20004U && skipped == 0U);
    missed = UINT32_MAX - 2U;
    skipped = 2U;
    Sigcat_CountSkipped(&missed, &skipped);
    HOLDS(missed == UINT32_MAX && skipped == 0U);
    skipped = 1U;
    Sigcat_CountSkipped(&missed, &skipped);
    HOLDS(missed == UINT32_MAX && skipped == 0U);
    return 0;
}

static int the_grid_and_windows_go_on(void)
{
    Sigcat_Alive alive;
    uint32_t release = 0xFFFFFFF0U;
    uint32_t dropped = 0U;

    HOLDS(Sigcat_Release(&release, 0x10U, 0xFFFFFFF0U) == 1U && release == 0U);
    Sigcat_DropUpTo(&release, &dropped, 0x10U, 0xFFFFFFFFU);
    Sigcat_DropBefore(&release, &dropped, 0x10U, 0U);
    HOLDS(release == 0U && dropped == 0U);
    Sigcat_DropUpTo(&release, &dropped, 0x10U, 0U);
    HOLDS(release == 0x10U && dropped == 1U);
    Sigcat_EnterAlive(&alive, 0xFFFFFFF0U);
    Sigcat_CloseWindow(&alive, 0x20U, 0U, 1U, 0xFU);
    HOLDS(!alive.has_closed);
    Sigcat_CloseWindow(&alive, 0x20U, 0U, 1U, 0x10U);
    HOLDS(alive.has_closed && !alive.is_bad && alive.window == 0x10U);
    return 0;
}

static int windows_that_began_long_ago_are_kept_near(void)
{
    Sigcat_Ticks window = 10U;

    Sigcat_CountsInTicks();
    Sigcat_KeepWindowNear(&window, 0x100U, 5U); /* it is to come */
    HOLDS(window == 10U);
    window = 0U;
    Sigcat_KeepWindowNear(&window, 0x100U, SIGCAT_KEPT);
    HOLDS(window == 0U);
    Sigcat_KeepWindowNear(&window, 0x100U, SIGCAT_KEPT + 1U);
    HOLDS(window == (SIGCAT_KEPT - 0x200U));
    window = 0U;
    Sigcat_KeepWindowNear(&window, 0x0FFFFFFFU, SIGCAT_KEPT + 1U); /* more than one of the longest stay */
    HOLDS(window == 0U);
    Sigcat_KeepWindowNear(&window, 0x0FFFFFFFU, SIGCAT_KEPT + 0x10000000U);
    HOLDS(window == 0x0FFFFFFFU);
    return 0;
}

static int a_time_out_goes_on(void)
{
    Sigcat_Clock clock = { SIGCAT_NOT_JUDGED, 0U, false };
    Sigcat_Reception reception = { 0xFFFFFFF0U, 1U, true };

    Sigcat_CheckClock(&clock, &reception, 0xFFFFFF00U, 0x20U, 1U, false, 0x10U);
    HOLDS(!clock.is_late);
    Sigcat_CheckClock(&clock, &reception, 0xFFFFFF00U, 0x20U, 1U, false, 0x11U);
    HOLDS(clock.is_late);
    clock.is_late = false;
    Sigcat_CheckClock(&clock, &reception, 5U, 0x20U, 1U, false, 0x11U); /* its call runs again */
    HOLDS(!clock.is_late);
    return 0;
}

static int time_wraps_around(void)
{
    return a_time_is_reached_across_the_wrap()
        || what_is_over_stays_over()
        || releases_that_are_long_over_are_counted_once()
        || the_grid_and_windows_go_on()
        || windows_that_began_long_ago_are_kept_near()
        || a_time_out_goes_on();
}
