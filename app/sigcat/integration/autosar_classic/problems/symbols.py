"""Names in C that clash: with those of cores, of the RTE, or with each other."""

import re
from collections.abc import Iterator

from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_classic.model import ClassicIntegration, Component, PerInstanceMemory
from sigcat.integration.autosar_classic.problems.problem import identifier, name
from sigcat.integration.problem import Problem
from sigcat.integration.references import places

_OF_BASE_SOFTWARE = ("Rte_", "SchM_", "Dem_", "NvM_", "WdgM_", "FiM_", "Os_", "EcuM_", "BswM_")
"""Prefixes of names of the base software."""
_HEADER = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.+-]*\.h(pp)?")


def symbol_problems(model: ClassicIntegration) -> Iterator[Problem]:
    """Functions of C, one for each symbol on the whole ECU; and what memories and sections are called."""
    seen = _taken(model)
    for index, component in enumerate(model.components):
        for number, runnable in enumerate(component.runnables):
            at: Pointer = ("Components", index, "Runnables", number, "Symbol")
            yield from name(at, runnable.symbol)
            if owner := _reserved(runnable.symbol, model):
                yield Problem(at, f"{runnable.symbol} must be the function of one runnable: names like it are {owner}.", "Rename it.")  # fmt: skip
            other = seen.setdefault(runnable.symbol, f"{component.name}.{runnable.name}")
            if other != f"{component.name}.{runnable.name}":
                yield Problem(at, f"{runnable.symbol} must be the function of one runnable, and is that of {other} too.", "Rename it.")  # fmt: skip
        yield from _memory_types(component, ("Components", index))
    for place, memory in places(model, "Components/*/PerInstanceMemories/*"):
        yield from _memory(memory, place)
    yield from _sections(model)


def _taken(model: ClassicIntegration) -> dict[str, str]:
    """Functions that the code of the functions has, which their cores call."""
    return {
        call.name: f"the function {function.info.function_name}"
        for function in model.functions or ()
        for component in function.components
        for call in component.runnables
    }


def _reserved(symbol: str, model: ClassicIntegration) -> str:
    """Return which reserved names a symbol belongs to: those of the core, a component's source or the base software."""
    for component in model.components:
        core = f"{component.function}_Adapter"
        if symbol == core or symbol.startswith(f"{core}_"):
            return f"those of the core of {component.function}"
        if symbol.startswith(f"{component.name}_Swc_"):
            return f"those of the source of {component.name}"
    if symbol == "main" or symbol.startswith(_OF_BASE_SOFTWARE):
        return "those of the base software"
    return ""


def _memory(memory: PerInstanceMemory, at: Pointer) -> Iterator[Problem]:
    """Text that the RTE generator writes into a header unchanged."""
    yield from identifier((*at, "Type"), memory.type)
    yield from identifier((*at, "TypeDefinition"), memory.type_definition)
    if memory.header is not None and not _HEADER.fullmatch(memory.header):
        yield Problem((*at, "Header"), f"A header must be the name of a file such as core.h, not {memory.header[:60]!r}.", "Correct it.")  # fmt: skip


def _memory_types(component: Component, at: Pointer) -> Iterator[Problem]:
    """One type is one thing in a component."""
    seen: dict[str, str] = {}
    for index, memory in enumerate(component.memories):
        if seen.setdefault(memory.type, memory.type_definition) != memory.type_definition:
            message = f"{memory.type} must be defined once, and is {seen[memory.type]} already."
            yield Problem((*at, "PerInstanceMemories", index, "Type"), message, "Rename it.")


def _sections(model: ClassicIntegration) -> Iterator[Problem]:
    """Components share the sections of a name: what is in them is of one kind."""
    seen: dict[str, tuple[str, str]] = {}
    for at, section in places(model, "Components/*/MemorySections/*"):
        kind, owner = seen.setdefault(section.name, (section.kind, model.components[int(at[1])].name))
        if kind != section.kind:
            message = f"Section {section.name} must be of kind {kind}, as in {owner}, not {section.kind}."
            yield Problem((*at, "Kind"), message, "Rename one of the two.")
