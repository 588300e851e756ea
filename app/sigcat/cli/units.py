"""`sigcat units [WORD...]` and `sigcat units convert NUMBER UNIT UNIT`."""

import argparse
import json
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from sigcat.cli.tree_options import add_tree_options, read_tree
from sigcat.errors import NotFound, UsageError
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from fractions import Fraction

    from sigcat.catalogue.model.vocabulary import Unit, Vocabulary

_CONVERT = "convert"
_LARGEST_DENOMINATOR = 1_000_000
"""Fractions with a larger one come of pi, and say nothing to a reader."""


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "units",
        help="list, search and convert units",
        description="List the units and quantities of a catalogue, each unit with its factor to the base unit, or those that have all "
        "of the words in key, name, definition or quantity. `sigcat units convert 100 km/h m/s` converts a number.",
    )
    parser.add_argument("words", nargs="*", metavar="WORD", help="words to search for, or: convert NUMBER UNIT UNIT")
    parser.add_argument("--format", choices=("text", "json"), default="text", help="default: %(default)s")
    add_tree_options(parser)
    parser.set_defaults(run=units)


def units(arguments: argparse.Namespace) -> int:
    """Print the units, or a number that is converted. Raises NotFound where nothing matches."""
    vocabulary = read_tree(arguments, expanded=False, for_units=True).vocabulary
    if arguments.words[:1] == [_CONVERT]:
        print(_converted(arguments.words[1:], vocabulary))
        return 0
    found = _found([word.lower() for word in arguments.words], vocabulary)
    if not found:
        raise NotFound(_nothing_found(arguments.words, vocabulary))
    if arguments.format == "json":
        print(json.dumps([_data(unit) for units in found.values() for unit in units], indent=2, ensure_ascii=False))
    else:
        print("\n".join(map(printable, _lines(found, vocabulary))))
    return 0


def _found(words: "Sequence[str]", vocabulary: "Vocabulary") -> "Mapping[str, Sequence[Unit]]":
    """Return the units that have all of the words, by quantity."""
    from sigcat.catalogue.model.near_units import spellings_of

    found: dict[str, list[Unit]] = {}
    for unit in sorted(vocabulary.distinct_units, key=lambda unit: unit.quantity):
        text = " ".join((unit.key, unit.name, unit.definition, unit.quantity, spellings_of(unit))).lower()
        if all(word in text for word in words):
            found.setdefault(unit.quantity, []).append(unit)
    return found


def _nothing_found(words: "Sequence[str]", vocabulary: "Vocabulary") -> str:
    from sigcat.catalogue.model.near_units import advice

    return f"no unit matches {' '.join(words)!r}. {advice(' '.join(words), vocabulary)}"


def _lines(found: "Mapping[str, Sequence[Unit]]", vocabulary: "Vocabulary") -> "Iterator[str]":
    for quantity, units in found.items():
        known = vocabulary.quantities.get(quantity.lower())
        yield f"{quantity}: {known.definition}" if known and known.definition else quantity
        for unit in units:
            yield f"  {unit.key:12} {unit.name:32} {_factor_text(unit, vocabulary)}".rstrip()


def _factor_text(unit: "Unit", vocabulary: "Vocabulary") -> str:
    """Return what one of a unit is in the base unit."""
    from sigcat.function.function_json.conversion import base_of, between

    base = base_of(unit.key)
    linear = between(unit.key, base) if base else None
    if base is None or linear is None or base == unit.key.lower():
        return ""
    offset = f" {'-' if linear.offset < 0 else '+'} {_number(abs(linear.offset))}" if linear.offset else ""
    known = vocabulary.unit(base)
    return f"= {_number(linear.factor)} {known.key if known else base}{offset}"


def _data(unit: "Unit") -> dict[str, Any]:
    from sigcat.function.function_json.conversion import base_of, between

    base = base_of(unit.key)
    linear = between(unit.key, base) if base else None
    return {
        "key": unit.key,
        "name": unit.name,
        "quantity": unit.quantity,
        "definition": unit.definition,
        "allowedDatatypes": list(unit.allowed_datatypes),
        "file": unit.origin.file,
        "line": unit.origin.line,
        **({"base": base, "factor": float(linear.factor), "offset": float(linear.offset)} if linear else {}),
    }


def _converted(given: "Sequence[str]", vocabulary: "Vocabulary") -> str:
    """Return the sentence that a number in one unit is another number in another unit. Raises UsageError, NotFound."""
    from sigcat.function.function_json.conversion import between, of_text

    if len(given) != 3:
        raise UsageError("write a number and two units: sigcat units convert 100 km/h m/s")
    number = of_text(given[0])
    if number is None:
        raise UsageError(
            f"{given[0][:80]!r} is not a number that a double holds: write one first, as in sigcat units convert 100 km/h m/s"
        )
    source, target = (_unit(name, vocabulary) for name in given[1:])
    linear = between(source.key, target.key)
    if linear is None:
        raise UsageError(_not_convertible(source, target))
    return f"{given[0]} {source.key} = {_number(linear(number))} {target.key}"


def _unit(name: str, vocabulary: "Vocabulary") -> "Unit":
    from sigcat.catalogue.model.near_units import advice, near_unit

    unit = vocabulary.unit(name) or near_unit(name, vocabulary)
    if unit is None:
        raise NotFound(f"unknown unit {name!r}. {advice(name, vocabulary)}")
    return unit


def _not_convertible(source: "Unit", target: "Unit") -> str:
    from sigcat.function.function_json.conversion import same_kind

    others = same_kind(source.key)
    hint = f" {source.key} converts to {', '.join(others)}." if others else ""
    return f"{source.key} ({source.quantity}) cannot be converted to {target.key} ({target.quantity}).{hint}"


def _number(number: "Fraction") -> str:
    """Return a number as text: exact where it ends, else the nearest double with the fraction behind it."""
    from sigcat.function.function_json.conversion import as_text

    exact = as_text(number)
    if "/" not in exact:
        return exact
    is_told = number.denominator <= _LARGEST_DENOMINATOR
    return f"{float(number)!r} ({exact})" if is_told else repr(float(number))
