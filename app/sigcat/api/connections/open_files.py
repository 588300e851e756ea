"""Number of connections that the system lets a process have: each is an open file."""

import sys

_OTHER_FILES = 200
"""Files, pipes and processes of the service itself."""


def connections_allowed(wanted: int) -> int:
    """As many as requested, or what the limit of open files leaves. Raises that limit as far as it may."""
    if sys.platform == "win32":
        return wanted
    import resource

    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    needed = wanted + _OTHER_FILES
    if soft == resource.RLIM_INFINITY or soft >= needed:
        return wanted
    most = needed if hard == resource.RLIM_INFINITY else min(needed, hard)
    try:
        resource.setrlimit(resource.RLIMIT_NOFILE, (most, hard))
    except (OSError, ValueError):  # some systems allow less than they say
        most = soft
    return min(wanted, max(most - _OTHER_FILES, most // 2))
