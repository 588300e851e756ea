"""The report: each field of an Integration JSON with its place in ARXML, and how the applications use the platform."""

from collections.abc import Iterator

from sigcat.adapter.autosar_adaptive.arxml.components import checkpoints
from sigcat.adapter.autosar_adaptive.arxml.field_targets import field_targets
from sigcat.adapter.autosar_adaptive.arxml.health import alive_supervisions
from sigcat.adapter.core.core_calls import short_name
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.integration.autosar_adaptive.model import Call, Component, ServiceField
from sigcat.integration.report import Entry
from sigcat.limits import Limits

_SUPERVISION = (
    "supervised by the core; not exported to ara::phm, which cannot pause where a mode excludes the call, nor wait "
    "for the error to mature"
)
_REPORTED = (
    "each end of the call is a checkpoint; ara::phm has no limits for it, as its verdict is at once and final, and the "
    "error matures or heals: admin data has them"
)
_LIMITED = "each end of the call is a checkpoint, and deployment.arxml has the ALIVE-SUPERVISION with the same limits"
_REACTION = "received over its field; what the core decides is logged, as no service of the function sends it"
_ERROR = "Update of its field; kPassed and kFailed, debounced by the core, go to ara::diag::Monitor"
_CYCLE = "the thread of the adapter runs it at the core's NextTime"


def report(data: bytes, name: str, limits: Limits) -> tuple[Entry, ...]:
    """An entry for each field that has a value. Raises InputRefused if the document cannot be used."""
    model = read_integration(data, name, limits)
    return (*field_targets(model), *(entry for part in model.components for entry in _of_component(part)))


def _of_component(component: Component) -> Iterator[Entry]:
    function = component.function or component.name
    for call in component.calls:
        yield from _of_call(function, component, call)
    for interface in component.services:
        for services in interface.services:
            for field in services.fields:
                yield from _of_field(function, component, field, is_provided=interface.role == "Provider")


def _of_call(function: str, component: Component, call: Call) -> Iterator[Entry]:
    target = f"{component.executable}: Run{short_name(call.name, function)}"
    if call.cycle_time is not None:
        yield Entry(function, call.name, "call", "CycleTime", target, _CYCLE)
    for kind in call.supervision_types or ():
        place, note = _supervised(component, call, kind)
        yield Entry(function, call.name, "call", f"SupervisionType {kind}", place, note)


def _supervised(component: Component, call: Call, kind: str) -> tuple[str, str]:
    """The supervisor of a call, with notes."""
    if kind != "Alive" or call.name not in checkpoints(component):
        return "core", _SUPERVISION
    is_limited = call.name in (each.call.name for each in alive_supervisions(component))
    return "core and ara::phm::SupervisedEntity", _LIMITED if is_limited else _REPORTED


def _of_field(function: str, component: Component, field: ServiceField, *, is_provided: bool) -> Iterator[Entry]:
    if field.safety_reaction is not None:
        yield Entry(function, field.name, "safety reaction", "Name", f"{component.executable}: Connect", _REACTION)
    if field.error is not None and is_provided:
        yield Entry(function, field.name, "error", "Name", f"{component.executable}: Publish", _ERROR)
