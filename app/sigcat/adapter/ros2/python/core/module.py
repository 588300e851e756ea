"""The module of a core: a class over the shared library that notebooks use without ROS."""

import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.core.plan import CorePlan, Method, WireType
from sigcat.adapter.host.plan import received_values, sent_values
from sigcat.adapter.ros2.plan import NodePlan
from sigcat.adapter.ros2.python.core.bridge import declarations, digest, publish_names, struct_names
from sigcat.adapter.ros2.python.names import Import, class_name, imports, python_names, typed
from sigcat.adapter.templates import rendered
from sigcat.function.document.text import sentence


class _Sent(NamedTuple):
    """A value that is sent: its names in Python and in the library, and its type."""

    member: str
    name: str
    type: str
    comment: str
    is_queue: bool
    is_plain: bool
    """Whether it is one number."""


class _Published(NamedTuple):
    """A flag that a value is to be sent: its names in Python and in the library."""

    member: str
    name: str


class _Received(NamedTuple):
    """A value that the core takes: its name in the library, and the method that takes it."""

    name: str
    receiver: str
    wire: WireType
    type: str
    comment: str


class _Method(NamedTuple):
    """A method of the function: its names in Python and in the library."""

    member: str
    of: Method
    comment: str
    arguments: Mapping[str, str]
    """Arguments in Python by their names in the library."""


def core_type(core: CorePlan) -> str:
    """The class of a core: `CoreAccCore`."""
    return f"{class_name(core.function)}Core"


def receivers(core: CorePlan) -> dict[str, str]:
    """Methods that take values, by their names in the library."""
    names = python_names(each.name for each in received_values(core))
    return {name: f"receive_{each}" for name, each in names.items()}


def method_names(core: CorePlan) -> dict[str, str]:
    """Methods of the function, as a part of names in Python."""
    return python_names(each.named.name for each in core.methods)


def members(core: CorePlan) -> dict[str, str]:
    """Members of sent values, by their names in the library."""
    return python_names(publish_names(core))


def argument_names(method: Method, *, is_request: bool) -> dict[str, str]:
    """Arguments or results of a method, as Python has them."""
    return python_names(each.name for each in (method.arguments if is_request else method.results))


def core_module(node: NodePlan) -> str:
    """The whole module."""
    core = node.core
    names, methods = members(core), method_names(core)
    own = ["Core", *(["Call"] if core.steps else []), *(["Error"] if core.errors else [])]
    return rendered(
        "adapter/ros2/python/core/core.py.j2",
        function=core.function,
        version=f" {core.version}" if core.version else "",
        about=[sentence(core.description)] if core.description else [],
        origin=core.provenance.text,
        typing_imports=_typing_imports(core),
        own_imports=imports([(".support.core", own)]),
        declarations=declarations(core),
        digest=digest(core),
        stem=class_name(core.function),
        type=core_type(core),
        adapter=core.type_name,  # names of functions of the library begin with it
        package=node.package,
        library=node.core_library,
        structs=struct_names(core),
        calls=core.steps,
        has_errors=bool(core.errors),
        monitors=node.monitors,
        # Stored parameters with their keys.
        learned=[(each.named.name, node.host.stored_keys[each.variable]) for each in core.learned],
        received=_received(core),
        methods=[_method(each, methods) for each in core.methods],
        out=_sent(core),
        publish=[_Published(names[each], each) for each in publish_names(core)],
    )


def _typing_imports(core: CorePlan) -> Sequence[Import]:
    types = [*(each.type for each in _received(core)), *(each.type for each in _sent(core))]
    types += ["Tuple[int, Dict[str, Any]]"] if core.methods else []
    types += ["Mapping[str, Any]"] if core.requests else []
    types += ["NamedTuple"] if core.published else []
    used = set(re.findall(r"[A-Z]\w+", " ".join(types)))
    return imports([("typing", used)]) if used else ()


def _received(core: CorePlan) -> Sequence[_Received]:
    names = receivers(core)
    return [
        _Received(each.name, names[each.name], each.wire, typed(each.wire, is_sequence=True), each.comment)
        for each in received_values(core)
    ]


def _sent(core: CorePlan) -> Sequence[_Sent]:
    names = members(core)
    return [
        _Sent(
            names[each.name],
            each.name,
            f"List[{typed(each.wire)}]" if each.is_queue else typed(each.wire),
            each.comment,
            each.is_queue,
            is_plain=each.wire.is_plain,
        )
        for each in sent_values(core)
    ]


def _method(method: Method, names: Mapping[str, str]) -> _Method:
    named = method.named
    return _Method(
        names[named.name],
        method,
        named.comment or named.name,
        argument_names(method, is_request=True),
    )
