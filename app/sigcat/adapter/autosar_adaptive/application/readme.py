"""The page for the integrator who builds the applications."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.application.plan import ApplicationPlan, ComponentPlan, ExecutablePlan
from sigcat.adapter.core.plan import Call
from sigcat.adapter.templates import rendered

_TEMPLATE = "adapter/autosar_adaptive/application/README.md.j2"


class _Readme(NamedTuple):
    """Plan of README.md."""

    name: str
    executables: Sequence[ExecutablePlan]
    components: Sequence[ComponentPlan]
    calls: Mapping[str, Sequence[str]]
    """Calls of each component, with their cycles."""
    threaded: Sequence[ComponentPlan]
    """Components whose calls have priorities."""


def readme(application: ApplicationPlan) -> str:
    """README.md."""
    components = application.components
    calls = {component.name: [_call(step) for step in component.core.steps] for component in components}
    threaded = [component for component in components if component.is_threaded or component.joined]
    return rendered(_TEMPLATE, _Readme(application.name, application.executables, components, calls, threaded))


def _call(step: Call) -> str:
    return f"{step.interface} ({step.cycle / 10**6:g} ms)" if step.cycle else step.interface
