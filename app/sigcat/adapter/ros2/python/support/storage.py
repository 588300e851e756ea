"""
What a node keeps from one run to the next: a text of its own.

It is written whole or not at all: beside the file first, and then in its place.
"""

import os
from pathlib import Path
from reprlib import repr as shortened
from struct import pack
from typing import Any, Dict, Iterator, List, Mapping, Sequence, Tuple

from .core import Core, Leaf

FIRST_LINE = 'sigcat 1'
COUNTS = ('occurrences', 'ignition_cycles', 'has_failed', 'is_tested')
_NUMBER_OF_FLAG = {'false': False, 'true': True}


class BrokenFile(ValueError):
    """A file that this package did not write."""


def default_folder(package: str) -> Path:
    """Answer the folder of a package, in that of ROS."""
    return Path(os.environ.get('ROS_HOME') or Path.home() / '.ros') / package


def file_of(folder: Path, node: str) -> Path:
    """Answer the file of a node, which is given with its namespace: `/ego/core_acc`."""
    return folder / f'{node.strip("/").replace("/", ".")}.txt'


def set_aside(path: Path) -> Path:
    """Keep a file that cannot be read beside where it was."""
    aside = path.with_name(f'{path.name}.broken')
    path.replace(aside)
    return aside


def read(path: Path, core: Core) -> Dict[str, Any]:
    """
    Read what was stored, as the core takes it.

    Raises FileNotFoundError, or BrokenFile if it cannot be read, or is not as it was written.
    """
    try:
        values = dict(_lines(path.read_text(encoding='utf-8')))
    except FileNotFoundError:
        raise
    except (OSError, UnicodeDecodeError) as reason:
        raise BrokenFile(str(reason)) from None
    stored: Dict[str, Any] = {}
    if 'ignition_cycle' in values:
        stored['has_cycle'] = True
        stored['ignition_cycle'] = _number(values['ignition_cycle'], 'uint32_t')
    for error in core.errors:
        stored[error.name] = {
            name: _number(values[f'{error.name}.{name}'], _datatype(name))
            for name in COUNTS
            if f'{error.name}.{name}' in values
        }
    stored.update(_learned(values, core.learned_leaves()))
    return stored


def _lines(text: str) -> Iterator[Tuple[str, str]]:
    first, *rows = text.split('\n')
    if first != FIRST_LINE or rows[-1:] != ['']:
        raise BrokenFile(f'the first line is not {FIRST_LINE!r}, or the last one has no end')
    seen = set()
    for row in rows[:-1]:
        key, sign, value = row.partition(': ')
        if not sign or not key or key in seen:
            raise BrokenFile(f'{shortened(row)} is no line of it')
        seen.add(key)
        yield key, value


def _learned(values: Mapping[str, str], leaves: Sequence[Leaf]) -> Dict[str, Any]:
    """Answer the parameters of which everything is there."""
    names = dict.fromkeys(leaf.parameter for leaf in leaves)
    found: Dict[str, Any] = {}
    for name in names:
        own = [leaf for leaf in leaves if leaf.parameter == name]
        if all(leaf.key in values for leaf in own):
            whole: Dict[Any, Any] = {}
            for leaf in own:
                _put(whole, ('value', *leaf.path), _value(values[leaf.key], leaf))
            found[name] = {'value': _without_numbers(whole['value']), 'is_there': True}
    return found


def _put(whole: Dict[Any, Any], path: Tuple[Any, ...], value: Any) -> None:
    for name in path[:-1]:
        whole = whole.setdefault(name, {})
    whole[path[-1]] = value


def _without_numbers(value: Any) -> Any:
    """Turn what is numbered into a list."""
    if not isinstance(value, dict):
        return value
    parts = {name: _without_numbers(part) for name, part in value.items()}
    return list(parts.values()) if 0 in parts else parts


def _value(text: str, leaf: Leaf) -> Any:
    if leaf.length is None:
        return _number(text, leaf.datatype)
    numbers = [_number(each, leaf.datatype) for each in text.split(' ')]
    if len(numbers) != leaf.length:
        raise BrokenFile(f'{leaf.key} has {len(numbers)} elements and not {leaf.length}')
    return numbers


def _datatype(count: str) -> str:
    return 'uint16_t' if count in ('occurrences', 'ignition_cycles') else '_Bool'


def _number(text: str, datatype: str) -> Any:
    try:
        if datatype == '_Bool':
            return _NUMBER_OF_FLAG[text]
        if datatype in ('float', 'double'):
            return float(text)
        number = int(text)
    except (KeyError, ValueError):
        raise BrokenFile(f'{shortened(text)} is no {datatype}') from None
    bits = int(datatype.strip('uint_t'))
    low, high = (0, 2 ** bits) if datatype[0] == 'u' else (-2 ** (bits - 1), 2 ** (bits - 1))
    if not low <= number < high:
        raise BrokenFile(f'{shortened(text)} is no {datatype}')
    return number


def write(path: Path, core: Core) -> None:
    """Write what the core keeps. Raises OSError if that is not possible."""
    path.parent.mkdir(parents=True, exist_ok=True)
    new = path.with_name(f'{path.name}.new')
    try:
        with new.open('wb') as file:
            file.write(_text(core).encode())
            file.flush()
            os.fsync(file.fileno())
    except OSError:
        new.unlink(missing_ok=True)
        raise
    new.replace(path)
    folder = os.open(path.parent, os.O_RDONLY)
    try:
        os.fsync(folder)
    finally:
        os.close(folder)


def _text(core: Core) -> str:
    stored = core.stored()
    rows: List[str] = [FIRST_LINE, f'ignition_cycle: {stored["ignition_cycle"]}']
    for error in core.errors:
        counts = stored[error.name]
        rows += [
            f'{error.name}.{name}: {_written(counts[name], _datatype(name))}' for name in COUNTS
        ]
    for leaf in core.learned_leaves():
        place = stored[leaf.parameter]
        if place['is_there']:
            value = place['value']
            for name in leaf.path:
                value = value[name]
            elements = value if leaf.length is not None else [value]
            rows.append(f'{leaf.key}: {" ".join(_written(e, leaf.datatype) for e in elements)}')
    return '\n'.join(rows) + '\n'


def _written(value: Any, datatype: str) -> str:
    if datatype == '_Bool':
        return 'true' if value else 'false'
    if datatype == 'float' and value - value == 0:
        texts = (f'{value:.{digits}g}' for digits in range(1, 10))
        return next(text for text in texts if pack('f', float(text)) == pack('f', value))
    return repr(value)
