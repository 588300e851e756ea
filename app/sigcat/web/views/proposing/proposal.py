"""A proposed change of a node, or a new one: the fields of its form, and the overlay that they make."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import BRANCH, SIGNALS
from sigcat.function.extension.overlay import statement_text
from sigcat.function.importing.yaml_text import inline, scalar
from sigcat.web.views.node_view import ordered
from sigcat.web.views.overlay_draft import new_node

_OF_BRANCH = ("type", "description", "comment", "deprecation")
_OF_SIGNAL = ("type", "datatype", "unit", "min", "max", "default", "allowed", "description", "comment", "deprecation")
_TEXTS = frozenset(("type", "datatype", "unit", "description", "comment", "deprecation"))
"""Attributes that are entered as they are; all others as YAML has them."""
_LONG = frozenset(("description", "comment", "deprecation"))
_ALWAYS = ("type", "datatype")
"""Attributes that an overlay repeats: vss-tools requires them."""


class Field(NamedTuple):
    """An attribute in the form."""

    name: str
    value: str
    former: str
    """The value of the catalogue; empty for a new node."""

    @property
    def is_long(self) -> bool:
        """Whether it takes several lines."""
        return self.name in _LONG

    @property
    def is_changed(self) -> bool:
        """Whether the value is another one. A cleared field is not: an overlay cannot remove an attribute."""
        return bool(self.value) and self.value != self.former


class Proposal(NamedTuple):
    """A node as it is proposed."""

    path: str
    is_new: bool
    fields: tuple[Field, ...]

    @property
    def text(self) -> str:
        """The overlay: of a known node what differs, with type and datatype."""
        fields = [each for each in self.fields if each.is_changed or (each.value and each.name in _ALWAYS)]
        lines = "".join(map(_line, fields))
        return f"{scalar(self.path)}:\n{lines}"

    @property
    def cleared(self) -> tuple[str, ...]:
        """Attributes that were cleared, and stay."""
        return tuple(each.name for each in self.fields if each.former and not each.value)

    @property
    def whole_text(self) -> str:
        """An overlay with all values, to be edited as text."""
        return self._replace(fields=tuple(each._replace(former="") for each in self.fields)).text


def changing(node: Node, given: Callable[[str, str], str]) -> Proposal:
    """A change of a node. `given` returns the value of a field by its name, or else its second argument."""
    names = _OF_SIGNAL if node.is_leaf else _OF_BRANCH
    former = {name: _shown(name, node.values.get(name)) for name in ordered(dict.fromkeys((*names, *node.values)))}
    fields = tuple(Field(name, _one_line(name, given(name, value)), value) for name, value in former.items())
    return Proposal(node.path, is_new=False, fields=fields)


def adding(catalogue: Catalogue, node: Node, name: str, given: Callable[[str, str], str]) -> Proposal:
    """A new node below a branch, or beside a signal."""
    path, values = new_node(catalogue, node)
    branch, _, proposed = path.rpartition(".")
    names = ordered(dict.fromkeys((*_OF_SIGNAL, *values)))
    fields = tuple(Field(each, _one_line(each, given(each, _shown(each, values.get(each)))), "") for each in names)
    return Proposal(f"{branch}.{name or proposed}", is_new=True, fields=fields)


def types_for(proposal: Proposal) -> tuple[str, ...]:
    """Types that a node may get: a branch stays one."""
    return (BRANCH,) if not proposal.is_new and _type_of(proposal) == BRANCH else (*SIGNALS, BRANCH)


def _type_of(proposal: Proposal) -> str:
    return next((each.former for each in proposal.fields if each.name == "type"), "")


def _shown(name: str, value: Any) -> str:
    if value is None:
        return ""
    return " ".join(value.split()) if name in _TEXTS and isinstance(value, str) else inline(value)


def _one_line(name: str, text: str) -> str:
    """A value as entered. YAML that is entered stays in its line, so that it cannot add attributes."""
    return " ".join(text.split()) if name in _TEXTS else " ".join(text.splitlines()).strip()


def _line(field: Field) -> str:
    if field.name not in _TEXTS:
        return f"  {field.name}: {field.value}\n"
    _, _, text = statement_text("_", {field.name: field.value}).partition("\n")
    return text


def posted_fields(fields: Mapping[str, str]) -> Callable[[str, str], str]:
    """The values of a posted form; its fields are named `a.NAME`."""
    return lambda name, otherwise: fields.get(f"a.{name}", otherwise)
