"""Elements of ports without the interface of the function that is behind them: no code connects them."""

from collections.abc import Iterable, Iterator, Mapping

from sigcat.function.document.document import Pointer
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import data, errors, methods, parameters, safety_reactions
from sigcat.integration.autosar_classic.model import ClassicIntegration, Component, Element, Port
from sigcat.integration.problem import Problem
from sigcat.integration.references import unknown

_WITH_USES = frozenset(
    ("ImplicitRead", "ExplicitRead", "QueuedReceive", "ExplicitWrite", "QueuedSend", "AsynchronousCall", "Result",
     "Parameter")
)  # fmt: skip
"""Accesses for which the code needs to know the interface."""
Known = Mapping[str, frozenset[str]]
"""Names of the interfaces of a function by their kind; those of signals and queues with their call."""


def use_problems(model: ClassicIntegration) -> Iterator[Problem]:
    """Problems of `Uses`, for each component whose function is in the document."""
    functions = {each.info.function_name: each for each in model.functions or ()}
    for index, component in enumerate(model.components):
        if component.function in functions:
            yield from _of_component(component, ("Components", index), _known(functions[component.function]))


def _known(function: FunctionJson) -> Known:
    own = [item for _, _, item in errors(function)]
    reactions = [item for _, _, item in safety_reactions(function)]
    others = (name for each in own for name in each.dependencies)
    statuses = frozenset((*(each.name for each in own), *others, *(name for each in reactions for name in each.errors)))
    exchanged = frozenset(f"{located.runnable.name} {item.name}" for _, located, item in data(function))
    return {
        "signal": exchanged,
        "queue": exchanged,
        "error": statuses,
        "safety reaction": frozenset(each.name for each in reactions),
        "method": frozenset(item.name for _, _, item in methods(function)),
        "parameter": frozenset(item.name for _, _, item in parameters(function)),
    }


def _of_component(component: Component, at: Pointer, known: Known) -> Iterator[Problem]:
    accessed = {
        (access.port, access.element)
        for runnable in component.runnables
        for access in runnable.accesses
        if access.kind in _WITH_USES
    }
    for index, port in enumerate(component.ports):
        for number, element in enumerate(port.elements):
            here = (*at, "Ports", index, "Elements", number)
            yield from _of_element(port, element, here, known, is_accessed=(port.name, element.name) in accessed)
    for index, parameter in enumerate(component.parameters):
        yield from _names(parameter.uses, (*at, "InternalParameters", index, "Uses"), known)


def _of_element(port: Port, element: Element, at: Pointer, known: Known, *, is_accessed: bool) -> Iterator[Problem]:
    if is_accessed and not element.uses:
        message = f"{element.name} of {port.name} must have the interface of the function that is behind it."
        yield Problem((*at, "Uses") if element.uses is not None else at, message, "Give `Uses`, as `sigcat integrate` writes it.")  # fmt: skip
    for index, use in enumerate(element.uses or ()):
        name = f"{use.call} {use.interface}" if use.kind in ("signal", "queue") else use.interface
        if use.kind in known and name not in known[use.kind]:
            of_call = f" of {use.call}" if name != use.interface else ""
            yield unknown((*at, "Uses", index, "Interface"), f"{use.kind}{of_call} of {use.function}", use.interface)


def _names(uses: Iterable[str], at: Pointer, known: Known) -> Iterator[Problem]:
    for index, name in enumerate(uses):
        if name not in known["parameter"]:
            yield unknown((*at, index), "parameter of the function", name)
