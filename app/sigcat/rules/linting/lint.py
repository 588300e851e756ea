"""Lint files: paths in, findings out.

A folder or the root of a tree is checked as a whole tree. An overlay is checked over the tree that it is made for,
alone, or with those that the options say it stacks with. A part of a tree that is named alone, as pre-commit names changed files, is checked
by itself, below the branch where its tree includes it. Only the named files have findings.
"""

import os
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from sigcat import codes
from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.composing.older_releases import read_units, with_present_spellings
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.vocabulary import Vocabulary
from sigcat.catalogue.reading.layers import Layer, layer_from_text, read_layer
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.data import ROOT_FILE
from sigcat.errors import UsageError, without_signals
from sigcat.file_kind import QUANTITY_NAMES, UNIT_NAMES
from sigcat.findings import Finding, RuleCode, has_errors, in_order
from sigcat.limits import DEFAULT_LIMITS
from sigcat.names import bounded_proposals
from sigcat.open_files import made_once, read_bytes, size_of
from sigcat.path_faults import path_fault
from sigcat.real_path import real_path
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.engine import Found, found_in, lint_lines
from sigcat.rules.linting.catalogues import (
    all_overlays,
    all_quantities,
    all_trees,
    all_types,
    all_units,
    by_catalogue,
    of_tree,
    of_types,
)
from sigcat.rules.linting.context import (
    base_of,
    compose_tree,
    stacks_of,
    type_files,
    type_layers,
    unchecked_tree,
    units_of,
    with_instances,
)
from sigcat.rules.linting.discovery import Source, discover
from sigcat.rules.linting.includes import first_bytes
from sigcat.rules.linting.nearby_trees import default_tree
from sigcat.rules.linting.options import LintOptions, LintResult, identity_of
from sigcat.rules.linting.selection import rules_for, selected, taken
from sigcat.rules.linting.severity import Grading, matches
from sigcat.rules.linting.siblings import with_own_tree, with_siblings
from sigcat.rules.linting.suppression import MARK, Suppressions, apply_suppressions, read_suppressions
from sigcat.rules.problem import Repair
from sigcat.rules.record import Rule, parse_rules
from sigcat.rules.rule_set import RuleSet

if TYPE_CHECKING:
    from sigcat.catalogue.network.can_database import CanDatabase

_ABOUT_RULES = frozenset((codes.RULE_UNUSABLE.id, codes.RULE_TOO_SLOW.id))
"""Findings about rules, reported on every run, whichever files are linted."""
_NOT_READ = frozenset((codes.FILE_TOO_LARGE.id, codes.FILE_UNREADABLE.id))
_NOT_TEXT = frozenset((codes.NOT_UTF_8.id, codes.FILE_TOO_LARGE.id))
"""A file that is not text has no lines to check."""

Texts = Literal["vspec", "comments", "nothing"]
"""The checked parts of a file's text beside its values: lines and comments, comments, or nothing."""


class _Lint:
    """One run, and what it has gathered so far. Not a dataclass: to load that module takes a twentieth of a short run."""

    def __init__(
        self, options: LintOptions, rules: RuleSet, units: frozenset[str], quantities: Collection[Path]
    ) -> None:
        self.options = options
        self.rules = rules
        self.units = units
        """Files of units and quantities that are linted."""
        self.quantities = frozenset(map(real_path, quantities))
        """Files that are known to have quantities, whatever their names."""
        self.found: dict[Finding, Repair | None] = {}
        self.files: dict[str, Texts] = {}
        """The files that were looked at."""
        self.beside: set[str] = set()
        """The files that were read for what they need."""
        self.causes: set[str] = set()
        """Rule files, and faulty files of units and CAN databases: findings in other files may follow from them."""
        self.functions: set[str] = set()
        """Function files: findings in them may follow from those in trees and overlays."""
        self.can = self._can_database()

    def _can_database(self) -> "CanDatabase | None":
        """Return the database of the options, if they name one. Its errors are findings."""
        if not self.options.dbc:
            return None
        from sigcat.catalogue.network.can_database import read_can_database

        database = read_can_database(self.options.dbc)
        self.add((finding, None) for finding in database.findings)
        if not has_errors(database.findings):
            return database
        self.causes.update(finding.file for finding in database.findings)
        return None

    def add(self, found: Iterable[Found], files: set[str] | None = None) -> None:
        """Keep findings: of all files, or of `files` and those about rules."""
        with bounded_proposals():
            for finding, repair in found:
                if files is None or finding.file in files or finding.rule in _ABOUT_RULES:
                    self.found.setdefault(finding, repair)

    def add_composed(self, found: Iterable[Found], vocabulary: Vocabulary, files: Collection[str]) -> None:
        """Keep findings of `files`, and of the files of units from which findings in them follow."""
        self.causes |= vocabulary.faulty_files
        self.add(found, {*files, *vocabulary.faulty_files})

    def look_at(self, files: Iterable[str], texts: Texts = "vspec") -> None:
        """Remember files whose text is checked after all values."""
        self.files.update(dict.fromkeys(files, texts))


def lint_paths(paths: Sequence[Path], options: LintOptions | None = None) -> LintResult:
    """Lint files and folders. Raises NotFound, UsageError, and InputRefused for rules that cannot be used."""
    with collector_paused():
        return _lint_paths(paths, options or LintOptions())


def _lint_paths(paths: Sequence[Path], options: LintOptions) -> LintResult:
    every_rule = rules_for(options)
    quantities = all_quantities(options)
    discovered = discover(
        paths,
        all_overlays(options),
        all_types(options),
        all_trees(options),
        options.rule_files,
        (*all_units(options), *quantities),
    )
    sources = [s for s in discovered if not _is_excluded(s.path, options) and not _is_project(s.path, options)]
    units = [source for source in sources if source.kind == "vocabulary"]
    named = [source.path for source in units if source.named]
    options = _with_units(options._replace(types=type_files(sources, options)), named)
    rules = selected(every_rule, options)
    linted_units = frozenset(str(source.path) for source in units)
    lint = _Lint(options, made_once("rule set", rules, lambda: RuleSet(rules)), linted_units, quantities)
    if not _has_project(paths, options):
        _refuse_empty(paths, discovered)
    trees = _lint_trees([s.path for s in sources if s.kind == "tree"], lint)
    _lint_overlays([s.path for s in sources if s.kind == "overlay"], trees, lint)
    lint.add((finding, None) for finding in _unlisted_overlays(sources, options))
    for source in sources:
        if source.kind == "types":
            _lint_types(source.path, trees, lint)
        elif source.kind in _LINT_FILE:
            _LINT_FILE[source.kind](source, lint)
    is_complete = any(path.is_dir() for path in paths)
    _lint_functions([s.path for s in sources if s.kind == "function"], lint, is_complete=is_complete)
    _lint_project(paths, lint)
    return _result(lint, every_rule, paths if is_complete else ())


def _with_units(options: LintOptions, named: Sequence[Path]) -> LintOptions:
    """The options with the units and quantities that were named beside what uses them."""
    units = [path for path in named if path.name in UNIT_NAMES]
    quantities = [path for path in named if path.name in QUANTITY_NAMES]
    return options._replace(units=(*options.units, *units), quantities=(*options.quantities, *quantities))


def _refuse_empty(paths: Sequence[Path], sources: Sequence[Source]) -> None:
    """Raise UsageError for a folder without a file that is checked: a typing error would pass."""
    checked = (source.path for source in sources if source.kind != "other")
    found = {parent for path in checked for parent in _without_dots(path).parents}
    for path in paths:
        if path.is_dir() and _without_dots(path) not in found:
            fix = "Name another folder."
            raise UsageError(f"Nothing to check: {path} has no .vspec, units, function or rule file. {fix}")


def _without_dots(path: Path) -> Path:
    return Path(os.path.abspath(path))  # noqa: PTH100 — links stay as they are


def _is_excluded(path: Path, options: LintOptions) -> bool:
    return any(matches(str(path), glob, options.root) for glob in options.exclude)


# -- trees, overlays and parts ----------------------------------------------------------------------------------------


def _lint_trees(roots: Sequence[Path], lint: _Lint) -> list[Path]:
    """Lint whole trees; the roots, as what overlays may be made for."""
    for root in roots:
        options = of_tree(root, lint.options)
        catalogue = compose_tree(root, options)
        _refuse_without_signals(catalogue, root, options)
        lint.causes |= catalogue.vocabulary.faulty_files
        lint.add(found_in(catalogue, lint.rules, attributes=lint.options.attributes, can=lint.can))
        lint.look_at([*(file.name for file in catalogue.files), str(root)])
    return list(roots)


def _lint_overlays(overlays: Sequence[Path], trees: Sequence[Path], lint: _Lint) -> None:
    for options, listed in by_catalogue(overlays, lint.options):
        groups: dict[Path, list[Path]] = {}
        for overlay in listed:
            groups.setdefault(base_of(overlay, trees, options), []).append(overlay)
        for base, group in groups.items():
            for stack in stacks_of(group, options):
                _lint_stack(base, stack, {str(path) for path in group}, options, lint)


def _unlisted_overlays(sources: Iterable[Source], options: LintOptions) -> Iterator[Finding]:
    """A note at each overlay in the folder of a project that none of its catalogues and vehicles has."""
    listed = {*map(real_path, (*all_overlays(options), *options.of_vehicles))}
    for source in sources if options.catalogues else ():
        if source.kind == "overlay" and not source.named and real_path(source.path) not in listed:
            yield _not_listed(source.path, codes.OVERLAY_NOT_LISTED, "overlay", "overlays")


def _lint_stack(base: Path, stack: Sequence[Path], named: Collection[str], options: LintOptions, lint: _Lint) -> None:
    """Overlays over one tree, the last on top; findings in the named ones only."""
    layers = [read_layer(path, options.include_dirs, is_overlay=True) for path in stack]
    catalogue, expanded = _composed_over(base, layers, stack, options)
    _refuse_without_signals(catalogue, base, options)
    judged_layers = [layer for layer in layers if layer.name in named]
    files = {file.name for layer in judged_layers for file in layer.files} | {layer.name for layer in judged_layers}
    folders = {Path(layer.name).parent for layer in judged_layers}
    vocabulary = [file.name for file in catalogue.vocabulary.files]
    beside = {name for name in vocabulary if Path(name).parent in folders or name in lint.units}
    judged = tuple(catalogue.written_in(files))
    rules = lint.rules if options.overlays else lint.rules.without_stacks
    found = found_in(with_instances(catalogue, judged, expanded), rules, judged, options.attributes, lint.can)
    if not options.overlays:
        found = with_siblings(found, stack[-1], catalogue, rules.rules)
    if base == ROOT_FILE and options.base is None and not options.overlays:
        found = with_own_tree(found, layers[-1], rules.rules)
    lint.add_composed(found, catalogue.vocabulary, files | beside)
    unread = [f for layer in layers if layer.name not in named for f in layer.findings if f.severity == "error"]
    lint.causes.update(finding.file for finding in unread)  # what is checked lies over these
    lint.add((finding, None) for finding in unread)
    lint.look_at([*files, *beside])
    lint.beside.update(file.name for file in catalogue.files)


def _refuse_without_signals(catalogue: Catalogue, base: Path, options: LintOptions) -> None:
    """Raise UsageError if the tree that was named has no signals; one with errors has findings."""
    if base == options.base and not catalogue.has_signals and not has_errors(catalogue.findings):
        raise UsageError(without_signals(base))


def _composed_over(
    base: Path, overlays: Sequence[Layer], files: Sequence[Path], options: LintOptions
) -> tuple[Catalogue, Callable[[], Catalogue]]:
    """A tree with overlays as it is written, and what expands its instances."""
    tree = read_layer(base, options.include_dirs)
    vocabulary, is_older = units_of(base, tree, files, options)
    types = type_layers((base, *files), options)
    tree = with_present_spellings(tree) if is_older else tree
    compose_all = partial(compose, [tree, *overlays], vocabulary, types, name=base.stem)
    catalogue = compose_all(expanded=False, earlier=unchecked_tree(tree, vocabulary))
    return catalogue, partial(compose_all, earlier=catalogue)


def _lint_types(path: Path, trees: Sequence[Path], lint: _Lint) -> None:
    """A tree of struct types by itself, with the units of the tree that uses them."""
    options = of_types(path, lint.options)
    layer = read_layer(path, options.include_dirs)
    vocabulary, _ = units_of(base_of(path, trees, options), layer, [path], options)
    others = [read_layer(other, options.include_dirs) for other in options.types if real_path(other) != real_path(path)]
    types = [*others, layer]
    catalogue = compose([layer], vocabulary, types, expanded=False, name=path.stem)
    files = {file.name for file in layer.files} | {str(path)}
    lint.add_composed(found_in(catalogue, lint.rules, attributes=options.attributes), vocabulary, files)
    lint.look_at(files)
    lint.beside.update(file.name for file in catalogue.files)


def _lint_part(source: Source, lint: _Lint) -> None:
    """A part of a tree by itself; a part whose tree is linted too was checked with it."""
    if source.tree is None:
        return
    name = str(source.path)
    layer = layer_from_text(_bytes_of(source.path, lint), name, is_overlay=False)
    if source.prefix:
        statements = tuple(statement.placed(source.prefix) for statement in layer.statements)
        layer = Layer(layer.name, False, layer.files, statements, layer.findings)
    lint.beside.add(str(source.tree))
    vocabulary, is_older = units_of(source.tree, layer, (), of_tree(source.tree, lint.options))
    catalogue = compose([with_present_spellings(layer) if is_older else layer], vocabulary, expanded=False)
    found = found_in(catalogue, lint.rules.for_parts, attributes=lint.options.attributes, can=lint.can)
    local = (each for each in found if each[0].rule not in lint.rules.of_whole_trees)
    lint.add_composed(local, vocabulary, {name})
    lint.look_at([name])


# -- other files ------------------------------------------------------------------------------------------------------


def _lint_functions(paths: Sequence[Path], lint: _Lint, *, is_complete: bool) -> None:
    """Function files, alone and together. Files that were named one by one may be a part of a set."""
    lint.functions.update(map(str, paths))
    lint.look_at(lint.functions, "comments")
    read = [(_bytes_of(path, lint), str(path)) for path in paths]
    not_read = {finding.file for finding in lint.found if finding.rule in _NOT_READ}
    files = [(data, name) for data, name in read if name not in not_read]
    if lint.options.check_functions is not None and files:
        checked = lint.options.check_functions(files, is_complete)
        lint.add((finding, None) for finding in checked.findings)
        lint.beside.update(checked.beside)
        lint.causes |= checked.causes


def _lint_project(paths: Sequence[Path], lint: _Lint) -> None:
    """Check the project file, where it or its folder is named."""
    if lint.options.check_project is not None and _has_project(paths, lint.options):
        lint.look_at([str(lint.options.file)], "nothing")
        lint.add((finding, None) for finding in lint.options.check_project())


def _has_project(paths: Sequence[Path], options: LintOptions) -> bool:
    """Whether the project file has something to check, and it or its folder is named."""
    if options.file is None or options.check_project is None:
        return False
    file = real_path(options.file)
    return any(real_path(path) in (file, *file.parents) for path in paths)


def _is_project(path: Path, options: LintOptions) -> bool:
    """Whether a file is the project file, which is read before anything is linted."""
    return options.file is not None and path.name == options.file.name and real_path(path) == real_path(options.file)


def _lint_rules(source: Source, lint: _Lint) -> None:
    lint.causes.add(str(source.path))
    lint.look_at([str(source.path)], "nothing")
    file = parse_rules(_bytes_of(source.path, lint), str(source.path), trusted=False)
    lint.add((finding, None) for finding in file.findings)
    lint.add(found_in(compose([]), RuleSet((*file.rules, *file.unusable))))
    lint.add((finding, None) for finding in taken(file.rules, compiled_rules(lint.options.rule_folder)))
    if not file.findings:
        from sigcat.rules.linting.examples import unfit_examples  # few runs have rules to check

        units = read_units(ROOT_FILE, lint.options.units, lint.options.quantities).vocabulary
        lint.add((finding, None) for finding in unfit_examples(file.rules, units))


def _lint_vocabulary(source: Source, lint: _Lint) -> None:
    """Lint units and quantities that no tree or overlay has brought along, beside those of the nearest tree."""
    path, name = source.path, str(source.path)
    if name in lint.files:
        return
    options = lint.options
    listed = [source.spec for source in options.catalogues][:1]
    tree = options.base or (listed[0] if listed else default_tree(path)) or ROOT_FILE
    units, quantities = (*options.units, path), options.quantities
    is_of_units = path.name not in QUANTITY_NAMES and real_path(path) not in lint.quantities
    if not is_of_units:
        units, quantities = options.units, (*options.quantities, path)
    vocabulary = read_units(
        tree, units, quantities, overlays=(path,), has_standard=options.has_standard_units
    ).vocabulary
    lint.add_composed(((finding, None) for finding in vocabulary.findings), vocabulary, {name})
    if options.catalogues and not source.named and not _is_listed(path, options) and default_tree(path) is None:
        lint.causes.add(name)
        key = "units" if is_of_units else "quantities"
        lint.add([(_not_listed(path, codes.VOCABULARY_NOT_LISTED, "file", key), None)])
    lint.look_at([name])


def _is_listed(path: Path, options: LintOptions) -> bool:
    return real_path(path) in map(real_path, (*all_units(options), *all_quantities(options)))


def _not_listed(path: Path, rule: RuleCode, what: str, key: str) -> Finding:
    message, fix = f"No catalogue of the project has this {what}.", f"Add it to `{key}` in sigcat.toml."
    return rule.finding(message, str(path), 1, 1, fix=fix)


def _lint_unreadable(source: Source, lint: _Lint) -> None:
    """Report what is called like a file and is none."""
    lint.look_at([str(source.path)], "nothing")
    lint.add([(codes.FILE_UNREADABLE.finding(path_fault(source.path), str(source.path)), None)])


_LINT_FILE: Mapping[str, Callable[[Source, _Lint], None]] = {
    "part": _lint_part,
    "rules": _lint_rules,
    "vocabulary": _lint_vocabulary,
    "unreadable": _lint_unreadable,
}
"""Kinds of files that are linted one by one."""


def _bytes_of(path: Path, lint: _Lint) -> bytes:
    """The bytes of a file; nothing and a finding if it cannot be read, or is beyond the limit."""
    try:
        size = size_of(path)
        if size <= DEFAULT_LIMITS.file_bytes:
            return read_bytes(path)
        message = f"The file has {size:,} bytes; the limit is {DEFAULT_LIMITS.file_bytes:,}."
        finding = codes.FILE_TOO_LARGE.finding(message, str(path))
    except OSError as error:
        finding = codes.FILE_UNREADABLE.finding(f"{str(path)!r} cannot be read: {error.strerror}.", str(path))
    lint.add([(finding, None)])
    return b""


# -- the result -------------------------------------------------------------------------------------------------------


def _result(lint: _Lint, every_rule: Sequence[Rule], whole: Sequence[Path]) -> LintResult:
    """Lines, suppressions, severities and the baseline: what is the same for every kind of file."""
    known = [rule.id for rule in every_rule]
    lines, suppressions = _judged_texts(lint, known)
    grading = Grading(lint.rules.severities, frozenset(known), lint.options)
    kept = apply_suppressions(in_order(list(grading.graded([*lint.found, *lines]))), suppressions, lint.rules.codes)
    findings = [*kept.findings, *grading.graded(kept.about_comments)]
    findings, in_baseline = _without_baseline(findings, grading, whole)
    unused = ((graded, repair) for finding, repair in kept.unused for graded in grading.graded([finding]))
    repairs = {identity_of(f): r for f, r in (*lint.found.items(), *lines.items(), *unused) if r is not None}
    beside = tuple(sorted(lint.beside.difference(lint.files)))
    return LintResult(
        in_order(findings, lint.causes, lint.functions),
        tuple(lint.files),
        beside,
        repairs,
        kept.suppressed + in_baseline,
        lint.rules.counted,
    )


def _judged_texts(lint: _Lint, known: Sequence[str]) -> tuple[dict[Finding, Repair | None], list[Suppressions]]:
    """Return the findings in lines, and the comments that suppress findings."""
    lines: dict[Finding, Repair | None] = {}
    suppressions = []
    no_text = {finding.file for finding in lint.found if finding.rule in _NOT_TEXT}
    for name, texts in lint.files.items():
        if texts == "nothing" or name in no_text:
            continue
        data = first_bytes(Path(name))
        content = data.decode("utf-8-sig", "replace")
        if texts == "vspec":
            lines.update(lint_lines(content, name, lint.rules))
        if MARK in data:
            suppressions.append(read_suppressions(content, name, known))
    return lines, suppressions


def _without_baseline(findings: list[Finding], grading: Grading, whole: Sequence[Path]) -> tuple[list[Finding], int]:
    """The findings that the baseline does not know, and how many it does. `whole` are paths with all that is in them."""
    options = grading.options
    if options.baseline is None:
        return findings, 0
    from sigcat.rules.linting.baseline import compare, covers, read_baseline  # few runs have one

    baseline = read_baseline(options.baseline)
    is_complete = bool(whole) and covers(whole, baseline, options.root)
    compared = compare(findings, baseline, options.root, complete=is_complete)
    return [*compared.findings, *grading.graded(compared.stale)], compared.known
