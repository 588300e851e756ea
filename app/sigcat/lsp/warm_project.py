"""A project that stays loaded: open texts in place of files, and what was made of files that did not change."""

import os
from collections.abc import Callable, Hashable, Iterator
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from sigcat import codes
from sigcat.adapter.core.clashes import code_problems
from sigcat.catalogue.hosting.file_marks import Marks, marks_of
from sigcat.catalogue.hosting.source import Source, load
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.digest import digest_of
from sigcat.errors import InputRefused, SigcatError
from sigcat.file_kind import file_kind, root_name
from sigcat.findings import Finding
from sigcat.function.folder_functions import folder_functions
from sigcat.function.linting import checked_functions
from sigcat.names import bounded_proposals
from sigcat.open_files import open_files, open_text, read_bytes
from sigcat.project.chosen_tree import TreeOptions
from sigcat.project.find_project import FILES, find_project
from sigcat.project.linting import ChosenLint, chosen_lint
from sigcat.project.project import Project
from sigcat.project.read_project import read_project
from sigcat.project.vehicles import vehicle_findings
from sigcat.real_path import near_path, real_path
from sigcat.rules.linting.context import tree_near
from sigcat.rules.linting.discovery import walk
from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.linting.nearby_trees import tree_of
from sigcat.rules.linting.options import LintResult
from sigcat.rules.tree import Tree

Result = TypeVar("Result")
FindProject = Callable[[Path], Path | None]
"""Finds the project file of a folder."""
_FUNCTION_FILES = 500
"""Function files of a folder without a project that are searched for uses of a signal."""
_UNREADABLE = frozenset(
    rule.id for rule in (codes.NOT_YAML, codes.NOT_A_MAPPING, codes.NOT_UTF_8, codes.NESTING_TOO_DEEP, codes.NOT_TOML)
)
"""Rules that a text breaks of which nothing is read."""


class _Loaded(NamedTuple):
    marks: Marks
    texts: tuple[str, ...]
    catalogue: Catalogue


class WarmProject:
    """The project of a folder. Its functions run one at a time, within `with_texts`."""

    def __init__(self, root: Path, find_project: FindProject = find_project) -> None:
        self.root = root
        self._find_project = find_project
        self._texts: dict[str, bytes] = {}
        self._sound: dict[str, bytes] = {}
        """The last texts that could be read, for look-ups: an unfinished line is often invalid YAML."""
        self._projects: dict[Path, Project] = {}
        """Project files as they could be read last."""
        self._made: dict[Hashable, tuple[object, Any]] = {}
        self._catalogues: dict[tuple[Source, bool], _Loaded] = {}
        self._trees: dict[int, Tree] = {}

    def open(self, path: Path, text: bytes) -> None:
        """Take the text of an editor for a file."""
        self._texts = {**self._texts, **dict.fromkeys(_names_of(path), text)}

    def close(self, path: Path) -> None:
        """Read a file from the disk again."""
        closed = _names_of(path)
        self._texts = {name: text for name, text in self._texts.items() if name not in closed}
        self._sound = {name: text for name, text in self._sound.items() if name not in closed}

    def with_texts(self, work: Callable[[], Result]) -> Result:
        """Return what `work` returns when it reads open texts in place of files."""
        with open_files(self._texts, self._made), bounded_proposals():
            return work()

    def with_sound_texts(self, work: Callable[[], Result]) -> Result:
        """Return what `work` returns when it reads those open texts that can be read, else what they were before."""
        texts = {name: self._sound.get(name, text) for name, text in self._texts.items()}
        with open_files(texts, self._made), bounded_proposals():
            return work()

    def lint(self, path: Path) -> LintResult:
        """Lint a file as `sigcat lint FILE` does in the folder of the project."""
        text = open_text(path)
        result = self._lint(path)
        if text is not None and not any(each.rule in _UNREADABLE for each in result.findings):
            self._sound.update(dict.fromkeys(_names_of(path), text))
        return result

    def _lint(self, path: Path) -> LintResult:
        if path.name in FILES:
            return LintResult(self._project_findings(path), (str(path),))
        try:
            options, tree = self.chosen(path)
            folders = self.project(path).functions
            check = partial(checked_functions, tree, check_code=code_problems, load_tree=self.load, folders=folders)
            return lint_paths([path], options._replace(check_functions=check))
        except InputRefused as error:
            return LintResult(tuple(error.findings), (str(path),))

    def chosen(self, path: Path) -> ChosenLint:
        """Return the options of a lint of a file, and the tree of its functions. Raises SigcatError."""
        return chosen_lint(self.project(path), TreeOptions())

    def project(self, path: Path) -> Project:
        """Return the project of a file, as it could be read last. Raises InputRefused, UsageError."""
        file = self._find_project(path.parent)
        if file is None:
            return Project()
        try:
            self._projects[file] = read_project(file)
        except SigcatError:
            if file not in self._projects:
                raise
        return self._projects[file]

    def load(self, source: Source, *, expanded: bool = True) -> Catalogue:
        """Load a catalogue, again only if a file of it changed."""
        known = self._catalogues.get((source, expanded))
        if known is None or known[:2] != _state_of(source, known.catalogue):
            catalogue = load(source, expanded=expanded)
            known = _Loaded(*_state_of(source, catalogue), catalogue)
            self._catalogues[source, expanded] = known
        return known.catalogue

    def tree(self, path: Path) -> Tree:
        """Return the catalogue that a file belongs to, with its instances not expanded."""
        catalogue = self.load(self._source_of(path), expanded=False)
        if id(catalogue) not in self._trees:
            alive = {id(loaded.catalogue) for loaded in self._catalogues.values()}
            self._trees = {key: tree for key, tree in self._trees.items() if key in alive}
            self._trees[id(catalogue)] = Tree(catalogue)
        return self._trees[id(catalogue)]

    def functions(self, path: Path) -> tuple[Path, ...]:
        """Return the function files of the project, else those of the folder."""
        try:
            project = self.project(path)
        except SigcatError:
            project = Project()
        listed = folder_functions(project.functions) if project.functions else ()
        opened = (Path(name) for name in self._texts if is_function(Path(name)))
        found = listed or tuple(_found_functions(self.root))
        return tuple({real_path(file): near_path(file) for file in (*found, *opened)}.values())

    def _source_of(self, path: Path) -> Source:
        """Return the catalogue of the project that has the file, or the tree near it with the file on top."""
        options, tree = self.chosen(path)
        sources = options.catalogues or (tree,)
        known = next((source for source in sources if self._has(source, path)), None)
        if known is not None or file_kind(_start(path), path.name) != "vspec":
            return known or tree
        around = tree_of(path)
        if around is not None:
            return Source("", "", around[0])
        near = options.base or tree_near(root_name(_start(path)), path)
        return (tree if near in (None, tree.spec) else Source("", "", near))._replace(
            overlays=(*options.overlays, path)
        )

    def _has(self, source: Source, path: Path) -> bool:
        real = real_path(path)
        if real in map(real_path, (source.spec, *source.overlays)):
            return True
        files = self.load(source, expanded=False).files
        return any(Path(file.name).name == path.name and real_path(Path(file.name)) == real for file in files)

    def _project_findings(self, path: Path) -> tuple[Finding, ...]:
        try:
            return tuple(vehicle_findings(read_project(path)))
        except InputRefused as error:
            return tuple(error.findings)


def is_function(path: Path) -> bool:
    """Whether a file is a function.yaml or Function JSON."""
    return file_kind(_start(path), path.name) in ("function", "function json")


def _start(path: Path) -> bytes:
    try:
        return read_bytes(path)
    except OSError:
        return b""


def _found_functions(root: Path) -> Iterator[Path]:
    found = 0
    for path in walk(root):
        if found < _FUNCTION_FILES and path.suffix != ".vspec" and is_function(path):
            found += 1
            yield path


def _state_of(source: Source, catalogue: Catalogue) -> tuple[Marks, tuple[str, ...]]:
    """Return what a change of the files of a catalogue changes: their marks, or the digests of their open texts."""
    own = (source.spec, *source.overlays, *source.units, *source.quantities, *source.types)
    files = dict.fromkeys((*own, *(Path(file.name) for file in catalogue.files)))
    folders = dict.fromkeys(file.parent for file in files)
    texts = tuple(digest_of(text) for file in files if (text := open_text(file)) is not None)
    return marks_of((*files, *folders)), texts


def _names_of(path: Path) -> frozenset[str]:
    return frozenset((os.path.abspath(path), str(real_path(path))))  # noqa: PTH100 — links stay
