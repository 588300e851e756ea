"""How parts of a component are called in C."""

from collections.abc import Iterable

from sigcat.adapter.autosar_classic.code.plan import SwcPlan
from sigcat.adapter.core.c.lines import Line, Lines, indented, joined, lines, spaced
from sigcat.adapter.core.plan import GLOBALS
from sigcat.asil import level_of, rank
from sigcat.function.document.text_filters import AnyText, block_comment, c_header


def core_object(swc: SwcPlan) -> str:
    """The object of the core: its one instance, or one of the component."""
    return f"{swc.core.type_name}_Instance" if swc.core.code.signature == GLOBALS else static(swc, "Core")


def at_core(swc: SwcPlan) -> str:
    return f"&{core_object(swc)}"


def static(swc: SwcPlan, what: str) -> str:
    """A function or variable that only this file knows."""
    return f"{swc.name}_Swc_{what}"


def enter(swc: SwcPlan) -> Lines:
    return lines(f"Rte_Enter_{swc.area}();")


def leave(swc: SwcPlan) -> Lines:
    return lines(f"Rte_Exit_{swc.area}();")


def in_calls(swc: SwcPlan, part: Lines) -> Lines:
    """What runs the function's code, where a method may not run beside a call."""
    if not swc.calls_area:
        return part
    return joined([lines(f"Rte_Enter_{swc.calls_area}();"), part, lines(f"Rte_Exit_{swc.calls_area}();")])


def section_of(swc: SwcPlan, kind: str, usual: str) -> str:
    """The memory section of what every runnable uses: that of the highest ASIL; the usual one where there is none."""
    found = [each for each in swc.component.sections if each.kind == kind]
    return max(found, key=lambda each: rank(level_of(each.asil_level) or "QM")).name if found else usual


def section(swc: SwcPlan, name: str, part: Lines) -> Lines:
    """What stands in a memory section."""
    if not part:
        return ()
    include = f"#include {c_header(f'{swc.name}_MemMap.h')}"
    return spaced([
        lines(f"#define {swc.name}_START_SEC_{name}\n{include}"),
        part,
        lines(f"#define {swc.name}_STOP_SEC_{name}\n{include}"),
    ])  # fmt: skip


def function(head: str, body: Iterable[Lines], comment: AnyText = "") -> Lines:
    """A function, its brace on a line of its own."""
    before = (Line(block_comment(comment)),) if comment else ()
    return (*before, Line(head), Line("{"), *indented(joined(body)), Line("}"))
