"""Port interfaces: data, operations, modes and parameters."""

from collections.abc import Iterable

from sigcat.adapter.arxml.tree import Package, Tag, definition_properties, description, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.paths import (
    IMPLEMENTATION_TYPE,
    INTERFACES,
    MODE_GROUP,
    MODE_GROUPS,
    OPERATION,
    PARAMETER,
    VARIABLE,
)
from sigcat.integration.autosar_classic.model import (
    ClassicIntegration,
    ClientServerInterface,
    DataElement,
    ModeSwitchInterface,
    Operation,
    OperationArgument,
    ParameterInterface,
    SenderReceiverInterface,
)

_SERVICE_KINDS = {
    "DiagnosticEventManager": "DIAGNOSTIC-EVENT-MANAGER",
    "NvRamManager": "NON-VOLATILE-RAM-MANAGER",
    "WatchdogManager": "WATCH-DOG-MANAGER",
    "FunctionInhibitionManager": "FUNCTION-INHIBITION-MANAGER",
    "EcuManager": "ECU-MANAGER",
}


def package(model: ClassicIntegration, known: Library) -> Package:
    """The package of port interfaces."""
    return Package(
        INTERFACES,
        (
            *(_sender_receiver(each, known) for each in model.sender_receiver_interfaces),
            *(_client_server(each, known) for each in model.client_server_interfaces),
            *(_mode_switch(each, known) for each in model.mode_switch_interfaces),
            *(_parameters(each, known) for each in model.parameter_interfaces),
        ),
    )


def _service(kind: str | None) -> Iterable[Tag | None]:
    """IS-SERVICE and the module of the base software that offers it, if one does."""
    yield tag("IS-SERVICE", text="true" if kind else "false")
    if kind:
        yield tag("SERVICE-KIND", text=_SERVICE_KINDS.get(kind, "VENDOR-SPECIFIC"))


def _sender_receiver(interface: SenderReceiverInterface, known: Library) -> Tag:
    return tag(
        "SENDER-RECEIVER-INTERFACE",
        description(interface.description),
        *_service(None),
        listed("DATA-ELEMENTS", (_element(VARIABLE, each, known) for each in interface.elements)),
        name=interface.name,
    )


def _element(kind: str, element: DataElement, known: Library) -> Tag:
    policy = tag("SW-IMPL-POLICY", text="QUEUED" if element.queued else "STANDARD")
    return tag(
        kind,
        description(element.description),
        trace([("VssPath", element.vss_path), ("Unit", element.unit)]),
        definition_properties(_access(kind), policy),
        known.type_reference("TYPE-TREF", element.type),
        name=element.name,
    )


def _access(kind: str) -> Tag:
    return tag("SW-CALIBRATION-ACCESS", text="READ-WRITE" if kind == PARAMETER else "READ-ONLY")


def _parameters(interface: ParameterInterface, known: Library) -> Tag:
    elements = (_element(PARAMETER, each, known) for each in interface.elements)
    return tag("PARAMETER-INTERFACE", *_service(None), listed("PARAMETERS", elements), name=interface.name)


def _client_server(interface: ClientServerInterface, known: Library) -> Tag:
    path = known.paths.of(INTERFACES, interface.name)
    errors = (
        tag("APPLICATION-ERROR", tag("ERROR-CODE", text=each.value), name=each.name) for each in interface.errors or ()
    )
    return tag(
        "CLIENT-SERVER-INTERFACE",
        *_service(interface.service),
        listed("OPERATIONS", (_operation(each, path, known) for each in interface.operations)),
        listed("POSSIBLE-ERRORS", errors),
        name=interface.name,
    )


def _operation(operation: Operation, interface: str, known: Library) -> Tag:
    errors = (
        reference("POSSIBLE-ERROR-REF", f"{interface}/{name}", "APPLICATION-ERROR") for name in operation.errors or ()
    )
    return tag(
        OPERATION,
        description(operation.description),
        listed("ARGUMENTS", (_argument(each, known) for each in operation.arguments)),
        listed("POSSIBLE-ERROR-REFS", errors),
        name=operation.name,
    )


def _argument(argument: OperationArgument, known: Library) -> Tag:
    return tag(
        "ARGUMENT-DATA-PROTOTYPE",
        trace([("Unit", argument.unit)]),
        reference("TYPE-TREF", known.implementation_path(argument.type), IMPLEMENTATION_TYPE),
        tag("DIRECTION", text=argument.direction),
        tag("SERVER-ARGUMENT-IMPL-POLICY", text="USE-ARGUMENT-TYPE"),
        name=argument.name,
    )


def _mode_switch(interface: ModeSwitchInterface, known: Library) -> Tag:
    group = reference("TYPE-TREF", known.paths.of(MODE_GROUPS, interface.group), MODE_GROUP)
    return tag(
        "MODE-SWITCH-INTERFACE",
        *_service(interface.service),
        tag("MODE-GROUP", group, name=interface.prototype),
        name=interface.name,
    )
