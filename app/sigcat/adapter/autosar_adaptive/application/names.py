"""Names in the generated C++."""

from sigcat.adapter.autosar_adaptive.application.plan import ApplicationPlan, ComponentPlan
from sigcat.adapter.core.identifiers import identifier
from sigcat.names import screaming_snake_case


def include_guard(application: ApplicationPlan, component: ComponentPlan, header: str) -> str:
    """The include guard of a header, unlike that of the core."""
    return f"{screaming_snake_case('_'.join((*application.namespace, component.stem, header)))}_H"


def checkpoint(call: str) -> str:
    """The constant of a call among the checkpoints."""
    return f"k{identifier(call)}"


def cpp_type(name: str) -> str:
    """A type, from any namespace."""
    return f"::{name}" if "::" in name and not name.startswith("std::") else name
