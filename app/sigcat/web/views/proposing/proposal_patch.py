"""A proposed overlay as a patch: it changes the overlays that the catalogue is made of, and leaves all other lines alone."""

import difflib
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from sigcat.catalogue.comparing.changes import same
from sigcat.catalogue.hosting.variants import expanded_of
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.catalogue.reading.statement import SourceFile, Statement
from sigcat.catalogue.reading.yaml_document import read_document
from sigcat.digest import digest_of
from sigcat.errors import UsageError
from sigcat.findings import has_errors
from sigcat.function.extension.overlay import statement_text
from sigcat.function.importing.yaml_edits import Edit, Text, edited, entries_of
from sigcat.limits import Limits
from sigcat.names import parent_path
from sigcat.open_files import read_bytes
from sigcat.real_path import real_path

NEW_FILE = "proposal.vspec"
"""File of the patch where the catalogue has no overlay."""


class _Change(NamedTuple):
    """Values of a node that a file gets. With `is_added`, the file gets a statement."""

    path: str
    values: Mapping[str, Any]
    is_added: bool


def proposal_patch(catalogue: Catalogue, overlay: bytes, limits: Limits) -> str:
    """Return a patch for `git apply`. Raises UsageError for an overlay with errors, or if a file has changed meanwhile."""
    layer = layer_from_text(overlay, "overlay.vspec", limits=limits)
    if has_errors(layer.findings):
        raise UsageError("The overlay has errors: a patch cannot be made of it.")
    changes: dict[str, list[_Change]] = {}
    files = {file.name: file for layer in catalogue.overlays for file in layer.files}
    for statement in layer.statements:
        name, change = _change(expanded_of(catalogue), statement, files)
        if change.values:
            changes.setdefault(name, []).append(change)
    return "".join(_file_patch(files.get(name), each) for name, each in changes.items())


def _change(catalogue: Catalogue, posted: Statement, files: Mapping[str, SourceFile]) -> tuple[str, _Change]:
    """The file that a statement belongs to, and what is new in it."""
    node = catalogue.get(posted.path)
    definition = catalogue.definitions.get(posted.path) or (node.definition if node else None)
    if definition is None:
        return _home(catalogue, posted.path), _Change(posted.path, posted.values, is_added=True)
    values = {name: value for name, value in posted.values.items() if not same(definition.values.get(name), value)}
    for own in reversed(definition.statements):
        if own.path == posted.path and own.file.name in files and _is_written_so(own):
            return own.file.name, _Change(posted.path, values, is_added=False)
    repeated = {name: posted.values[name] for name in ("type", "datatype") if name in posted.values}
    whole = {**repeated, **values} if values else {}
    return _home(catalogue, posted.path), _Change(posted.path, whole, is_added=True)


def _is_written_so(statement: Statement) -> bool:
    """Whether its file has the whole path as a key: one that is included below a branch has only the end of it."""
    return statement.path in entries_of(read_document(_read(statement.file), statement.file.name).root)


def _home(catalogue: Catalogue, path: str) -> str:
    """The overlay that speaks last of the nearest branch above, or else the last one; empty without overlays."""
    roots = {layer.name for layer in catalogue.overlays}
    above = path
    while above := parent_path(above):
        definition = catalogue.definitions.get(above)
        for statement in reversed(definition.statements if definition else ()):
            if statement.file.name in roots:
                return statement.file.name
    return next((layer.name for layer in reversed(catalogue.overlays)), "")


# -- one file -----------------------------------------------------------------------------------------------------


def _file_patch(file: SourceFile | None, changes: Sequence[_Change]) -> str:
    if file is None:
        text = "\n".join(statement_text(each.path, each.values) for each in changes)
        return f"diff --git a/{NEW_FILE} b/{NEW_FILE}\nnew file mode 100644\n{_diff('', text, '/dev/null', f'b/{NEW_FILE}')}"
    before = _read(file).decode("utf-8")
    name = _path_in_repository(file.name)
    return _diff(before, _changed(before, file.name, changes), f"a/{name}", f"b/{name}")


def _read(file: SourceFile) -> bytes:
    """The bytes of a file of the catalogue. Raises UsageError unless they are those that the service read."""
    try:
        data = read_bytes(Path(file.name))
    except OSError:
        data = b""
    if digest_of(data) != file.digest:
        raise UsageError(f"{Path(file.name).name} has changed since the service read it. Reload the catalogue.")
    return data


def _changed(before: str, name: str, changes: Sequence[_Change]) -> str:
    """The text with its changes; line breaks and a byte order mark stay."""
    has_crlf = "\r\n" in before
    text = before.replace("\r\n", "\n").removeprefix("\ufeff")
    text = edited(text, _edits(text, name, [each for each in changes if not each.is_added]))
    for each in changes:
        if each.is_added:
            text = f"{text.rstrip()}\n\n{statement_text(each.path, each.values)}".lstrip("\n")
    mark = "\ufeff" if before.startswith("\ufeff") else ""
    return mark + (text.replace("\n", "\r\n") if has_crlf else text)


def _edits(text: str, name: str, changes: Sequence[_Change]) -> Iterator[Edit]:
    entries = entries_of(read_document(text.encode(), name).root)
    editor = Text(text)
    for each in changes:
        _, mapping = entries[each.path]
        last = next(reversed(entries_of(mapping)), "")
        for key, value in each.values.items():
            yield from editor.set_value(mapping, key, value, last)


def _diff(before: str, after: str, old: str, new: str) -> str:
    lines = difflib.unified_diff(_lines(before), _lines(after), _labelled(old), _labelled(new))
    return "".join(line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in lines)


def _lines(text: str) -> list[str]:
    """Lines as git has them: other characters that break lines do not count."""
    return re.findall(r"[^\n]*\n|[^\n]+", text)


def _labelled(path: str) -> str:
    """A path with a space ends with a tab, so that git reads it whole."""
    return f"{path}\t" if " " in path else path


def _path_in_repository(file: str) -> str:
    """The path of a file from the top of its repository; without one, from the current folder, or its name."""
    path = real_path(Path(file))
    for folder in path.parents:
        if (folder / ".git").exists():
            return path.relative_to(folder).as_posix()
    here = real_path(Path())
    return path.relative_to(here).as_posix() if path.is_relative_to(here) else path.name
