"""The module of a node: topics, parameters and services of one function, over what all nodes have in common."""

import sys
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, NamedTuple

from sigcat.adapter.core.plan import WireType
from sigcat.adapter.ros2.plan import (
    ArgumentField,
    Given,
    InterfaceType,
    MethodService,
    NodeParameter,
    NodePlan,
    Publisher,
    StructPair,
    Subscription,
    Symbol,
    Taken,
)
from sigcat.adapter.ros2.python.core_module import argument_names, core_type, members, method_names, receivers
from sigcat.adapter.ros2.python.names import class_name, imports, number, sorted_imports
from sigcat.adapter.templates import rendered
from sigcat.function.document.text import sentence
from sigcat.function.document.text_filters import AnyText, python_string
from sigcat.integration.ros2.model import QualityOfService
from sigcat.integration.ros2.settings import SchedulingPolicy
from sigcat.names import snake_case


class _Range(NamedTuple):
    """The range of a descriptor, which has two limits of its type."""

    type: str
    low: str
    high: str


class _Parameter(NamedTuple):
    """A parameter of the node, and expressions of its default, its limits and its value for the core."""

    of: NodeParameter
    default: str
    range: _Range | None
    limits: Sequence[str]
    value: str


class _Value(NamedTuple):
    """A field or an argument, and the expression of its value."""

    name: str
    value: str


class _Taken(NamedTuple):
    """A value of a message, and the method of the core that takes it."""

    of: Taken
    receiver: str
    value: str


class _Subscription(NamedTuple):
    """A topic that the node takes."""

    of: Subscription
    type: str
    private: str
    quality: str
    takes: Sequence[_Taken]

    @property
    def wakes(self) -> bool:
        """Whether a message may make a call due."""
        return any(each.of.wakes for each in self.takes)


class _Given(NamedTuple):
    """A field of a message, and the value of the core that it is made of."""

    of: Given
    value: str
    source: str
    handed_over: Sequence[Sequence[str]]
    """Arguments of the calls that hand it over to the function itself."""


class _Publisher(NamedTuple):
    """A topic that the node gives, if one of the flags is set."""

    of: Publisher
    type: str
    private: str
    quality: str
    fixed: Sequence[_Value]
    gives: Sequence[_Given]
    flags: Sequence[str]
    queue: str
    """Values, each of which is a message; if empty, there is one message."""


class _Service(NamedTuple):
    """A service that the function answers or asks, the name of its method, and values of the request and the response."""

    of: MethodService
    type: str
    name: str
    request: Sequence[_Value]
    response: Sequence[_Value]
    private: str = ""
    flag: str = ""


class _Field(NamedTuple):
    """A field of a struct in the message and in the core, and expressions of its value for both."""

    name: str
    core: str
    taken: str
    given: str


class _Struct(NamedTuple):
    """A struct of a message, and functions that begin with its stem."""

    stem: str
    name: str
    type: str
    fields: Sequence[_Field]


class _Base(NamedTuple):
    """The class that the node derives from."""

    module: str
    name: str


_FUNCTION = _Base(".support.function_node", "FunctionNode")
_BONDED = _Base(".support.bond", "BondedNode")


class _Node(NamedTuple):
    """Plan of the module."""

    function: str
    about: Sequence[AnyText]
    type: str
    name: str
    core: str
    step: str
    out: str
    publish: str
    priority: int | None
    policy: SchedulingPolicy
    typing_imports: str
    other_imports: str
    own_imports: str
    base: str
    structs: Sequence[_Struct]
    parameters: Sequence[_Parameter]
    subscriptions: Sequence[_Subscription]
    publishers: Sequence[_Publisher]
    offered: Sequence[_Service]
    used: Sequence[_Service]


def node_module(node: NodePlan, *, has_bond: bool) -> str:
    """The whole module."""
    core, stem = node.core, class_name(node.core.function)
    base = _BONDED if has_bond else _FUNCTION
    plan = _Node(
        function=core.function,
        about=[sentence(core.description)] if core.description else [],
        type=node.type,
        name=node.name,
        core=core_type(core),
        step=_class_of(node.step_service, node),
        out=f"{stem}Out",
        publish=f"{stem}Publish",
        priority=node.priority,
        policy=node.policy,
        typing_imports=_typing_imports(node),
        other_imports=_other_imports(node),
        own_imports=_own_imports(node, base),
        base=base.name,
        structs=[_struct(pair, node) for pair in node.structs],
        parameters=[_parameter(each) for each in node.parameters],
        subscriptions=[_subscription(each, node) for each in node.subscriptions],
        publishers=[_publisher(each, node) for each in node.publishers],
        offered=[_offered(each, node) for each in node.offered],
        used=[_used(each, node) for each in node.used],
    )
    return rendered("adapter/ros2/python/node.py.j2", plan)


def _class_of(interface: InterfaceType, node: NodePlan) -> str:
    """A message or service: `msg.Speed`, or `geometry_msgs.msg.Twist`."""
    own = f"{interface.kind}.{interface.name}"
    return own if node.is_own(interface) else f"{interface.package}.{own}"


# -- imports ------------------------------------------------------------------------------------------------------


def _typing_imports(node: NodePlan) -> str:
    used = {"Any", "List", "Optional"}
    if node.parameters:
        used |= {"Callable", "Dict"}
    if node.structs or any(not each.response for each in node.used):
        used.add("Dict")
    return imports("typing", used)


def _other_imports(node: NodePlan) -> str:
    found: list[tuple[str, Iterable[str]]] = []
    if node.publishers or node.used:
        found.append(("builtin_interfaces.msg", ["Time"]))
    found.append((node.step_service.package, {each.kind for each in node.messages if node.is_own(each)}))
    found += [(f"{package}.msg", ()) for package in {each.package for each in node.messages if not node.is_own(each)}]
    if node.parameters:
        found.append(("rcl_interfaces.msg", {"ParameterDescriptor", *_range_types(node)}))
    return sorted_imports(found)


def _range_types(node: NodePlan) -> Iterator[str]:
    ranges = [each for each in map(_range, node.parameters) if each is not None]
    return ("FloatingPointRange" if each.type == "double" else "IntegerRange" for each in ranges)


def _own_imports(node: NodePlan, base: _Base) -> str:
    stem = class_name(node.core.function)
    support = {base.module: [base.name]}
    support.setdefault(_FUNCTION.module, []).append("spin")
    own = [core_type(node.core)]
    own += [f"{stem}Publish"] if node.publishers or node.used else []
    own += [f"{stem}Out"] if node.publishers else []
    return sorted_imports([
        (f".{snake_case(node.core.function)}_core", own),
        *([(".support.core", ["OK"])] if node.offered else []),
        *support.items(),
        *([(".support.parameters", ["symbol"])] if any(each.symbols for each in node.parameters) else []),
        *([(".support.quality", ["quality"])] if node.subscriptions or node.publishers else []),
    ])  # fmt: skip


# -- parameters ---------------------------------------------------------------------------------------------------


def _parameter(parameter: NodeParameter) -> _Parameter:
    has_limits = parameter.low is not None or parameter.high is not None
    limits = (_limit(parameter.low, "-inf"), _limit(parameter.high, "inf")) if has_limits else ()
    return _Parameter(parameter, number(parameter.default), _range(parameter), limits, _parameter_value(parameter))


def _limit(value: float | None, infinite: str) -> str:
    return f"float({python_string(infinite)})" if value is None else repr(value)


def _range(parameter: NodeParameter) -> _Range | None:
    low, high = parameter.low, parameter.high
    if parameter.type not in ("double", "integer") or (low is None and high is None):
        return None
    if parameter.type == "double":
        least, most = -sys.float_info.max if low is None else low, sys.float_info.max if high is None else high
        return _Range("double", repr(float(least)), repr(float(most)))
    return _Range("integer", str(-(2**63) if low is None else int(low)), str(2**63 - 1 if high is None else int(high)))


def _parameter_value(parameter: NodeParameter) -> str:
    value = f"value_of({python_string(parameter.name)})"
    if parameter.symbols:
        table = _table(parameter.symbols)
        if parameter.type.endswith("_array"):
            return f"[symbol({table}, each) for each in {value}]"
        return f"symbol({table}, {value})"
    return f"list({value})" if parameter.type.endswith("_array") else value


def _table(symbols: Iterable[Symbol]) -> str:
    return f"{{{', '.join(f'{python_string(each.text)}: {each.number}' for each in symbols)}}}"


# -- topics -------------------------------------------------------------------------------------------------------


def _subscription(subscription: Subscription, node: NodePlan) -> _Subscription:
    return _Subscription(
        subscription,
        _class_of(subscription.message, node),
        node.private(subscription.topic),
        _quality(subscription.quality),
        [_taken(each, node) for each in subscription.takes],
    )


def _quality(quality: QualityOfService) -> str:
    given = [python_string(quality.reliability), python_string(quality.durability), f"depth={quality.depth}"]
    given += [f"deadline={quality.deadline:g}"] if quality.deadline is not None else []
    given += [f"liveliness={python_string(quality.liveliness)}"] if quality.liveliness != "automatic" else []
    given += [f"lease={quality.lease_duration:g}"] if quality.lease_duration is not None else []
    return f"quality({', '.join(given)})"


def _taken(taken: Taken, node: NodePlan) -> _Taken:
    value, is_array = f"message.{taken.field}", taken.wire.length is not None
    if taken.symbols:
        pairs = [(python_string(each.text), str(each.number)) for each in taken.symbols]
        value = _looked_up(value, pairs, str(taken.nameless), is_array=is_array)
    elif taken.numbers:
        value = _looked_up(value, [(str(one), str(other)) for one, other in taken.numbers], None, is_array=is_array)
    elif taken.wire.is_struct:
        value = _struct_value(value, taken.wire, node)
    return _Taken(taken, receivers(node.core)[taken.place], value)


def _looked_up(value: str, pairs: Iterable[tuple[str, str]], other: str | None, *, is_array: bool) -> str:
    """Meaning of a value; `other` for all others, None for the value itself."""
    table = f"{{{', '.join(f'{one}: {another}' for one, another in pairs)}}}"
    one = "each" if is_array else value
    found = f"{table}.get({one}, {one if other is None else other})"
    return f"[{found} for each in {value}]" if is_array else found


def _publisher(publisher: Publisher, node: NodePlan) -> _Publisher:
    names = members(node.core)
    sources = ["value" if publisher.is_queue else f"out.{names[each.place]}" for each in publisher.gives]
    return _Publisher(
        publisher,
        _class_of(publisher.message, node),
        node.private(publisher.topic),
        _quality(publisher.quality),
        [_Value(each.field, _fixed(each.value)) for each in publisher.fixed],
        [_given(given, source, node) for given, source in zip(publisher.gives, sources, strict=True)],
        [f"publish.{names[each.place]}" for each in publisher.gives],
        f"out.{names[publisher.gives[0].place]}" if publisher.is_queue else "",
    )


def _fixed(value: Any) -> str:
    """A value of a document, as Python writes it."""
    return repr(value) if isinstance(value, bool | int | float) else python_string(value)


def _given(given: Given, source: str, node: NodePlan) -> _Given:
    """Another call of the function may take what this one sends: no message is needed for that."""
    taking = receivers(node.core)
    handed_over = [
        [f"self.core.{taking[port.name]}", source, *(["wakes=True"] if port.triggers else [])]
        for port in given.own_ports
    ]
    is_array = given.wire.length is not None
    if given.symbols:
        pairs = [(str(each.number), python_string(each.text)) for each in given.symbols]
        value = _looked_up(source, pairs, "''", is_array=is_array)
    elif given.numbers:
        pairs = [(str(one), str(other)) for one, other in given.numbers]
        value = _looked_up(source, pairs, None, is_array=is_array)
    else:
        value = _message_value(source, given.wire, node)
    return _Given(given, value, source, handed_over)


# -- structs ------------------------------------------------------------------------------------------------------


def _struct(pair: StructPair, node: NodePlan) -> _Struct:
    """A struct that a message and the core have."""
    fields = []
    for name, member in zip(pair.members, pair.struct.fields, strict=True):
        wire = WireType(member.c, member.length, is_struct=any(each.struct.name == member.c for each in node.structs))
        given = _message_value(f"value[{python_string(member.name)}]", wire, node)
        fields.append(_Field(name, member.name, _struct_value(f"message.{name}", wire, node), given))
    return _Struct(_stem(pair), pair.message.name, _class_of(pair.message, node), fields)


def _stem(pair: StructPair) -> str:
    return snake_case(pair.message.name)


def _pair(wire: WireType, node: NodePlan) -> StructPair:
    return next(pair for pair in node.structs if pair.struct.name == wire.c)


def _struct_value(value: str, wire: WireType, node: NodePlan) -> str:
    """Expression for the core of a field of a message."""
    if not wire.is_struct:
        return value if wire.length is None else f"list({value})"
    name = f"_{_stem(_pair(wire, node))}_of"
    return f"{name}({value})" if wire.length is None else f"[{name}(each) for each in {value}]"


def _message_value(value: str, wire: WireType, node: NodePlan) -> str:
    """Expression in a message of a value of the core."""
    if not wire.is_struct:
        return value
    name = f"_{_stem(_pair(wire, node))}_message"
    return f"{name}({value})" if wire.length is None else f"[{name}(each) for each in {value}]"


# -- services -----------------------------------------------------------------------------------------------------


def _offered(service: MethodService, node: NodePlan) -> _Service:
    own = argument_names(service.method, is_request=True)
    return _Service(
        service,
        _class_of(service.service, node),
        method_names(node.core)[service.method.named.name],
        [_Value(own[each.name], each.value) for each in _from_message("request", service.request, node)],
        _to_message("results", service.response, node),
        private=node.private(service.topic),
    )


def _used(service: MethodService, node: NodePlan) -> _Service:
    name = service.method.named.name
    return _Service(
        service,
        _class_of(service.service, node),
        method_names(node.core)[name],
        _to_message("arguments", service.request, node),
        _from_message("response", service.response, node),
        flag=f"publish.{members(node.core)[name]}",
    )


def _from_message(message: str, fields: Iterable[ArgumentField], node: NodePlan) -> Sequence[_Value]:
    """Arguments of the core, from fields of a message."""
    return [
        _Value(each.argument.name, _struct_value(f"{message}.{each.field}", each.argument.value.wire, node))
        for each in fields
    ]


def _to_message(values: str, fields: Iterable[ArgumentField], node: NodePlan) -> Sequence[_Value]:
    """Fields of a message, from arguments of the core."""
    return [
        _Value(
            each.field, _message_value(f"{values}[{python_string(each.argument.name)}]", each.argument.value.wire, node)
        )
        for each in fields
    ]
