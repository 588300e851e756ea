"""Shipped rules, read from YAML once and kept the way Python keeps compiled modules.

To read the records takes longer than to lint a changed file. They are read again when the size or time of a rule file
changes, or that of the code that reads rule files.
"""

from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any

from sigcat.catalogue.reading import yaml_document
from sigcat.compiled_values import Stamp, read_values, stamp_of, stamp_of_values, write_values
from sigcat.rules import record
from sigcat.rules.record import Nodes, Rule, load_rule_files

CODE = (Path(__file__), Path(record.__file__), Path(yaml_document.__file__))
"""Functions that decide which values a record has."""


def compiled_rules(folder: Path) -> tuple[Rule, ...]:
    """Return what `load_rules` returns, without reading the files again. Raises InputRefused with all findings."""
    files = tuple(sorted(folder.glob("*.yaml")))
    return _compiled_rules(folder, files, stamp_of((*files, *CODE)), stamp_of_values(folder, "rules"))


@lru_cache(maxsize=4)
def _compiled_rules(folder: Path, files: Sequence[Path], stamp: Stamp, _of_values: Stamp) -> tuple[Rule, ...]:
    records = read_values(folder, "rules", stamp)
    if records is not None:
        return tuple(map(_rule, records))
    rules = load_rule_files(files, trusted=True)
    write_values(folder, "rules", stamp, [_values(rule) for rule in rules])
    return rules


def _values(rule: Rule) -> tuple[Any, ...]:
    """The fields of a rule in types that marshal knows."""
    *values, nodes = rule
    return (*values, tuple(nodes))


def _rule(values: Sequence[Any]) -> Rule:
    *own, nodes = values
    return Rule._make((*own, Nodes._make(nodes)))
