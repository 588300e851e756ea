"""Numbers of Protocol Buffers fields that stay from export to export, in a lock file.

vss-tools numbers fields by position, so a new node renumbers those after it. With its option `--static-uid` it takes the
number from an attribute of each node. `with_numbers` gives it a tree with these attributes; its output stays as it is.
"""

import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.datatypes import element_of
from sigcat.catalogue.model.definition import Definition
from sigcat.errors import InputRefused, UsageError
from sigcat.limits import DEFAULT_LIMITS, Limits

ATTRIBUTE = "staticUID"
"""The attribute that `--static-uid` reads."""
_PER_NUMBER = 8
"""vss-tools divides the attribute by this."""
_LARGEST = 2**29 - 1
_RESERVED = range(19_000, 20_000)
_SHAPE = "Give the newer field an unused number, or take the file from git. Without it, all fields get other numbers."

Messages = Mapping[str, Mapping[str, int]]
Enumerations = Mapping[str, Sequence[str]]


class Lock(NamedTuple):
    """Numbers of fields by path of the branch or struct, and texts of enumerations in the order of their numbers."""

    messages: Messages
    enumerations: Enumerations


EMPTY = Lock({}, {})


def read_lock(path: Path, limits: Limits = DEFAULT_LIMITS) -> Lock:
    """Read a lock. Raises InputRefused if the file is not one."""
    if path.stat().st_size > limits.file_bytes:
        message = f"The file has {path.stat().st_size:,} bytes; the limit is {limits.file_bytes:,}."
        raise InputRefused(
            f"{path} is not a file of --keep-numbers-of", (codes.FILE_TOO_LARGE.finding(message, str(path)),)
        )
    try:
        content = json.loads(path.read_bytes())
    except (ValueError, RecursionError) as error:
        raise _refused(path, f"The file must be JSON: {error}.", getattr(error, "lineno", 1)) from error
    problem = next(_problems(content), "")
    if problem:
        raise _refused(path, problem)
    return Lock(content["messages"], content["enumerations"])


def lock_bytes(lock: Lock) -> bytes:
    """Return a lock as the file has it: sorted, so that a change is a short difference."""
    return (json.dumps(lock._asdict(), indent=2, ensure_ascii=False, sort_keys=True) + "\n").encode()


def continued(lock: Lock, catalogue: Catalogue) -> Lock:
    """Return the lock with numbers for new fields. A number is never given twice, also if its field is gone."""
    parents = [node for node in catalogue.nodes.values() if node.children]
    messages = {node.path: _numbers(lock.messages.get(node.path, {}), node) for node in parents}
    labelled = {path: node for path, node in catalogue.nodes.items() if _labels(node)}
    enumerations = {path: _ordered(lock.enumerations.get(path, ()), node) for path, node in labelled.items()}
    return Lock({**lock.messages, **messages}, {**lock.enumerations, **enumerations})


def with_numbers(catalogue: Catalogue, lock: Lock) -> Catalogue:
    """Return the expanded tree with the number of each field as the attribute that vss-tools reads."""
    numbers = {f"{path}.{name}": number for path, fields in lock.messages.items() for name, number in fields.items()}
    roots = tuple(_numbered(root, numbers, lock.enumerations) for root in catalogue.roots)
    definitions = {node.path: node.definition for node in roots[0].walk()}
    return Catalogue(
        catalogue.name, roots, catalogue.vocabulary, catalogue.layers, catalogue.findings, definitions, is_expanded=True
    )


def _numbers(known: Mapping[str, int], node: Node) -> Mapping[str, int]:
    numbers = dict(known)
    for child in node.children:
        if child.name not in numbers:
            numbers[child.name] = _next(max(numbers.values(), default=0))
    return numbers


def _next(number: int) -> int:
    """Return the number after the largest one. Raises UsageError if Protocol Buffers have none."""
    if number >= _LARGEST:
        raise UsageError(
            f"a message has the number {_LARGEST}, and Protocol Buffers have no larger one: change it in the file"
        )
    return _RESERVED.stop if number + 1 in _RESERVED else number + 1


def _labels(node: Node) -> Sequence[Any]:
    """The texts that the value may have: vss-tools makes an enumeration of them."""
    allowed = node.values.get("allowed")
    is_text = element_of(str(node.values.get("datatype"))) == "string"
    return allowed if is_text and isinstance(allowed, list) else ()


def _ordered(known: Sequence[str], node: Node) -> Sequence[str]:
    """Return the texts in the order of their numbers. One that is gone keeps its place: vss-tools counts by position."""
    return [*known, *(str(label) for label in _labels(node) if str(label) not in known)]


def _numbered(node: Node, numbers: Mapping[str, int], enumerations: Enumerations) -> Node:
    children = tuple(_numbered(child, numbers, enumerations) for child in node.children)
    values = {name: value for name, value in node.values.items() if name != "instances"}
    values[ATTRIBUTE] = hex(numbers.get(node.path, 1) * _PER_NUMBER)
    if _labels(node):
        values["allowed"] = list(enumerations[node.path])
    definition = Definition(node.path, node.definition.statements, values, node.definition.problems)
    return Node(node.path, definition, children)


# -- checks of a lock --------------------------------------------------------------------------------------


def _problems(content: Any) -> Iterator[str]:
    if not isinstance(content, dict) or set(content) != {"messages", "enumerations"}:
        yield "The file must be an object with `messages` and `enumerations`."
        return
    for name, value in content.items():
        if not isinstance(value, dict):
            yield f"`{name}` must be an object."
            return
    for path, fields in content["messages"].items():
        yield from _problems_of_fields(path, fields)
    for path, labels in content["enumerations"].items():
        if not isinstance(labels, list) or not all(isinstance(label, str) for label in labels):
            yield f"{path[:100]} must have a list of texts."
        elif len(set(labels)) < len(labels):
            yield f"{path[:100]} must not have a text twice."


def _problems_of_fields(path: str, fields: Any) -> Iterator[str]:
    if not isinstance(fields, dict):
        yield f"{path[:100]} must have an object of numbers."
        return
    for name, number in fields.items():
        if type(number) is not int or not 1 <= number <= _LARGEST or number in _RESERVED:
            yield f"The number of {path[:100]}.{name[:100]} must be from 1 to {_LARGEST}, and not from 19000 to 19999."
    first: dict[Any, str] = {}
    for name, number in fields.items():
        other = first.setdefault(str(number), name)
        if other != name:
            yield f"{path[:100]}.{other[:100]} and {path[:100]}.{name[:100]} must not both have the number {number}."


def _refused(path: Path, message: str, line: int = 1) -> InputRefused:
    return InputRefused(
        f"{path} is not a file of --keep-numbers-of",
        (codes.NOT_A_MAPPING.finding(message, str(path), line, 1, fix=_SHAPE),),
    )
