"""The report of an Integration JSON in C: the RTE functions of each runnable, and the parts left to the vendor."""

from collections.abc import Iterator
from typing import NamedTuple

from sigcat.adapter.autosar_classic.arxml.field_targets import field_targets
from sigcat.integration.autosar_classic.document import read_integration
from sigcat.integration.autosar_classic.model import Access, Component, Runnable
from sigcat.integration.report import Entry
from sigcat.limits import Limits

_APIS = {
    "ImplicitRead": "Rte_IRead, Rte_IStatus", "ExplicitRead": "Rte_IsUpdated, Rte_Read", "QueuedReceive": "Rte_Receive",
    "ExplicitWrite": "Rte_Write", "QueuedSend": "Rte_Send", "Mode": "Rte_Mode", "ModeSwitch": "Rte_Switch",
    "SynchronousCall": "Rte_Call", "AsynchronousCall": "Rte_Call", "Result": "Rte_Result", "Parameter": "Rte_Prm",
    "InternalTrigger": "Rte_IrTrigger",
}  # fmt: skip
_VENDOR = "the vendor's RTE and operating system, from the ARXML"
_MATURED = "PASSED and FAILED, as the core has matured them"
_CORE = "the core has its limits: the watchdog manager gets checkpoints"


def report(data: bytes, name: str, limits: Limits) -> tuple[Entry, ...]:
    """An entry for each field that becomes C, or that a vendor's tools take. Raises InputRefused if it cannot be used."""
    model = read_integration(data, name, limits)
    return (*field_targets(model), *(entry for component in model.components for entry in _of_component(component)))


def _of_component(component: Component) -> Iterator[Entry]:
    source, function = f"swc/{component.name}.c", component.function
    for runnable in component.runnables:
        yield from _of_runnable(runnable, source, function)
    for event in component.events:
        yield Entry(function, event.name, "event", "Kind", "components.arxml", _VENDOR)
    for part in _parts(component):
        yield Entry(function, part.name, part.kind, part.field, f"{source}: {part.symbols}", part.note)


class _Part(NamedTuple):
    """Something of a component, and the names in C that it has there."""

    name: str
    kind: str
    field: str
    symbols: str
    note: str = ""


def _parts(component: Component) -> Iterator[_Part]:
    """In the order of the document."""
    for area in component.exclusive_areas:
        yield _Part(area.name, "exclusive area", "Name", f"Rte_Enter_{area.name}, Rte_Exit_{area.name}")
    for memory in component.memories:
        yield _Part(memory.name, "memory", "Name", f"Rte_Pim_{memory.name}", "read by Init, written by Terminate")
    for parameter in component.parameters:
        yield _Part(parameter.name, "parameter", "Name", f"Rte_CData_{parameter.name}", "read by Init")
    for event in component.diagnostic_events:
        yield _Part(event.error, "error", "Port", f"Rte_Call_{event.port}_SetEventStatus", _MATURED)
    for entity in component.supervised_entities:
        yield _Part(entity.name, "supervised entity", "Checkpoints", "Rte_Call_<port>_CheckpointReached", _CORE)
    for section in component.sections:
        yield _Part(section.name, "memory section", "Name", f"{component.name}_START_SEC_{section.name}")


def _of_runnable(runnable: Runnable, source: str, function: str) -> Iterator[Entry]:
    yield Entry(function, runnable.name, "runnable", "Symbol", f"{source}: {runnable.symbol}")
    for access in runnable.accesses:
        yield Entry(
            function, _accessed(access), "access", "Kind", f"{source}: {_APIS[access.kind]}", f"in {runnable.symbol}"
        )


def _accessed(access: Access) -> str:
    return f"{access.port}.{access.element}" if access.port else access.element
