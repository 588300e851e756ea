"""Small functions of C for verdicts and the states of errors."""

from sigcat.adapter.core.c.lines import Lines, lines


def worse(prefix: str) -> Lines:
    """The worse of two verdicts: present, absent, not judged."""
    return lines(f"""
        /* The worse of two verdicts: present, absent, not judged. */
        static {prefix}_Verdict {prefix}_Worse({prefix}_Verdict a, {prefix}_Verdict b)
        {{
            return (a > b) ? a : b;
        }}
    """)


def has_failed(prefix: str, macro: str) -> Lines:
    """Whether an error is reported as failed."""
    return lines(f"""
        /* Whether an error is reported as failed. */
        static bool {prefix}_HasFailed(const {prefix}_Error *error)
        {{
            return (error->state == {macro}_FAILED) || (error->state == {macro}_HEALING);
        }}
    """)


def suspend(prefix: str, macro: str) -> Lines:
    """What was under way ends."""
    return lines(f"""
        /* What was under way ends. */
        static void {prefix}_Suspend({prefix}_Error *error)
        {{
            if (error->state == {macro}_PREFAILED) {{
                error->state = error->before;
            }} else if (error->state == {macro}_HEALING) {{
                error->state = {macro}_FAILED;
            }} else {{
                /* as it is */
            }}
        }}
    """)
