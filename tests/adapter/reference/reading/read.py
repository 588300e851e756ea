"""A Function JSON, read for its adapter."""

from collections.abc import Iterator, Mapping
from dataclasses import replace

from sigcat.function.function_json.interfaces.data_interfaces import ParameterInterface
from sigcat.function.function_json.interfaces.methods import Argument as DeclaredArgument
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.role import CONSUMER
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.runnable import Contract, Runnable
from tests.adapter.reference.function import Call, Function
from tests.adapter.reference.parts.methods import Argument, Method
from tests.adapter.reference.parts.parameters import Parameter
from tests.adapter.reference.reading.calls import call_of, checkpoints_of
from tests.adapter.reference.reading.data import data_of, port_key
from tests.adapter.reference.reading.names import unique
from tests.adapter.reference.reading.status import errors_of, mode_in, mode_out, reactions_of
from tests.adapter.reference.reading.times import nanoseconds
from tests.adapter.reference.reading.transfers import Table, to_catalogue, to_code, unchanged

INIT, SHUTDOWN = "Init", "Shutdown"


def read(document: FunctionJson) -> Function:
    """The function of a document. Raises `Unsupported` for what no adapter carries."""
    table = {datatype.reference: datatype for datatype in document.datatypes}
    runnables = [runnable for component in document.components for runnable in component.runnables]
    ports = _ports(runnables)
    calls = _named([call_of(runnable, document.modes or (), ports, table) for runnable in runnables])
    return Function(
        name=document.info.function_name,
        init=tuple(call for call in calls if call.run_type == INIT),
        steps=tuple(call for call in calls if call.run_type not in (INIT, SHUTDOWN)),
        terminate=tuple(call for call in calls if call.run_type == SHUTDOWN),
        ports=ports,
        checkpoints=checkpoints_of(runnables),
        errors=errors_of(runnables, table),
        reactions=reactions_of(runnables, table),
        mode_in=mode_in(document.mode_interfaces or (), table),
        mode_out=mode_out(document.mode_interfaces or (), table),
        methods=_methods(runnables, table),
        parameters=_parameters(runnables, table),
    )


def contracts_of(runnables: list[Runnable]) -> Iterator[tuple[Runnable, Contract]]:
    """All contracts, with their calls."""
    for runnable in runnables:
        for contract in runnable.contracts or ():
            yield runnable, contract


def _ports(runnables: list[Runnable]) -> Mapping[str, str]:
    """Names under which signals are received, by path or name."""
    ports: dict[str, str] = {}
    for runnable in runnables:
        for item in data_of(runnable):
            if item.role == CONSUMER and port_key(item) not in ports:
                ports[port_key(item)] = unique(item.name, ports.values())
    return ports


def _named(calls: list[Call]) -> list[Call]:
    """Calls whose outputs have separate names."""
    taken: set[str] = set()
    named = []
    for call in calls:
        outputs = []
        for output in call.outputs:
            outputs.append(replace(output, name=unique(output.name, taken)))
            taken.add(outputs[-1].name)
        named.append(replace(call, outputs=tuple(outputs)))
    return named


def _methods(runnables: list[Runnable], table: Table) -> tuple[Method, ...]:
    methods: dict[str, Method] = {}
    for runnable, contract in contracts_of(runnables):
        for item in contract.methods or ():
            methods.setdefault(item.name, _method(item, runnable.name, table))
    return tuple(methods.values())


def _method(item: MethodInterface, call: str, table: Table) -> Method:
    return Method(
        item.name,
        call,
        is_offered=item.role != CONSUMER,
        inputs=_arguments(item.inputs, table),
        outputs=_arguments(item.outputs, table),
        symbol=item.symbol,
        time_out=nanoseconds(item.timeout),
        request_variable=item.request_variable,
        status_variable=item.status_variable,
    )


def _arguments(items: tuple[DeclaredArgument, ...], table: Table) -> tuple[Argument, ...]:
    return tuple(Argument(item.name, item.variable or item.name, unchanged(item, table)) for item in items)


def _parameters(runnables: list[Runnable], table: Table) -> tuple[Parameter, ...]:
    """Parameters; those with the same variable are one."""
    found: dict[str, Parameter] = {}
    for runnable, contract in contracts_of(runnables):
        for item in contract.parameters or ():
            variable = item.variable or item.name
            name = unique(item.name, [each.name for each in found.values()])
            known = found.get(variable) or _parameter(item, name, variable, table)
            found[variable] = known._replace(calls=(*known.calls, runnable.name))
    return tuple(found.values())


def _parameter(item: ParameterInterface, name: str, variable: str, table: Table) -> Parameter:
    incoming, outgoing = to_code(item, table), to_catalogue(item, table)
    is_learned = item.attribute == "LearningParameter"
    return Parameter(name, variable, (), incoming, outgoing, is_learned, item.range_error)
