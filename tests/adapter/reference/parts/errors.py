"""States of an error (section 6): what it becomes, and what is sent of it."""

from enum import Enum
from typing import NamedTuple

_MOST = 65535


class Stage(Enum):
    """The state of an error."""

    NOT_TESTED = "NOT_TESTED"
    PASSED = "PASSED"
    PREFAILED = "PREFAILED"
    FAILED = "FAILED"
    HEALING = "HEALING"


class Error(NamedTuple):
    """An error of the function, as it is declared."""

    name: str
    maturation: int = 0
    """In ns, as are all times."""
    reset: int = 0
    waits_for_restart: bool = False
    reset_input: str | None = None
    """Name or path of the input that has to be not 0."""
    dependencies: tuple[str, ...] = ()
    occurrence_limit: int = 0
    ignition_limit: int = 0
    variable: str | None = None
    status_variable: str | None = None
    passed: int = 0
    failed: int = 1


class Evaluation(NamedTuple):
    """Inputs of the evaluation of an error."""

    is_present: bool
    may_heal: bool
    """Whether its reset condition holds, if it is absent."""
    t: int


class ErrorState(NamedTuple):
    """State of an error."""

    stage: Stage = Stage.NOT_TESTED
    since: int = 0
    """When it entered PREFAILED or HEALING."""
    before: Stage = Stage.NOT_TESTED
    """State before PREFAILED."""

    @property
    def is_failed(self) -> bool:
        """Whether others that depend on it fail too."""
        return self.stage in (Stage.FAILED, Stage.HEALING)

    @property
    def is_tested(self) -> bool:
        """Whether it has been tested."""
        return self.stage is not Stage.NOT_TESTED


class Counts(NamedTuple):
    """Stored values of an error."""

    occurrences: int = 0
    ignitions: int = 0
    has_failed: bool = False
    """In this ignition cycle."""
    was_tested: bool = False
    """In this ignition cycle."""


def evaluated(state: ErrorState, error: Error, evaluation: Evaluation) -> ErrorState:
    """Return the next state."""
    step = _when_present if evaluation.is_present else _when_absent
    after = step(state, error, evaluation)
    return after if after.stage is state.stage else evaluated(after, error, evaluation)


def _when_present(state: ErrorState, error: Error, evaluation: Evaluation) -> ErrorState:
    if state.stage in (Stage.NOT_TESTED, Stage.PASSED):
        return ErrorState(Stage.PREFAILED, evaluation.t, state.stage)
    if state.stage is Stage.PREFAILED and evaluation.t - state.since < error.maturation:
        return state
    return ErrorState(Stage.FAILED)


def _when_absent(state: ErrorState, error: Error, evaluation: Evaluation) -> ErrorState:
    if not state.is_failed:
        return ErrorState(Stage.PASSED)
    if not evaluation.may_heal:
        return ErrorState(Stage.FAILED)
    if state.stage is Stage.FAILED:
        return ErrorState(Stage.HEALING, evaluation.t)
    return state if evaluation.t - state.since < error.reset else ErrorState(Stage.PASSED)


def excluded(state: ErrorState) -> ErrorState:
    """Return the next state when the mode excludes its call."""
    if state.stage is Stage.PREFAILED:
        return ErrorState(state.before)
    return ErrorState(Stage.FAILED) if state.stage is Stage.HEALING else state


def sent(state: ErrorState, error: Error) -> int | None:
    """Return the value to send from now on; None if it stays."""
    if state.is_failed:
        return error.failed
    return error.passed if state.stage is Stage.PASSED else None


# -- counting -----------------------------------------------------------------------------------------------------


def counted(counts: Counts, before: ErrorState, after: ErrorState) -> Counts:
    """Counts after an evaluation."""
    is_new = after.is_failed and not before.is_failed
    return Counts(
        min(counts.occurrences + is_new, _MOST),
        counts.ignitions,
        counts.has_failed or after.is_failed,
        counts.was_tested or after.is_tested,
    )


def in_new_cycle(counts: Counts) -> Counts:
    """Counts when an ignition cycle begins."""
    if counts.has_failed:
        return Counts(counts.occurrences, min(counts.ignitions + 1, _MOST))
    return Counts(counts.occurrences, 0 if counts.was_tested else counts.ignitions)


def is_confirmed(counts: Counts, error: Error) -> bool:
    """Whether the error has failed as often, and in as many ignition cycles, as it takes."""
    is_often = counts.occurrences >= error.occurrence_limit and counts.ignitions >= error.ignition_limit
    return counts.occurrences > 0 and is_often
