"""Structs of the platform and of the core, copied member by member."""

from sigcat.adapter.autosar_adaptive.application.names import commented, include_guard
from sigcat.adapter.autosar_adaptive.application.plan import ApplicationPlan, ComponentPlan, StructPair
from sigcat.adapter.core.c.lines import Line, Lines, block, joined, lines, spaced
from sigcat.adapter.text_filters import c_string, comment


def structs_header(component: ComponentPlan, application: ApplicationPlan) -> Lines:
    """The whole header."""
    guard = include_guard(application, component, "structs")
    headers = [c_string(name) for name in (*component.type_headers, f"core/{component.core.header_file}")]
    return spaced([
        commented(f"Structs that {component.name} takes and gives, between the platform and the core."),
        lines(f"#ifndef {guard}\n#define {guard}"),
        lines("\n".join(f"#include {name}" for name in sorted(['"application/values.h"', *headers]))),
        lines("namespace application {"),
        *(part for pair in component.structs for part in (_copy(pair, gives=False), _copy(pair, gives=True))),
        lines("}  // namespace application"),
        lines(f"#endif  // {comment(guard)}"),
    ])  # fmt: skip


def _copy(pair: StructPair, *, gives: bool) -> Lines:
    platform, core = f"::{pair.type}", f"::{pair.struct.name}"
    source, target = (core, platform) if gives else (platform, core)
    names = [(field.name, member) for field, member in zip(pair.struct.fields, pair.members, strict=True)]
    members = [
        lines(f"Assign(from.{ours}, to.{theirs});" if gives else f"Assign(from.{theirs}, to.{ours});")
        for ours, theirs in names
    ]
    return joined([
        (Line("template <>"),),
        block(f"struct Copy<{source}, {target}> final", [
            block(f"static void Run(const {source}& from, {target}& to)", members),
        ], "};"),
    ])  # fmt: skip
