"""Values from the core to the RTE; errors to the diagnosis."""

from sigcat.adapter.autosar_classic.code.component.rte_values import component_lines
from sigcat.adapter.autosar_classic.code.plan import SwcPlan
from sigcat.adapter.core.c.text.lines import Lines


def functions(swc: SwcPlan) -> Lines:
    """Functions for what the core may say at any time, for outputs of each call, each request and each verdict."""
    return component_lines("publishing.c.j2", swc)
