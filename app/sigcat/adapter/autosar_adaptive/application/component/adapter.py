"""The adapter of a component: its header and its source."""

from collections.abc import Iterator, Sequence
from functools import partial

from sigcat.adapter.autosar_adaptive.application.names import checkpoint, include_guard
from sigcat.adapter.autosar_adaptive.application.plan import ApplicationPlan, ComponentPlan, Provided, Required
from sigcat.adapter.autosar_adaptive.arxml.components import IGNITION_CYCLE
from sigcat.adapter.autosar_adaptive.arxml.method_errors import DOMAIN, METHOD_ERRORS
from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.plan import GLOBALS
from sigcat.adapter.templates import rendered
from sigcat.function.document.text import composed
from sigcat.integration.autosar_adaptive.storages import ADAPTER_STORAGE

_ROOM = "adapter/autosar_adaptive/application/component"


def adapter_files(component: ComponentPlan, application: ApplicationPlan) -> tuple[str, str]:
    """The whole header, and the whole source."""
    core, fields = component.core, [each for service in component.provided for each in service.fields]
    version = f" {core.version}" if core.version else ""
    render = partial(
        rendered,
        component=component,
        type=component.type,
        core=core.type_name,  # with which names of its functions and types begin
        macro=Scope(core).macro,  # with which names of its constants begin
        is_global=core.code.signature == GLOBALS,
        namespace=application.namespace,
        guard=include_guard(application, component, "component"),
        about=composed(f"{component.name}{version} on AUTOSAR adaptive: ", core.description),
        headers=sorted(_headers(component)),
        checkpoint=checkpoint,
        # Calls that send states again when they end.
        repeating=sorted({each.repeated_by for each in fields if each.repeated_by}),
        has_fields=bool(fields),
        # Whether anything of the core is sent or logged.
        has_out=bool(fields or core.reactions or any(each.events for each in component.provided)),
        own_storage=f"storage_{ADAPTER_STORAGE}_",
        cycle_key=IGNITION_CYCLE,
        error_namespace="::".join(("", *component.error_namespace)),  # of the errors of methods
        errors=METHOD_ERRORS,  # why the core does not answer
        domain=DOMAIN,
    )
    return render(f"{_ROOM}/adapter.h.j2"), render(f"{_ROOM}/adapter.cpp.j2")


def _headers(component: ComponentPlan) -> Iterator[str]:
    used = {
        "clock": True,
        "communication": True,
        "log": True,
        "error_monitor": component.monitors,
        "required_service": component.required,
        "storage": component.storages,
        "watch": component.core.has_deadline,
        "call_thread": component.is_threaded,
        "call_mutex": component.is_threaded and component.has_offered,
    }
    yield from (f"application/{name}.h" for name, is_used in used.items() if is_used)
    if component.checkpoints:
        yield "ara/phm/supervised_entity.h"
    services: Sequence[Required | Provided] = (*component.required, *component.provided)
    if any(each.methods for each in services):
        yield "ara/core/future.h"
    yield from (each.names.proxy_header for each in component.required)
    yield from (each.names.skeleton_header for each in component.provided)
    yield f"core/{component.core.header_file}"
