"""The examples in the records of rules, run: each good one has no finding of its rule, each bad one has one."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.model.vocabulary import EMPTY, Vocabulary, read_vocabulary
from sigcat.catalogue.network.can_database import CanDatabase, read_can_database
from sigcat.catalogue.reading.layers import Layer, layer_from_text, read_layer
from sigcat.findings import Finding
from sigcat.names import parent_path
from sigcat.rules.engine import found_in, lint_lines
from sigcat.rules.linting.suppression import apply_suppressions, read_suppressions
from sigcat.rules.rule_set import RuleSet


def findings_of_example(
    example: str | Mapping[str, Any], rules: RuleSet, units: Vocabulary, folder: Path
) -> tuple[Finding, ...]:
    """All findings in an example. `folder` is an empty one, for examples that consist of files."""
    parts: dict[str, Any] = {"base": example} if isinstance(example, str) else dict(example)
    texts = [text for text in _texts(parts) if isinstance(text, str)]
    vocabulary = _vocabulary(parts, units, folder)
    layers = _files(parts["files"], folder) if "files" in parts else _layers(parts)
    found = [f for f, _ in found_in(compose(layers, vocabulary, expanded=False), rules, can=_can(parts, folder))]
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
        return units
    unit_file, quantity_file = folder / "units.yaml", folder / "quantities.yaml"
    unit_file.write_text(parts["units"], encoding="utf-8")
    quantity_file.write_text(parts.get("quantities", ""), encoding="utf-8")
    return read_vocabulary([unit_file], [quantity_file]) if parts["units"] else EMPTY
