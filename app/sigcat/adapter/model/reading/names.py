"""Names under which signals and parameters are known outside of the function: each is one of its own."""

from collections.abc import Container


def unique(name: str, taken: Container[str]) -> str:
    """The name, or with the first number behind it that makes it one of its own."""
    number = 1
    numbered = name
    while numbered in taken:
        number += 1
        numbered = f"{name}_{number}"
    return numbered
