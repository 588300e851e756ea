"""The module of a node: topics, parameters and services of one function, over what all nodes have in common."""

import sys
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from sigcat.adapter.ros2.plan import (
    Fixed,
    MethodService,
    NodeParameter,
    NodePlan,
    Publisher,
    ReceivedField,
    SentField,
    Subscription,
)
from sigcat.adapter.ros2.python.core.module import argument_names, core_type, members, method_names, receivers
from sigcat.adapter.ros2.python.names import Import, class_name, imports, number
from sigcat.adapter.ros2.python.node.conversions import (
    Conversion,
    Field,
    argument_fields,
    class_of,
    for_core,
    for_message,
    struct_of,
)
from sigcat.adapter.templates import rendered
from sigcat.function.document.text import sentence
from sigcat.function.document.text_filters import python_string
from sigcat.names import snake_case


class _Range(NamedTuple):
    """The range of a descriptor, which has two limits of its type."""

    type: str
    low: str
    high: str


class _Parameter(NamedTuple):
    """A parameter of the node, with literals of its default and its limits."""

    of: NodeParameter
    default: str
    range: _Range | None
    limits: Sequence[str]


class _Taken(NamedTuple):
    """A value of a message, and the method of the core that takes it."""

    of: ReceivedField
    receiver: str
    for_core: Conversion


class _Subscription(NamedTuple):
    """A topic that the node takes."""

    of: Subscription
    type: str
    private: str
    takes: Sequence[_Taken]


class _OwnReceiver(NamedTuple):
    """The method of the core by which another call of the function takes what this one sends: that needs no message."""

    name: str
    wakes: bool


class _Given(NamedTuple):
    """A field of a message, and the member of the core's output that it is made of."""

    of: SentField
    member: str
    for_message: Conversion
    own_receivers: Sequence[_OwnReceiver]


class _Publisher(NamedTuple):
    """A topic that the node gives."""

    of: Publisher
    type: str
    private: str
    fixed: Sequence[Fixed]
    """Fields with their values in Python."""
    gives: Sequence[_Given]


class _Service(NamedTuple):
    """A service that the function answers or asks, and the name of its method."""

    of: MethodService
    type: str
    name: str
    request: Sequence[Field]
    response: Sequence[Field]
    private: str = ""
    member: str = ""
    """The member of the core's flags that asks for a request."""


class _Base(NamedTuple):
    """The class that the node derives from."""

    module: str
    name: str


_FUNCTION = _Base(".support.function_node", "FunctionNode")
_BONDED = _Base(".support.bond", "BondedNode")


class _Names(NamedTuple):
    """Names in Python by those of the library."""

    receivers: Mapping[str, str]
    members: Mapping[str, str]
    methods: Mapping[str, str]


def node_module(node: NodePlan, *, has_bond: bool) -> str:
    """The whole module."""
    core, stem = node.core, class_name(node.core.function)
    base = _BONDED if has_bond else _FUNCTION
    names = _Names(receivers(core), members(core), method_names(core))
    return rendered(
        "adapter/ros2/python/node/node.py.j2",
        function=core.function,
        about=[sentence(core.description)] if core.description else [],
        origin=core.provenance.text,
        type=node.type,
        name=node.name,
        core=core_type(core),
        step=class_of(node.step_service, node),
        out=f"{stem}Out",
        publish=f"{stem}Publish",
        priority=node.priority,
        policy=node.policy,
        typing_imports=_typing_imports(node),
        other_imports=_other_imports(node),
        own_imports=_own_imports(node, base),
        base=base.name,
        structs=[struct_of(pair, node) for pair in node.structs],
        parameters=[_parameter(each) for each in node.parameters],
        subscriptions=[_subscription(each, node, names) for each in node.subscriptions],
        publishers=[_publisher(each, node, names) for each in node.publishers],
        offered=[_offered(each, node, names) for each in node.offered],
        used=[_used(each, node, names) for each in node.used],
    )


# -- imports ------------------------------------------------------------------------------------------------------


def _typing_imports(node: NodePlan) -> Sequence[Import]:
    used = {"Any", "List", "Optional"}
    if node.parameters:
        used |= {"Callable", "Dict"}
    if node.structs or any(not each.response for each in node.used):
        used.add("Dict")
    return imports([("typing", used)])


def _other_imports(node: NodePlan) -> Sequence[Import]:
    found: list[tuple[str, Iterable[str]]] = []
    if node.publishers or node.used:
        found.append(("builtin_interfaces.msg", ["Time"]))
    found.append((node.step_service.package, {each.kind for each in node.messages if node.is_own(each)}))
    found += [(f"{package}.msg", ()) for package in {each.package for each in node.messages if not node.is_own(each)}]
    if node.parameters:
        ranges = {each.type for each in map(_range, node.parameters) if each is not None}
        found.append(("rcl_interfaces.msg", {"ParameterDescriptor", *ranges}))
    return imports(found)


def _own_imports(node: NodePlan, base: _Base) -> Sequence[Import]:
    stem = class_name(node.core.function)
    support = {base.module: [base.name]}
    support.setdefault(_FUNCTION.module, []).append("spin")
    own = [core_type(node.core)]
    own += [f"{stem}Publish"] if node.publishers or node.used else []
    own += [f"{stem}Out"] if node.publishers else []
    return imports([
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
    return _Parameter(parameter, number(parameter.default), _range(parameter), limits)


def _limit(value: float | None, infinite: str) -> str:
    return f"float({python_string(infinite)})" if value is None else repr(value)


def _range(parameter: NodeParameter) -> _Range | None:
    low, high = parameter.low, parameter.high
    if parameter.type not in ("double", "integer") or (low is None and high is None):
        return None
    if parameter.type == "double":
        least, most = -sys.float_info.max if low is None else low, sys.float_info.max if high is None else high
        return _Range("FloatingPointRange", repr(float(least)), repr(float(most)))
    integers = (-(2**63) if low is None else int(low), 2**63 - 1 if high is None else int(high))
    return _Range("IntegerRange", *map(str, integers))


# -- topics -------------------------------------------------------------------------------------------------------


def _subscription(subscription: Subscription, node: NodePlan, names: _Names) -> _Subscription:
    return _Subscription(
        subscription,
        class_of(subscription.message, node),
        node.private(subscription.topic),
        [_Taken(each, names.receivers[each.place], for_core(each, node)) for each in subscription.takes],
    )


def _publisher(publisher: Publisher, node: NodePlan, names: _Names) -> _Publisher:
    return _Publisher(
        publisher,
        class_of(publisher.message, node),
        node.private(publisher.topic),
        [Fixed(each.field, _literal(each.value)) for each in publisher.fixed],
        [_filled(each, node, names) for each in publisher.gives],
    )


def _literal(value: Any) -> str:
    """A value of a document, as Python writes it."""
    return repr(value) if isinstance(value, bool | int | float) else python_string(value)


def _filled(given: SentField, node: NodePlan, names: _Names) -> _Given:
    own = [_OwnReceiver(names.receivers[port.name], wakes=bool(port.triggers)) for port in given.own_ports]
    return _Given(given, names.members[given.place], for_message(given, node), own)


# -- services -----------------------------------------------------------------------------------------------------


def _offered(service: MethodService, node: NodePlan, names: _Names) -> _Service:
    own = argument_names(service.method, is_request=True)
    request = [each._replace(core=own[each.core]) for each in argument_fields(service.request, node)]
    return _Service(
        service,
        class_of(service.service, node),
        names.methods[service.method.named.name],
        request,
        argument_fields(service.response, node),
        private=node.private(service.topic),
    )


def _used(service: MethodService, node: NodePlan, names: _Names) -> _Service:
    name = service.method.named.name
    return _Service(
        service,
        class_of(service.service, node),
        names.methods[name],
        argument_fields(service.request, node),
        argument_fields(service.response, node),
        member=names.members[name],
    )
