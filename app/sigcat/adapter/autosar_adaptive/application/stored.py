"""What is stored: parameters, and the counts of errors."""

from sigcat.adapter.autosar_adaptive.application.plan import ComponentPlan
from sigcat.adapter.core.c.lines import Lines, block, lines
from sigcat.adapter.core.identifiers import string
from sigcat.adapter.core.plan import Error, Parameter

CYCLE_KEY = "IgnitionCycle"


def storage_functions(component: ComponentPlan) -> list[Lines]:
    """Reading at the start, writing at the end; calibration is never written."""
    if component.storage is None:
        return []
    core = component.core.type_name
    load = block(f"{core}_Stored {component.type}::Load()", [
        lines(f"{core}_Stored stored{{}};"),
        lines(f"stored.has_cycle = storage_.Read({string(CYCLE_KEY)}, stored.ignition_cycle);"),
        *(_counts("Read", error) for error in component.core.errors),
        *(lines(f"stored.{each.named.name}.is_there = storage_.Read({string(each.key)}, stored.{each.named.name}.value);")
          for each in component.core.parameters),
        lines("return stored;"),
    ])  # fmt: skip
    store = block(f"void {component.type}::Store()", [
        lines(f"const {core}_Stored& stored = core_.stored;"),
        lines(f"storage_.Write({string(CYCLE_KEY)}, stored.ignition_cycle);"),
        *(_counts("Write", error) for error in component.core.errors),
        *(_learned(each) for each in component.core.parameters if each.learned is not None),
        lines("storage_.Save();"),
    ])  # fmt: skip
    return [load, store]


def _counts(what: str, error: Error) -> Lines:
    return lines(f"storage_.{what}Counts({string(error.named.name)}, stored.{error.named.name});")


def _learned(parameter: Parameter) -> Lines:
    place = f"stored.{parameter.named.name}"
    return block(f"if ({place}.is_there)", [lines(f"storage_.Write({string(parameter.key)}, {place}.value);")])
