"""Findings that only follow from others, left out: what was mistyped in one place is missing in others."""

import re
from collections.abc import Iterator
from typing import Any

from app.catalogue.interfaces import interface_name
from app.findings import Finding
from app.function.work import Work
from app.names import last_name, nearest

_UNRESOLVED = frozenset(("F013", "F014", "F015"))
_CALL = re.compile(r"(/components/\d+)/runnables/\d+")
_ERROR = re.compile(_CALL.pattern + r"/errors/\d+")
_MISSING = frozenset(("F041", "F056", "F070"))
"""Rules that name, in quotes, an error or a call that the function does not declare."""
_CIRCLES = {"F062": "I205", "F053": "I510"}
"""Circles in Function JSON, and the rules by which the catalogue has told the same ones."""
_QUOTED = re.compile("'([^']+)'")


def causes(work: Work) -> list[Finding]:
    """The findings of a function without those that go away when another one is mended.

    A call that was not found is missing in its component, in the modes that run it, and with the errors that it
    declares; a circle through several interfaces is told once.
    """
    unresolved = [finding for finding in work.findings if finding.rule in _UNRESOLVED]
    calls = [call for finding in unresolved if (call := _CALL.fullmatch(finding.pointer))]
    broken = {call[1] for call in calls}
    lost = {name for call in calls for name in _names_of(_at(call[0], work), work)}
    lost |= {str(_at(finding.pointer, work)) for finding in unresolved if _ERROR.fullmatch(finding.pointer)}
    circles = {(f.rule, word) for f in work.findings for word in re.findall(r"\w+", f.message) if f.rule[0] == "I"}
    return [
        finding
        for finding in work.findings
        if not (finding.rule == "F050" and finding.pointer in broken)
        and not (finding.rule in _MISSING and lost and _is_lost(finding, lost, work))
        and (_CIRCLES.get(finding.rule), finding.path) not in circles
    ]


def _at(pointer: str, work: Work) -> Any:
    """What stands in the declaration at a pointer that leads through lists and plain keys."""
    value = work.document.value
    for part in pointer.split("/")[1:]:
        value = value[int(part) if isinstance(value, list) else part]
    return value


def _names_of(call: Any, work: Work) -> Iterator[str]:
    """The name of a call, and the errors that it would have declared."""
    item = call if isinstance(call, dict) else {"interface": call}
    yield str(item["interface"])
    for reference in item.get("errors") or ():
        node = work.node(reference) or work.own(reference, "error")
        yield (interface_name(node.path) if node else None) or reference


def _is_lost(finding: Finding, lost: set[str], work: Work) -> bool:
    """Whether a finding is about a name that was lost, or was meant where a mistyped one stands."""
    named = _QUOTED.findall(finding.message)
    short = [last_name(work.interfaces.get(name, name)) for name in named]
    return any(nearest(name, lost) for name in (*named, *short))
