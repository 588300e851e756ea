"""Structs of the platform and of the core, copied member by member."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.application.names import include_guard
from sigcat.adapter.autosar_adaptive.application.plan import ApplicationPlan, ComponentPlan, StructPair
from sigcat.adapter.templates import rendered


class _Copies(NamedTuple):
    """Types of a struct on both sides, and its members where they are copied from and to."""

    platform: str
    core: str
    taken: Sequence[tuple[str, str]]
    given: Sequence[tuple[str, str]]


def structs_header(component: ComponentPlan, application: ApplicationPlan) -> str:
    """The whole header."""
    headers = ("application/values.h", *component.type_headers, f"core/{component.core.header_file}")
    guard = include_guard(application, component, "structs")
    return rendered(
        "adapter/autosar_adaptive/application/component/structs.h.j2",
        name=component.name,
        guard=guard,
        headers=sorted(headers),
        copies=[_copies(each) for each in component.structs],
    )


def _copies(pair: StructPair) -> _Copies:
    core = [field.name for field in pair.struct.fields]
    taken, given = zip(pair.members, core, strict=True), zip(core, pair.members, strict=True)
    return _Copies(f"::{pair.type}", f"::{pair.struct.name}", list(taken), list(given))
