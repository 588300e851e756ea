"""Changes of the project file and of files of pipelines: the name of a release, and nodes of vehicles."""

import re
from collections.abc import Collection, Iterator

from sigcat import codes
from sigcat.function.function_json.conversion import IDENTITY
from sigcat.function.importing.yaml_edits import Edit
from sigcat.migration.changed_text import Outcome, Place, Replacement, not_convertible, undecided
from sigcat.migration.migration import Migration
from sigcat.migration.numbers import converted
from sigcat.migration.overlay_changes import fate_of
from sigcat.text_lines import lines_of

_NODE = re.compile(
    r"""(?P<quote>["'])(?P<path>[A-Za-z]\w*(?:\.[\w*?]+)+)(?P=quote)(?:[ \t]*=[ \t]*(?P<value>[-+]?\d[\d_]*(?:\.\d+)?(?:[eE][-+]?\d+)?)(?![\w.]))?"""
)
"""A path in quotes, and the number that a vehicle sets for it."""
_SETTING = r"""^[ \t]*(?:release|tree)[ \t]*=[ \t]*(["'])(?P<name>{})\1"""
_WORD = r"(?<![\w.@/+-]){}(?![\w.-])"
_OWN = re.compile(r"\bsigcat\b")
_OF_VSS = re.compile(r"vss\b|vehicle_signal_specification", re.IGNORECASE)


def project_changes(text: str, old: str, new: str) -> Iterator[Outcome]:
    """Yield the changes of a `sigcat.toml` or `pyproject.toml`: the release of catalogues and of the linter."""
    for match in re.finditer(_SETTING.format(re.escape(old)), text, re.MULTILINE):
        line = text.count("\n", 0, match.start()) + 1
        yield Replacement(Edit(match.start("name"), match.end("name"), new), line, f"release {old} → {new}")


def vehicle_changes(
    file: str, text: str, migration: Migration, current: Collection[str], values: list[str]
) -> Iterator[Outcome]:
    """Yield the changes of the nodes that vehicles name. `values` receives the new paths of those whose value is converted."""
    for match in _NODE.finditer(text):
        place = Place(file, text.count("\n", 0, match.start()) + 1, match.start() - text.rfind("\n", 0, match.start()))
        path, fate = match["path"], fate_of(match["path"], migration)
        if not fate.is_certain:
            yield from undecided(path, fate, place, migration)
            continue
        if fate.path != path:
            yield Replacement(Edit(*match.span("path"), fate.path), place.line, f"`{path}` → `{fate.path}`")
        if match["value"] and path not in current:
            yield from _number(match, fate.path, place, migration, values)


def _number(
    match: re.Match[str], target: str, place: Place, migration: Migration, values: list[str]
) -> Iterator[Outcome]:
    """Yield the change of the number that a vehicle sets, where the unit changes."""
    both = migration.definitions(match["path"], target)
    change = migration.unit_change(*(each.get("unit") for each in both)) if both is not None else None
    if change is None or change.conversion == IDENTITY:
        return
    number = converted(match["value"].replace("_", ""), change.conversion) if change.conversion is not None else None
    if number is None:
        reason = f"the unit changed from {change.old or 'none'} to {change.new or 'none'}, without a conversion."
        yield not_convertible(match["path"], place, reason, "Check the value.")
        return
    values.append(target)
    note = f"value of `{target}`: {match['value']} → {number}"
    yield Replacement(Edit(*match.span("value"), number), place.line, note)


def pipeline_changes(file: str, text: str, old: str, new: str, *, accepts_guesses: bool) -> Iterator[Outcome]:
    """Yield the changes of lines that call sigcat with the old release. Other lines about VSS are guesses."""
    start = 0
    for number, line in enumerate(lines_of(text, keepends=True), 1):
        for match in re.finditer(_WORD.format(re.escape(old)), line):
            if _OWN.search(line) or (accepts_guesses and _OF_VSS.search(line)):
                edit = Edit(start + match.start(), start + match.end(), new)
                yield Replacement(edit, number, f"release {old} → {new}")
            elif _OF_VSS.search(line):
                message = f"The line names {old} of VSS, and no command of sigcat."
                yield codes.RELEASE_MENTIONED.finding(
                    message, file, number, match.start() + 1, fix=f"Write {new}, or pass --accept-guesses."
                )
        start += len(line)
