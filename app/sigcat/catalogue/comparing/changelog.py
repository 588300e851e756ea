"""Changes as an entry of a changelog (https://keepachangelog.com), and the version that they need (https://semver.org)."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Literal

from sigcat.catalogue.comparing.changes import Change, Class, worst
from sigcat.catalogue.comparing.diff_report import markdown_lines

Part = Literal["major", "minor", "patch", "none"]
_SECTIONS = ("Added", "Changed", "Deprecated", "Removed")
_PARTS: Mapping[Class, Part] = {"breaking": "major", "risky": "minor", "compatible": "minor", "text": "patch"}
_VERSION = re.compile(r"(.*?)(\d+)\.(\d+)(?:\.(\d+))?")
_TAG = re.compile(r"v?(\d+(?:\.\d+)+(?:[-+].*)?)")


def changelog_entry(changes: Sequence[Change], new: str, date: str = "") -> str:
    """Return the entry of a version. `new` is the name of the side; a name that is not a version is unreleased."""
    version = _TAG.fullmatch(new.removeprefix("git:"))
    released = f" - {date}" if date and version else ""
    lines = [f"## [{version[1] if version else 'Unreleased'}]{released}", ""]
    for section in _SECTIONS:
        chosen = [change for change in changes if _section(change) == section]
        if chosen:
            lines += [f"### {section}", "", *(line for change in chosen for line in _entry(change)), ""]
    return "\n".join(lines)


def version_part(changes: Iterable[Change]) -> Part:
    """Return the part of the version that the worst change raises."""
    return part_of(change.compatibility for change in changes)


def part_of(classes: Iterable[Class]) -> Part:
    """Return the part of the version that the worst class raises."""
    listed = tuple(classes)
    return _PARTS[worst(listed)] if listed else "none"


def next_version(version: str, part: Part) -> str:
    """Return the version after one such as `v1.2.0`; empty if it is not a version.

    Before 1.0.0 a breaking change raises the second number and any other the third, as package managers read it.
    """
    match = _VERSION.fullmatch(version)
    if match is None:
        return ""
    prefix, *numbers = match.groups(default="0")
    major, minor, patch = map(int, numbers)
    if major == 0:
        part = {"major": "minor", "minor": "patch", "patch": "patch", "none": "none"}[part]  # type: ignore[assignment]
    following = {
        "major": (major + 1, 0, 0), "minor": (major, minor + 1, 0), "patch": (major, minor, patch + 1),
        "none": (major, minor, patch),
    }[part]  # fmt: skip
    return prefix + ".".join(map(str, following))


def _section(change: Change) -> str:
    if change.kind in ("added", "removed"):
        return change.kind.capitalize()
    is_deprecation = any(attribute.rule == "deprecation-added" for attribute in change.attributes)
    return "Deprecated" if is_deprecation and len(change.attributes) == 1 else "Changed"


def _entry(change: Change) -> Iterator[str]:
    first, *details = markdown_lines(change)
    breaking = "**Breaking:** " if change.compatibility == "breaking" else ""
    verb, _, rest = first.removeprefix("- ").partition(": ")
    yield f"- {breaking}{first.removeprefix('- ') if verb == 'Moved' else rest}"
    yield from details
