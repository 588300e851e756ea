"""From an integration and the plans of its cores to the plan of the software components."""

from collections.abc import Iterator, Mapping

from sigcat import codes
from sigcat.adapter.autosar_classic.code.plan import (
    ClassicPlan,
    ModeEnd,
    ParameterEnd,
    Reported,
    SwcPlan,
    Told,
)
from sigcat.adapter.autosar_classic.code.planning.disagreements import disagreements
from sigcat.adapter.autosar_classic.code.planning.ends import SwcContext, received, sent
from sigcat.adapter.autosar_classic.code.planning.operations import method_ends
from sigcat.adapter.autosar_classic.code.rte_types import rte_types
from sigcat.adapter.source_cores import Holder, SourceCores, wrong_holders
from sigcat.errors import InputRefused
from sigcat.integration.autosar_classic.model import ClassicIntegration, Port


def derive(model: ClassicIntegration, cores: SourceCores) -> ClassicPlan:
    """The plan of the components. Raises InputRefused if one of them does not have its own function."""
    holders = (
        Holder(each.name, each.function, f"/Components/{at}/Function") for at, each in enumerate(model.components)
    )
    if found := list(wrong_holders(holders, cores, codes.NOT_WRITABLE_AS_CLASSIC, "software")):
        raise InputRefused("The integration cannot become software components.", tuple(found))
    types = rte_types(model)
    swcs = tuple(_swc(SwcContext(model, each, cores[each.function], types)) for each in model.components)
    if told := dict.fromkeys(finding for at, swc in enumerate(swcs) for finding in disagreements(swc, at)):
        raise InputRefused("The integration cannot become software components.", tuple(told))
    return ClassicPlan(model.info.name, swcs, types)


def _swc(context: SwcContext) -> SwcPlan:
    component = context.component
    return SwcPlan(
        component=component,
        host=context.host,
        received=tuple(received(context)),
        sent=tuple(sent(context)),
        mode_in=_mode(context, "Required"),
        mode_out=_mode(context, "Provided"),
        told=tuple(_errors_to_diagnosis(context)),
        reported=_reported(context),
        methods=tuple(method_ends(context)),
        parameters=tuple(_parameters(context)),
        memory=next(iter(component.memories), None),
        time=_called(context, "GetTime"),
        ignition=_called(context, "GetCycle"),
        restored=_called(context, "GetErrorStatus"),
        marked=_called(context, "SetRamBlockStatus"),
        area=component.exclusive_areas[0].name,
        calls_area=next((each.name for each in component.exclusive_areas[1:]), ""),
    )


def _mode(context: SwcContext, direction: str) -> ModeEnd | None:
    """The mode of the function: that of the ECU is for its end."""
    interfaces = {each.name: each for each in context.model.mode_switch_interfaces}
    core = context.host.core
    mode = core.mode_in if direction == "Required" else core.mode_out
    for port in context.component.ports:
        if mode and port.kind == "ModeSwitch" and port.direction == direction and port.elements[0].uses:
            interface = interfaces[port.interface]
            columns = tuple(use.interface for use in port.elements[0].uses)
            return ModeEnd(port.name, interface.prototype, interface.group, mode.named.name, columns)
    return None


def _errors_to_diagnosis(context: SwcContext) -> Iterator[Told]:
    ports = {port.name: port for port in context.component.ports}
    for event in context.component.diagnostic_events:
        error = context.host.errors.get(event.error)
        if error is not None:
            yield Told(event.port, _operation(ports[event.port]), error)


def _operation(port: Port) -> str:
    return port.elements[0].name


def _reported(context: SwcContext) -> Mapping[tuple[str, str], tuple[Reported, ...]]:
    ports = {port.name: port for port in context.component.ports}
    found: dict[tuple[str, str], tuple[Reported, ...]] = {}
    for entity in context.component.supervised_entities:
        for each in entity.checkpoints:
            one = Reported(f"Rte_Call_{each.port}_{_operation(ports[each.port])}", each.name)
            found[each.call, each.moment] = (*found.get((each.call, each.moment), ()), one)
    return found


def _parameters(context: SwcContext) -> Iterator[ParameterEnd]:
    """Yield parameters that are calibrated: a learned one is kept, and has no other source."""
    by_name = {context.host.interfaces[each.named.pointer]: each for each in context.host.core.settable}
    elements = {(one.name, each.name): each for one in context.model.parameter_interfaces for each in one.elements}
    for port in context.component.ports:
        for element in port.elements if port.kind == "Parameter" else ():
            type_ = context.type_of(elements[port.interface, element.name].type)
            for use in element.uses or ():
                if use.interface in by_name:
                    function = f"Rte_Prm_{port.name}_{element.name}"
                    yield ParameterEnd(function, type_, by_name[use.interface])
    for internal in context.component.parameters:
        for name in internal.uses:
            if name in by_name:
                function = f"Rte_CData_{internal.name}"
                yield ParameterEnd(function, context.type_of(internal.type), by_name[name])


def _called(context: SwcContext, operation: str) -> str:
    """The function of the RTE that calls an operation, by the name that the base software has for it."""
    ports = (port for port in context.component.ports if port.kind == "ClientServer" and port.direction == "Required")
    found = (port.name for port in ports if any(each.name == operation and not each.uses for each in port.elements))
    return next((f"Rte_Call_{port}_{operation}" for port in found), "")
