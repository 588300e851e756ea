"""Internal behavior of a component: runnables, what they access, what starts them, what they share."""

from collections.abc import Iterable
from typing import NamedTuple

from sigcat.adapter.arxml.tree import Tag, description, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.paths import (
    BEHAVIOR,
    COMPONENTS,
    MODE_GROUPS,
    MODE_PROTOTYPE,
    OPERATION,
    PARAMETER,
    RUNNABLE,
    SECTIONS,
    TYPE_MAPPING_SET,
    TYPE_MAPPINGS,
    VARIABLE,
)
from sigcat.adapter.autosar_classic.arxml.ports import port_tag
from sigcat.adapter.autosar_classic.arxml.releases import Release
from sigcat.adapter.autosar_classic.arxml.values import init_value
from sigcat.function.document.text import Text
from sigcat.integration.autosar_classic.datatypes.used_types import enumerations_of
from sigcat.integration.autosar_classic.model import (
    Access,
    AccessKind,
    Component,
    Event,
    InternalParameter,
    PerInstanceMemory,
    Port,
    Runnable,
)
from sigcat.integration.autosar_names import short_name


class Within(NamedTuple):
    """A component, and where its elements are."""

    component: Component
    known: Library
    release: Release

    def path(self, *names: str) -> str:
        """Path of an element of its behavior, or of the behavior."""
        return self.known.paths.of(COMPONENTS, self.component.name, behavior_name(self.component), *names)

    def port(self, name: str | None) -> Port:
        """One of its ports."""
        return next(each for each in self.component.ports if each.name == name)

    def port_reference(self, tag_name: str, port: Port) -> Tag:
        """Reference to one of its ports."""
        return reference(
            tag_name, self.known.paths.of(COMPONENTS, self.component.name, port.name), port_tag(port.direction)
        )

    def access(self, runnable: str | None, kinds: Iterable[AccessKind], port: str | None, element: str | None) -> str:
        """Path of the access point of a runnable to an element."""
        wanted = tuple(kinds)
        found = next(
            access.name
            for each in self.component.runnables
            if runnable in (None, each.name)
            for access in each.accesses
            if access.kind in wanted and access.port == port and element in (access.element, access.name)
        )
        owner = next(
            each.name
            for each in self.component.runnables
            if runnable in (None, each.name) and any(access.name == found for access in each.accesses)
        )
        return self.path(owner, found)


def behavior_name(component: Component) -> str:
    """Name of the internal behavior of a component."""
    return short_name(f"{component.name}_Behavior")


def behavior(at: Within, dependencies: Iterable[Tag]) -> Tag:
    """The internal behavior; `dependencies` are what the component needs of the base software."""
    component = at.component
    mapping = at.known.paths.of(TYPE_MAPPINGS, TYPE_MAPPING_SET)
    return tag(
        BEHAVIOR,
        tag("DATA-TYPE-MAPPING-REFS", reference("DATA-TYPE-MAPPING-REF", mapping, "DATA-TYPE-MAPPING-SET")),
        listed("EXCLUSIVE-AREAS", (_area(each.name, each.description) for each in component.exclusive_areas)),
        listed("EVENTS", (_event(each, at) for each in component.events)),
        tag("HANDLE-TERMINATION-AND-RESTART", text="NO-SUPPORT"),
        listed("INCLUDED-DATA-TYPE-SETS", _prefixes(at)),
        listed("PER-INSTANCE-MEMORYS", (_memory(each) for each in component.memories)),
        listed("PORT-API-OPTIONS", _port_options(at)),
        listed("RUNNABLES", (_runnable(each, at) for each in component.runnables)),
        listed("SERVICE-DEPENDENCYS", dependencies),
        listed("SHARED-PARAMETERS", (_parameter(each, at.known) for each in component.parameters)),
        tag("SUPPORTS-MULTIPLE-INSTANTIATION", text="false"),
        name=behavior_name(component),
    )


def _area(name: str, text: Text) -> Tag:
    return tag("EXCLUSIVE-AREA", description(text), name=name)


def _prefixes(at: Within) -> Iterable[Tag]:
    """Prefix of the names of values in the code of the component."""
    known = at.known
    used = enumerations_of(at.component, known.exchanged_types, known.application_types, known.implementation_types)
    for each in used:
        if each.literal_prefix:
            yield tag(
                "INCLUDED-DATA-TYPE-SET",
                listed("DATA-TYPE-REFS", [known.type_reference("DATA-TYPE-REF", each.name)]),
                tag("LITERAL-PREFIX", text=each.literal_prefix),
            )


def _port_options(at: Within) -> Iterable[Tag]:
    """Ports whose reads tell what end-to-end protection has rejected."""
    for port in at.component.ports:
        if port.reports_transformer_errors:
            handling = tag("ERROR-HANDLING", text="TRANSFORMER-ERROR-HANDLING")
            yield tag("PORT-API-OPTION", handling, at.port_reference("PORT-REF", port))


def _memory(memory: PerInstanceMemory) -> Tag:
    return tag(
        "PER-INSTANCE-MEMORY",
        description(memory.description),
        trace([("Header", memory.header)]),
        tag("TYPE", text=memory.type),
        tag("TYPE-DEFINITION", text=memory.type_definition),
        name=memory.name,
    )


def _parameter(parameter: InternalParameter, known: Library) -> Tag:
    return tag(
        PARAMETER,
        trace([("Uses", parameter.uses)]),
        known.type_reference("TYPE-TREF", parameter.type),
        init_value(parameter.init, parameter.type, known),
        name=parameter.name,
    )


# -- runnables --------------------------------------------------------------------------------------------------------

_LISTS: tuple[tuple[str, tuple[AccessKind, ...]], ...] = (
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


def _runnable(runnable: Runnable, at: Within) -> Tag:
    parameters = [_internal_access(name, at) for name in runnable.parameters or ()]
    parameters += [_access(each, at) for each in runnable.accesses if each.kind == "Parameter"]
    lists = (
        listed(name, (_access(each, at) for each in runnable.accesses if each.kind in kinds)) for name, kinds in _LISTS
    )
    return tag(
        RUNNABLE,
        description(runnable.description),
        trace(list(_facts(runnable))),
        _areas(runnable, at),
        tag("MINIMUM-START-INTERVAL", text=runnable.minimum_start_interval),
        reference("SW-ADDR-METHOD-REF", at.known.paths.of(SECTIONS, runnable.section), "SW-ADDR-METHOD"),
        tag("CAN-BE-INVOKED-CONCURRENTLY", text=str(runnable.concurrent).lower()),
        *lists,
        listed("PARAMETER-ACCESSS", parameters),
        tag("SYMBOL", text=runnable.symbol),
        name=runnable.name,
    )


def _facts(runnable: Runnable) -> Iterable[tuple[str, object]]:
    yield from (("Role", runnable.role), ("Call", runnable.call), ("Method", runnable.method))
    yield "AsilLevel", runnable.asil_level
    yield from ((f"{each.name}.Reason", each.reason) for each in runnable.accesses)


def _areas(runnable: Runnable, at: Within) -> Tag | None:
    paths = [at.path(name) for name in runnable.exclusive_areas]
    if at.release.has_conditional_areas:
        conditional = "EXCLUSIVE-AREA-REF-CONDITIONAL"
        references = [reference("EXCLUSIVE-AREA-REF", path, "EXCLUSIVE-AREA") for path in paths]
        return listed("CAN-ENTERS", (tag(conditional, each) for each in references))
    name = "CAN-ENTER-EXCLUSIVE-AREA-REF"
    return listed(f"{name}S", (reference(name, path, "EXCLUSIVE-AREA") for path in paths))


def _internal_access(name: str, at: Within) -> Tag:
    target = reference("LOCAL-PARAMETER-REF", at.path(name), PARAMETER)
    return tag("PARAMETER-ACCESS", tag("ACCESSED-PARAMETER", target), name=short_name(f"Prm_{name}"))


def _access(access: Access, at: Within) -> Tag:
    if access.kind == "InternalTrigger":
        return tag("INTERNAL-TRIGGERING-POINT", tag("SW-IMPL-POLICY", text="STANDARD"), name=access.name)
    port = at.port(access.port)
    path = at.known.interface_path(port, access.element)
    if access.kind == "Result":
        call = at.access(None, ("AsynchronousCall",), access.port, access.element)
        target = reference("ASYNCHRONOUS-SERVER-CALL-POINT-REF", call, "ASYNCHRONOUS-SERVER-CALL-POINT")
        return tag("ASYNCHRONOUS-SERVER-CALL-RESULT-POINT", target, name=access.name)
    if access.kind in ("SynchronousCall", "AsynchronousCall"):
        return _call_point(access, port, path, at)
    if access.kind in ("Mode", "ModeSwitch"):
        return _mode_point(access, port, path, at)
    if access.kind == "Parameter":
        prototype = tag(
            "AUTOSAR-PARAMETER-IREF",
            at.port_reference("PORT-PROTOTYPE-REF", port),
            reference("TARGET-DATA-PROTOTYPE-REF", path, PARAMETER),
        )
        return tag("PARAMETER-ACCESS", tag("ACCESSED-PARAMETER", prototype), name=access.name)
    variable = tag(
        "AUTOSAR-VARIABLE-IREF",
        at.port_reference("PORT-PROTOTYPE-REF", port),
        reference("TARGET-DATA-PROTOTYPE-REF", path, VARIABLE),
    )
    return tag("VARIABLE-ACCESS", tag("ACCESSED-VARIABLE", variable), name=access.name)


def _call_point(access: Access, port: Port, path: str, at: Within) -> Tag:
    kind = "SYNCHRONOUS" if access.kind == "SynchronousCall" else "ASYNCHRONOUS"
    operation = tag(
        "OPERATION-IREF",
        at.port_reference("CONTEXT-R-PORT-REF", port),
        reference("TARGET-REQUIRED-OPERATION-REF", path, OPERATION),
    )
    return tag(f"{kind}-SERVER-CALL-POINT", operation, tag("TIMEOUT", text=0), name=access.name)


def _mode_point(access: Access, port: Port, path: str, at: Within) -> Tag:
    side = "P" if port.direction == "Provided" else "R"
    content = (
        at.port_reference(f"CONTEXT-{side}-PORT-REF", port),
        reference("TARGET-MODE-GROUP-REF", path, MODE_PROTOTYPE),
    )
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


def _event(event: Event, at: Within) -> Tag:
    start = reference("START-ON-EVENT-REF", at.path(event.runnable), RUNNABLE)
    return tag(EVENT[event.kind], start, *_condition(event, at), name=event.name)


def _condition(event: Event, at: Within) -> Iterable[Tag]:
    if event.kind == "Timing":
        yield tag("OFFSET", text=event.offset or 0)
        yield tag("PERIOD", text=event.period)
    elif event.kind == "InternalTrigger":
        source = at.access(event.source, ("InternalTrigger",), event.port, event.element)
        yield reference("EVENT-SOURCE-REF", source, "INTERNAL-TRIGGERING-POINT")
    elif event.kind == "CallReturns":
        result = at.access(event.runnable, ("Result",), event.port, event.element)
        yield reference("EVENT-SOURCE-REF", result, "ASYNCHRONOUS-SERVER-CALL-RESULT-POINT")
    elif event.kind != "Init":
        yield from _of_port(event, at.port(event.port), at)


def _of_port(event: Event, port: Port, at: Within) -> Iterable[Tag]:
    path = at.known.interface_path(port, event.element or "")
    if event.kind == "DataReceived":
        element = reference("TARGET-DATA-ELEMENT-REF", path, VARIABLE)
        yield tag("DATA-IREF", at.port_reference("CONTEXT-R-PORT-REF", port), element)
    elif event.kind == "OperationInvoked":
        operation = reference("TARGET-PROVIDED-OPERATION-REF", path, OPERATION)
        yield tag("OPERATION-IREF", at.port_reference("CONTEXT-P-PORT-REF", port), operation)
    else:
        interface = at.known.modes[port.interface]
        mode = at.known.paths.of(MODE_GROUPS, interface.group, event.mode or "")
        yield tag("ACTIVATION", text="ON-EXIT" if event.activation == "OnExit" else "ON-ENTRY")
        yield tag(
            "MODE-IREFS",
            tag(
                "MODE-IREF",
                at.port_reference("CONTEXT-PORT-REF", port),
                reference("CONTEXT-MODE-DECLARATION-GROUP-PROTOTYPE-REF", path, MODE_PROTOTYPE),
                reference("TARGET-MODE-DECLARATION-REF", mode, "MODE-DECLARATION"),
            ),
        )
