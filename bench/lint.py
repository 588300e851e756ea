"""The linter as a process, cold, next to its reference."""

import os
import sys
from collections.abc import Callable, Mapping
from pathlib import Path

from bench import trees
from bench.measuring import command, interleaved
from bench.rows import Bench, Missing, Row
from sigcat.catalogue.hosting.releases import releases_folder
from sigcat.data import OVERLAYS, ROOT_FILE, VSPEC

_COMPOSE = """
import os, sys, yaml
for here, _, names in os.walk(sys.argv[1]):
    for name in names:
        with open(os.path.join(here, name), "rb") as file:
            yaml.compose(file, Loader=yaml.CSafeLoader)
"""


def whole_tree(bench: Bench) -> Row:
    """A copy of the shipped tree, which vss-tools accepts too, beside its export with `--strict`."""
    vspec = str(Path(sys.executable).with_name("vspec"))
    output = str(bench.folder / "out.json")
    tree = trees.copied(VSPEC, bench.folder)
    strict = command(vspec, "export", "json", "--strict", "-s", str(tree / ROOT_FILE.name), "-o", output)
    figure, reference = interleaved([_lint(tree), strict], bench.runs)
    return _row("`sigcat lint vspec`", figure, "`vspec export json --strict`", reference, 12, is_faster=True)


def parser_alone(bench: Bench) -> Row:
    """The tree of an official release beside a process that only reads the same files as YAML. Raises Missing."""
    tree = _official()
    compose = command(sys.executable, "-c", _COMPOSE, str(tree))
    figure, reference = interleaved([_lint(tree), compose], 3 * bench.runs)
    return _row(
        "`sigcat lint` of an official release (`sigcat pull v6.0`)",
        figure,
        "Python and `yaml.compose`",
        reference,
        4,
    )


def changed_part(bench: Bench) -> Row:
    """One file of a tree, as pre-commit names it."""
    return _changed("a changed part of a tree", VSPEC / "Body" / "Body.vspec", bench)


def changed_overlay(bench: Bench) -> Row:
    """One overlay, for which the tree below it is read."""
    return _changed("a changed overlay", OVERLAYS / "error.vspec", bench)


def hundred_thousand(bench: Bench) -> Row:
    """A hundred thousand signals beside five times twenty thousand."""
    large = trees.flat(bench.folder / "lint", 100_000)
    small = trees.flat(bench.folder / "lint", 20_000)
    figure, reference = interleaved([_lint(large), _lint(small)], min(bench.runs, 3))
    return _row("`sigcat lint` of 100,000 signals", figure, "5 × 20,000 signals", 5 * reference, 1.2)


ROWS: Mapping[str, Callable[[Bench], Row]] = {
    "lint": whole_tree, "lint-parser": parser_alone, "lint-part": changed_part, "lint-overlay": changed_overlay,
    "lint-large": hundred_thousand,
}  # fmt: skip


def _official() -> Path:
    """The tree of VSS 6.0: that of the folder in VSS_RELEASES, or the one that was pulled."""
    folder = Path(os.environ.get("VSS_RELEASES") or releases_folder())
    tree = (folder / "v6.0" / "spec").resolve()
    if not tree.is_dir():
        raise Missing("the official release v6.0: `sigcat pull v6.0`, or name a folder that has it in VSS_RELEASES")
    return tree


def _changed(work: str, file: Path, bench: Bench) -> Row:
    imported = command(sys.executable, "-c", "import yaml")
    figure, reference = interleaved([_lint(file), imported], 5 * bench.runs)
    return _row(f"`sigcat lint` of {work}", figure, '`python -c "import yaml"`', reference, 3)


def _lint(path: Path) -> Callable[[], float]:
    return command(str(Path(sys.executable).with_name("sigcat")), "lint", str(path), status=(0, 1))


def _row(work: str, figure: float, name: str, reference: float, wanted: float, *, is_faster: bool = False) -> Row:
    ratio = reference / figure if is_faster else figure / reference
    shown = f"{ratio:.1f} × faster" if is_faster else f"{ratio:.2f} ×"
    target = f"at least {wanted} × faster" if is_faster else f"at most {wanted} ×"
    is_met = ratio >= wanted if is_faster else ratio <= wanted
    return Row(work, f"{figure * 1000:.0f} ms", f"{name}: {reference * 1000:.0f} ms", shown, target, is_met)
