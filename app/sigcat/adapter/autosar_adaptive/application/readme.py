"""The page for the integrator who builds the applications."""

from sigcat.adapter.autosar_adaptive.application.plan import ApplicationPlan
from sigcat.adapter.core.plan import Call
from sigcat.adapter.templates import rendered

_TEMPLATE = "adapter/autosar_adaptive/application/README.md.j2"


def readme(application: ApplicationPlan) -> str:
    """README.md."""
    components = application.components
    calls = {component.name: [_call(step) for step in component.core.steps] for component in components}
    threaded = [component for component in components if component.is_threaded or component.joined]
    return rendered(
        _TEMPLATE,
        name=application.name,
        executables=application.executables,
        components=components,
        calls=calls,  # calls of each component, with their cycles
        threaded=threaded,  # components whose calls have priorities
    )


def _call(step: Call) -> str:
    return f"{step.interface} ({step.cycle / 10**6:g} ms)" if step.cycle else step.interface
