"""Modes: which one the function is in, and which calls it excludes (section 8)."""

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class ModeIn:
    """The mode that the function receives."""

    name: str
    numbers: Mapping[int, str]
    """Names by what is received."""
    codes: Mapping[str, int]
    """Numbers of the modes in the code."""
    initial: str
    variable: str | None = None
    goes_to_initial: bool = False
    """Mode after an unknown one; otherwise the mode stays."""
    unknown_error: str | None = None


@dataclass(frozen=True)
class ModeOut:
    """The mode that the function reports."""

    name: str
    numbers: Mapping[int, int]
    """Sent values, by the numbers in the code."""
    variable: str


@dataclass
class Mode:
    """The mode while the adapter runs."""

    declared: ModeIn | None
    current: str | None = None
    received: int | None = None
    is_unknown: bool | None = None

    def __post_init__(self) -> None:
        self.current = self.declared.initial if self.declared else None

    def take(self) -> None:
        """Go to what was received last."""
        if self.declared is None or self.received is None:
            return
        name = self.declared.numbers.get(self.received)
        self.is_unknown = name is None
        if name is not None:
            self.current = name
        elif self.declared.goes_to_initial:
            self.current = self.declared.initial
