"""The module of a core: a class over the shared library that notebooks use without ROS."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat.adapter.core.plan import Call, CorePlan, Method, Output, WireType
from sigcat.adapter.ros2.plan import Monitor, NodePlan
from sigcat.adapter.ros2.python.bridge import declarations, digest, out_names, publish_names, struct_names
from sigcat.adapter.ros2.python.names import class_name, imports, python_names, typed
from sigcat.adapter.templates import rendered
from sigcat.function.document.text import sentence
from sigcat.function.document.text_filters import AnyText, python_string


class _Sent(NamedTuple):
    """A value that is sent: its names in Python and in the library, its type, and the expression that copies it."""

    member: str
    name: str
    type: str
    comment: str
    value: str


class _Told(NamedTuple):
    """A flag that a value is to be sent: its names in Python and in the library."""

    member: str
    name: str


class _Taken(NamedTuple):
    """A value that the core takes: the method, the function of the library, and its argument."""

    receiver: str
    function: str
    type: str
    comment: str
    given: str

    @property
    def is_wide(self) -> bool:
        """Whether the call has an argument on each line."""
        return len(self.function) + len(self.given) > 60


class _Method(NamedTuple):
    """A method of the function: its names in Python and in the library."""

    member: str
    name: str
    comment: str
    is_offered: bool
    arguments: Sequence[str]
    dictionary: str
    """Arguments by their names in the library."""
    has_arguments: bool
    has_results: bool


class _Core(NamedTuple):
    """Plan of the module."""

    function: str
    version: str
    about: Sequence[AnyText]
    typing_imports: str
    own_imports: str
    declarations: str
    digest: str
    stem: str
    type: str
    package: str
    library: str
    structs: Sequence[str]
    calls: Sequence[Call]
    has_errors: bool
    monitors: Sequence[Monitor]
    learned: Sequence[tuple[str, str]]
    """Stored parameters with their keys."""
    taken: Sequence[_Taken]
    methods: Sequence[_Method]
    out: Sequence[_Sent]
    publish: Sequence[_Told]


def core_type(core: CorePlan) -> str:
    """The class of a core: `CoreAccCore`."""
    return f"{class_name(core.function)}Core"


def receivers(core: CorePlan) -> dict[str, str]:
    """Methods that take values, by their names in the library."""
    names = [*(port.name for port in core.ports), *(each.named.name for each in core.reactions)]
    names += [each.name for each in core.foreign_errors]
    names += [core.mode_in.named.name] if core.mode_in else []
    return {name: f"receive_{each}" for name, each in python_names(names).items()}


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
    names, comments = members(core), _comments(core)
    own = ["Core", *(["Call"] if core.steps else []), *(["Error"] if core.errors else [])]
    plan = _Core(
        function=core.function,
        version=f" {core.version}" if core.version else "",
        about=[sentence(core.description)] if core.description else [],
        typing_imports=_typing_imports(core),
        own_imports=imports(".support.core", own),
        declarations=declarations(core),
        digest=digest(core),
        stem=class_name(core.function),
        type=core_type(core),
        package=node.package,
        library=node.core_library,
        structs=struct_names(core),
        calls=core.steps,
        has_errors=bool(core.errors),
        monitors=node.monitors,
        learned=[(each.named.name, node.stored_keys[each.variable]) for each in node.learned],
        taken=[_taken(name, wire, comment, core) for name, wire, comment in _values(core)],
        methods=[_method(each, core) for each in core.methods],
        out=[
            _Sent(names[each], each, _type(core, each), comments[each], _value(each, core)) for each in out_names(core)
        ],
        publish=[_Told(names[each], each) for each in publish_names(core)],
    )
    return rendered("adapter/ros2/python/core.py.j2", plan)


def _typing_imports(core: CorePlan) -> str:
    taken = [typed(wire, is_sequence=True) for _, wire, _ in _values(core)]
    taken += ["Tuple[Dict[str, Any]"] * bool(core.methods)
    taken += ["Mapping[str, Any]"] * bool(core.requests)
    given = [_type(core, name) for name in out_names(core)]
    used = " ".join((*taken, *given))
    names = [
        name
        for name in ("Any", "Dict", "List", "Mapping", "Sequence", "Tuple")
        if f"{name}[" in used or (name == "Any" and "Any" in used)
    ]
    names += ["NamedTuple"] * bool(publish_names(core))
    return imports("typing", names)


def _outputs(core: CorePlan) -> dict[str, Output]:
    return {output.named.name: output for output in core.outputs}


def _wires(core: CorePlan) -> dict[str, WireType]:
    found = {name: output.value.wire for name, output in _outputs(core).items()}
    return found | {each.named.name: each.wire for each in core.statuses}


def _type(core: CorePlan, name: str) -> str:
    wire, output = _wires(core)[name], _outputs(core).get(name)
    return f"List[{typed(wire)}]" if output is not None and output.queue else typed(wire)


def _comments(core: CorePlan) -> dict[str, str]:
    found = (*core.outputs, *core.statuses, *core.methods)
    return {each.named.name: each.named.comment for each in found}


def _values(core: CorePlan) -> Iterator[tuple[str, WireType, str]]:
    """Received values: the name in the library, the type, and a comment."""
    yield from ((port.name, port.wire, port.comment) for port in core.ports)
    yield from ((each.named.name, each.wire, each.named.comment) for each in core.reactions)
    yield from ((each.name, each.wire, each.comment) for each in core.foreign_errors)
    if core.mode_in:
        yield core.mode_in.named.name, core.mode_in.wire, core.mode_in.named.comment


def _taken(name: str, wire: WireType, comment: str, core: CorePlan) -> _Taken:
    given = "value"
    if wire.length is not None:
        given = f"self._array({python_string(wire.c)}, value, {wire.length})"
    elif wire.is_struct:
        given = f"self._struct({python_string(wire.c)}, value)"
    function = f"{core.type_name}_Receive_{name}"
    return _Taken(receivers(core)[name], function, typed(wire, is_sequence=True), comment, given)


def _method(method: Method, core: CorePlan) -> _Method:
    own = argument_names(method, is_request=True)
    pairs = ", ".join(f"{python_string(each.name)}: {own[each.name]}" for each in method.arguments)
    return _Method(
        method_names(core)[method.named.name],
        method.named.name,
        method.named.comment or method.named.name,
        method.is_offered,
        [f"{each}: Any" for each in own.values()],
        f"{{{pairs}}}",
        bool(method.arguments),
        bool(method.results),
    )


def _value(name: str, core: CorePlan) -> str:
    wire, output = _wires(core)[name], _outputs(core).get(name)
    if output is not None and output.queue:
        return f"self._plain(found.{name}.values)[:found.{name}.count]"
    return f"self._plain(found.{name})" if wire.is_struct or wire.length is not None else f"found.{name}"
