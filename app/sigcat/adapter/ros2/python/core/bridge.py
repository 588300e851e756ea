"""The bridge: what Python needs of a core beside its header, in C, and the declarations of both for Python."""

import textwrap
from collections.abc import Iterator, Sequence
from hashlib import sha256
from typing import NamedTuple

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.c.text.layout import c_lines
from sigcat.adapter.core.c.text.lines import c_file
from sigcat.adapter.core.plan import CorePlan
from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.ros2.python.names import WIDEST


class _Layout(NamedTuple):
    """A struct whose layout Python compares, and its members in the order in which both sides list them."""

    name: str
    members: Sequence[str]
    group: str = ""
    """The member of the context that has this type."""


class _Bridge(NamedTuple):
    """Plan of the bridge and of its declarations; `p`, `m` and `b` are prefixes of names."""

    plan: CorePlan
    p: str
    m: str
    b: str
    guard: str
    layouts: Sequence[_Layout]
    digest: str = ""


def bridge_files(core: CorePlan) -> tuple[GeneratedFile, ...]:
    """Header and source, which are compiled with the core."""
    bridge = _bridge(core)._replace(digest=digest(core))
    return (
        _file(f"{core.function}_bridge.h", "bridge.h.j2", bridge),
        _file(f"{core.function}_bridge.{core.code.ending}", "bridge.c.j2", bridge),
    )


def _file(name: str, template: str, bridge: _Bridge) -> GeneratedFile:
    return c_file(name, c_lines(f"adapter/ros2/python/core/{template}", **bridge._asdict()))


def _bridge(core: CorePlan) -> _Bridge:
    scope, b = Scope(core), f"{core.function}_Bridge"
    guard = f"{scope.macro.removesuffix('_ADAPTER')}_BRIDGE_H"
    return _Bridge(core, scope.prefix, scope.macro, b, guard, [*_layouts(core, scope.prefix, b)])


def declarations(core: CorePlan) -> str:
    """Types and functions, as Python has to know them. The core itself stays opaque."""
    rows = (line.text for line in c_lines("adapter/ros2/python/core/declarations.h.j2", **_bridge(core)._asdict()))
    code = (row.partition(" /* ")[0].rstrip() for row in rows if not row.startswith("/*"))
    return "\n".join(part for row in code for part in _wrapped(row))


def _wrapped(row: str) -> list[str]:
    """A line, on as many as a module of Python has room for."""
    return textwrap.wrap(row, WIDEST, subsequent_indent="    ", break_long_words=False) if len(row) > WIDEST else [row]


def digest(core: CorePlan) -> str:
    """Key that distinguishes declarations."""
    return sha256(declarations(core).encode()).hexdigest()[:16]


def struct_names(core: CorePlan) -> tuple[str, ...]:
    """Structs whose layout Python compares."""
    return tuple(each.name for each in _bridge(core).layouts)


def out_names(core: CorePlan) -> tuple[str, ...]:
    """Members of `out`, in order; `publish` has the methods that are used beside them."""
    return tuple(each.named.name for each in (*core.outputs, *core.statuses))


def publish_names(core: CorePlan) -> tuple[str, ...]:
    """Members of `publish`, in order."""
    return tuple(each.named.name for each in core.published)


def _layouts(plan: CorePlan, p: str, b: str) -> Iterator[_Layout]:
    yield from (_Layout(each.name, [field.name for field in each.fields]) for each in plan.structs)
    for method in plan.methods:
        for name, items in (("Arguments", method.arguments), ("Results", method.results)):
            if items:
                yield _Layout(f"{p}_{method.named.name}_{name}", [each.name for each in items])
    if plan.settable:
        yield _Layout(f"{p}_Parameters", [each.named.name for each in plan.settable])
    errors, parameters = ([each.named.name for each in plan.errors], [each.named.name for each in plan.parameters])
    yield _Layout(f"{p}_Stored", ["ignition_cycle", "has_cycle", *errors, *parameters])
    if plan.errors:
        yield _Layout("Sigcat_Counts", ["occurrences", "ignition_cycles", "has_failed", "is_tested"])
        yield _Layout(f"{b}_Error", ["state", "is_confirmed", "occurrences", "ignition_cycles"])
    if plan.steps:
        yield _Layout(f"{b}_Call", ["missed", "dropped"])
    if plan.is_sent:
        yield _Layout(f"{b}_Out", out_names(plan), "out")
    if plan.published:
        yield _Layout(f"{b}_Publish", publish_names(plan), "publish")
