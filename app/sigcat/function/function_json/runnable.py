"""A call of the function: when it runs, how it is supervised, what it reads and writes."""

import re
from typing import Any

from pydantic import field_serializer, model_validator

from sigcat.function.document.field_types import CIdentifier, Name, Quantity, VssPath, Words
from sigcat.function.document.text import Text
from sigcat.function.function_json.code import Checkpoint
from sigcat.function.function_json.duration import exact_time
from sigcat.function.function_json.error_fields import SetErrorName
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, SafetyReaction
from sigcat.function.function_json.wire import (
    Integer,
    Listed,
    Number,
    WireModel,
    WrittenWhole,
    described,
    optional,
    own,
    tabled,
)


class WatchdogLimits(WireModel):
    """Limits of the alive supervision (in cycles) or the deadline supervision (in ms)."""

    min: Number = described("Min", "Fewest indications, or shortest duration.", unit="cycles or ms")
    max: Number = described("Max", "Most indications, or longest duration.", unit="cycles or ms")
    reference: Number = described("Ref", "Cycles in which indications are counted; 0 for a deadline.", unit="cycles")
    error_name: Name = described("ErrorName", "Error interface that is set when a limit is broken.")
    description: Text | None = tabled("Description", "Explanation, if needed.")


class Watchdog(WireModel):
    """Supervision of a call by the watchdog."""

    alive: WatchdogLimits | None = described("AliveSupervision", "Limits in cycles.")
    deadline: WatchdogLimits | None = described("DeadlineSupervision", "Limits in ms.")
    logical: Text | None = described("LogicalSupervision", "Order relative to other calls, as text.")
    logical_error: Name | None = tabled("LogicalError", "Error interface that is set when the order is broken.")


class Contract(WireModel):
    """Interfaces that a call reads and writes."""

    type: Name | None = optional("Type", "How data is handed over: global variables or C calls.")
    signals: Listed[Signal] | None = described("SignalList", "Data interfaces.")
    queues: Listed[DataQueue] | None = described("DataQList", "Queued data interfaces.")
    methods: Listed[MethodInterface] | None = described("MethodList", "Methods.")
    parameters: Listed[ParameterInterface] | None = described("ParameterList", "Parameters.")
    errors: Listed[ErrorInterface] | None = described("ErrorList", "Error interfaces.")
    safety_reactions: Listed[SafetyReaction] | None = described("SafetyReactionList", "Safety reaction interfaces.")
    absent_signals: Listed[Signal] | None = own(
        "AbsentSignalList", "Optional data interfaces whose signals the vehicle does not have. They are not exchanged."
    )
    absent_queues: Listed[DataQueue] | None = own("AbsentDataQList", "The same for queued data interfaces.")


class Runnable(WireModel):
    """A call of the function: init, a step, terminate."""

    name: Name = described("Name", "Name of the call: <FunctionName>_Init, _Step or _Terminate.")
    description: Text = described("Description", "What the call does.")
    run_type: Name = described("Runtype", "Init, Cyclic, EventTriggered or Shutdown.")
    cycle_time: WrittenWhole | None = optional("Cycletime", "Time from one call to the next.", unit="ms")
    cycle_time_nanoseconds: Integer | None = own(
        "CycletimeNanoseconds",
        "The cycle time, where it is not whole milliseconds; `Cycletime` is absent then.",
        unit="ns",
    )
    stack_size: Quantity | None = optional(
        "StackSize", "Stack that the call needs, as a number in a text.", unit="bytes"
    )
    previous_runnable: Name | None = optional("PrevRunnable", "Call after which this one runs.")
    execution_offset: Quantity | None = optional(
        "ExecOffset", "Offset of the first call, as a number in a text.", unit="ms"
    )
    parallel_processing: bool | None = optional("ParallelProcessing", "Whether calls may run at the same time.")
    asil_level: Name | None = optional("AsilLevel", "ASIL that the call is implemented to.")
    watchdog: Watchdog | None = described("Watchdog", "Supervision; null if there is none.")
    scheduling: Name = described("Scheduling", "Preemptive or Non-Preemptive.")
    debounce_delay: Quantity | None = optional(
        "DebounceDelay", "Shortest time between two calls, as a number in a text.", unit="ms"
    )
    priority: Words = described("Priority", "Priority relative to other calls; a higher number runs first.")
    events: Name | None = optional(
        "EventList", "Events that trigger the call: names or paths of signals that it consumes, separated by commas."
    )
    contracts: Listed[Contract] | None = optional("funcContractList", "What the call reads and writes.")
    supervision_types: Listed[Name] | None = tabled(
        "SupervisionType", "Alive, Deadline, Logical; empty if unsupervised."
    )
    vss_path: VssPath | None = own("VssPath", "Path of the interface in the catalogue.")
    symbol: CIdentifier | None = own("Symbol", "Function or member function in C; the name of the call if absent.")
    arguments: Listed[CIdentifier] | None = own(
        "Arguments", "Names of the objects that it takes pointers to, in order."
    )
    success_value: Integer | None = own(
        "SuccessValue", "Result that means success; absent if the call returns nothing."
    )
    pre_processing: Listed[CIdentifier] | None = own(
        "PreProcessing", "C functions of the project that run before the call, in order."
    )
    post_processing: Listed[CIdentifier] | None = own(
        "PostProcessing", "C functions of the project that run after the call, in order."
    )
    checkpoint: Checkpoint | None = own("Checkpoint", "Place of the call in the graph of the logical supervision.")
    overrun_error: SetErrorName = own("OverrunError", "Error interface that is set when activations were missed.")

    @model_validator(mode="before")
    @classmethod
    def _exact(cls, data: Any) -> Any:
        return exact_time(data, "cycle_time", "Cycletime")

    @field_serializer("cycle_time")
    def _published(self, time: float | None) -> int | None:
        """The published schema has whole milliseconds only."""
        return int(time) if time is not None and time == int(time) else None

    @property
    def priority_number(self) -> int | None:
        """The number that the priority means; None for words."""
        return priority_number(self.priority)


_NUMBER = re.compile(r"\s*[+-]?[0-9]{1,18}\s*")


def priority_number(text: str) -> int | None:
    """Return the number that a priority means; None for words, and for no text."""
    return int(text) if _NUMBER.fullmatch(text) else None
