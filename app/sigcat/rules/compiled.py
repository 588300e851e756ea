"""Shipped rules, read from YAML once: kept as Python keeps compiled modules.

To read 200 records takes longer than to lint a changed file. Their values are kept in `__pycache__` beside the files,
where only who may change the rules may write, and count as long as sizes and times of the files stand.
"""

import marshal
import os
import sys
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from sigcat import __version__
from sigcat.rules.record import Nodes, Rule, load_rule_files

_Stamp = tuple[tuple[str, int, int], ...]


def compiled_rules(folder: Path) -> tuple[Rule, ...]:
    """What `load_rules` gives, without reading the files again. Raises InputRefused with all defects."""
    files = sorted(folder.glob("*.yaml"))
    stamp = _stamp(files)
    kept = folder / "__pycache__" / f"rules-{__version__}.{sys.implementation.cache_tag}.marshal"
    rules = _kept(kept, stamp)
    if rules is None:
        rules = load_rule_files(files, trusted=True)
        if stamp and not sys.dont_write_bytecode and not sys.pycache_prefix:
            _keep(kept, stamp, rules)
    return rules


def _stamp(files: Iterable[Path]) -> _Stamp:
    try:
        stats = [(str(file), file.stat()) for file in files]
    except OSError:
        return ()
    return tuple((name, stat.st_size, stat.st_mtime_ns) for name, stat in stats)


def _kept(file: Path, stamp: _Stamp) -> tuple[Rule, ...] | None:
    try:
        written, records = marshal.loads(file.read_bytes())  # noqa: S302 — trusted as compiled Python is, see above
        if not stamp or written != stamp:
            return None
        return tuple(Rule._make((*record[:8], Nodes._make(record[8]), *record[9:])) for record in records)
    except (OSError, ValueError, TypeError, EOFError):
        return None


def _keep(file: Path, stamp: _Stamp, rules: Iterable[Rule]) -> None:
    """Keep the rules if the folder can be written, whole or not at all: several linters may start at once."""
    records = [(*rule[:8], tuple(rule.nodes), *rule[9:]) for rule in rules]
    temporary = file.with_name(f"{file.name}.{os.getpid()}")
    with suppress(OSError, ValueError):
        file.parent.mkdir(exist_ok=True)
        temporary.write_bytes(marshal.dumps((stamp, records)))
        temporary.replace(file)
