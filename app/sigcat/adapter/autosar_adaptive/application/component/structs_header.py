"""Structs of the platform and of the core, copied member by member."""

from sigcat.adapter.autosar_adaptive.application.names import include_guard
from sigcat.adapter.autosar_adaptive.application.plan import ApplicationPlan, ComponentPlan
from sigcat.adapter.templates import rendered


def structs_header(component: ComponentPlan, application: ApplicationPlan) -> str:
    """The whole header."""
    headers = ("application/values.h", *component.type_headers, f"core/{component.core.header_file}")
    guard = include_guard(application, component, "structs")
    return rendered(
        "adapter/autosar_adaptive/application/component/structs.h.j2",
        name=component.name,
        guard=guard,
        headers=sorted(headers),
        pairs=component.structs,
    )
