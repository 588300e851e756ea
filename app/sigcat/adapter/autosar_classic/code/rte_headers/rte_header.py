"""The headers of the contract phase: what the RTE has for a component, before it is generated."""

from collections.abc import Sequence

from sigcat.adapter.autosar_classic.code.c_text import c_lines
from sigcat.adapter.autosar_classic.code.component.methods import end_of, head
from sigcat.adapter.autosar_classic.code.plan import SwcPlan
from sigcat.adapter.autosar_classic.code.rte_headers import literals
from sigcat.adapter.autosar_classic.code.rte_headers.api import Call
from sigcat.adapter.autosar_classic.code.rte_types import rte_types
from sigcat.adapter.core.c.text.lines import Lines
from sigcat.integration.autosar_classic.model import ClassicIntegration, Runnable


def type_header(model: ClassicIntegration) -> Lines:
    """Rte_Type.h: the datatypes of all components. Platform types are the vendor's."""
    types = [each for each in model.implementation_types if each.category != "VALUE"]
    return c_lines("code/rte_headers/Rte_Type.h.j2", name=model.info.name, types=types, groups=model.mode_groups)


def component_type_header(swc: SwcPlan, model: ClassicIntegration) -> Lines:
    """Rte_<component>_Type.h: names of numbers, and their limits."""
    interfaces = {each.name: each.group for each in model.mode_switch_interfaces}
    groups = {interfaces[port.interface] for port in swc.component.ports if port.kind == "ModeSwitch"}
    return c_lines(
        "code/rte_headers/Rte_component_Type.h.j2",
        swc=swc,
        enumerations=[*literals.enumerations(swc, model)],
        limits=[*literals.limits(swc, model)],
        groups=[each for each in model.mode_groups if each.name in groups],
        errors={f"{end.interface}_{name}": value for end in swc.methods for name, value in end.errors.items()},
    )


def component_header(swc: SwcPlan, calls: Sequence[Call], model: ClassicIntegration) -> Lines:
    """Rte_<component>.h, the one header of the RTE that the source of a component includes."""
    headers = [*dict.fromkeys(each.header for each in swc.component.memories if each.header)]
    initial = [*literals.initial_values(swc, model, rte_types(model))]
    runnables = [(_head(each, swc), each.section) for each in swc.component.runnables]
    return c_lines(
        "code/rte_headers/Rte_component.h.j2",
        swc=swc,
        headers=headers,
        initial_values=initial,
        calls=calls,
        runnables=runnables,
    )


def _head(each: Runnable, swc: SwcPlan) -> str:
    return head(each, end_of(each, swc)) if each.role == "Method" else f"void {each.symbol}(void)"


def lifecycle_header(model: ClassicIntegration) -> Lines:
    """Rte_Main.h: what starts and stops the RTE; the state manager of the ECU calls it, in this order."""
    return c_lines("code/rte_headers/Rte_Main.h.j2", batches=model.ecu.init_batches)
