"""The source of a software component: runnables that hand over to the core what the RTE has, and back."""

from sigcat.adapter.autosar_classic.code.c_text import c_lines
from sigcat.adapter.autosar_classic.code.component import publishing, receiving
from sigcat.adapter.autosar_classic.code.component.runnables import runnable
from sigcat.adapter.autosar_classic.code.names import core_object, section_of
from sigcat.adapter.autosar_classic.code.plan import SwcPlan
from sigcat.adapter.core.c.names.shadowing import distinct
from sigcat.adapter.core.c.text.lines import Lines
from sigcat.adapter.core.plan import GLOBALS
from sigcat.function.document.text import composed


def swc_source(swc: SwcPlan) -> Lines:
    """The whole file. A variable of the code may be called as one of these functions calls something: that is renamed."""
    version = f" {swc.core.version}" if swc.core.version else ""
    has_object = swc.core.code.signature != GLOBALS
    lines = c_lines(
        "code/component/swc.c.j2",
        swc=swc,
        about=composed(f"Software component {swc.name} of {swc.core.function}{version}: ", swc.core.description),
        core=core_object(swc),
        has_data=bool(has_object or swc.core.steps or swc.kept or swc.mode_out or swc.told),
        has_object=has_object,
        data_section=section_of(swc, "VAR_CLEARED", "VAR_CLEARED_UNSPECIFIED"),
        code_section=section_of(swc, "CODE", "CODE"),
        functions="\n\n".join(_text(each) for each in (receiving.functions(swc), publishing.functions(swc))),
        runnables=[(each.section, _text(runnable(each, swc))) for each in swc.component.runnables],
    )
    return distinct(swc.core, lines)


def _text(part: Lines) -> str:
    return "\n".join(line.text for line in part)
