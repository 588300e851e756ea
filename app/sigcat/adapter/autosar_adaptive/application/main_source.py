"""The main function of an executable."""

from sigcat.adapter.autosar_adaptive.application.plan import ApplicationPlan, ExecutablePlan
from sigcat.adapter.templates import rendered


def main_source(executable: ExecutablePlan, application: ApplicationPlan) -> str:
    """The whole source."""
    return rendered(
        "adapter/autosar_adaptive/application/main.cpp.j2",
        name=executable.name,
        namespace=application.namespace,
        components=executable.components,
    )
