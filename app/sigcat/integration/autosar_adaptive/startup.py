"""Start of a component's process: its scheduling by that of its calls, unless the deployment states it."""

from collections.abc import Iterable, Sequence
from typing import Any, Literal, NamedTuple, Self

from pydantic import Field, SerializerFunctionWrapHandler, model_serializer, model_validator

from sigcat.function.declaration.form import DeclarationModel, Duration, Natural
from sigcat.function.document.field_types import CIdentifier
from sigcat.function.document.structure import unfit
from sigcat.function.document.text import Text
from sigcat.function.function_json.runnable import priority_number
from sigcat.function.function_json.wire import Integer

Policy = Literal["SCHED_FIFO", "SCHED_RR", "SCHED_OTHER"]
HIGHEST_PRIORITY = 99
"""Highest priority of SCHED_FIFO and SCHED_RR; their lowest is 1. SCHED_OTHER has 0 alone."""


class StartupSettings(DeclarationModel):
    """Start of a process."""

    policy: Policy | None = Field(
        None,
        description="Scheduling policy of POSIX; SCHED_FIFO, or SCHED_RR if the call of the highest priority has it.",
    )
    priority: Integer | None = Field(
        None,
        ge=0,
        le=HIGHEST_PRIORITY,
        description="Priority within the policy; the highest of the cyclic calls if absent.",
    )
    enter_timeout: Duration | None = Field(None, description="Longest time until the process runs, in ms.")
    exit_timeout: Duration | None = Field(None, description="Longest time until the process has ended, in ms.")
    arguments: list[Text] | None = Field(None, description="Arguments of the executable.")
    environment: dict[CIdentifier, Text] | None = Field(None, description="Environment variables of the process.")
    restart_attempts: Natural | None = Field(None, description="How often a process that fails is started again.")

    @model_serializer(mode="wrap")
    def _without_absent(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        return {key: value for key, value in handler(self).items() if value is not None}

    @model_validator(mode="after")
    def _fits_together(self) -> Self:
        if self.policy == "SCHED_OTHER" and self.priority:
            raise unfit(f"`priority` must be 0 for SCHED_OTHER, not {self.priority}.", "priority")
        if self.policy in ("SCHED_FIFO", "SCHED_RR") and self.priority == 0:
            raise unfit(f"`priority` must be from 1 to {HIGHEST_PRIORITY} for {self.policy}, not 0.", "priority")
        return self


NO_STARTUP = StartupSettings.model_validate({})
"""Everything by default."""


class Wish(NamedTuple):
    """Scheduling that a call states."""

    call: str
    scheduling: str | None
    priority: str | None

    @property
    def number(self) -> int:
        """Its priority; 0 if it has none, a negative one, or one that is not a number."""
        return max(priority_number(self.priority or "") or 0, 0)


def unwritable(wishes: Iterable[Wish]) -> list[Wish]:
    """Return wishes whose priority no policy has. A call without one has no wish."""
    return [wish for wish in wishes if wish.priority and not 1 <= wish.number <= HIGHEST_PRIORITY]


def startup(stated: StartupSettings, wishes: Sequence[Wish]) -> StartupSettings:
    """Return policy and priority of a process: those that are set, else those of its most urgent cyclic call.

    Fixed priorities use SCHED_FIFO, whether or not the call may be preempted by others of its executable.
    """
    most_urgent = max(wishes, key=lambda wish: wish.number, default=Wish("", None, None))
    wanted = min(most_urgent.number, HIGHEST_PRIORITY)
    priority = wanted if stated.priority is None else stated.priority
    policy = stated.policy or _policy(most_urgent, priority)
    if stated.priority is None:
        priority = 0 if policy == "SCHED_OTHER" else max(priority, 1)
    return stated.model_copy(update={"policy": policy, "priority": priority})


def _policy(most_urgent: Wish, priority: int) -> Policy:
    if not priority:
        return "SCHED_OTHER"
    return "SCHED_RR" if most_urgent.scheduling == "RR" else "SCHED_FIFO"
