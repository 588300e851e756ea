"""The module of a core: a class over the shared library that notebooks use without ROS."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.core.plan import CorePlan, Method
from sigcat.adapter.host.host_plan import HostValue, received_values, sent_values
from sigcat.adapter.ros2.plan import NodePlan
from sigcat.adapter.ros2.python.core.bridge import declarations, digest, publish_names, struct_names
from sigcat.adapter.ros2.python.names import Import, class_name, imports, python_names, typed, typing_names
from sigcat.adapter.templates import rendered
from sigcat.function.document.text import sentence


class Names(NamedTuple):
    """Names in Python by those of the library."""

    receivers: Mapping[str, str]
    """Methods that take values."""
    members: Mapping[str, str]
    """Members of sent values."""
    methods: Mapping[str, str]
    """Methods of the function, as a part of names."""


def core_type(core: CorePlan) -> str:
    """The class of a core: `CoreAccCore`."""
    return f"{class_name(core.function)}Core"


def names_of(core: CorePlan) -> Names:
    """The names of a core."""
    taken = python_names(each.name for each in received_values(core))
    receivers = {name: f"receive_{each}" for name, each in taken.items()}
    methods = python_names(each.named.name for each in core.methods)
    return Names(receivers, python_names(publish_names(core)), methods)


def argument_names(method: Method) -> dict[str, str]:
    """Arguments of a method in Python by their names in the library."""
    return python_names(each.name for each in method.arguments)


def core_module(node: NodePlan) -> str:
    """The whole module."""
    core = node.core
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
        names=names_of(core),
        received=list(received_values(core)),
        received_type=_received_type,
        methods=core.methods,
        argument_names=argument_names,
        out=list(sent_values(core)),
        sent_type=_sent_type,
        publish=publish_names(core),
    )


def _typing_imports(core: CorePlan) -> Sequence[Import]:
    received, sent = tuple(received_values(core)), tuple(sent_values(core))
    used = set().union(*(typing_names(each.wire, is_sequence=True) for each in received))
    used = used.union(
        *(typing_names(each.wire) for each in sent), {"List"} if any(each.is_queue for each in sent) else ()
    )
    used |= {"Tuple", "Dict", "Any"} if core.methods else set()
    used |= {"Mapping", "Any"} if core.requests else set()
    used |= {"NamedTuple"} if core.published else set()
    return imports([("typing", used)]) if used else ()


def _received_type(value: HostValue) -> str:
    return typed(value.wire, is_sequence=True)


def _sent_type(value: HostValue) -> str:
    return f"List[{typed(value.wire)}]" if value.is_queue else typed(value.wire)
