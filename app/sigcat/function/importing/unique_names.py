"""Names of values in a function: the last name in the code, with those before it where two are alike."""

import re
from collections import Counter
from collections.abc import Iterator, Sequence

from sigcat.function.c_project.code_values import Value


def unique_names(values: Sequence[Value]) -> Iterator[str]:
    """The shortest name of each value that no other one has: `speed`, or `ego_speed` of `rtU.ego.speed`."""
    endings = [tuple(_endings(value.expression)) for value in values]
    counted = Counter(ending.lower() for each in endings for ending in each)
    for number, each in enumerate(endings):
        yield next((ending for ending in each if counted[ending.lower()] == 1), f"{each[-1]}_{number}")


def _endings(expression: str) -> Iterator[str]:
    """Names, the shortest first; an index alone is none."""
    parts = [part for part in re.split(r"[^A-Za-z0-9_]+", expression) if part]
    for size in range(1, len(parts) + 1):
        if not parts[-size].isdigit():
            yield "_".join(parts[-size:])
