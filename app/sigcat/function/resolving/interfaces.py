"""References from a declaration to interfaces of the catalogue, and the attributes of those."""

from math import isfinite
from typing import Any

from sigcat import codes
from sigcat.asil import LEVELS, Level, level_of
from sigcat.catalogue.model.catalogue import Node
from sigcat.catalogue.model.interfaces import Category, category_of, function_of, interface_name
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.resolving.context import Context
from sigcat.names import did_you_mean, either, with_article


def interface_node(
    reference: str, category: Category, at: Pointer, context: Context, *, own: bool = False
) -> Node | None:
    """The node of an interface given by name or path; None, with a problem, if it is not there or of another category.

    Of an interface of the function itself the last name is enough. With `own`, it has to be one of those.
    """
    node = context.node(reference, category)
    actual = category_of(node.path) if node is not None else None
    if node is None or actual is None:
        message = f"The catalogue has no {_words(category)} interface {reference!r}."
        fix = _meant(reference, category, context)
        context.problems.append(Problem(codes.INTERFACE_UNKNOWN, at, message, fix, Subject(category, reference)))
        return None
    if actual != category:
        message = f"{reference!r} must be {with_article(_words(category))} interface, not {with_article(_words(actual))} interface."
        context.problems.append(
            Problem(codes.INTERFACE_OF_ANOTHER_CATEGORY, at, message, subject=Subject(category, node.path))
        )
        return None
    if own and function_of(node.path) != context.function:
        message = f"{interface_name(node.path)!r} must be an interface of {context.function}, not of {function_of(node.path)}."
        context.problems.append(
            Problem(codes.INTERFACE_OF_ANOTHER_FUNCTION, at, message, subject=Subject(category, node.path))
        )
        return None
    return node


def error_name(reference: str | None, at: Pointer, context: Context) -> str | None:
    """The interface name of an error that is given by name or path; whether the function declares it is checked later."""
    node = interface_node(reference, "error", at, context) if reference is not None else None
    return interface_name(node.path) if node is not None else None


def _meant(reference: str, category: Category, context: Context) -> str:
    """Advice: an interface of a near name."""
    hint = did_you_mean(reference, context.names(category)) or did_you_mean(reference, context.own_names(category))
    return hint or f"Define it under `define`, or in an overlay of {_words(category)} interfaces."


def _words(category: Category) -> str:
    return category.replace("_", " ")


# -- attributes ---------------------------------------------------------------------------------------------------


def text_of(node: Node, name: str) -> str | None:
    """Value of an attribute that is a text."""
    value = node.values.get(name)
    return value if isinstance(value, str) else None


def asil_of(node: Node, at: Pointer, context: Context) -> Level | None:
    """The ASIL that the catalogue states; a text that is none counts as not stated."""
    value = node.values.get("ASILlevel")
    level = level_of(value)
    if value is not None and level is None:
        context.problems.append(
            _not_expected(node, "ASILlevel", either(LEVELS), at)._replace(rule=codes.ASIL_MISSPELLED)
        )
    return level


def number_of(node: Node, name: str, at: Pointer, context: Context) -> float | None:
    """Value of an attribute that has to be a number."""
    value = node.values.get(name)
    if value is None or (isinstance(value, int | float) and not isinstance(value, bool) and isfinite(value)):
        return value
    context.problems.append(_not_expected(node, name, "a finite number", at))
    return None


def texts_of(node: Node, name: str, at: Pointer, context: Context) -> tuple[str, ...]:
    """Value of an attribute that has to be a text or a list of texts."""
    value = node.values.get(name)
    values = [] if value is None else value if isinstance(value, list) else [value]
    if all(isinstance(item, str) for item in values):
        return tuple(values)
    context.problems.append(_not_expected(node, name, "a list of names", at))
    return ()


def mapping_of(node: Node, name: str, at: Pointer, context: Context) -> dict[str, Any] | None:
    """Value of an attribute that has to be a mapping."""
    value = node.values.get(name)
    if value is None or isinstance(value, dict):
        return value
    context.problems.append(_not_expected(node, name, "a mapping", at))
    return None


def _not_expected(node: Node, name: str, expected: str, at: Pointer) -> Problem:
    origin = node.definition.origin(name)
    value = repr(node.values.get(name))[:60]
    message = f"`{name}` of {node.path!r} must be {expected}, not {value} ({origin.file}:{origin.line})."
    return Problem(codes.VALUE_UNFIT, at, message, subject=Subject("data", node.path, (name,)))
