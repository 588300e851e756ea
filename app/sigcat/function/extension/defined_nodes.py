"""Nodes of the catalogue that a declaration defines: paths, attributes, and pointers into the file."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.function.declaration.declaration import Declaration
from sigcat.function.declaration.define_section import (
    CallDefinition,
    DefineSection,
    ErrorDefinition,
    ModesDefinition,
    ReactionDefinition,
    StructDefinition,
)
from sigcat.function.declaration.form import DeclarationModel, key_of
from sigcat.function.document.document import Pointer

ERROR_STATES = {"PASSED": 0, "FAILED": 1}
CONDITION_STATES = {"INACTIVE": 0, "ACTIVE": 1}
_RUN_TYPES = {"Init": "Init", "Terminate": "Shutdown"}


class DefinedNode(NamedTuple):
    """A node of the catalogue that a declaration defines: its path, its attributes, and where they stand."""

    path: str
    values: Mapping[str, Any]
    at: Pointer
    """Pointer of the node in the declaration."""
    keys: Mapping[str, str] = {}
    """Keys of the declaration by attribute, where they are spelled differently."""
    described_at: Pointer = ()
    """Pointer of its description, if that is the function's."""

    def pointer(self, attribute: str) -> Pointer:
        """Pointer of an attribute, written or not."""
        if attribute == "description" and self.described_at:
            return self.described_at
        return (*self.at, self.keys.get(attribute, attribute)) if attribute else self.at


@dataclass(frozen=True)
class Definitions:
    """The nodes that one declaration adds to the catalogue, and the struct types."""

    nodes: tuple[DefinedNode, ...] = ()
    types: tuple[DefinedNode, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.nodes or self.types)

    @cached_property
    def by_path(self) -> Mapping[str, DefinedNode]:
        """The nodes by their paths."""
        return {node.path: node for node in self.nodes}


def definitions_of(declaration: Declaration, catalogue: Catalogue) -> Definitions:
    """Everything that a declaration defines, branches above first."""
    if declaration.define is None:
        return Definitions()
    return Definitions(_nodes(declaration, declaration.define, catalogue), _types(declaration, declaration.define))


def _nodes(declaration: Declaration, define: DefineSection, catalogue: Catalogue) -> tuple[DefinedNode, ...]:
    nodes = [*_data(define), *_interfaces(declaration, define)]
    root = catalogue.roots[0].path if catalogue.roots else "Vehicle"
    nodes = [
        node._replace(path=f"{root}.{node.path.partition('.')[2]}") if node.at[1] != "data" else node for node in nodes
    ]
    return (*_branches(declaration, nodes, root, catalogue), *nodes)


def _types(declaration: Declaration, define: DefineSection) -> tuple[DefinedNode, ...]:
    nodes: dict[str, DefinedNode] = {}
    for path, struct in define.types.items():
        at = ("define", "types", path)
        for above in _above(path):
            if above not in define.types:
                text = f"Struct types of the function {declaration.function}."
                nodes.setdefault(above, DefinedNode(above, {"type": "branch", "description": text}, at))
        nodes |= {node.path: node for node in _struct(path, struct, at)}
    return tuple(nodes.values())


# -- branches -----------------------------------------------------------------------------------------------------

_GROUPS = {
    "Parameter": "Parameters of the function {0}.",
    "Error": "Errors that the function {0} reports.",
    "SafetyReaction": "Safety conditions to which the function {0} reacts.",
    "Mode": "Modes of the function {0}.",
    "Scheduling": "Calls of the function {0}.",
}


def _branches(
    declaration: Declaration, nodes: list[DefinedNode], root: str, catalogue: Catalogue
) -> Iterator[DefinedNode]:
    """Branches of the function that the nodes need; those that the catalogue has are said again in its words."""
    own = f"{root}.Function.{declaration.function}"
    texts = {
        f"{root}.Function": "Software functions with the interfaces that are neither data nor parameters.",
        own: declaration.description,
        **{f"{own}.{name}": text.format(declaration.function) for name, text in _GROUPS.items()},
    }
    needed = {above: node.at[:2] for node in reversed(nodes) for above in _above(node.path) if node.at[1] != "data"}
    for path, text in texts.items():
        if path in needed:
            known = catalogue.get(path)
            description = known.values.get("description", text) if known else text
            described_at: Pointer = ("description",) if description is declaration.description else ()
            values = {"type": "branch", "description": description}
            yield DefinedNode(path, values, needed[path], described_at=described_at)


def _above(path: str) -> Iterator[str]:
    names = path.split(".")
    return (".".join(names[:length]) for length in range(1, len(names)))


# -- nodes --------------------------------------------------------------------------------------------------------

_SPELLED = {"ASILlevel": "asil"}
_ATTRIBUTES = {key: attribute for attribute, key in _SPELLED.items()}


def _data(define: DefineSection) -> Iterator[DefinedNode]:
    for path, item in define.data.items():
        yield DefinedNode(path, _attributes(item), ("define", "data", path), _SPELLED)


def _interfaces(declaration: Declaration, define: DefineSection) -> Iterator[DefinedNode]:
    own = f".Function.{declaration.function}"
    names = _Names(declaration.function, define)
    for name, parameter in define.parameters.items():
        values = _attributes(parameter, type="attribute")
        yield DefinedNode(f"{own}.Parameter.{name}", values, ("define", "parameters", name), _SPELLED)
    for name, error in define.errors.items():
        yield DefinedNode(f"{own}.Error.{name}", _error(error, names), ("define", "errors", name), _SPELLED)
    for name, reaction in define.safety_reactions.items():
        at = ("define", "safetyReactions", name)
        yield DefinedNode(f"{own}.SafetyReaction.{name}", _reaction(reaction, names), at, _SPELLED)
    yield from _modes(own, define.modes)
    for name, call in define.scheduling.items():
        at = ("define", "scheduling", name)
        yield DefinedNode(f"{own}.Scheduling.{name}", _call(name, call, names), at, _SPELLED)


def _modes(own: str, modes: ModesDefinition | None) -> Iterator[DefinedNode]:
    items = (("In", "in", "sensor", modes and modes.in_), ("Out", "out", "actuator", modes and modes.out))
    for name, key, kind, item in items:
        if item:
            values = {"type": kind, "datatype": "string", "allowed": item.allowed, "description": item.description}
            yield DefinedNode(f"{own}.Mode.{name}", values, ("define", "modes", key))


def _struct(path: str, struct: StructDefinition, at: Pointer) -> Iterator[DefinedNode]:
    yield DefinedNode(path, {"type": "struct", "description": struct.description}, at)
    for name, field in struct.fields.items():
        yield DefinedNode(f"{path}.{name}", _attributes(field, type="property"), (*at, "fields", name), _SPELLED)


class _Names(NamedTuple):
    """Interface names of the file's definitions, by last name."""

    function: str
    define: DefineSection

    def error(self, name: str) -> str:
        """Interface name of an error: `AliveError` → `CoreAcc_AliveError_ErrorSts` if the file defines it."""
        return f"{self.function}_{name}_ErrorSts" if name in self.define.errors else name

    def call(self, name: str) -> str:
        """Interface name of a call: `Init` → `CoreAcc_Init`."""
        return f"{self.function}_{name}" if name in self.define.scheduling else name


_OF_CALLS = ("runType", "cycleTime", "executionOffset", "priority", "scheduling", "debounceTime", "previousRunnable")
_OF_VALUES = ("datatype", "arraysize", "allowed", "enum", "unit", "min", "max", "default", "resolution")
_OF_STATUSES = ("maturationTime", "severity", "resetTime", "resetCondition", "dependency", "errorList")
_OF_SUPERVISION = ("supervisionType", "aliveSupervision", "deadlineSupervision", "logicalSupervision", "stackSize")
_ORDER = ("type", *_OF_CALLS, *_OF_VALUES, *_OF_STATUSES, "ASILlevel", *_OF_SUPERVISION, "description", "comment")
"""Attributes in the order in which overlays have them."""


def _attributes(item: DeclarationModel, **others: Any) -> dict[str, Any]:
    """The attributes of a definition that have a value; `others` are those that are not as the author wrote them."""
    own = {_ATTRIBUTES.get(field, key_of(field)): getattr(item, field) for field in type(item).model_fields}
    given = {**own, **others}
    return {name: given[name] for name in _ORDER if given.get(name) is not None}


def _error(item: ErrorDefinition, names: _Names) -> dict[str, Any]:
    dependency = [names.error(name) for name in item.dependency] or None
    return _attributes(item, type="sensor", enum=item.enum or ERROR_STATES, dependency=dependency)


def _reaction(item: ReactionDefinition, names: _Names) -> dict[str, Any]:
    errors = [names.error(name) for name in item.error_list] or None
    return _attributes(item, type="sensor", enum=item.enum or CONDITION_STATES, errorList=errors)


def _call(name: str, item: CallDefinition, names: _Names) -> dict[str, Any]:
    supervised = {
        "Alive": _supervision(item.alive_supervision, names),
        "Deadline": _supervision(item.deadline_supervision, names),
        "Logical": _supervision(item.logical_supervision, names),
    }
    kinds = [kind for kind, limits in supervised.items() if limits]
    is_step = name not in _RUN_TYPES
    return _attributes(
        item,
        type="branch",
        runType=item.run_type or _RUN_TYPES.get(name, "Cyclic"),
        previousRunnable=names.call(item.previous_runnable) if item.previous_runnable else None,
        supervisionType=(kinds or "None") if kinds or is_step else None,
        **{f"{kind.lower()}Supervision": limits for kind, limits in supervised.items()},
    )


def _supervision(item: Any, names: _Names) -> dict[str, Any] | None:
    if item is None:
        return None
    values: dict[str, Any] = item.model_dump(by_alias=True, exclude_none=True)
    return {**values, "error": names.error(values["error"])}
