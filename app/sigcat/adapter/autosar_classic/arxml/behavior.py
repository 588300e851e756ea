"""Internal behavior of a component: runnables, what they access, what starts them, what they share."""

from collections.abc import Iterable
from typing import NamedTuple

from sigcat.adapter.arxml.tree import Child, Tag, conditional, description, listed, reference, references, tag, trace
from sigcat.adapter.autosar_classic.arxml import paths
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.ports import port_reference, side_of
from sigcat.adapter.autosar_classic.arxml.value_specifications import init_value
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.datatypes.used_types import enumerations_of
from sigcat.integration.autosar_names import short_name


class Within(NamedTuple):
    """A component, and where its elements are."""

    component: model.Component
    known: Library

    def path(self, *names: str) -> str:
        """Path of an element of its behavior, or of the behavior."""
        return self.known.path(paths.COMPONENTS, self.component.name, behavior_name(self.component), *names)

    def port(self, name: str | None) -> model.Port:
        """One of its ports."""
        return next(each for each in self.component.ports if each.name == name)

    def port_reference(self, tag_name: str, port: model.Port) -> Tag:
        """Reference to one of its ports."""
        path = self.known.path(paths.COMPONENTS, self.component.name, port.name)
        return port_reference(tag_name, path, port.direction)

    def access(
        self, runnable: str | None, kinds: Iterable[model.AccessKind], port: str | None, element: str | None
    ) -> str:
        """Path of the access point of a runnable to an element."""
        wanted = tuple(kinds)
        runnables = [each for each in self.component.runnables if runnable in (None, each.name)]
        found = next(
            access.name
            for each in runnables
            for access in each.accesses
            if access.kind in wanted and access.port == port and element in (access.element, access.name)
        )
        owner = next(each.name for each in runnables if any(access.name == found for access in each.accesses))
        return self.path(owner, found)


def behavior_name(component: model.Component) -> str:
    """Name of the internal behavior of a component."""
    return short_name(f"{component.name}_Behavior")


def behavior(at: Within, dependencies: Iterable[Tag]) -> Tag:
    """The internal behavior; `dependencies` are what the component needs of the base software."""
    component = at.component
    areas = (tag("EXCLUSIVE-AREA", description(each.description), name=each.name) for each in component.exclusive_areas)
    return tag(
        paths.BEHAVIOR,
        at.known.type_mappings(),
        listed("EXCLUSIVE-AREAS", areas),
        listed("EVENTS", (_event(each, at) for each in component.events)),
        {"HANDLE-TERMINATION-AND-RESTART": "NO-SUPPORT", "SUPPORTS-MULTIPLE-INSTANTIATION": False},
        listed("INCLUDED-DATA-TYPE-SETS", _prefixes(at)),
        listed("PER-INSTANCE-MEMORYS", (_memory(each) for each in component.memories)),
        listed("PORT-API-OPTIONS", _port_options(at)),
        listed("RUNNABLES", (_runnable(each, at) for each in component.runnables)),
        listed("SERVICE-DEPENDENCYS", dependencies),
        listed("SHARED-PARAMETERS", (_parameter(each, at.known) for each in component.parameters)),
        name=behavior_name(component),
    )


def _prefixes(at: Within) -> Iterable[Tag]:
    """Prefix of the names of values in the code of the component."""
    known = at.known
    used = enumerations_of(at.component, known.exchanged_types, known.application_types, known.implementation_types)
    for each in used:
        if each.literal_prefix:
            target = tag("DATA-TYPE-REFS", known.type_reference("DATA-TYPE-REF", each.name))
            yield tag("INCLUDED-DATA-TYPE-SET", target, {"LITERAL-PREFIX": each.literal_prefix})


def _port_options(at: Within) -> Iterable[Tag]:
    """Ports whose reads tell what end-to-end protection has rejected."""
    for port in at.component.ports:
        if port.reports_transformer_errors:
            handling = {"ERROR-HANDLING": "TRANSFORMER-ERROR-HANDLING"}
            yield tag("PORT-API-OPTION", handling, at.port_reference("PORT-REF", port))


def _memory(memory: model.PerInstanceMemory) -> Tag:
    return tag(
        "PER-INSTANCE-MEMORY",
        description(memory.description),
        trace([("Header", memory.header)]),
        {"TYPE": memory.type, "TYPE-DEFINITION": memory.type_definition},
        name=memory.name,
    )


def _parameter(parameter: model.InternalParameter, known: Library) -> Tag:
    return tag(
        paths.PARAMETER,
        trace([("Uses", parameter.uses)]),
        known.type_reference("TYPE-TREF", parameter.type),
        init_value(parameter.init, parameter.type, known),
        name=parameter.name,
    )


# -- runnables --------------------------------------------------------------------------------------------------------

_LISTS: tuple[tuple[str, tuple[model.AccessKind, ...]], ...] = (
    ("ASYNCHRONOUS-SERVER-CALL-RESULT-POINTS", ("Result",)),
    ("DATA-READ-ACCESSS", ("ImplicitRead",)),
    ("DATA-RECEIVE-POINT-BY-ARGUMENTS", ("ExplicitRead", "QueuedReceive")),
    ("DATA-SEND-POINTS", ("ExplicitWrite", "QueuedSend")),
    ("INTERNAL-TRIGGERING-POINTS", ("InternalTrigger",)),
    ("MODE-ACCESS-POINTS", ("Mode",)),
    ("MODE-SWITCH-POINTS", ("ModeSwitch",)),
    ("SERVER-CALL-POINTS", ("SynchronousCall", "AsynchronousCall")),
)
"""Lists of a runnable, and the accesses in each."""


def _runnable(runnable: model.Runnable, at: Within) -> Tag:
    parameters = [_internal_access(name, at) for name in runnable.parameters or ()]
    parameters += (_access(each, at) for each in runnable.accesses if each.kind == "Parameter")
    lists = (
        listed(name, (_access(each, at) for each in runnable.accesses if each.kind in kinds)) for name, kinds in _LISTS
    )
    return tag(
        paths.RUNNABLE,
        description(runnable.description),
        trace(_facts(runnable)),
        _areas(runnable, at),
        reference("SW-ADDR-METHOD-REF", at.known.path(paths.SECTIONS, runnable.section), "SW-ADDR-METHOD"),
        {"MINIMUM-START-INTERVAL": runnable.minimum_start_interval, "SYMBOL": runnable.symbol},
        {"CAN-BE-INVOKED-CONCURRENTLY": runnable.concurrent},
        *lists,
        listed("PARAMETER-ACCESSS", parameters),
        name=runnable.name,
    )


def _facts(runnable: model.Runnable) -> Iterable[tuple[str, object]]:
    yield from (("Role", runnable.role), ("Call", runnable.call), ("Method", runnable.method))
    yield "AsilLevel", runnable.asil_level
    yield from ((f"{each.name}.Reason", each.reason) for each in runnable.accesses)


def _areas(runnable: model.Runnable, at: Within) -> Tag | None:
    areas = [at.path(name) for name in runnable.exclusive_areas]
    if not at.known.release.has_conditional_areas:
        return references("CAN-ENTER-EXCLUSIVE-AREA-REF", areas, "EXCLUSIVE-AREA")
    targets = (reference("EXCLUSIVE-AREA-REF", path, "EXCLUSIVE-AREA") for path in areas)
    return listed("CAN-ENTERS", map(conditional, targets))


def _internal_access(name: str, at: Within) -> Tag:
    target = reference("LOCAL-PARAMETER-REF", at.path(name), paths.PARAMETER)
    return tag("PARAMETER-ACCESS", tag("ACCESSED-PARAMETER", target), name=short_name(f"Prm_{name}"))


def _access(access: model.Access, at: Within) -> Tag:
    if access.kind == "InternalTrigger":
        return tag("INTERNAL-TRIGGERING-POINT", {"SW-IMPL-POLICY": "STANDARD"}, name=access.name)
    port = at.port(access.port)
    path = at.known.interface_path(port, access.element)
    if access.kind == "Result":
        call = at.access(None, ("AsynchronousCall",), access.port, access.element)
        target = reference("ASYNCHRONOUS-SERVER-CALL-POINT-REF", call, "ASYNCHRONOUS-SERVER-CALL-POINT")
        return tag("ASYNCHRONOUS-SERVER-CALL-RESULT-POINT", target, name=access.name)
    if access.kind in ("SynchronousCall", "AsynchronousCall"):
        context = at.port_reference("CONTEXT-R-PORT-REF", port)
        operation = tag("OPERATION-IREF", context, reference("TARGET-REQUIRED-OPERATION-REF", path, paths.OPERATION))
        kind = access.kind.removesuffix("Call").upper()
        return tag(f"{kind}-SERVER-CALL-POINT", operation, {"TIMEOUT": 0}, name=access.name)
    if access.kind in ("Mode", "ModeSwitch"):
        return _mode_point(access, port, path, at)
    word, kind = ("PARAMETER", paths.PARAMETER) if access.kind == "Parameter" else ("VARIABLE", paths.VARIABLE)
    context = at.port_reference("PORT-PROTOTYPE-REF", port)
    prototype = tag(f"AUTOSAR-{word}-IREF", context, reference("TARGET-DATA-PROTOTYPE-REF", path, kind))
    return tag(f"{word}-ACCESS", tag(f"ACCESSED-{word}", prototype), name=access.name)


def _mode_point(access: model.Access, port: model.Port, path: str, at: Within) -> Tag:
    side = side_of(port.direction)
    context = at.port_reference(f"CONTEXT-{side}-PORT-REF", port)
    content = (context, reference("TARGET-MODE-GROUP-REF", path, paths.MODE_PROTOTYPE))
    if access.kind == "ModeSwitch":
        return tag("MODE-SWITCH-POINT", tag("MODE-GROUP-IREF", *content), name=access.name)
    group = tag("MODE-GROUP-IREF", tag(f"{side}-MODE-GROUP-IN-ATOMIC-SWC-INSTANCE-REF", *content))
    return tag("MODE-ACCESS-POINT", tag("IDENT", name=access.name), group)


# -- events -----------------------------------------------------------------------------------------------------------

EVENT = {
    "Init": "INIT-EVENT",
    "Timing": "TIMING-EVENT",
    "DataReceived": "DATA-RECEIVED-EVENT",
    "ModeSwitch": "SWC-MODE-SWITCH-EVENT",
    "OperationInvoked": "OPERATION-INVOKED-EVENT",
    "CallReturns": "ASYNCHRONOUS-SERVER-CALL-RETURNS-EVENT",
    "InternalTrigger": "INTERNAL-TRIGGER-OCCURRED-EVENT",
}
"""Element of an event, by its kind."""


def _event(event: model.Event, at: Within) -> Tag:
    start = reference("START-ON-EVENT-REF", at.path(event.runnable), paths.RUNNABLE)
    return tag(EVENT[event.kind], start, *_condition(event, at), name=event.name)


def _condition(event: model.Event, at: Within) -> Iterable[Child]:
    if event.kind == "Timing":
        yield {"OFFSET": event.offset or 0, "PERIOD": event.period}
    elif event.kind == "InternalTrigger":
        source = at.access(event.source, ("InternalTrigger",), event.port, event.element)
        yield reference("EVENT-SOURCE-REF", source, "INTERNAL-TRIGGERING-POINT")
    elif event.kind == "CallReturns":
        result = at.access(event.runnable, ("Result",), event.port, event.element)
        yield reference("EVENT-SOURCE-REF", result, "ASYNCHRONOUS-SERVER-CALL-RESULT-POINT")
    elif event.kind != "Init":
        yield from _of_port(event, at.port(event.port), at)


def _of_port(event: model.Event, port: model.Port, at: Within) -> Iterable[Child]:
    path = at.known.interface_path(port, event.element or "")
    if event.kind == "DataReceived":
        element = reference("TARGET-DATA-ELEMENT-REF", path, paths.VARIABLE)
        yield tag("DATA-IREF", at.port_reference("CONTEXT-R-PORT-REF", port), element)
    elif event.kind == "OperationInvoked":
        operation = reference("TARGET-PROVIDED-OPERATION-REF", path, paths.OPERATION)
        yield tag("OPERATION-IREF", at.port_reference("CONTEXT-P-PORT-REF", port), operation)
    else:
        interfaces = at.known.model.mode_switch_interfaces
        interface = next(each for each in interfaces if each.name == port.interface)
        mode = at.known.path(paths.MODE_GROUPS, interface.group, event.mode or "")
        iref = tag(
            "MODE-IREF",
            at.port_reference("CONTEXT-PORT-REF", port),
            reference("CONTEXT-MODE-DECLARATION-GROUP-PROTOTYPE-REF", path, paths.MODE_PROTOTYPE),
            reference("TARGET-MODE-DECLARATION-REF", mode, "MODE-DECLARATION"),
        )
        yield {"ACTIVATION": "ON-EXIT" if event.activation == "OnExit" else "ON-ENTRY"}
        yield tag("MODE-IREFS", iref)
