"""The names of `instances`, and how many nodes they make, without making any."""

import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from sigcat.catalogue.model.definition import instances_of
from sigcat.limits import COMPARED_INSTANCES

_LAST_RANGE = re.compile(r".*(\[(\d+),(\d+)\]).*")


def instance_names(entry: Any) -> Iterator[str]:
    """Names of one entry of `instances`: `Row[1,2]` → `Row1`, `Row2`."""
    for item in entry if isinstance(entry, list) else [entry]:
        text = str(item)
        match = _LAST_RANGE.match(text)
        if match is None:
            yield text
        else:
            for number in range(int(match[2]), int(match[3]) + 1):
                yield text.replace(match[1], str(number))


def count_instances(instances: Iterable[Any]) -> int:
    """Return the number of nodes that the instances of one branch add, without making them."""
    roots, total = 1, 0
    for entry in instances:
        count = sum(_range_length(str(item)) for item in (entry if isinstance(entry, list) else [entry]))
        total += roots * count
        if count > 1 or isinstance(entry, list):
            roots *= count
    return total


def levels_of_instances(values: Mapping[str, Any]) -> Iterator[frozenset[str]]:
    """Names of instances, level by level: a list of single names is one level, as is each list in a list.

    A range with a space, which is a finding, counts as the range that was meant: nothing else is reported because of it.
    """
    instances = [_meant(entry) for entry in instances_of(values)]
    singles = [entry for entry in instances if not isinstance(entry, list) and "[" not in str(entry)]
    if len(singles) == len(instances):
        if singles:
            yield frozenset(map(str, singles))
        return
    for entry in instances:
        yield frozenset(instance_names(entry)) if count_instances([entry]) <= COMPARED_INSTANCES else frozenset()


def _meant(entry: Any) -> Any:
    if isinstance(entry, list):
        return [_meant(item) for item in entry]
    return _SPACED_RANGE.sub(r"[\1,\2]", entry) if isinstance(entry, str) else entry


_SPACED_RANGE = re.compile(r"\[ *(\d+) *, *(\d+) *\]")


def _range_length(text: str) -> int:
    match = _LAST_RANGE.match(text)
    return max(int(match[3]) - int(match[2]) + 1, 0) if match else 1
