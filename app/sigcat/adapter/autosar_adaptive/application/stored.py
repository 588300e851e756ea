"""What is stored: parameters, and the counts of errors."""

from sigcat.adapter.autosar_adaptive.application.names import writes
from sigcat.adapter.autosar_adaptive.application.plan import ComponentPlan, Monitor, Storage, Stored
from sigcat.adapter.autosar_adaptive.arxml.components import IGNITION_CYCLE
from sigcat.adapter.core.c.lines import Lines, block, lines
from sigcat.adapter.text_filters import c_string
from sigcat.integration.autosar_adaptive.storages import ADAPTER_STORAGE

ADAPTER = f"storage_{ADAPTER_STORAGE}_"


def storage_functions(component: ComponentPlan) -> list[Lines]:
    """Reading at the start, writing at the end; calibration is never written."""
    return [*([_load(component)] if component.storages else []), *([_store(component)] if writes(component) else [])]


def _load(component: ComponentPlan) -> Lines:
    core = component.core.type_name
    cycle = lines(f"stored.has_cycle = {ADAPTER}.Read({c_string(IGNITION_CYCLE)}, stored.ignition_cycle);")
    parameters = [
        lines(f"{_place(each)}.is_there = {each.storage.variable}.Read({c_string(each.key)}, {_place(each)}.value);")
        for each in component.stored
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
        lines(f"{ADAPTER}.Write({c_string(IGNITION_CYCLE)}, stored.ignition_cycle);") if component.monitors else (),
        *(_counts("Write", each) for each in component.monitors),
        *(_learned(each) for each in component.stored if each.parameter.learned is not None),
        *(lines(f"{each.variable}.Save();") for each in _written(component)),
    ])  # fmt: skip


def _counts(what: str, monitor: Monitor) -> Lines:
    return lines(f"{ADAPTER}.{what}Counts({c_string(monitor.name)}, stored.{monitor.error.named.name});")


def _place(stored: Stored) -> str:
    return f"stored.{stored.parameter.named.name}"


def _learned(stored: Stored) -> Lines:
    place = _place(stored)
    return block(
        f"if ({place}.is_there)", [lines(f"{stored.storage.variable}.Write({c_string(stored.key)}, {place}.value);")]
    )


def _written(component: ComponentPlan) -> list[Storage]:
    learned = {each.storage for each in component.stored if each.parameter.learned is not None}
    return [each for each in component.storages if each in learned or each.name == ADAPTER_STORAGE]
