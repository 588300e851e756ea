"""Count the changes between neighbouring official releases of VSS in docs/explanation/census.md: `python -m scripts.census`."""

import argparse
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

from sigcat.catalogue.comparing.bindings import BINDINGS, Binding, classes_of
from sigcat.catalogue.comparing.changes import Change, Class
from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.comparing.sides import read_side
from sigcat.catalogue.hosting.releases import releases_folder
from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import NotFound

PAGE = Path(__file__).parents[1] / "docs" / "explanation" / "census.md"
RELEASES = ("v3.0", "v3.1", "v4.0", "v4.1", "v4.2", "v5.0", "v5.1", "v6.0")
"""The official releases that sigcat reads."""
_WORST = 10
_INTRODUCTION = """# Census of changes

This page counts the changes between neighbouring official releases of VSS by their class for each
[binding](../reference/compatibility.md#bindings). `python -m scripts.census` writes it.
"""
_TABLE = """
## Changes by binding

A cell has the number of breaking, risky and other changes.

"""
_HEAVIEST = """
## The ten heaviest changes

The weight of a change is the number of its signals, multiplied by the number of bindings that it breaks.

"""


class Step(NamedTuple):
    """Two neighbouring releases and their changes."""

    old: str
    new: str
    changes: Sequence[Change]

    @property
    def title(self) -> str:
        """`5.0 → 5.1`."""
        return f"{self.old.removeprefix('v')} → {self.new.removeprefix('v')}"


def main() -> int:
    """Read the releases and write the page."""
    parser = argparse.ArgumentParser(prog="python -m scripts.census", description=__doc__)
    parser.add_argument(
        "folder", nargs="?", type=Path, default=releases_folder(), metavar="FOLDER",
        help="folder with the releases, each in a folder of its name (default: those that `sigcat pull` downloaded)",
    )  # fmt: skip
    folder = parser.parse_args().folder
    if missing := [name for name in RELEASES if not (folder / name).is_dir()]:
        parser.error(f"{folder} lacks {', '.join(missing)}: `sigcat pull {missing[0]}`")
    PAGE.write_text(page(steps(folder)), encoding="utf-8")
    return 0


def steps(folder: Path) -> Sequence[Step]:
    """Compare the releases of a folder."""
    catalogues = ((name, _catalogue(folder / name)) for name in RELEASES)
    return [Step(old, new, compare(before, after)) for (old, before), (new, after) in pairwise(catalogues)]


def _catalogue(folder: Path) -> Catalogue:
    return read_side(str(folder), _no_release).catalogue


def _no_release(name: str) -> Source:
    raise NotFound(name)


def page(all_steps: Sequence[Step]) -> str:
    """The page in Markdown."""
    return "".join((_INTRODUCTION, _summary(all_steps), _TABLE, *_table(all_steps), _HEAVIEST, *_heaviest(all_steps)))


def _summary(all_steps: Sequence[Step]) -> str:
    """Count the steps that look harmless by path and break other bindings."""
    by_path = [step for step in all_steps if not _breaks(step, "path")]
    protobuf, ros2 = (sum(_breaks(step, name) for step in by_path) for name in ("protobuf", "ros2"))
    return f"""
{len(by_path)} of {len(all_steps)} steps break no lookup by path. Of these, Protocol Buffers break in {protobuf} and ROS 2 messages in {ros2}.
"""


def _breaks(step: Step, binding: Binding) -> bool:
    return any(binding in _broken(change) for change in step.changes)


def _table(all_steps: Iterable[Step]) -> Iterator[str]:
    yield f"| releases | changes | {' | '.join(BINDINGS)} |\n|---|---|{'---|' * len(BINDINGS)}\n"
    for step in all_steps:
        counts = Counter((each.binding, each.compatibility) for change in step.changes for each in classes_of(change))
        cells = (_cell(counts, binding) for binding in BINDINGS)
        yield f"| {step.title} | {len(step.changes)} | {' | '.join(cells)} |\n"


def _cell(counts: Counter[tuple[Binding, Class]], binding: Binding) -> str:
    others = counts[binding, "compatible"] + counts[binding, "text"]
    return f"{counts[binding, 'breaking']} / {counts[binding, 'risky']} / {others}"


def _heaviest(all_steps: Iterable[Step]) -> Iterator[str]:
    weighed = [(_weight(change), step, change) for step in all_steps for change in step.changes]
    yield "| releases | node | change | signals | breaks | rules |\n|---|---|---|---|---|---|\n"
    for _, step, change in sorted(weighed, key=lambda each: each[0], reverse=True)[:_WORST]:
        broken = _broken(change)
        names = "all" if len(broken) == len(BINDINGS) else ", ".join(broken)
        path = change.former or change.path
        yield f"| {step.title} | `{path}` | {change.kind} | {_signals(change)} | {names} | {_rules(change)} |\n"


def _weight(change: Change) -> int:
    return _signals(change) * len(_broken(change))


def _signals(change: Change) -> int:
    return change.leaves or len(change.paths)


def _broken(change: Change) -> Sequence[Binding]:
    return [each.binding for each in classes_of(change) if each.compatibility == "breaking"]


def _rules(change: Change) -> str:
    rules = dict.fromkeys(each.rule for each in classes_of(change) if each.compatibility == "breaking")
    return ", ".join(f"`{rule}`" for rule in rules)


if __name__ == "__main__":
    raise SystemExit(main())
