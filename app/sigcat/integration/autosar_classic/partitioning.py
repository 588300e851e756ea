"""ASIL of a component's memory and runnables, by which an integrator partitions them (ISO 26262-6, annex D).

The core of a component is one object. Each runnable reads and writes it, so that each has the ASIL of that memory: the
highest one of the component's calls and their interfaces.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.asil import Level, is_above, level_of, rank
from sigcat.function.exchange import Part
from sigcat.function.function_json.walk import interface_lists
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.context import Context
from sigcat.integration.report import Entry


class _Cause(NamedTuple):
    level: Level
    name: str
    """Call or interface that has the level."""


def asil_of(part: Part) -> Level:
    """Highest ASIL of a component: of its calls and of the data that they exchange."""
    return _cause(part).level


def _cause(part: Part) -> _Cause:
    return max(_levels(part), key=lambda cause: rank(cause.level), default=_Cause("QM", "no call or interface"))


def _levels(part: Part) -> Iterator[_Cause]:
    for call in part.component.runnables:
        if level := level_of(call.asil_level):
            yield _Cause(level, call.name)
        for contract in call.contracts or ():
            for key, items in interface_lists(contract):
                for interface in items or () if key != "MethodList" else ():
                    if level := level_of(interface.asil_level):
                        yield _Cause(level, interface.name)


def report_lower_calls(part: Part, context: Context) -> None:
    """Report calls that are declared with a lower ASIL than the memory that their runnables write."""
    cause = _cause(part)
    for call in part.component.runnables:
        declared = level_of(call.asil_level)
        if is_above(cause.level, declared):
            message = f"{call.name} must have ASIL {cause.level}, not {declared}: its runnable writes the core, which holds {cause.name}."
            fix = f"Develop its code to ASIL {cause.level}, or move the call to a separate component."
            context.findings.report(codes.CALL_BELOW_ITS_MEMORY, message, call, fix, key="AsilLevel")


def partition_entries(part: Part, component: model.Component) -> tuple[Entry, ...]:
    """A row for each runnable: its code section, the memory that it writes, and why it has its ASIL."""
    cause = _cause(part)
    memory = ", ".join(each.name for each in component.sections if each.kind != "CODE")
    why = f"writes the core, whose ASIL is {cause.level}" + (f" for {cause.name}" if cause.level != "QM" else "")
    return tuple(_entry(part, runnable, memory, why) for runnable in component.runnables)


def _entry(part: Part, runnable: model.Runnable, memory: str, why: str) -> Entry:
    target = f"ASIL {runnable.asil_level}: code in {runnable.section}, memory in {memory}"
    return Entry(part.function_name, f"{part.name}/{runnable.name}", "runnable", "AsilLevel", target, why)


def sections(part: Part, runnables: Sequence[model.Runnable]) -> tuple[model.MemorySection, ...]:
    """The sections of a component: its code, and its variables."""
    level = asil_of(part)
    name = "VAR_CLEARED_UNSPECIFIED" if level == "QM" else f"VAR_CLEARED_ASIL_{level}_UNSPECIFIED"
    stack = max((each.stack_size or 0 for each in runnables), default=0) or None
    return (
        model.MemorySection(
            name=code_section(level), kind="CODE", asil_level=level, alignment="UNSPECIFIED", stack_size=stack
        ),
        model.MemorySection(name=name, kind="VAR_CLEARED", asil_level=level, alignment="UNSPECIFIED"),
    )


def code_section(level: Level) -> str:
    """Section of the code of runnables."""
    return "CODE" if level == "QM" else f"CODE_ASIL_{level}"
