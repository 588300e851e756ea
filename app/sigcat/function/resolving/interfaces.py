"""References from a declaration to interfaces of the catalogue, and the attributes of those."""

from collections.abc import Callable
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.asil import LEVELS, Level, level_of
from sigcat.catalogue.model.catalogue import Node
from sigcat.catalogue.model.interfaces import Category, category_of, function_of, interface_name
from sigcat.findings import RuleCode
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Subject
from sigcat.function.document.text import Text
from sigcat.function.function_json.conversion import is_finite_number
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
        context.report(codes.INTERFACE_UNKNOWN, at, message, fix, Subject(category, reference))
        return None
    if actual != category:
        message = f"{reference!r} must be {with_article(_words(category))} interface, not {with_article(_words(actual))} interface."
        context.report(codes.INTERFACE_OF_ANOTHER_CATEGORY, at, message, subject=Subject(category, node.path))
        return None
    if own and function_of(node.path) != context.function:
        message = f"{interface_name(node.path)!r} must be an interface of {context.function}, not of {function_of(node.path)}."
        context.report(codes.INTERFACE_OF_ANOTHER_FUNCTION, at, message, subject=Subject(category, node.path))
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


class Attributes(NamedTuple):
    """Attributes of a node of the catalogue that a declaration refers to; one of the wrong kind is a problem there."""

    node: Node
    at: Pointer
    """Pointer of the reference in the declaration."""
    context: Context

    def text(self, name: str) -> str | None:
        """Value of an attribute that is a text."""
        value = self.node.values.get(name)
        return value if isinstance(value, str) else None

    @property
    def description(self) -> Text:
        """The description, whatever its kind."""
        return Text(str(self.node.values.get("description") or ""))

    @property
    def asil(self) -> Level | None:
        """The ASIL that the catalogue states; a text that is none counts as not stated."""
        value = self.node.values.get("ASILlevel")
        level = level_of(value)
        if value is not None and level is None:
            self._not_expected("ASILlevel", either(LEVELS), codes.ASIL_MISSPELLED)
        return level

    def number(self, name: str) -> float | None:
        """Value of an attribute that has to be a number."""
        number: float | None = self._of_kind(name, "a finite number", is_finite_number)
        return number

    def texts(self, name: str) -> tuple[str, ...]:
        """Value of an attribute that has to be a text or a list of texts."""
        value = self._of_kind(name, "a list of names", _is_of_texts)
        return (value,) if isinstance(value, str) else tuple(value or ())

    def mapping(self, name: str) -> dict[str, Any] | None:
        """Value of an attribute that has to be a mapping."""
        value: dict[str, Any] | None = self._of_kind(name, "a mapping", lambda value: isinstance(value, dict))
        return value

    def _of_kind(self, name: str, expected: str, is_fit: Callable[[Any], bool]) -> Any:
        value = self.node.values.get(name)
        if value is None or is_fit(value):
            return value
        self._not_expected(name, expected)
        return None

    def _not_expected(self, name: str, expected: str, rule: RuleCode = codes.VALUE_UNFIT) -> None:
        origin = self.node.definition.origin(name)
        value = repr(self.node.values.get(name))[:60]
        message = f"`{name}` of {self.node.path!r} must be {expected}, not {value} ({origin.file}:{origin.line})."
        self.context.report(rule, self.at, message, subject=Subject("data", self.node.path, (name,)))


def _is_of_texts(value: Any) -> bool:
    return all(isinstance(item, str) for item in (value if isinstance(value, list) else [value]))
