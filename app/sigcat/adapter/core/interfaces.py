"""Inputs and outputs of a call (sections 2 to 5)."""

from collections.abc import Callable, Iterable, Iterator, Mapping

from sigcat import codes
from sigcat.adapter.core.core_values import value_of
from sigcat.adapter.core.identifiers import identifier, unique
from sigcat.adapter.core.plan import CONDITIONS, Call, Element, Input, Named, Output, Port, Queue, TimeOut
from sigcat.adapter.core.planning import Context, expression, nanoseconds
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Subject
from sigcat.function.function_json.error_fields import errors_set_by
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.role import CONSUMER
from sigcat.function.function_json.runnable import Contract, Runnable
from sigcat.function.function_json.walk import located_absent, located_data

Data = Signal | DataQueue
_Located = Callable[[Contract, Pointer], Iterable[tuple[Pointer, Data]]]


def _data(call: Runnable, at: Pointer, located: _Located, *, consumed: bool) -> Iterator[tuple[Pointer, Data]]:
    """Signals and queues that a call consumes, or that it provides, with their pointers."""
    for index, contract in enumerate(call.contracts or ()):
        for pointer, item in located(contract, (*at, "funcContractList", index)):
            if (item.role == CONSUMER) is consumed:
                yield pointer, item


def named(item: Data | ParameterInterface, at: Pointer, taken: Mapping[str, object]) -> Named:
    """A unique name for an interface, beside the existing ones."""
    unit = item.vss_unit or (item.units if item.vss_datatype is None else None)
    text = f"{item.vss_path or item.name}{f' [{unit}]' if unit else ''}"
    return Named(unique(identifier(item.name), taken), text, at)


def inputs_of(
    call: Runnable, at: Pointer, ports: Mapping[str, str], resets: frozenset[str], context: Context
) -> tuple[Input, ...]:
    """Inputs of a call. `ports` has the names under which signals are received, by path or name."""
    found: dict[str, Input] = {}
    there = ((each, ports[port_key(each[1])]) for each in _data(call, at, located_data, consumed=True))
    absent = ((each, "") for each in _data(call, at, located_absent, consumed=True))
    for (pointer, item), port in (*there, *absent):
        made = _input(item, pointer, port, found, context) if port else _absent(item, pointer, found, context)
        if made is not None:
            found[made.named.name] = made._replace(is_reset=bool({item.name, item.vss_path} & resets))
    return tuple(found.values())


def outputs_of(call: Runnable, at: Pointer, taken: set[str], context: Context) -> tuple[Output, ...]:
    """Outputs of a call; `taken` are names of outputs of other calls."""
    found: dict[str, Output] = {}
    for pointer, item in _data(call, at, located_data, consumed=False):
        name = named(item, pointer, dict.fromkeys([*taken, *found]))
        variable = _variable(item, pointer, context)
        value = value_of(item, pointer, context, to_code=False)
        if variable is not None and value is not None:
            queue = _queue(item, pointer, context)
            found[name.name] = Output(name, variable, value, item.range_error, queue)
    taken.update(found)
    return tuple(found.values())


def port_key(item: Data) -> str:
    """Identity of an input's signal: its path, or its name."""
    return item.vss_path or item.name


def _input(item: Data, at: Pointer, port: str, taken: Mapping[str, object], context: Context) -> Input | None:
    name = named(item, at, taken)
    variable = _variable(item, at, context)
    value = value_of(item, at, context, to_code=True)
    time_out = _time_out(item, at, context)
    queue = _queue(item, at, context)
    if variable is None or value is None:
        return None
    return Input(
        named=name,
        port=port,
        variable=variable,
        value=value,
        is_immediate=(item.access or "").lower() == "immediate",
        time_out=time_out,
        errors=_errors(item, has_time_out=time_out is not None),
        queue=queue,
        names=tuple(filter(None, (item.name, item.vss_path))),
    )


def _errors(item: Data, *, has_time_out: bool) -> dict[str, str]:
    named = {each.field: each.error for each in errors_set_by(item) if each.field in CONDITIONS}
    return {field: error for field, error in named.items() if has_time_out or not CONDITIONS[field].needs_time_out}


def _absent(item: Data, at: Pointer, taken: Mapping[str, object], context: Context) -> Input | None:
    """An input that no one sends: its variable keeps the start value, and no value is ever checked."""
    name, variable = named(item, at, taken), _variable(item, at, context)
    value = value_of(item, at, context, to_code=True)
    if variable is None or value is None:
        return None
    leaves = tuple(leaf._replace(element=_unchecked(leaf.element), replacement=None) for leaf in value.leaves)
    return Input(
        named=name,
        port="",
        variable=variable,
        value=value._replace(leaves=leaves),
        errors={"absent_error": item.absent_error} if item.absent_error else {},
        queue=_queue(item, at, context),
        names=tuple(filter(None, (item.name, item.vss_path))),
    )


def _unchecked(element: Element) -> Element:
    return Element(element.target, element.target, coded=element.coded)


def _variable(item: Data, at: Pointer, context: Context) -> str | None:
    if item.variable is None:
        subject = Subject("data", item.vss_path or item.name)
        message = f"{item.name} must have a variable of the C code."
        context.report(codes.VARIABLE_MISSING, at, message, "Give `variable`, such as `bus.speed`.", subject)
        return None
    return expression(item.variable, item.name, (*at, "Variable"), context)


def _time_out(item: Data, at: Pointer, context: Context) -> TimeOut | None:
    time = nanoseconds(item.timeout, (*at, "Timeout"), context)
    if time is None:
        return None
    return TimeOut(time, item.timeout_start == "First", item.timeout_value or "Last", item.timeout_recovery or 1)


def _queue(item: Data, at: Pointer, context: Context) -> Queue | None:
    if not isinstance(item, DataQueue):
        return None
    count = expression(item.count_variable, item.name, (*at, "CountVariable"), context)
    per_step = min(item.values_per_step or 1, item.queue_length)
    return Queue(item.queue_length, item.overflow == "DropNewest", per_step, count, item.overflow_error)


def ports_of(calls: list[tuple[Pointer, Runnable]]) -> dict[str, str]:
    """Names under which signals are received, by path or name."""
    names: dict[str, str] = {}
    for at, call in calls:
        for _, item in _data(call, at, located_data, consumed=True):
            if port_key(item) not in names:
                names[port_key(item)] = unique(identifier(item.name), names.values())
    return names


def received(calls: Iterable[Call], steps: frozenset[str]) -> tuple[Port, ...]:
    """Received values, for all calls; only steps receive later values, too."""
    ports: dict[str, Port] = {}
    for call in calls:
        for each in call.inputs:
            if each.is_absent:
                continue
            port = ports.setdefault(each.port, Port(each.port, each.named.comment, each.value.wire, ()))
            if call.name in steps:
                ports[each.port] = port._replace(consumers=(*port.consumers, (call.name, each)))
    return tuple(
        port._replace(triggers=tuple(call.name for call in calls if port.name in call.triggers))
        for port in ports.values()
    )
