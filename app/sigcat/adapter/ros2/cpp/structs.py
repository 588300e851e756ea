"""Structs of messages and of the core, copied member by member."""

from sigcat.adapter.ros2.cpp.layout import WIDEST, comment, function, indented, spaced, text
from sigcat.adapter.ros2.cpp.names import copyright_line, guard, header_of
from sigcat.adapter.ros2.plan import NodePlan, StructPair, WorkspacePlan
from sigcat.function.document.text_filters import c_header


def structs_header(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The whole header."""
    name = guard(workspace, f"{node.name}_structs")
    headers = sorted(
        [node.core.header_file, f"{workspace.name}/values.hpp", *(header_of(pair.message) for pair in node.structs)]
    )
    return spaced([
        text([copyright_line(workspace), "//", comment(f"Structs that {node.name} takes and gives, between messages and the core.")]),
        f"#ifndef {name}\n#define {name}",
        "\n".join(f"#include {c_header(each)}" for each in headers),
        f"namespace {workspace.name}\n{{",
        *(part for pair in node.structs for part in (_copy(pair, gives=False), _copy(pair, gives=True))),
        f"}}  {comment(f'namespace {workspace.name}')}",
        f"#endif  {comment(name)}",
    ]) + "\n"  # fmt: skip


def _copy(pair: StructPair, *, gives: bool) -> str:
    message, core = pair.message.cpp, f"::{pair.struct.name}"
    source, target = (core, message) if gives else (message, core)
    names = [(field.name, member) for field, member in zip(pair.struct.fields, pair.members, strict=True)]
    rows = [
        f"assign(from.{ours}, to.{theirs});" if gives else f"assign(from.{theirs}, to.{ours});"
        for ours, theirs in names
    ]
    head = f"struct Copy<{source}, {target}>"
    if len(head) > WIDEST:
        head = f"struct Copy<{source},\n  {target}>"
    taken, filled = f"  const {source} & from,", f"{target} & to)"
    arguments = f"{taken} {filled}" if len(taken) + len(filled) + 3 <= WIDEST else f"{taken}\n  {filled}"
    return text([
        f"template<>\n{head}\n{{",
        indented(function(f"static void run(\n{arguments}", rows)),
        "};",
    ])  # fmt: skip
