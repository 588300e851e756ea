"""Calls of nodes that read or write each signal."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat.asil import Level, level_of
from sigcat.function.exchange import Part
from sigcat.function.function_json.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.duration import milliseconds
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.role import PROVIDER
from sigcat.function.function_json.runnable import Contract, Runnable
from sigcat.integration.finding_collector import FindingCollector, Subject
from sigcat.integration.ros2.names import package_name, report_renamed

Kind = str
INIT, CYCLIC, SHUTDOWN, EVENT = "init", "cyclic", "shutdown", "event"


class SignalUse(NamedTuple):
    """One call reads or writes one signal."""

    part: Part
    runnable: Runnable
    data: Signal | DataQueue
    path: str
    """Path in the catalogue; empty if the signal names none."""

    @property
    def is_provider(self) -> bool:
        """Whether the call writes the signal."""
        return self.data.role == PROVIDER

    @property
    def key(self) -> str:
        """Identity of the signal in the set: its path, or its name in the function."""
        return self.path or f"{self.part.function_name}.{self.data.name}"

    @property
    def interface(self) -> Subject:
        """The signal, as findings call it."""
        return Subject(self.key, self.data)

    @property
    def queue_length(self) -> int | None:
        """Values to queue, if it is a queue."""
        return self.data.queue_length if isinstance(self.data, DataQueue) else None

    @property
    def is_sent_in_each_cycle(self) -> bool:
        """Whether the call provides a value whenever it runs: of a queue with a count it may provide none."""
        return bool(self.cycle) and not (isinstance(self.data, DataQueue) and self.data.count_variable)

    @property
    def timeout(self) -> float | None:
        """Longest time between two values, in ms."""
        return whole(milliseconds(self.data.timeout)) or None

    @property
    def asil(self) -> Level:
        """ASIL of the signal, or else of the call."""
        return asil_of(self.data.asil_level or self.runnable.asil_level)

    @property
    def cycle(self) -> float | None:
        """Cycle of the call, in ms, if it has one."""
        return self.runnable.cycle_time if run_kind(self.runnable) == CYCLIC else None


def node_parts(functions: Sequence[FunctionJson], findings: FindingCollector) -> tuple[Part, ...]:
    """Every component under the name of the node that it becomes. Two components of one name bear their function's name too."""
    names = [component.name for function in functions for component in function.components]
    made: list[Part] = []
    taken: set[str] = set()
    for function in functions:
        for index, component in enumerate(function.components):
            is_shared = names.count(component.name) > 1 and component.name != function.info.function_name
            source = f"{function.info.function_name}_{component.name}" if is_shared else component.name
            name = package_name(source, taken)
            report_renamed(name, component.name, Subject(component.name, component), findings)
            taken.add(name.text)
            made.append(Part(name.text, function, index))
    return tuple(made)


def signal_uses(parts: Sequence[Part], paths: Mapping[str, str]) -> tuple[SignalUse, ...]:
    """Every use of every signal and queue. `paths` are those of signals that name none, by `Function.Signal`."""
    return tuple(use for part in parts for use in _uses(part, paths))


def _uses(part: Part, paths: Mapping[str, str]) -> Iterator[SignalUse]:
    for runnable in part.component.runnables:
        for contract in runnable.contracts or ():
            for data in data_of(contract):
                yield SignalUse(
                    part, runnable, data, data.vss_path or paths.get(f"{part.function_name}.{data.name}", "")
                )


def data_of(contract: Contract) -> tuple[Signal | DataQueue, ...]:
    """Signals and queues."""
    return (*(contract.signals or ()), *(contract.queues or ()))


def run_kind(runnable: Runnable) -> Kind:
    """When a call runs, however the document spells it: `Terminate` and `Shutdown`, `event based`."""
    text = runnable.run_type.strip().lower()
    for start, kind in (("init", INIT), ("cyc", CYCLIC), ("shut", SHUTDOWN), ("term", SHUTDOWN)):
        if text.startswith(start):
            return kind
    return EVENT


def asil_of(text: str | None) -> Level:
    """The level that a document states; QM where it states none that can be read (F090, F091)."""
    return level_of(text) or "QM"


def whole(number: float | None) -> float | None:
    """A number that is whole as an integer, so that it is written as one."""
    return int(number) if number is not None and number == int(number) else number
