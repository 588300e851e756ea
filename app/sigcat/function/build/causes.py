"""Findings that only follow from others, left out: what was mistyped in one place is missing in others."""

import re
from collections.abc import Iterator

from sigcat.catalogue.model.interfaces import interface_name
from sigcat.findings import Finding
from sigcat.function.build.work import Work
from sigcat.function.declaration.declaration import Declaration, RunnableItem
from sigcat.names import last_name, nearest

_UNRESOLVED = frozenset(("F013", "F014", "F015"))
_CALL = re.compile(r"(/components/(\d+))/runnables/(\d+)")
_ERROR = re.compile(_CALL.pattern + r"/errors/(\d+)(?:/interface)?")
_MISSING = frozenset(("F041", "F056", "F070"))
"""Rules that name, in quotes, an error or a call that the function does not declare."""
_CIRCLES = {"F062": "I205", "F053": "I510"}
"""Circles in Function JSON, and the rules by which the catalogue has told the same ones."""
_QUOTED = re.compile("'([^']+)'")


def causes(work: Work, declaration: Declaration) -> list[Finding]:
    """The findings of a function without those that go away when another one is mended.

    A call that was not found is missing in its component, in the modes that run it, and with the errors that it
    declares; a circle through several interfaces is told once.
    """
    unresolved = [finding.pointer for finding in work.findings if finding.rule in _UNRESOLVED]
    calls = [call for pointer in unresolved if (call := _CALL.fullmatch(pointer.removesuffix("/interface")))]
    errors = [error for pointer in unresolved if (error := _ERROR.fullmatch(pointer))]
    broken = {call[1] for call in calls}
    lost = {name for call in calls for name in _names_of(_declared(call, declaration), work)}
    lost |= {_declared(error, declaration).errors[int(error[4])].interface for error in errors}
    circles = {(f.rule, word) for f in work.findings for word in re.findall(r"\w+", f.message) if f.rule[0] == "I"}
    return [
        finding
        for finding in work.findings
        if not (finding.rule == "F050" and finding.pointer in broken)
        and not (finding.rule in _MISSING and lost and _is_lost(finding, lost, work))
        and (_CIRCLES.get(finding.rule), finding.path) not in circles
    ]


def _declared(place: re.Match[str], declaration: Declaration) -> RunnableItem:
    return declaration.components[int(place[2])].runnables[int(place[3])]


def _names_of(call: RunnableItem, work: Work) -> Iterator[str]:
    """The name of a call, and the errors that it would have declared."""
    yield call.interface
    for error in call.errors:
        node = work.node(error.interface) or work.own(error.interface, "error")
        yield (interface_name(node.path) if node else None) or error.interface


def _is_lost(finding: Finding, lost: set[str], work: Work) -> bool:
    """Whether a finding is about a name that was lost, or was meant where a mistyped one stands."""
    named = _QUOTED.findall(finding.message)
    short = [last_name(work.interfaces.get(name, name)) for name in named]
    return any(nearest(name, lost) for name in (*named, *short))
