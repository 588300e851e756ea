"""Values that a node keeps between runs, in a file that is written whole or not at all."""

import os
from pathlib import Path
from tempfile import mkstemp
from typing import Any, Dict, Mapping, Sequence, Tuple

from .core import Core, Leaf
from .stored_text import BrokenFile, parse, read_text, read_texts, stored_text, text_of

COUNTS = {
    'occurrences': 'uint16_t',
    'ignition_cycles': 'uint16_t',
    'has_failed': '_Bool',
    'is_tested': '_Bool',
}
"""Counts of an error, each under its own key, with its datatype."""


def default_folder(package: str) -> Path:
    """Answer the folder of a package, in that of ROS."""
    return Path(os.environ.get('ROS_HOME') or Path.home() / '.ros') / package


def file_of(folder: Path, node: str, domain: int) -> Path:
    """
    Answer the file of a node, which is given with its namespace: `/ego/core_acc`.

    Its name has the domain, unless that is 0.
    """
    ending = f'-{domain}' if domain else ''
    return folder / f'{node.strip("/").replace("/", ".")}{ending}.txt'


class Storage:
    """The file of a node."""

    def __init__(self, path: Path, core: Core) -> None:
        """Take the core whose values they are."""
        self.path = path
        self._core = core
        self._values: Dict[str, str] = {}

    def load(self) -> Dict[str, Any]:
        """
        Read what was stored, as the core takes it; empty without a file.

        Raises BrokenFile if it cannot be read, or is not as it was written.
        """
        self._values = {}
        values = self._read()
        stored = _stored(values, self._core)
        self._values = values
        return stored

    def set_aside(self) -> Path:
        """Keep a broken file beside as `.broken`."""
        aside = self.path.with_name(f'{self.path.name}.broken')
        self.path.replace(aside)
        return aside

    def save(self) -> None:
        """
        Write what the core keeps, all of it or nothing. Raises OSError if that is not possible.

        What was read before and is not of the core stays.
        """
        self._values.update(_texts(self._core))
        _write(self.path, stored_text(self._values))

    def _read(self) -> Dict[str, str]:
        try:
            return parse(self.path.read_bytes())
        except OSError as reason:
            is_there = not isinstance(reason, (FileNotFoundError, NotADirectoryError))
            if is_there or self.path.is_symlink():
                raise BrokenFile(str(reason)) from None
            return {}


def _write(path: Path, data: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    number, name = mkstemp(dir=path.parent, prefix=f'{path.name}.')
    new = Path(name)
    try:
        with os.fdopen(number, 'wb') as file:
            os.fchmod(number, 0o644)
            file.write(data)
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


def _stored(values: Mapping[str, str], core: Core) -> Dict[str, Any]:
    """Answer values as the core takes them."""
    stored: Dict[str, Any] = {}
    if 'ignition_cycle' in values:
        stored['has_cycle'] = True
        stored['ignition_cycle'] = read_text(values['ignition_cycle'], 'uint32_t')
    for error in core.errors:
        stored[error.name] = {
            name: read_text(values[f'{error.name}.{name}'], datatype)
            for name, datatype in COUNTS.items()
            if f'{error.name}.{name}' in values
        }
    stored.update(_learned(values, core.learned_leaves()))
    return stored


def _learned(values: Mapping[str, str], leaves: Sequence[Leaf]) -> Dict[str, Any]:
    """Answer the parameters of which everything is there."""
    read = {leaf: _of_leaf(values[leaf.key], leaf) for leaf in leaves if leaf.key in values}
    found: Dict[str, Any] = {}
    for name in dict.fromkeys(leaf.parameter for leaf in leaves):
        own = [leaf for leaf in leaves if leaf.parameter == name]
        if all(leaf in read for leaf in own):
            whole: Dict[Any, Any] = {}
            for leaf in own:
                _put(whole, ('value', *leaf.path), read[leaf])
            found[name] = {'value': _without_numbers(whole['value']), 'is_there': True}
    return found


def _of_leaf(text: str, leaf: Leaf) -> Any:
    if leaf.length is None:
        return read_text(text, leaf.datatype)
    return read_texts(text, leaf.datatype, leaf.length)


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


def _texts(core: Core) -> Dict[str, str]:
    """Answer what the core keeps, as texts by key."""
    stored = core.stored()
    texts = {'ignition_cycle': text_of(stored['ignition_cycle'], 'uint32_t')}
    for error in core.errors:
        for name, datatype in COUNTS.items():
            texts[f'{error.name}.{name}'] = text_of(stored[error.name][name], datatype)
    for leaf in core.learned_leaves():
        if stored[leaf.parameter]['is_there']:
            value = stored[leaf.parameter]['value']
            for name in leaf.path:
                value = value[name]
            elements = value if leaf.length is not None else [value]
            texts[leaf.key] = ' '.join(text_of(each, leaf.datatype) for each in elements)
    return texts
