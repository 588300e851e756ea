"""Small functions of C for times: of snapshots, of what is late, and sums that stay at the largest number."""

from sigcat.adapter.core.c.lines import Lines, lines


def now(prefix: str) -> Lines:
    """The time: one before the last one counts as the last one."""
    return lines(f"""
        /* The time: one before the last one counts as the last one. */
        static inline uint64_t {prefix}_Now({prefix} *self, uint64_t t)
        {{
            if (t > self->now) {{
                self->now = t;
            }}
            return self->now;
        }}
    """)


def earlier(prefix: str) -> Lines:
    """The earlier of two times."""
    return lines(f"""
        static uint64_t {prefix}_Earlier(uint64_t a, uint64_t b)
        {{
            return (a < b) ? a : b;
        }}
    """)


def later(prefix: str) -> Lines:
    """The later of two times."""
    return lines(f"""
        static uint64_t {prefix}_Later(uint64_t a, uint64_t b)
        {{
            return (a > b) ? a : b;
        }}
    """)


def added(prefix: str) -> Lines:
    """A sum that stays at the largest number."""
    return lines(f"""
        /* A sum that stays at the largest number. */
        static uint32_t {prefix}_Added(uint32_t sum, uint64_t more)
        {{
            return (more > ((uint64_t)UINT32_MAX - sum)) ? UINT32_MAX : (sum + (uint32_t)more);
        }}
    """)


def judge(prefix: str, macro: str) -> Lines:
    """Whether a value is late, judged in each snapshot. What is late stays so until enough new values have come."""
    return lines(f"""
        /* Whether a value is late, judged in each snapshot. What is late stays so until enough new values have come. */
        static void {prefix}_Judge({prefix}_Clock *own_clock, const {prefix}_Reception *reception, uint64_t entered,
            uint64_t time_out, uint32_t recovery, bool starts_with_first, uint64_t t)
        {{
            const bool is_there = reception->is_there;
            const uint64_t last = (is_there && (reception->time > entered)) ? reception->time : entered;

            if ((is_there || !starts_with_first) && ((t - last) > time_out)) {{
                own_clock->is_late = true;
                own_clock->count = reception->count;
            }} else if (own_clock->is_late && ((reception->count - own_clock->count) >= recovery)) {{
                own_clock->is_late = false;
            }} else {{
                /* as before */
            }}
            if (own_clock->is_late) {{
                own_clock->verdict = {macro}_PRESENT;
            }} else {{
                own_clock->verdict = is_there ? {macro}_ABSENT : {macro}_NOT_JUDGED;
            }}
        }}
    """)
