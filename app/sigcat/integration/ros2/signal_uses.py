"""Calls of nodes, and the times and ASIL at which they read or write signals."""

from collections.abc import Sequence

from sigcat.asil import Level, level_of
from sigcat.function.exchange import Part, Side
from sigcat.function.function_json.duration import milliseconds, whole
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.runnable import Runnable
from sigcat.integration.finding_collector import FindingCollector, Subject
from sigcat.integration.ros2.names import package_name, report_renamed

INIT, CYCLIC, SHUTDOWN, EVENT = "init", "cyclic", "shutdown", "event"


def cycle_of(side: Side) -> float | None:
    """Return the cycle of the call of a side, in ms, if it has one."""
    return side.runnable.cycle_time if run_kind(side.runnable) == CYCLIC else None


def is_sent_in_each_cycle(side: Side) -> bool:
    """Whether the call provides a value whenever it runs: of a queue with a count it may provide none."""
    return bool(cycle_of(side)) and not getattr(side.interface, "count_variable", None)


def timeout_of(side: Side) -> float | None:
    """Return the longest time between two values, in ms."""
    return whole(milliseconds(side.data.timeout)) or None


def asil_of_side(side: Side) -> Level:
    """Return the ASIL of the signal, or else of the call."""
    return asil_of(side.data.asil_level or side.runnable.asil_level)


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


def run_kind(runnable: Runnable) -> str:
    """When a call runs, however the document spells it: `Terminate` and `Shutdown`, `event based`."""
    text = runnable.run_type.strip().lower()
    for start, kind in (("init", INIT), ("cyc", CYCLIC), ("shut", SHUTDOWN), ("term", SHUTDOWN)):
        if text.startswith(start):
            return kind
    return EVENT


def asil_of(text: str | None) -> Level:
    """The level that a document states; QM where it states none that can be read (F090, F091)."""
    return level_of(text) or "QM"
