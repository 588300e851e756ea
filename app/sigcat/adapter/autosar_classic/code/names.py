"""Names of the parts of a component in C."""

from sigcat.adapter.autosar_classic.code.plan import SwcPlan
from sigcat.adapter.core.plan import GLOBALS
from sigcat.asil import level_of, rank


def core_object(swc: SwcPlan) -> str:
    """The object of the core: its one instance, or one of the component."""
    return f"{swc.core.type_name}_Instance" if swc.core.code.signature == GLOBALS else static(swc, "Core")


def static(swc: SwcPlan, what: str) -> str:
    """A function or variable that only this file knows."""
    return f"{swc.name}_Swc_{what}"


def section_of(swc: SwcPlan, kind: str, usual: str) -> str:
    """The memory section of data that every runnable uses: that of the highest ASIL; the usual one if there is none."""
    found = [each for each in swc.component.sections if each.kind == kind]
    return max(found, key=lambda each: rank(level_of(each.asil_level) or "QM")).name if found else usual
