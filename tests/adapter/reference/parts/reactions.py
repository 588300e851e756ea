"""Safety reactions: whether the function has to react (section 7)."""

from dataclasses import dataclass, field

from tests.adapter.reference.parts.time_out import Clock, TimeOut


@dataclass(frozen=True)
class Reaction:
    """A safety reaction."""

    name: str
    errors: tuple[str, ...] = ()
    inactive: int = 0
    active: int = 1
    is_initially_active: bool = False
    variable: str | None = None
    time_out: TimeOut | None = None
    calls: tuple[str, ...] = ()


@dataclass
class ReactionState:
    """A safety reaction while the adapter runs."""

    reaction: Reaction
    is_active: bool = False
    outside: bool | None = None
    """Last value from outside."""
    clocks: dict[str, Clock] = field(default_factory=dict)
    """By call."""

    def __post_init__(self) -> None:
        self.is_active = self.reaction.is_initially_active
        if self.reaction.time_out:
            self.clocks = {call: Clock(self.reaction.time_out) for call in self.reaction.calls}

    def receive(self, number: int, t: int) -> None:
        """The outside says something."""
        for clock in self.clocks.values():
            clock.receive(t)
        if number in (self.reaction.inactive, self.reaction.active):
            self.outside = number == self.reaction.active

    def evaluate(self, call: str, t: int, *, has_failed: bool) -> None:
        """Decide, at the snapshot of a call; `has_failed`: whether one of its errors has."""
        is_late = False
        if call in self.clocks:
            self.clocks[call].evaluate(t)
            is_late = self.clocks[call].is_expired
        is_unsaid = self.outside is None and not self.reaction.errors
        is_default = is_unsaid and self.reaction.is_initially_active
        self.is_active = has_failed or bool(self.outside) or is_late or is_default
