"""Optional signals that the catalogue of a vehicle does not have: their types are those that it would have."""

from collections.abc import Mapping
from typing import Any

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.datatypes import is_array
from sigcat.catalogue.model.definition import STRUCT, Definition, instances_of
from sigcat.function.declaration.declaration import DataItem
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Subject
from sigcat.function.extension.sound_catalogue import sound_node
from sigcat.function.function_json.datatypes.primitive_types import BY_VSS
from sigcat.function.function_json.datatypes.type_list import smallest_integer
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.data_nodes import proposed


def is_absent(item: DataItem, context: Context) -> bool:
    """Whether a signal is optional, and the catalogue does not have it. A definition of instances is not a signal."""
    return bool(item.optional) and context.data(item.path) is None and item.path not in context.instances


def absent_node(item: DataItem, at: Pointer, context: Context) -> Node | None:
    """The node that an absent signal would be; None, with a problem, if nothing says its datatype."""
    subject, path = Subject("data", item.path), (*at, "path")
    removed = removed_node(item.path, context.catalogue)
    near = "" if removed else proposed(item.path, context)
    message = f"The catalogue has no signal {item.path!r}."
    node = removed or _declared_node(item, context)
    if node is None:
        fix = "Give `datatype`, that of the variable: nothing else says it without the catalogue."
        context.report(codes.DATATYPE_OF_ABSENT_UNKNOWN, path, message, near or fix, subject)
        return None
    message += (
        f" It is optional: {'its variable has the start value' if item.role == 'consumed' else 'it is not sent'}."
    )
    context.report(codes.OPTIONAL_SIGNAL_ABSENT, path, message, near, subject)
    return node


def removed_node(path: str, catalogue: Catalogue) -> Node | None:
    """The node at a path that an overlay or a vehicle removes, or one of an instance that it does not have."""
    definition: Definition | None = None
    below: Definition | None = None
    for name in path.split("."):
        below = catalogue.definitions.get(f"{definition.path}.{name}" if definition else name)
        if below is None and (definition is None or not instances_of(definition.values)):
            return None
        definition = below or definition
    return sound_node(Node(path, below, ())) if below is not None else None


def _declared_node(item: DataItem, context: Context) -> Node | None:
    """A node with the datatype of the declaration: an enumeration needs only its numbers."""
    datatype = item.datatype or (smallest_integer(item.values) if item.values else "")
    struct = context.catalogue.get(datatype)
    if (datatype not in BY_VSS or is_array(datatype)) and (struct is None or struct.type != STRUCT):
        return None
    values: Mapping[str, Any] = {
        "type": "sensor" if item.role == "consumed" else "actuator",
        "datatype": datatype,
        "description": "A signal that the vehicle does not have.",
        "unit": item.unit,
        "enum": item.values,
    }
    given = {name: value for name, value in values.items() if value is not None}
    return Node(item.path, Definition(item.path, (), given), ())
