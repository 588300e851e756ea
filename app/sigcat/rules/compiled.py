"""Shipped rules, read from YAML once and kept the way Python keeps compiled modules.

To read the records takes longer than to lint a changed file. Their values are kept in `__pycache__` beside the files,
which is writable only for those who may change the rules. They are read again when the size or time of a rule file
changes, or that of the code that reads rule files.
"""

import marshal
import os
import sys
from collections.abc import Iterable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from sigcat import __version__
from sigcat.catalogue.reading import yaml_document
from sigcat.rules import record
from sigcat.rules.record import Nodes, Rule, load_rule_files

CODE = (Path(__file__), Path(record.__file__), Path(yaml_document.__file__))
"""What decides which values a record has."""

_Stamp = tuple[tuple[str, int, int], ...]


def compiled_rules(folder: Path) -> tuple[Rule, ...]:
    """What `load_rules` gives, without reading the files again. Raises InputRefused with all findings."""
    files = sorted(folder.glob("*.yaml"))
    stamp = _stamp((*files, *CODE))
    compiled = folder / "__pycache__" / f"rules-{__version__}.{sys.implementation.cache_tag}.marshal"
    rules = _read(compiled, stamp)
    if rules is None:
        rules = load_rule_files(files, trusted=True)
        if stamp and not sys.dont_write_bytecode and not sys.pycache_prefix:
            _write(compiled, stamp, rules)
    return rules


def _stamp(files: Iterable[Path]) -> _Stamp:
    """Name, size and time of each file; nothing if one cannot be found, as in a zipped package."""
    try:
        stats = [(str(file), file.stat()) for file in files]
    except OSError:
        return ()
    return tuple((name, stat.st_size, stat.st_mtime_ns) for name, stat in stats)


def _read(file: Path, stamp: _Stamp) -> tuple[Rule, ...] | None:
    try:
        written, records = marshal.loads(file.read_bytes())  # noqa: S302 — trusted as compiled Python is, see above
        return tuple(map(_rule, records)) if stamp and written == stamp else None
    except (OSError, ValueError, TypeError, EOFError):
        return None


def _write(file: Path, stamp: _Stamp, rules: Sequence[Rule]) -> None:
    """Write the rules if the folder can be written, whole or not at all: several linters may start at once."""
    temporary = file.with_name(f"{file.name}.{os.getpid()}")
    with suppress(OSError, ValueError):
        file.parent.mkdir(exist_ok=True)
        temporary.write_bytes(marshal.dumps((stamp, [_values(rule) for rule in rules])))
        temporary.replace(file)


def _values(rule: Rule) -> tuple[Any, ...]:
    """The fields of a rule in types that marshal knows."""
    *values, nodes = rule
    return (*values, tuple(nodes))


def _rule(values: Sequence[Any]) -> Rule:
    *own, nodes = values
    return Rule._make((*own, Nodes._make(nodes)))
