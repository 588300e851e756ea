"""The main function of an executable."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.application.plan import ApplicationPlan, ComponentPlan, ExecutablePlan
from sigcat.adapter.templates import rendered


class _Main(NamedTuple):
    """Plan of the source."""

    name: str
    namespace: Sequence[str]
    components: Sequence[ComponentPlan]


def main_source(executable: ExecutablePlan, application: ApplicationPlan) -> str:
    """The whole source."""
    plan = _Main(executable.name, application.namespace, executable.components)
    return rendered("adapter/autosar_adaptive/application/main.cpp.j2", plan)
