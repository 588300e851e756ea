"""The examples in the records of rules, run: each good one has no finding of its rule, each bad one has one."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from sigcat import codes
from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.model.vocabulary import EMPTY, Vocabulary, read_vocabulary
from sigcat.catalogue.network.can_database import CanDatabase, read_can_database
from sigcat.catalogue.reading.layers import Layer, layer_from_text, read_layer
from sigcat.findings import Finding
from sigcat.names import parent_path
from sigcat.rules.engine import found_in, lint_lines
from sigcat.rules.linting.suppression import apply_suppressions, read_suppressions
from sigcat.rules.record import Rule
from sigcat.rules.record_faults import MAKERS
from sigcat.rules.rule_set import RuleSet
from sigcat.temporary_files import temporary_folder


def unfit_examples(rules: Iterable[Rule], units: Vocabulary) -> Iterator[Finding]:
    """A finding for each example of which the rule says something else. Units are those of the project."""
    for rule in rules:
        alone = RuleSet((rule,))
        if rule.check in MAKERS or alone.findings:  # its findings are not made here, or it cannot be used
            continue
        for index, example in enumerate(rule.good, 1):
            wrong = [f for f in _found(alone, example, units) if f.rule == rule.id or f.severity == "error"]
            for finding in wrong[:1]:
                message = f"Rule {rule.id} must not report its good example {index}, and does: {finding.message}"
                yield _unfit(rule, message)
        for index, example in enumerate(rule.bad, 1):
            if not any(each.rule == rule.id for each in _found(alone, example, units)):
                yield _unfit(rule, f"Rule {rule.id} must report its bad example {index}, and does not.")


def _found(alone: RuleSet, example: str | Mapping[str, Any], units: Vocabulary) -> tuple[Finding, ...]:
    """Findings of a rule in an example, and those about what it is written with."""
    with temporary_folder("sigcat-lint-") as folder:
        return findings_of_example(example, alone, units, Path(folder))


def _unfit(rule: Rule, message: str) -> Finding:
    fix = "Correct the example, or the rule."
    return codes.RULE_EXAMPLE_UNFIT.finding(message, rule.file, rule.line, 1, rule.id, fix=fix)


def findings_of_example(
    example: str | Mapping[str, Any], rules: RuleSet, units: Vocabulary, folder: Path
) -> tuple[Finding, ...]:
    """All findings in an example. `folder` is an empty one, for examples that consist of files."""
    parts: dict[str, Any] = {"base": example} if isinstance(example, str) else dict(example)
    texts = [text for text in _texts(parts) if isinstance(text, str)]
    vocabulary = _vocabulary(parts, units, folder)
    layers = _files(parts["files"], folder) if "files" in parts else _layers(parts)
    can = _can(parts, folder)
    found = [f for f, _ in found_in(compose(layers, vocabulary, expanded=False), rules, can=can)]
    found.extend(can.findings if can else ())
    for text in texts:
        found.extend(finding for finding, _ in lint_lines(text, "example.vspec", rules))
    suppressions = [
        read_suppressions(text, layer.name, rules.codes) for text, layer in zip(texts, layers[-1:], strict=False)
    ]
    kept = apply_suppressions(found, suppressions, rules.codes)
    return (*kept.findings, *kept.about_comments)


def _texts(parts: Mapping[str, Any]) -> list[Any]:
    return [parts.get("whole"), parts.get("base"), parts.get("overlay"), *parts.get("overlays", ())]


def _layers(parts: Mapping[str, Any]) -> list[Layer]:
    if "whole" in parts:
        return [layer_from_text(parts["whole"].encode(), "example.vspec", is_overlay=False)]
    base = layer_from_text(parts.get("base", "").encode(), "example.vspec", is_overlay=False)
    texts = [*([parts["overlay"]] if "overlay" in parts else ()), *parts.get("overlays", ())]
    overlays = [layer_from_text(text.encode(), f"overlay{i}.vspec") for i, text in enumerate(texts, 1)]
    return [_with_branches([base, *overlays]), base, *overlays]


def _with_branches(layers: Sequence[Layer]) -> Layer:
    """A layer with the branches that the statements of the others need above them and do not have."""
    written = {statement.path for layer in layers for statement in layer.statements}
    needed: dict[str, None] = {"Vehicle": None}
    for path in written:
        if "*" not in path:
            above = parent_path(path)
            while above:
                needed[above] = None
                above = parent_path(above)
    missing = sorted(path for path in needed if path not in written and path.strip("."))
    text = "".join(f"{path}: {{type: branch, description: A branch.}}\n" for path in missing)
    return layer_from_text(text.encode(), "branches.vspec", is_overlay=False)


def _files(files: Mapping[str, str], folder: Path) -> list[Layer]:
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    return [read_layer(folder / next(iter(files)))]


def _can(parts: Mapping[str, Any], folder: Path) -> CanDatabase | None:
    if "dbc" not in parts:
        return None
    file = folder / "example.dbc"
    file.write_text(parts["dbc"], encoding="utf-8")
    return read_can_database([file])


def _vocabulary(parts: Mapping[str, Any], units: Vocabulary, folder: Path) -> Vocabulary:
    if "units" not in parts:
        return units._replace(findings=())  # these are of the project, not of the example
    files = {key: folder / f"{key}.yaml" for key in ("units", "quantities") if parts.get(key)}
    for key, file in files.items():
        file.write_text(parts[key], encoding="utf-8")
    if "units" not in files:
        return EMPTY
    return read_vocabulary([files["units"]], [files["quantities"]] if "quantities" in files else [])
