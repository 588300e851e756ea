"""Propose what may be written at a place: paths, attributes, units, datatypes, rule codes and C variables."""

import re
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Literal, NamedTuple

from sigcat.catalogue.model.datatypes import DATATYPES
from sigcat.catalogue.model.definition import (
    BRANCH,
    BRANCH_ATTRIBUTES,
    DATA_ATTRIBUTES,
    TYPES,
    Definition,
)
from sigcat.file_kind import QUANTITY_NAMES, UNIT_NAMES
from sigcat.lsp.definition import code_files
from sigcat.lsp.places import key_of, statement_at
from sigcat.lsp.warm_project import WarmProject, is_function
from sigcat.names import last_name, parent_path
from sigcat.open_files import made_once, read_bytes
from sigcat.project.find_project import FILES
from sigcat.rules.checks.attributes import extended_attributes
from sigcat.rules.linting.selection import rules_for
from sigcat.rules.tree import Tree
from sigcat.text_lines import lines_of

Kind = Literal["branch", "signal", "attribute", "unit", "datatype", "value", "rule", "variable"]
_MOST = 200
"""Proposals for a word without a path."""
_PATH_KEYS = ("path", "interface")
_C_VARIABLE = re.compile(
    r"^\s*(?:extern\s+|static\s+|volatile\s+|const\s+)*[A-Za-z_]\w*(?:\s+[A-Za-z_]\w*)*[\s*]+"
    r"(?P<name>[A-Za-z_]\w*)\s*(?:\[[^\]]*\]\s*)*[;=]"
)
_NO_TYPES = ("return", "goto", "typedef", "else", "case")
_SELECTING = re.compile(r"""(?:ignore|ignore-file)\[|["'][A-Z]*[0-9]*$""")


class Proposal(NamedTuple):
    """A text that may replace the word before the cursor."""

    text: str
    label: str
    kind: Kind
    detail: str = ""
    start: int = 0
    """Column at which the word begins."""


_VALUES: Mapping[str, list[Proposal]] = {
    "type": [Proposal(name, name, "value") for name in TYPES],
    "datatype": [Proposal(name, name, "datatype") for name in sorted(DATATYPES)],
}
"""Values of a key that do not depend on the file."""


def proposals_at(project: WarmProject, path: Path, lines: list[str], line: int, column: int) -> list[Proposal]:
    """Return what may be written at a place."""
    before = lines[line][:column]
    word = re.search(r"[\w.%/^*-]*$", before)
    start = word.start() if word is not None else column
    proposed = _proposed(project, path, lines, line, before, before[start:])
    return [each._replace(start=start) for each in proposed]


def _proposed(
    project: WarmProject, path: Path, lines: list[str], line: int, before: str, word: str
) -> Iterable[Proposal]:
    if path.name in FILES or "sigcat:" in before:
        return _rule_codes(project, path) if _SELECTING.search(before) else ()
    key = key_of(before)
    if key == "unit" or (key == "quantity" and path.name in UNIT_NAMES):
        return _units(project.tree(path), key)
    if is_function(path):
        return _in_function(project, path, key, word)
    return _in_tree(project, path, lines, line, before, key, word)


def _in_tree(
    project: WarmProject, path: Path, lines: list[str], line: int, before: str, key: str, word: str
) -> Iterable[Proposal]:
    if key in _VALUES:
        return _VALUES[key]
    if key or path.name in (*UNIT_NAMES, *QUANTITY_NAMES):
        return ()
    if before[:1].isspace():
        return _attributes(project, path, lines, line)
    return _keys(project.tree(path), path, word)


def _in_function(project: WarmProject, path: Path, key: str, word: str) -> Iterable[Proposal]:
    if key == "variable":
        return _plain(_variables(code_files(path)), "variable")
    if key == "datatype":
        return _VALUES[key]
    if key in _PATH_KEYS:
        return [*_paths(project.tree(path), word), *_interfaces(project.tree(path), key)]
    return ()


def _keys(tree: Tree, path: Path, word: str) -> Iterator[Proposal]:
    """Propose paths below the branch at which the tree includes the file."""
    prefix = _prefix_of(tree, path)
    for proposal in _paths(tree, f"{prefix}{word}"):
        yield proposal._replace(text=proposal.text.removeprefix(prefix))


def _prefix_of(tree: Tree, path: Path) -> str:
    statement = statement_at(tree.catalogue, path, 1 << 30)
    if statement is None:
        return ""
    lines = lines_of(read_bytes(path).decode("utf-8-sig", "replace"))
    written = key_of(lines[statement.origin().line - 1])
    return statement.path.removesuffix(written) if statement.path.endswith(written) else ""


def _paths(tree: Tree, word: str) -> Iterator[Proposal]:
    if "." in word:
        above = parent_path(word)
        return (_path(path, node) for path, node in _below(tree).get(above, ()))
    wanted = word.lower()
    every = (pair for pairs in _below(tree).values() for pair in pairs)
    found = (pair for pair in every if "." not in pair[0] or (wanted and wanted in last_name(pair[0]).lower()))
    return (_path(path, node) for (path, node), _ in zip(found, range(_MOST), strict=False))


def _below(tree: Tree) -> Mapping[str, list[tuple[str, Definition]]]:
    """Return the paths right below each path, names of instances included."""
    return made_once(("paths below", tree.catalogue.name), tree, lambda: _paths_below(tree))


def _paths_below(tree: Tree) -> Mapping[str, list[tuple[str, Definition]]]:
    found: dict[str, list[tuple[str, Definition]]] = {}
    for path, node in tree.expanded.items():
        found.setdefault(parent_path(path), []).append((path, node))
    return found


def _path(path: str, node: Definition) -> Proposal:
    facts = " ".join(str(node.values[name]) for name in ("datatype", "unit") if name in node.values)
    return Proposal(path, path, "branch" if node.type == BRANCH else "signal", facts or node.type)


def _interfaces(tree: Tree, key: str) -> Iterable[Proposal]:
    return _plain(tree.interfaces, "signal") if key == "interface" else ()


def _attributes(project: WarmProject, path: Path, lines: list[str], line: int) -> Iterator[Proposal]:
    """Propose the attributes of a node, its own type's first; those that it has are skipped."""
    own = [key_of(each) for each in _block(lines, line)]
    kind = next((text.split(":", 1)[1].strip() for text in _block(lines, line) if key_of(text) == "type"), "")
    core = BRANCH_ATTRIBUTES if kind == BRANCH else DATA_ATTRIBUTES if kind else BRANCH_ATTRIBUTES | DATA_ATTRIBUTES
    options = project.chosen(path).options
    more = extended_attributes(rules_for(options)) | frozenset(options.attributes)
    for name in (*sorted(core), *sorted(more - core)):
        if name not in own:
            yield Proposal(f"{name}: ", name, "attribute", "VSS" if name in core else "extended attribute")


def _block(lines: list[str], line: int) -> list[str]:
    """Return the indented lines around a line, without it."""
    first = line
    while first > 0 and (lines[first - 1][:1].isspace() or not lines[first - 1].strip()):
        first -= 1
    last = line + 1
    while last < len(lines) and lines[last][:1].isspace():
        last += 1
    return [*lines[first:line], *lines[line + 1 : last]]


def _units(tree: Tree, key: str) -> Iterator[Proposal]:
    vocabulary = tree.catalogue.vocabulary
    if key == "quantity":
        yield from (Proposal(each.key, each.key, "unit", each.definition) for each in vocabulary.quantities.values())
        return
    for unit in vocabulary.distinct_units:
        yield Proposal(unit.key, unit.key, "unit", f"{unit.name} ({unit.quantity})")


def _rule_codes(project: WarmProject, path: Path) -> Iterator[Proposal]:
    for rule in rules_for(project.chosen(path).options):
        yield Proposal(rule.id, rule.id, "rule", rule.title)


def _plain(texts: Iterable[str], kind: Kind) -> list[Proposal]:
    return [Proposal(text, text, kind) for text in texts]


def _variables(files: Iterable[Path]) -> list[str]:
    lines = (line for file in files for line in lines_of(read_bytes(file).decode("utf-8", "replace")))
    found = (match for line in lines if (match := _C_VARIABLE.match(line)) and line.split()[0] not in _NO_TYPES)
    return list(dict.fromkeys(match["name"] for match in found))
