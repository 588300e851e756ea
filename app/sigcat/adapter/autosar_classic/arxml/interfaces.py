"""Port interfaces: data, operations, modes and parameters."""

from sigcat.adapter.arxml.tree import (
    Package,
    Tag,
    definition_properties,
    description,
    listed,
    reference,
    references,
    tag,
    trace,
)
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


def package(known: Library) -> Package:
    """The package of port interfaces."""
    model = known.model
    return Package(
        INTERFACES,
        (
            *(_sender_receiver(each, known) for each in model.sender_receiver_interfaces),
            *(_client_server(each, known) for each in model.client_server_interfaces),
            *(_mode_switch(each, known) for each in model.mode_switch_interfaces),
            *(_parameters(each, known) for each in model.parameter_interfaces),
        ),
    )


def _service(kind: str | None) -> dict[str, str | bool | None]:
    """IS-SERVICE and the module of the base software that offers it, if one does."""
    return {"IS-SERVICE": bool(kind), "SERVICE-KIND": _SERVICE_KINDS.get(kind, "VENDOR-SPECIFIC") if kind else None}


def _sender_receiver(interface: SenderReceiverInterface, known: Library) -> Tag:
    text = description(interface.description)
    elements = listed("DATA-ELEMENTS", (_element(VARIABLE, each, known) for each in interface.elements))
    return tag("SENDER-RECEIVER-INTERFACE", text, _service(None), elements, name=interface.name)


def _element(kind: str, element: DataElement, known: Library) -> Tag:
    access = tag("SW-CALIBRATION-ACCESS", text="READ-WRITE" if kind == PARAMETER else "READ-ONLY")
    policy = tag("SW-IMPL-POLICY", text="QUEUED" if element.queued else "STANDARD")
    return tag(
        kind,
        description(element.description),
        trace([("VssPath", element.vss_path), ("Unit", element.unit)]),
        definition_properties(access, policy),
        known.type_reference("TYPE-TREF", element.type),
        name=element.name,
    )


def _parameters(interface: ParameterInterface, known: Library) -> Tag:
    elements = (_element(PARAMETER, each, known) for each in interface.elements)
    return tag("PARAMETER-INTERFACE", _service(None), listed("PARAMETERS", elements), name=interface.name)


def _client_server(interface: ClientServerInterface, known: Library) -> Tag:
    path = known.path(INTERFACES, interface.name)
    errors = (tag("APPLICATION-ERROR", {"ERROR-CODE": each.value}, name=each.name) for each in interface.errors or ())
    return tag(
        "CLIENT-SERVER-INTERFACE",
        _service(interface.service),
        listed("OPERATIONS", (_operation(each, path, known) for each in interface.operations)),
        listed("POSSIBLE-ERRORS", errors),
        name=interface.name,
    )


def _operation(operation: Operation, interface: str, known: Library) -> Tag:
    errors = (f"{interface}/{name}" for name in operation.errors or ())
    return tag(
        OPERATION,
        description(operation.description),
        listed("ARGUMENTS", (_argument(each, known) for each in operation.arguments)),
        references("POSSIBLE-ERROR-REF", errors, "APPLICATION-ERROR"),
        name=operation.name,
    )


def _argument(argument: OperationArgument, known: Library) -> Tag:
    return tag(
        "ARGUMENT-DATA-PROTOTYPE",
        trace([("Unit", argument.unit)]),
        reference("TYPE-TREF", known.implementation_path(argument.type), IMPLEMENTATION_TYPE),
        {"DIRECTION": argument.direction, "SERVER-ARGUMENT-IMPL-POLICY": "USE-ARGUMENT-TYPE"},
        name=argument.name,
    )


def _mode_switch(interface: ModeSwitchInterface, known: Library) -> Tag:
    group = reference("TYPE-TREF", known.path(MODE_GROUPS, interface.group), MODE_GROUP)
    prototype = tag("MODE-GROUP", group, name=interface.prototype)
    return tag("MODE-SWITCH-INTERFACE", _service(interface.service), prototype, name=interface.name)
