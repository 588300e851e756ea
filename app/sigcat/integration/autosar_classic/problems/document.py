"""Parts of an Integration JSON that an RTE generator would refuse, each with its place."""

from collections.abc import Iterator, Mapping

from sigcat.integration.autosar_classic.model import ClassicIntegration
from sigcat.integration.autosar_classic.problems.components import component_problems, ports_problems
from sigcat.integration.autosar_classic.problems.connections import connection_problems, signal_problems, task_problems
from sigcat.integration.autosar_classic.problems.initial_value_problems import value_problems
from sigcat.integration.autosar_classic.problems.interfaces import interface_problems
from sigcat.integration.autosar_classic.problems.literals import literal_problems
from sigcat.integration.autosar_classic.problems.needs import need_problems
from sigcat.integration.autosar_classic.problems.problem import names_of
from sigcat.integration.autosar_classic.problems.symbols import symbol_problems
from sigcat.integration.autosar_classic.problems.type_problems import type_problems
from sigcat.integration.autosar_classic.problems.uses import use_problems
from sigcat.integration.autosar_classic.problems.windows import window_problems
from sigcat.integration.problem import Problem


def problems_of(model: ClassicIntegration) -> Iterator[Problem]:
    """Everything that is wrong: names, references, ports, behaviour, connections, tasks."""
    yield from names_of(model)
    if model.deployment.tick < 1:
        message = f"A tick must be at least 1 µs, not {model.deployment.tick}."
        fix = "Name the period of the counter that starts timing events."
        yield Problem(("ClassicDeployment", "Tick"), message, fix)
    yield from type_problems(model)
    yield from literal_problems(model)
    yield from value_problems(model)
    yield from interface_problems(model)
    known = interfaces_of(model)
    for index, component in enumerate(model.components):
        yield from component_problems(component, ("Components", index), known)
    for index, parameters in enumerate(model.parameter_components):
        yield from ports_problems(parameters.ports, ("ParameterComponents", index), known)
    yield from use_problems(model)
    yield from window_problems(model, model.deployment.release)
    yield from need_problems(model)
    yield from symbol_problems(model)
    yield from connection_problems(model)
    data = {each.name: frozenset(one.name for one in each.elements) for each in model.sender_receiver_interfaces}
    yield from signal_problems(model, data)
    yield from task_problems(model)


def interfaces_of(model: ClassicIntegration) -> Mapping[str, tuple[str, frozenset[str]]]:
    """Kind and elements of each interface."""
    found: dict[str, tuple[str, frozenset[str]]] = {}
    for data in model.sender_receiver_interfaces:
        found[data.name] = "SenderReceiver", frozenset(each.name for each in data.elements)
    for operations in model.client_server_interfaces:
        found[operations.name] = "ClientServer", frozenset(each.name for each in operations.operations)
    for modes in model.mode_switch_interfaces:
        found[modes.name] = "ModeSwitch", frozenset((modes.prototype,))
    for parameters in model.parameter_interfaces:
        found[parameters.name] = "Parameter", frozenset(each.name for each in parameters.elements)
    return found
