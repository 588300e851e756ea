"""Lint files: paths in, findings out.

What a user may expect: a folder or the root of a tree is checked as a whole tree; an overlay is checked over the tree
that it is made for, together with the overlays beside it; a part of a tree that is named alone, as pre-commit names
changed files, is checked by itself, at the place that its tree gives it. Findings are told for named files only.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Literal, NamedTuple

from sigcat import codes
from sigcat.catalogue.composing.compose import compose, compose_part
from sigcat.catalogue.composing.older_releases import Units, in_present_words, read_units
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.definition import Definition
from sigcat.catalogue.model.vocabulary import EMPTY, Vocabulary, default_files, read_vocabulary
from sigcat.catalogue.reading.layers import Layer, layer_from_text, read_layer
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.data import OVERLAYS, ROOT_FILE
from sigcat.file_kind import FUNCTION_KINDS, QUANTITY_NAMES, UNIT_NAMES, file_kind
from sigcat.findings import Finding, Severity, in_order
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.rules.engine import Found, found_in, lint_lines
from sigcat.rules.flaw import Repair
from sigcat.rules.linting.discovery import (
    Source,
    default_tree,
    discover,
    first_bytes,
    types_beside,
)
from sigcat.rules.linting.options import LintOptions, LintResult, place_of
from sigcat.rules.linting.selection import chosen, graded, matches, rules_for
from sigcat.rules.linting.suppression import MARK, apply_suppressions, read_suppressions
from sigcat.rules.record import Rule, parse_rules
from sigcat.rules.rule_set import RuleSet
from sigcat.rules.tree import Tree

_WHOLE_TREE_CHECKS = frozenset(("reference", "reference-cycle", "companions", "asil-of-step", "deprecation-target"))
_WHOLE_TREE_CODES = frozenset(
    (
        codes.BRANCH_UNDEFINED.id,
        codes.SECOND_ROOT.id,
        codes.OUTSIDE_ROOT.id,
        codes.INCLUDE_OUTSIDE.id,
        codes.GLOB_MATCHES_NOTHING.id,
    )
)
"""What composing says of a part alone only because the rest of its tree is not there."""

_ABOUT_RULES = frozenset((codes.RULE_UNUSABLE.id, codes.RULE_TOO_SLOW.id))
"""What is wrong with a rule is told wherever it was to be used."""
_UNREADABLE = frozenset((codes.NOT_UTF_8.id, codes.FILE_TOO_LARGE.id))
"""A file that is no text has no lines to judge."""

Texts = Literal["vspec", "comments", "nothing"]
"""What is looked at in the text of a file beside its values: lines and comments, comments, or nothing."""


_AS_IT_IS = LintOptions()


class _Lint(NamedTuple):
    """What one lint gathers: findings with repairs, and the files that were looked at."""

    options: LintOptions
    rules: RuleSet
    found: dict[Finding, Repair | None]
    files: dict[str, Texts]


def lint_paths(paths: Sequence[Path], options: LintOptions | None = None) -> LintResult:
    """Lint files and folders. Raises NotFound, UsageError, and InputRefused for rules that cannot be used."""
    with collector_paused():
        return _linted(paths, options or LintOptions())


def _linted(paths: Sequence[Path], options: LintOptions) -> LintResult:
    every_rule = rules_for(options)
    sources = [s for s in discover(paths, options.overlays, options.types) if not _excluded(s.path, options)]
    options = options._replace(types=_types(sources, options))
    lint = _Lint(options, RuleSet(chosen(every_rule, options)), {}, {})
    bases = _lint_trees([s.path for s in sources if s.kind == "tree"], lint)
    _lint_overlays([s.path for s in sources if s.kind == "overlay"], bases, lint)
    for source in sources:
        if source.kind == "part" and source.tree is not None:
            _lint_part(source, lint)
        elif source.kind == "types":
            _lint_types(source.path, bases, lint)
        elif source.kind == "rules":
            _lint_rules(source.path, lint)
        elif source.kind == "vocabulary" and str(source.path) not in lint.files:
            _lint_vocabulary(source.path, lint)
    complete = any(path.is_dir() for path in paths)
    _lint_functions([s.path for s in sources if s.kind == "function"], lint, complete=complete)
    return _finished(lint, every_rule, paths if complete else ())


def lint_text(
    text: bytes,
    name: str,
    base: Catalogue | None,
    rules: RuleSet,
    *,
    is_tree: bool = False,
    limits: Limits = DEFAULT_LIMITS,
) -> tuple[Finding, ...]:
    """Findings in a text that stands in no file: an overlay over `base`, or a tree by itself."""
    if not text.strip():
        return (
            codes.POSTED_TEXT_EMPTY.finding("The text is empty.", name, 1, 1, fix="Send the file: nothing of it came."),
        )
    if file_kind(text) in FUNCTION_KINDS:
        wanted = "a tree" if is_tree else "an overlay"
        message = f"The text must be {wanted}, not a function."
        return (codes.FIELD_UNKNOWN.finding(message, name, 1, 1, fix="Check it with the kind `function`."),)
    layer = layer_from_text(text, name, is_overlay=not is_tree, limits=limits)
    if is_tree or base is None:
        compose_text = partial(compose, [layer], base.vocabulary if base else EMPTY, limits=limits)
        alone = compose_text(expanded=False)
        found = found_in(_with_instances(alone, alone.definitions.values(), compose_text), rules)
    else:
        part = compose_part(base, layer, limits)
        judged = part.changed.values()
        found = found_in(_with_instances(part, judged, partial(_composed_over, base, layer, limits)), rules, judged)
    content = text.decode("utf-8-sig", "replace")
    findings = [f for f, _ in found if f.file == name]
    findings.extend(lint_lines(content, name, rules))
    suppressions = [read_suppressions(content, name, rules.codes)] if MARK in text else []
    grade = _Grade(rules.severities, frozenset(), _AS_IT_IS)
    kept = apply_suppressions(in_order(list(grade.all(findings))), suppressions, rules.codes)
    return in_order((*kept.findings, *grade.all(kept.about_comments)))


def _composed_over(base: Catalogue, layer: Layer, limits: Limits) -> Catalogue:
    layers = [*base.tree_layers, layer]
    return compose(layers, base.vocabulary, base.type_layers, name=base.name, limits=limits, earlier=base)


def _with_instances(catalogue: Catalogue, judged: Iterable[Definition], expanded: Callable[[], Catalogue]) -> Catalogue:
    """The catalogue, and where instances are made or refined, what is wrong with them: only `expanded` shows that."""
    tree = Tree(catalogue)
    if not any("instances" in definition.values or tree.is_instance(definition.path) for definition in judged):
        return catalogue
    known = {_without_path(finding) for finding in catalogue.findings}
    more = [finding for finding in expanded().findings if _without_path(finding) not in known]
    return catalogue.with_findings(in_order([*catalogue.findings, *more])) if more else catalogue


def _without_path(finding: Finding) -> tuple[str, str, int, int, str]:
    """A problem stands in one place, and has the path of every instance that has it."""
    return (finding.rule, finding.file, finding.line, finding.column, finding.message)


def _lint_trees(roots: Sequence[Path], lint: _Lint) -> dict[Path, Catalogue]:
    bases = {}
    for root in roots:
        catalogue = _compose_tree(root, (), lint.options)
        bases[root] = catalogue
        _add(found_in(catalogue, lint.rules, attributes=lint.options.attributes), None, lint)
        files = [file.name for layer in catalogue.layers for file in layer.files]
        _look_at([*files, *(file.name for file in catalogue.vocabulary.files)], lint)
        _look_at([str(root)], lint)
    return bases


def _compose_tree(root: Path, overlays: Sequence[Path], options: LintOptions) -> Catalogue:
    tree = read_layer(root, options.include_dirs)
    vocabulary, is_older = _units(root, tree, overlays, options)
    types = _type_layers((root,), options)
    layers = [_as_of_its_time(tree, is_older)]
    catalogue = compose(layers, vocabulary, types, expanded=False, name=root.stem)
    expanded = partial(compose, layers, vocabulary, types, name=root.stem, earlier=catalogue)
    return _with_instances(catalogue, catalogue.definitions.values(), expanded)


def _as_of_its_time(layer: Layer, is_older: bool) -> Layer:
    """The tree of an older release in the words of today; what it breaks is graded as in any tree."""
    return in_present_words(layer) if is_older else layer


def _units(root: Path, tree: Layer, overlays: Sequence[Path], options: LintOptions) -> Units:
    """Units beside the tree, then those beside its overlays, then those of the options; of a release of any age.

    Where there are none, an official tree that uses units is one of 3.0; one that uses none tells nothing of its age.
    """
    units = default_files(root, (), UNIT_NAMES[0])
    quantities = default_files(root, (), QUANTITY_NAMES[0])
    for folder in dict.fromkeys(path.parent for path in overlays):
        units += tuple(folder / name for name in UNIT_NAMES if (folder / name).is_file())
        quantities += tuple(folder / name for name in QUANTITY_NAMES if (folder / name).is_file())
    if overlays and root == ROOT_FILE and not options.units and units == default_files(root, (), UNIT_NAMES[0]):
        units += (OVERLAYS / UNIT_NAMES[0],)  # the shipped tree has them for functions, too
    units, quantities = (*units, *options.units), (*quantities, *options.quantities)
    if not units and not any("unit" in statement.values for statement in tree.statements):
        return Units(read_vocabulary((), tuple(dict.fromkeys(quantities))), is_older=False)
    return read_units(root, tuple(dict.fromkeys(units)), tuple(dict.fromkeys(quantities)))


def _lint_overlays(overlays: Sequence[Path], bases: dict[Path, Catalogue], lint: _Lint) -> None:
    groups: dict[Path, list[Path]] = {}
    for overlay in overlays:
        groups.setdefault(_base_for(overlay, list(bases), lint.options), []).append(overlay)
    for base, group in groups.items():
        _lint_group(base, group, lint)


def _base_for(overlay: Path, roots: Sequence[Path], options: LintOptions) -> Path:
    if options.base is not None:
        return options.base
    if len(roots) == 1:
        return roots[0]
    near = default_tree(overlay)
    return near if near is not None else ROOT_FILE


def _lint_group(base: Path, group: Sequence[Path], lint: _Lint) -> None:
    """Overlays over one tree, with those that belong to them; findings in the named ones only."""
    options = lint.options
    order = _in_order_of_application(group, options)
    tree = read_layer(base, options.include_dirs)
    vocabulary, is_older = _units(base, tree, order, options)
    overlays = [read_layer(path, options.include_dirs, is_overlay=True) for path in order]
    types = _type_layers((base, *order), options)
    tree = _as_of_its_time(tree, is_older)
    earlier = _unchecked(tree, vocabulary)
    catalogue = compose([tree, *overlays], vocabulary, types, expanded=False, name=base.stem, earlier=earlier)
    named = {str(path) for path in group}
    files = {file.name for layer in overlays if layer.name in named for file in layer.files} | named
    beside = {file.name for file in vocabulary.files if Path(file.name).parent in {path.parent for path in group}}
    judged = tuple(catalogue.written_in(files))
    expanded = partial(compose, [tree, *overlays], vocabulary, types, name=base.stem, earlier=catalogue)
    found = found_in(_with_instances(catalogue, judged, expanded), lint.rules, judged, options.attributes)
    _add(found, files | (beside - set(lint.files)), lint)
    _look_at([*files, *beside], lint)


def _unchecked(tree: Layer, vocabulary: Vocabulary) -> Catalogue:
    """The tree as it is written, unchecked: nodes that no overlay speaks of are looked up, and never judged."""
    definitions = {s.path: Definition(s.path, (s,), s.values) for s in tree.statements}
    return Catalogue(tree.name, (), vocabulary, (), (), definitions, is_expanded=False)


def _in_order_of_application(group: Sequence[Path], options: LintOptions) -> list[Path]:
    """The overlays of the configuration and those beside the named ones, and the named ones, in order."""
    stack = {path.resolve(): path for path in options.overlays}
    named = {path.resolve(): path for path in group}
    if any(path in stack for path in named):
        context = dict(stack)
    else:
        context = {**stack, **{path.resolve(): path for path in _beside(group)}}
    return list({**context, **named}.values())


def _beside(group: Sequence[Path]) -> list[Path]:
    """The other overlays of the folders: one may refer to what another defines."""
    folders = dict.fromkeys(path.parent for path in group)
    near = [path for folder in folders for path in sorted(folder.glob("*.vspec")) if path.is_file()]
    named = {path.resolve(): path for path in group}
    found = discover(near, group) if near else ()
    return [named.get(s.path.resolve(), s.path) for s in found if s.kind == "overlay"]


def _types(sources: Iterable[Source], options: LintOptions) -> tuple[Path, ...]:
    """The files of struct types: those of the options, and those that were found."""
    known = {path.resolve(): path for path in options.types}
    found = {source.path.resolve(): source.path for source in sources if source.kind == "types"}
    return tuple({**known, **found}.values())


def _type_layers(files: Iterable[Path], options: LintOptions) -> list[Layer]:
    """The struct types of a tree and its overlays: those of the options, and those in the same folders."""
    paths = {path.resolve(): path for path in (*types_beside(files), *options.types)}
    return [read_layer(path, options.include_dirs) for path in paths.values()]


def _lint_types(path: Path, bases: dict[Path, Catalogue], lint: _Lint) -> None:
    """A tree of struct types by itself, with the units of the tree that uses them."""
    options = lint.options
    layer = read_layer(path, options.include_dirs)
    vocabulary, _ = _units(_base_for(path, list(bases), options), layer, [path], options)
    types = [layer if other == path else read_layer(other, options.include_dirs) for other in options.types]
    catalogue = compose([layer], vocabulary, types, expanded=False, name=path.stem)
    files = {file.name for file in layer.files} | {str(path)}
    _add(found_in(catalogue, lint.rules, attributes=options.attributes), files, lint)
    _look_at(files, lint)


def _lint_part(source: Source, lint: _Lint) -> None:
    assert source.tree is not None
    data = _bytes_of(source.path, lint)
    layer = layer_from_text(data, str(source.path), is_overlay=False)
    if source.prefix:
        statements = tuple(statement.placed(source.prefix) for statement in layer.statements)
        layer = Layer(layer.name, False, layer.files, statements, layer.findings)
    vocabulary, is_older = _units(source.tree, layer, (), lint.options)
    catalogue = compose([_as_of_its_time(layer, is_older)], vocabulary, expanded=False)
    found = found_in(catalogue, lint.rules.without(_WHOLE_TREE_CHECKS), attributes=lint.options.attributes)
    _add(((f, r) for f, r in found if f.rule not in _WHOLE_TREE_CODES), {str(source.path)}, lint)
    _look_at([str(source.path)], lint)


def _bytes_of(path: Path, lint: _Lint) -> bytes:
    """The bytes of a file; nothing and a finding if it cannot be read, or is beyond the limit."""
    try:
        size = path.stat().st_size
        if size <= DEFAULT_LIMITS.file_bytes:
            return path.read_bytes()
        message = f"The file has {size:,} bytes; the limit is {DEFAULT_LIMITS.file_bytes:,}."
        finding = codes.FILE_TOO_LARGE.finding(message, str(path))
    except OSError as error:
        finding = codes.FILE_UNREADABLE.finding(f"{str(path)!r} cannot be read: {error.strerror}.", str(path))
    _add([(finding, None)], None, lint)
    return b""


def _lint_functions(paths: Sequence[Path], lint: _Lint, *, complete: bool) -> None:
    """Function files, alone and together. Files that were named one by one may be a part of a set."""
    _look_at(map(str, paths), lint, "comments")
    read = [(_bytes_of(path, lint), str(path)) for path in paths]
    unreadable = {
        finding.file for finding in lint.found if finding.rule in (codes.FILE_TOO_LARGE.id, codes.FILE_UNREADABLE.id)
    }
    files = [(data, name) for data, name in read if name not in unreadable]
    if lint.options.check_functions is not None and files:
        _add(((f, None) for f in lint.options.check_functions(files, complete)), None, lint)


def _lint_rules(path: Path, lint: _Lint) -> None:
    _look_at([str(path)], lint, "nothing")
    file = parse_rules(_bytes_of(path, lint), str(path), trusted=False)
    bound = found_in(compose([]), RuleSet(file.rules))
    _add(((f, None) for f in file.findings), None, lint)
    _add(bound, None, lint)


def _lint_vocabulary(path: Path, lint: _Lint) -> None:
    is_units = path.name in UNIT_NAMES
    beside = tuple(path.parent / name for name in QUANTITY_NAMES if (path.parent / name).is_file())
    vocabulary = read_units(path, (path,), beside).vocabulary if is_units else read_vocabulary((), (path,))
    _add(((f, None) for f in vocabulary.findings), {str(path)}, lint)
    _look_at([str(path)], lint)


def _add(found: Iterable[Found], files: set[str] | None, lint: _Lint) -> None:
    for finding, repair in found:
        if files is None or finding.file in files or finding.rule in _ABOUT_RULES:
            lint.found.setdefault(finding, repair)


def _look_at(files: Iterable[str], lint: _Lint, texts: Texts = "vspec") -> None:
    lint.files.update(dict.fromkeys(files, texts))


def _excluded(path: Path, options: LintOptions) -> bool:
    return any(matches(str(path), glob, options.root) for glob in options.exclude)


def _finished(lint: _Lint, every_rule: Sequence[Rule], complete: Sequence[Path]) -> LintResult:
    """Lines, suppressions, severities of folders and the baseline: what does not depend on the kind of file."""
    options = lint.options
    codes = [rule.id for rule in every_rule]
    suppressions = []
    findings = list(lint.found)
    no_texts = {finding.file for finding in findings if finding.rule in _UNREADABLE}
    for name, texts in lint.files.items():
        if texts == "nothing" or name in no_texts:
            continue
        data = first_bytes(Path(name))
        content = data.decode("utf-8-sig", "replace")
        if texts == "vspec":
            findings.extend(lint_lines(content, name, lint.rules))
        if MARK in data:
            suppressions.append(read_suppressions(content, name, codes))
    grade = _Grade(lint.rules.severities, frozenset(codes), options)
    kept = apply_suppressions(in_order(list(grade.all(findings))), suppressions, lint.rules.codes)
    told = [*kept.findings, *grade.all(kept.about_comments)]
    known = 0
    if options.baseline is not None:
        from sigcat.rules.linting.baseline import compare, covers, read_baseline

        baseline = read_baseline(options.baseline)
        is_complete = bool(complete) and covers(complete, baseline, options.root)
        compared = compare(told, baseline, options.root, complete=is_complete)
        told, known = [*compared.findings, *grade.all(compared.stale)], compared.known
    unused = ((f, r) for finding, r in kept.unused for f in grade.all([finding]))
    repairs = {place_of(f): r for f, r in (*lint.found.items(), *unused) if r is not None}
    return LintResult(in_order(told), tuple(lint.files), repairs, kept.suppressed + known)


class _Grade(NamedTuple):
    """Severities of the rules that run. A code without a record is told as it is."""

    severities: Mapping[str, Severity]
    codes: frozenset[str]
    options: LintOptions

    def all(self, findings: Iterable[Finding]) -> Iterator[Finding]:
        """Findings of rules that run, with their severities; those of other rules are left out."""
        for finding in findings:
            severity = self.severities.get(finding.rule)
            if severity is None and finding.rule in self.codes:
                continue
            if severity is not None and severity != finding.severity:
                finding = finding._replace(severity=severity)  # noqa: PLW2901 — the finding as this lint grades it
            final = graded(finding, self.options.per_file, self.options.root)
            if final is not None:
                yield final
