"""Errors and safety reactions while the adapter runs (sections 6 and 7)."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field

from tests.adapter.reference.causes import Cause, Verdict
from tests.adapter.reference.function import Function
from tests.adapter.reference.parts.errors import (
    Counts,
    Error,
    ErrorState,
    Evaluation,
    Stage,
    counted,
    evaluated,
    excluded,
    sent,
)
from tests.adapter.reference.parts.reactions import ReactionState


@dataclass
class Diagnosis:
    """State of errors, including those of others, and of safety reactions."""

    function: Function
    counts: dict[str, Counts]
    causes: Mapping[str, list[Cause]]
    is_reset: Callable[[Error], bool]
    """Whether the input that an error waits for is set."""
    states: dict[str, ErrorState] = field(default_factory=dict)
    sent: dict[str, int] = field(default_factory=dict)
    """Return the sent values of errors that have a verdict."""
    foreign: dict[str, bool] = field(default_factory=dict)
    """Whether errors of others have failed, as far as that was received."""
    read: dict[str, bool] = field(default_factory=dict)
    """Whether the variables of errors were set when they were read last."""
    reactions: dict[str, ReactionState] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.states = {error.name: ErrorState() for error in self.function.errors}
        self.reactions = {reaction.name: ReactionState(reaction) for reaction in self.function.reactions}

    # -- errors ---------------------------------------------------------------------------------------------------

    def of_call(self, call: str, *, late: bool) -> Iterable[Error]:
        """The errors that are evaluated when a call has ended (late), or before it."""
        for error in self._owned(call):
            if self._is_late(error, call) == late:
                yield error

    def supervised(self, calls: Iterable[str]) -> Iterable[Error]:
        """The errors of calls that time alone can change."""
        owned = {error.name for call in calls for error in self._owned(call)}
        for error in self.function.errors:
            if error.name in owned and any(cause.is_supervised for cause in self.causes.get(error.name, ())):
                yield error

    def _owned(self, call: str) -> Iterable[Error]:
        for error in self.function.errors:
            owner = self.function.owner(error.name)
            if owner is not None and owner.name == call:
                yield error

    def _is_late(self, error: Error, call: str) -> bool:
        causes = self.causes.get(error.name, ())
        return error.variable is not None or any(cause.is_late and cause.call == call for cause in causes)

    def evaluate(self, error: Error, t: int) -> None:
        """Evaluate an error."""
        before, verdicts = self.states[error.name], self._verdicts(error)
        if any(self._has_failed(name) for name in error.dependencies):
            after = ErrorState(Stage.FAILED)
        elif all(verdict is None for verdict in verdicts):
            after = before
        else:
            may_heal = not error.waits_for_restart and self.is_reset(error)
            after = evaluated(before, error, Evaluation(any(verdicts), may_heal, t))
        self.states[error.name] = after
        self.counts[error.name] = counted(self.counts.get(error.name, Counts()), before, after)
        now = sent(after, error)
        if now is not None:
            self.sent[error.name] = now

    def _verdicts(self, error: Error) -> list[Verdict]:
        verdicts = [cause.evaluate() for cause in self.causes.get(error.name, ())]
        verdicts.append(self.read.get(error.name))
        return verdicts + [False for name in error.dependencies if self._is_tested(name)]

    def _has_failed(self, name: str) -> bool:
        state = self.states.get(name)
        return self.foreign.get(name, False) if state is None else state.is_failed

    def _is_tested(self, name: str) -> bool:
        state = self.states.get(name)
        return name in self.foreign if state is None else state.is_tested

    def exclude(self, call: str) -> None:
        """The mode excludes a call."""
        for error in self._owned(call):
            self.states[error.name] = excluded(self.states[error.name])

    # -- safety reactions -----------------------------------------------------------------------------------------

    def react(self, state: ReactionState, call: str, t: int) -> None:
        """Decide a reaction at the snapshot of a call."""
        has_failed = any(self._has_failed(name) for name in state.reaction.errors)
        state.evaluate(call, t, has_failed=has_failed)

    def restart(self, call: str, t: int) -> None:
        """Restart the clocks of reactions for a call."""
        for state in self.reactions.values():
            if call in state.clocks:
                state.clocks[call].restart(t)
