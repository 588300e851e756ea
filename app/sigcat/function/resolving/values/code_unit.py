"""The unit and the scale in which the code holds a value."""

from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.model.catalogue import Node
from sigcat.catalogue.model.near_units import advice, near_unit
from sigcat.catalogue.model.vocabulary import Vocabulary
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.function_json.conversion import IDENTITY, Linear, between, same_kind
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.values.code_value import Item
from sigcat.function.resolving.values.numbers import fraction
from sigcat.names import did_you_mean


class CodeUnit(NamedTuple):
    """The code's unit, and the conversion from the catalogue's to it."""

    unit: str | None
    to_code: Linear = IDENTITY
    is_fit: bool = True
    """False if the unit is unknown or cannot be converted: a finding says so."""


def code_unit(item: Item, at: Pointer, node: Node, context: Context) -> CodeUnit:
    """The unit of an item in the code."""
    unit = node.values.get("unit")
    own = unit if isinstance(unit, str) else None
    if item.unit is None:
        return CodeUnit(own)
    vocabulary = context.catalogue.vocabulary
    known = vocabulary.unit(item.unit)
    if known is None and vocabulary.may_define(item.unit):
        return CodeUnit(own, is_fit=False)
    if known is None:
        fix = _meant(item.unit, own, vocabulary) if own else advice(item.unit, vocabulary)
        context.problems.append(_problem(item, at, f"Unknown unit {item.unit!r}.", fix))
        return CodeUnit(own, is_fit=False)
    if own is None:
        context.problems.append(_problem(item, at, f"{item.path!r} has no unit in the catalogue.", "Remove `unit`."))
        return CodeUnit(None, is_fit=False)
    conversion = between(own, known.key)
    if conversion is None:
        message = f"{own!r}, the unit in the catalogue, cannot be converted to {known.key!r}."
        context.problems.append(_problem(item, at, message, _convertible(own, vocabulary)))
    return CodeUnit(known.key, conversion or IDENTITY, conversion is not None)


def _meant(name: str, own: str, vocabulary: Vocabulary) -> str:
    """A sentence that names the unit that is meant, if a value of the catalogue's unit can be held in it; else all of these."""
    near = near_unit(name, vocabulary)
    if near is not None and between(own, near.key):
        return f"Write `{near.key}`: {near.name}."
    return did_you_mean(name, (own, *_same_kind(own, vocabulary))) or _convertible(own, vocabulary)


def _problem(item: Item, at: Pointer, message: str, fix: str) -> Problem:
    return Problem(codes.UNIT_NOT_CONVERTIBLE, (*at, "unit"), message, fix, Subject("data", item.path))


def _convertible(own: str, vocabulary: Vocabulary) -> str:
    """A sentence that names the units in which a value of the catalogue's unit can be held, by their keys."""
    kinds = _same_kind(own, vocabulary)
    return f"Use {own!r} or one that it converts to: {', '.join(kinds)}." if kinds else f"Use {own!r}."


def _same_kind(own: str, vocabulary: Vocabulary) -> tuple[str, ...]:
    return tuple(unit.key for unit in map(vocabulary.unit, same_kind(own)) if unit is not None)


def scale_of(item: Item, at: Pointer, context: Context) -> Linear:
    """From the stored value to the physical one."""
    if item.factor is None and item.offset is None:
        return IDENTITY
    if item.factor == 0:
        subject = Subject("data", item.path)
        message, fix = "`factor` must not be 0, which loses every value.", "Remove it, or give the scale of the code."
        context.report(codes.CONVERSION_LOSES_RANGE, (*at, "factor"), message, fix, subject)
        return IDENTITY
    return Linear(fraction(1 if item.factor is None else item.factor), fraction(item.offset or 0))
