"""Names under which signals and parameters are known outside the function: each is unique."""

from collections.abc import Container


def unique(name: str, taken: Container[str]) -> str:
    """Return the name, or the name with the first number that makes it unique."""
    number = 1
    numbered = name
    while numbered in taken:
        number += 1
        numbered = f"{name}_{number}"
    return numbered
