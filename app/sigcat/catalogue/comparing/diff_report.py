"""Changes for readers: a tree for terminals, Markdown for release notes, data for programs."""

import json
import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import takewhile
from typing import Any

from sigcat.catalogue.comparing.bindings import BINDINGS, EFFECTS, TITLES, Effect, classes_of, reason
from sigcat.catalogue.comparing.changes import CLASSES, AttributeChange, Change, Class, Evidence, Kind, worst
from sigcat.catalogue.comparing.compatibility import ROWS, TABLE
from sigcat.terminal_text import printable

_SIGNS: Mapping[Kind, str] = {"added": "+", "removed": "-", "changed": "~", "moved": "→"}
_COLOURS: Mapping[str, str] = {
    "+": "32", "-": "31", "~": "33", "→": "36", "breaking": "1;31", "risky": "33", "compatible": "32", "text": "2",
}  # fmt: skip
_EVIDENCES: Mapping[Evidence, str] = {
    "": "",
    "fka": "its `fka` says so",
    "deprecation": "announced in its deprecation note",
    "same definition": "guessed: same definition",
}
_HEADINGS: Mapping[Class, str] = {
    "breaking": "Breaking", "risky": "Risky", "compatible": "Compatible", "text": "Text only",
}  # fmt: skip
_ABSENT = "(none)"
_SHOWN = 72
COMMENT_MARK = "<!-- sigcat diff -->"
"""First line of a comment, by which a pipeline finds the one to replace."""
_COMMENT_LENGTH = 65_000
"""GitHub takes 65,536 characters."""
_CUT = "\nThe comment is full: further changes are not shown. `sigcat diff` lists them all.\n"
_LISTED = 6
"""At most so many paths are listed; of the rest, the number."""


def summary(changes: Iterable[Change], hidden: int = 0) -> str:
    """`3 changes: 1 breaking, 2 compatible`; `hidden` more were left out on demand."""
    counts = _counts(changes)
    total = sum(counts.values())
    if not total:
        return f"No such changes; {hidden} others not shown." if hidden else "No differences."
    parts = ", ".join(f"{count} {_class_in_words(name)}" for name, count in counts.items() if count)
    others = f"; {hidden} others not shown" if hidden else ""
    return f"{total} {'change' if total == 1 else 'changes'}: {parts}{others}"


def text_report(changes: Sequence[Change], *, is_coloured: bool = False, hidden: int = 0) -> str:
    """The changes as a tree of the paths that users of the old tree know."""
    lines: list[str] = []
    above: tuple[str, ...] = ()
    for change in changes:
        *branches, name = (change.former or change.path).split(".")
        shared = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(above, branches, strict=False)))
        lines += [f"{'  ' * depth}{_in_one_line(branches[depth])}" for depth in range(shared, len(branches))]
        above = (*branches, name)
        indent = "  " * len(branches)
        sign = _coloured(_SIGNS[change.kind], _SIGNS[change.kind], is_coloured)
        label = _coloured(f"[{_class_in_words(change.compatibility)}]", change.compatibility, is_coloured)
        lines.append(f"{indent}{sign} {_in_one_line(name)}{_behind_name(change)}  {label}")
        lines += [f"{indent}    {detail}" for detail in _details(change)]
    return "\n".join([*lines, *([""] if lines else []), summary(changes, hidden), ""])


def markdown_report(changes: Sequence[Change], old: str, new: str, hidden: int = 0) -> str:
    """Release notes, the worst first. All text from the trees is in code spans, where nothing is markup."""
    return _heading(changes, old, new, hidden) + "".join(_sections(changes))


def markdown_comment(changes: Sequence[Change], old: str, new: str, hidden: int = 0) -> str:
    """The same as a comment of a pull request: with the mark by which the next one replaces it, and not too long for it."""
    text = f"{COMMENT_MARK}\n{_heading(changes, old, new, hidden)}"
    for part in _sections(changes):
        if len(text) + len(part) > _COMMENT_LENGTH - len(_CUT):
            return text + _CUT
        text += part
    return text


def _heading(changes: Sequence[Change], old: str, new: str, hidden: int) -> str:
    return f"# Changes from {_code(old)} to {_code(new)}\n\n{summary(changes, hidden).rstrip('.')}.\n"


def _sections(changes: Sequence[Change]) -> Iterator[str]:
    """Yield a heading for each class, then each of its changes whole."""
    for compatibility in CLASSES:
        chosen = [change for change in changes if change.compatibility == compatibility]
        for number, change in enumerate(chosen):
            heading = "" if number else f"\n## {_HEADINGS[compatibility]}\n\n"
            yield heading + "\n".join(markdown_lines(change)) + "\n"


def sentence(change: Change) -> str:
    """The change on one line, without a full stop."""
    first, *details = (line.strip().removeprefix("- ") for line in markdown_lines(change))
    return "; ".join((first, *details)).replace("`", "")


def diff_data(changes: Sequence[Change]) -> dict[str, Any]:
    """The changes as plain data: what JSON can hold, in keys that stay."""
    counts = _counts(changes)
    return {
        "summary": {
            "worst": worst(change.compatibility for change in changes) if changes else None,
            "total": len(changes),
            **counts,
        },
        "changes": [_change_data(change) for change in changes],
    }


def class_table() -> str:
    """The class table in Markdown."""
    rows = [
        "| Rule | What changed | Actuator | Sensor | Attribute | Why |",
        "|---|---|---|---|---|---|",
        *(f"| `{r.rule}` | {r.what} | {r.actuator} | {r.sensor} | {r.attribute} | {r.why} |" for r in TABLE),
    ]
    return "\n".join(rows) + "\n"


def binding_names() -> str:
    """The list of bindings in Markdown."""
    rows = "".join(f"| `{name}` | {title} |\n" for name, title in TITLES.items())
    return f"| binding | software that uses |\n|---|---|\n{rows}"


def binding_table() -> str:
    """The table of bindings in Markdown; `=` is the class of the table of classes, an empty cell no effect."""
    rows = [
        f"| Rule | {' | '.join(BINDINGS)} | Why |",
        f"|---|{'---|' * len(BINDINGS)}---|",
        *(f"| {_rule_cell(each)} | {' | '.join(_binding_cells(each))} | {each.why} |" for each in EFFECTS),
        f"| all others |{' = |' * len(BINDINGS)} The meaning of the values is the same in every binding. |",
    ]
    return "\n".join(rows) + "\n"


def _binding_cells(effect: Effect) -> Iterator[str]:
    for name in BINDINGS:
        cell = effect.cells.get(name, "=")
        yield "" if effect.what and cell == "compatible" else cell


def _rule_cell(effect: Effect) -> str:
    return f"`{effect.rule}`: {effect.what}" if effect.what else f"`{effect.rule}`"


def _in_one_line(text: str) -> str:
    return printable(re.sub(r"\s+", " ", text))


def _counts(changes: Iterable[Change]) -> dict[Class, int]:
    counts: dict[Class, int] = dict.fromkeys(CLASSES, 0)
    for change in changes:
        counts[change.compatibility] += 1
    return counts


def _class_in_words(compatibility: Class) -> str:
    return "text only" if compatibility == "text" else compatibility


def _coloured(text: str, of: str, is_coloured: bool) -> str:
    return f"\x1b[{_COLOURS[of]}m{text}\x1b[0m" if is_coloured else text


# -- one change as text -------------------------------------------------------------------------------------------


def _behind_name(change: Change) -> str:
    """Return the text after the name: the number of nodes, and their new paths."""
    parts = [f"  → {_in_one_line(change.path)}"] if change.former and change.kind == "moved" else []
    counted = _counted(change)
    if counted:
        parts.append(f"  {counted}")
    if change.former and change.kind == "changed":
        parts.append(f"  now {_in_one_line(change.path)}")
    return "".join(parts)


def _counted(change: Change) -> str:
    """`6 instances, 144 signals`; nothing for one signal."""
    parts = [f"{len(change.paths)} instances"] if len(change.paths) > 1 else []
    if change.type == "branch" and change.kind != "changed":
        if change.leaves:
            parts.append(f"{change.leaves} {'signal' if change.leaves == 1 else 'signals'}")
        else:
            parts.append("no new signals" if change.kind == "added" else "no signals lost")
    return ", ".join(parts)


def _details(change: Change) -> Iterator[str]:
    if change.evidence:
        yield _EVIDENCES[change.evidence]
    if change.note:
        yield f"its deprecation said: {_short(change.note)}"
    if change.rule not in ROWS:
        yield _because(change)
    for attribute in change.attributes:
        old, new = _shown_pair(attribute)
        yield f"{_in_one_line(attribute.name)}: {old} → {new}"
    for word, paths in (("added", change.came), ("removed", change.went)):
        if paths:
            yield f"{word}: {_listed(paths, _in_one_line)}"


def markdown_lines(change: Change) -> Iterator[str]:
    """The change as an item of a list, with its details below it."""
    counted = f" ({_counted(change)})" if _counted(change) else ""
    if change.kind == "moved":
        yield f"- Moved: {_code(change.former)} → {_code(change.path)}{counted}: {_EVIDENCES[change.evidence]}"
    else:
        before = f", formerly {_code(change.former)}" if change.former else ""
        yield f"- {change.kind.capitalize()}: {_code(change.path)}{before}{counted}"
    if change.note:
        yield f"  - its deprecation said: {_code(change.note)}"
    if change.rule not in ROWS:
        yield f"  - {_because(change)}"
    for attribute in change.attributes:
        old, new = (text if text == _ABSENT else _code(text) for text in _shown_pair(attribute))
        yield f"  - {_code(attribute.name)}: {old} → {new} ({_class_in_words(attribute.compatibility)})"
    for word, paths in (("added", change.came), ("removed", change.went)):
        if paths:
            yield f"  - {word}: {_listed(paths, _code)}"


def _because(change: Change) -> str:
    """Return the effect on a binding that decided the class."""
    return f"{change.rule}: {reason(change.rule)}"


def _listed(paths: Sequence[str], show: Any) -> str:
    more = f" and {len(paths) - _LISTED} more" if len(paths) > _LISTED else ""
    return ", ".join(show(path) for path in paths[:_LISTED]) + more


def _code(text: str) -> str:
    """A code span that holds any text: its fence is longer than any run of backticks in the text."""
    content = _in_one_line(text).strip() or " "
    fence = "`" * (max((len(run) for run in re.findall(r"`+", content)), default=0) + 1)
    pad = " " if "`" in content else ""
    return f"{fence}{pad}{content}{pad}{fence}"


# -- values -------------------------------------------------------------------------------------------------------


def _shown_pair(attribute: AttributeChange) -> tuple[str, str]:
    """Both values, shortened around the place where they begin to differ."""
    old, new = (_ABSENT if value is None else _in_one_line(_shown(value)) for value in (attribute.old, attribute.new))
    shared = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(old, new, strict=False)))
    start = max(shared - 24, 0) if max(len(old), len(new)) > _SHOWN else 0
    return _short(old, start), _short(new, start)


def _short(text: str, start: int = 0) -> str:
    part = _in_one_line(text)[start:]
    cut = part if len(part) <= _SHOWN else part[: _SHOWN - 1] + "…"
    return ("…" if start else "") + cut


def _shown(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list):
        return f"[{', '.join(map(_shown, value))}]"
    if isinstance(value, dict):
        return f"{{{', '.join(f'{name}: {_shown(item)}' for name, item in value.items())}}}"
    text = str(value)
    return json.dumps(text, ensure_ascii=False) if text != text.strip() or not text else text


def _change_data(change: Change) -> dict[str, Any]:
    return {
        "kind": change.kind,
        "compatibility": change.compatibility,
        "rule": change.rule,
        "path": change.path,
        "old_path": change.former or None,
        "type": change.type,
        "paths": list(change.paths),
        "old_paths": list(change.former_paths),
        "signal_count": change.leaves,
        "evidence": change.evidence or None,
        "is_guess": change.is_guess,
        "attribute_changes": [attribute_data(attribute) for attribute in change.attributes],
        "instances_added": list(change.came),
        "instances_removed": list(change.went),
        "note": change.note or None,
        "effects": list(change.effects),
        "bindings": {each.binding: each.compatibility for each in classes_of(change)},
    }


def attribute_data(attribute: AttributeChange) -> dict[str, Any]:
    """An attribute's change as plain data."""
    return {
        "name": attribute.name,
        "old_value": plain(attribute.old),
        "new_value": plain(attribute.new),
        "compatibility": attribute.compatibility,
        "rule": attribute.rule,
    }


def plain(value: Any) -> Any:
    """A value as JSON can hold it: dates and numbers without an end become text."""
    if isinstance(value, dict):
        return {str(name): plain(item) for name, item in value.items()}
    if isinstance(value, list):
        return [plain(item) for item in value]
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if value is None or isinstance(value, str | int | float):
        return value
    return value.isoformat() if hasattr(value, "isoformat") else str(value)
