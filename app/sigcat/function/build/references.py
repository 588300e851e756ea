"""References from a declaration to interfaces of the catalogue, and the attributes of those."""

from typing import Any

from sigcat.catalogue.model.catalogue import Node
from sigcat.catalogue.model.interfaces import Category, category_of, function_of, interface_name
from sigcat.function.build.work import Work
from sigcat.function.document.document import Pointer


def interface_node(reference: str, category: Category, at: Pointer, work: Work, *, own: bool = False) -> Node | None:
    """The node of an interface given by name or path; None, with a finding, if it is not there or of another category.

    Of an interface of the function itself the last name is enough. With `own`, it has to be one of those.
    """
    node = work.node(reference) or work.own(reference, category)
    words = category.replace("_", " ")
    if node is None or category_of(node.path) is None:
        fix = _meant(reference, category, work)
        work.report("F013", at, f"The catalogue has no {words} interface {reference!r}.", fix, reference)
        return None
    actual = category_of(node.path)
    if actual != category:
        message = f"{reference!r} is a {str(actual).replace('_', ' ')} interface, not a {words} interface."
        work.report("F014", at, message, path=node.path)
        return None
    if own and function_of(node.path) != work.function:
        message = f"{interface_name(node.path)!r} belongs to {function_of(node.path)}, not to {work.function}."
        work.report("F015", at, message, path=node.path)
        return None
    return node


def _meant(reference: str, category: Category, work: Work) -> str:
    """What to write instead: an interface of a near name."""
    candidates = [name for name, path in work.interfaces.items() if category_of(path) == category]
    words = category.replace("_", " ")
    hint = work.hint(reference, candidates) or work.hint(reference, work.own_names(category))
    return hint or f"Define it under `define`, or in an overlay of {words} interfaces."


def text_of(node: Node, name: str) -> str | None:
    """Value of an attribute that is a text."""
    value = node.values.get(name)
    return value if isinstance(value, str) else None


def number_of(node: Node, name: str, at: Pointer, work: Work) -> float | None:
    """Value of an attribute that has to be a number."""
    value = node.values.get(name)
    if value is None or (isinstance(value, int | float) and not isinstance(value, bool)):
        return value
    _report(node, name, "a number", at, work)
    return None


def texts_of(node: Node, name: str, at: Pointer, work: Work) -> tuple[str, ...]:
    """Value of an attribute that has to be a text or a list of texts."""
    value = node.values.get(name)
    values = [] if value is None else value if isinstance(value, list) else [value]
    if all(isinstance(item, str) for item in values):
        return tuple(values)
    _report(node, name, "a list of names", at, work)
    return ()


def mapping_of(node: Node, name: str, at: Pointer, work: Work) -> dict[str, Any] | None:
    """Value of an attribute that has to be a mapping."""
    value = node.values.get(name)
    if value is None or isinstance(value, dict):
        return value
    _report(node, name, "a mapping", at, work)
    return None


def _report(node: Node, name: str, expected: str, at: Pointer, work: Work) -> None:
    origin = node.definition.origin(name)
    value = repr(node.values.get(name))[:60]
    message = f"`{name}` of {node.path!r} is {value}: {expected} belongs there ({origin.file}:{origin.line})."
    work.report("F004", at, message, path=node.path)
