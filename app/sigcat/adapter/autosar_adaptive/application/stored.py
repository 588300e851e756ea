"""What is stored: parameters, and the counts of errors."""

from sigcat.adapter.autosar_adaptive.application.names import writes
from sigcat.adapter.autosar_adaptive.application.plan import ComponentPlan, Monitor
from sigcat.adapter.autosar_adaptive.arxml.components import IGNITION_CYCLE
from sigcat.adapter.core.c.lines import Lines, block, lines
from sigcat.adapter.core.identifiers import string
from sigcat.adapter.core.plan import Parameter


def storage_functions(component: ComponentPlan) -> list[Lines]:
    """Reading at the start, writing at the end; calibration is never written."""
    return [*([_load(component)] if component.storage else []), *([_store(component)] if writes(component) else [])]


def _load(component: ComponentPlan) -> Lines:
    core = component.core.type_name
    cycle = lines(f"stored.has_cycle = storage_.Read({string(IGNITION_CYCLE)}, stored.ignition_cycle);")
    parameters = [
        lines(f"stored.{each.named.name}.is_there = storage_.Read({string(each.key)}, stored.{each.named.name}.value);")
        for each in component.core.parameters
    ]
    return block(f"{core}_Stored {component.type}::Load()", [
        lines(f"{core}_Stored stored{{}};"),
        cycle if component.monitors else (),
        *(_counts("Read", each) for each in component.monitors),
        *parameters,
        lines("return stored;"),
    ])  # fmt: skip


def _store(component: ComponentPlan) -> Lines:
    core = component.core.type_name
    return block(f"void {component.type}::Store()", [
        lines(f"const {core}_Stored& stored = core_.stored;"),
        lines(f"storage_.Write({string(IGNITION_CYCLE)}, stored.ignition_cycle);") if component.monitors else (),
        *(_counts("Write", each) for each in component.monitors),
        *(_learned(each) for each in component.core.parameters if each.learned is not None),
        lines("storage_.Save();"),
    ])  # fmt: skip


def _counts(what: str, monitor: Monitor) -> Lines:
    return lines(f"storage_.{what}Counts({string(monitor.name)}, stored.{monitor.error.named.name});")


def _learned(parameter: Parameter) -> Lines:
    place = f"stored.{parameter.named.name}"
    return block(f"if ({place}.is_there)", [lines(f"storage_.Write({string(parameter.key)}, {place}.value);")])
