"""Parts of a component that its function does not have."""

from collections.abc import Iterator

from sigcat import codes
from sigcat.adapter.autosar_classic.code.plan import SwcPlan
from sigcat.findings import Finding
from sigcat.function.document.document import Pointer, pointer_text
from sigcat.integration.autosar_classic.model import Access, Port, Runnable

_DATA = frozenset(("ExplicitRead", "ImplicitRead", "QueuedReceive", "ExplicitWrite", "QueuedSend", "ImplicitWrite"))
_WITH_METHOD = ("Method", "Answer")


def disagreements(swc: SwcPlan, index: int) -> Iterator[Finding]:
    """Everything of a component that its core cannot do."""
    at: Pointer = ("Components", index)
    steps = {step.interface for step in swc.core.steps}
    methods = {name for each in swc.methods for name in each.columns}
    for number, runnable in enumerate(swc.component.runnables):
        below: Pointer = (*at, "Runnables", number)
        if runnable.role in _WITH_METHOD and runnable.method not in methods:
            yield _finding((*below, "Method"), f"{runnable.name} must have a method of {swc.core.function}.")
        if runnable.role == "Step" and runnable.call not in steps:
            yield _finding((*below, "Call"), f"{runnable.name} must run a step of {swc.core.function}.")
        yield from _unknown_data(runnable, swc, at)
    yield from _unreported_rejections(swc, at)


def _unknown_data(runnable: Runnable, swc: SwcPlan, at: Pointer) -> Iterator[Finding]:
    """Data and parameters that a runnable accesses, and the core has no place for."""
    known = {end.key for end in (*swc.received, *swc.sent)}
    functions = {each.function for each in swc.parameters}
    ports = {port.name: (number, port) for number, port in enumerate(swc.component.ports)}
    for access in runnable.accesses:
        number, port = ports.get(access.port or "", (-1, None))
        if port is None:
            continue
        if access.kind == "Parameter":
            is_known = f"Rte_Prm_{port.name}_{access.element}" in functions
        elif access.kind == "ModeSwitch":
            is_known = swc.mode_out is not None and swc.mode_out.port == port.name
        else:
            is_known = access.kind not in _DATA or (port.name, access.element) in known
        if not is_known:
            yield _of_port(access, port, number, swc, at)


def _unreported_rejections(swc: SwcPlan, at: Pointer) -> Iterator[Finding]:
    """Elements whose rejections the core needs, and that the RTE would not report."""
    needed = {end.key: end for end in swc.received if end.tells_of_rejection}
    implicit = {
        (access.port, access.element)
        for runnable in swc.component.runnables
        for access in runnable.accesses
        if access.kind == "ImplicitRead"
    }
    for number, port in enumerate(swc.component.ports):
        for index, element in enumerate(port.elements):
            key, below = (port.name, element.name), (*at, "Ports", number, "Elements", index)
            why = f"{swc.core.function} names an `e2eError` for it."
            if key in needed and not needed[key].has_transformer_errors:
                yield _finding(below, f"{port.name}.{element.name} must have `TransformerErrors`: {why}")
            if key in needed and key in implicit:
                yield _finding(below, f"{port.name}.{element.name} must be read explicitly: {why}")


def _of_port(access: Access, port: Port, number: int, swc: SwcPlan, at: Pointer) -> Finding:
    elements = [each.name for each in port.elements]
    below: Pointer = (*at, "Ports", number, "Elements", elements.index(access.element), "Uses")
    return _finding(below, f"{port.name}.{access.element} must be used by an interface of {swc.core.function}.")


def _finding(pointer: Pointer, message: str) -> Finding:
    fix = "Integrate the functions again."
    return codes.NOT_WRITABLE_AS_CLASSIC.finding(message, pointer=pointer_text(pointer), fix=fix)
