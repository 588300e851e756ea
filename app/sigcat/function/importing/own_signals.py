"""Signals that the catalogue does not have, defined in the function file from what the code says of them."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.vocabulary import Vocabulary
from sigcat.errors import UsageError
from sigcat.function.importing.parameters import described, free_name, physical_definition, starting_with_letter
from sigcat.function.importing.signals import Signal
from sigcat.function.importing.units import unit_of


def checked_branch(path: str, catalogue: Catalogue) -> str:
    """The path of a branch that signals can be defined below. Raises UsageError."""
    root = catalogue.roots[0].path if catalogue.roots else "Vehicle"
    names = path.split(".")
    if names[0] != root or len(names) < 2 or not all(name.isascii() and name.isidentifier() for name in names):
        raise UsageError(f"--define-under must be the path of a branch such as {root}.Pump, not {path!r}")
    for length in range(2, len(names) + 1):
        node = catalogue.get(".".join(names[:length]))
        if node is not None and node.is_leaf:
            raise UsageError(f"--define-under must be the path of a branch; {node.path} is a {node.type}")
    return path


def defined_under(
    branch: str, function: str, signals: Sequence[Signal], catalogue: Catalogue
) -> tuple[tuple[Signal, ...], Mapping[str, Mapping[str, Any]]]:
    """The signals with a path below the branch where they had none, and the definitions of these paths."""
    parent = catalogue.get(branch)
    taken = {node.name.lower() for node in parent.children} if parent else set[str]()
    said: set[str] = set()
    made = tuple(each if each.is_chosen else _defined(each, branch, taken) for each in signals)
    own = [after for before, after in zip(signals, made, strict=True) if not before.is_chosen]
    definitions = {each.path: _definition(each, said, catalogue.vocabulary) for each in own}
    return made, {**dict(_branches(branch, function, catalogue)), **definitions} if own else {}


def _branches(branch: str, function: str, catalogue: Catalogue) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Branches that the catalogue does not have yet, the outermost first."""
    names = branch.split(".")
    for length in range(2, len(names) + 1):
        path = ".".join(names[:length])
        if catalogue.get(path) is None:
            words = f"Signals of the function {function}." if length == len(names) else f"Branch {names[length - 1]}."
            yield path, {"type": "branch", "description": words}


def _defined(signal: Signal, branch: str, taken: set[str]) -> Signal:
    name = starting_with_letter(signal.name)
    if signal.value.datatype == "boolean" and not name.startswith(("Is", "Has")):
        name = f"Is{name}"
    return signal._replace(path=f"{branch}.{free_name(name, taken)}", near=(), why="")


def _definition(signal: Signal, said: set[str], vocabulary: Vocabulary) -> Mapping[str, Any]:
    value = signal.value._replace(start=None)
    unit = unit_of(value.remark.units, vocabulary)
    description = described(value, signal.name, said, vocabulary, "Signal")
    definition = physical_definition(value, unit, description)
    del definition["default"]
    if signal.values:
        allowed = {"datatype": "string", "allowed": list(signal.values)}
        return {**allowed, "asil": definition["asil"], "description": description}
    return definition
