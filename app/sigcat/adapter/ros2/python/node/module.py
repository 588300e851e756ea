"""The module of a node: topics, parameters and services of one function, over what all nodes have in common."""

import sys
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

from sigcat.adapter.ros2.plan import MethodService, NodeParameter, NodePlan
from sigcat.adapter.ros2.python.core.module import argument_names, core_type, names_of
from sigcat.adapter.ros2.python.names import Import, class_name, imports, number
from sigcat.adapter.ros2.python.node.conversions import (
    Field,
    argument_fields,
    for_core,
    for_message,
    struct_fields,
    struct_stem,
)
from sigcat.adapter.templates import rendered
from sigcat.function.document.text import sentence
from sigcat.function.document.text_filters import python_string


class _Range(NamedTuple):
    """The range of a descriptor, which has two limits of its type."""

    type: str
    low: str
    high: str


_FUNCTION_NODE = ".support.function_node"


def node_module(node: NodePlan, *, has_bond: bool) -> str:
    """The whole module."""
    stem = class_name(node.core.function)
    base = (".support.bond", "BondedNode") if has_bond else (_FUNCTION_NODE, "FunctionNode")
    return rendered(
        "adapter/ros2/python/node/node.py.j2",
        node=node,
        function=node.core.function,
        about=[sentence(node.core.description)] if node.core.description else [],
        origin=node.core.provenance.text,
        core=core_type(node.core),
        out=f"{stem}Out",
        publish=f"{stem}Publish",
        typing_imports=_typing_imports(node),
        other_imports=_other_imports(node),
        own_imports=_own_imports(node, *base),
        base=base[1],
        names=names_of(node.core),
        number=number,
        literal=_literal,
        range_of=_range,
        limits_of=_limits,
        for_core=for_core,
        for_message=for_message,
        struct_stem=struct_stem,
        struct_fields=struct_fields,
        argument_fields=argument_fields,
        request_of_offered=_request_of_offered,
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


def _own_imports(node: NodePlan, module: str, base: str) -> Sequence[Import]:
    stem = class_name(node.core.function)
    support = {module: [base]}
    support.setdefault(_FUNCTION_NODE, []).append("spin")
    own = [core_type(node.core)]
    own += [f"{stem}Publish"] if node.publishers or node.used else []
    own += [f"{stem}Out"] if node.publishers else []
    return imports([
        (f".{node.function_stem}_core", own),
        *([(".support.core", ["OK"])] if node.offered else []),
        *support.items(),
        *([(".support.parameters", ["symbol"])] if any(each.symbols for each in node.parameters) else []),
        *([(".support.quality", ["quality"])] if node.subscriptions or node.publishers else []),
    ])  # fmt: skip


# -- parameters ---------------------------------------------------------------------------------------------------


def _limits(parameter: NodeParameter) -> Sequence[str]:
    has_any = parameter.low is not None or parameter.high is not None
    return (_limit(parameter.low, "-inf"), _limit(parameter.high, "inf")) if has_any else ()


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


# -- topics and services ------------------------------------------------------------------------------------------


def _literal(value: Any) -> str:
    """A value of a document, as Python writes it."""
    return repr(value) if isinstance(value, bool | int | float) else python_string(value)


def _request_of_offered(service: MethodService, node: NodePlan) -> Sequence[Field]:
    """Fields of the request, with the names that the arguments have in Python."""
    own = argument_names(service.method)
    return [each._replace(core=own[each.core]) for each in argument_fields(service.request, node)]
