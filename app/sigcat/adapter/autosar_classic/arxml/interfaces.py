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
from sigcat.adapter.autosar_classic.arxml import paths
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.integration.autosar_classic import model

_SERVICE_KINDS = {
    "DiagnosticEventManager": "DIAGNOSTIC-EVENT-MANAGER",
    "NvRamManager": "NON-VOLATILE-RAM-MANAGER",
    "WatchdogManager": "WATCH-DOG-MANAGER",
    "FunctionInhibitionManager": "FUNCTION-INHIBITION-MANAGER",
    "EcuManager": "ECU-MANAGER",
}


def package(known: Library) -> Package:
    """The package of port interfaces."""
    document = known.model
    interfaces = [_sender_receiver(each, known) for each in document.sender_receiver_interfaces]
    interfaces += (_client_server(each, known) for each in document.client_server_interfaces)
    interfaces += (_mode_switch(each, known) for each in document.mode_switch_interfaces)
    interfaces += (_parameters(each, known) for each in document.parameter_interfaces)
    return Package(paths.INTERFACES, tuple(interfaces))


def _service(kind: str | None) -> dict[str, str | bool | None]:
    """IS-SERVICE and the module of the base software that offers it, if one does."""
    return {"IS-SERVICE": bool(kind), "SERVICE-KIND": _SERVICE_KINDS.get(kind, "VENDOR-SPECIFIC") if kind else None}


def _sender_receiver(interface: model.SenderReceiverInterface, known: Library) -> Tag:
    text = description(interface.description)
    elements = listed("DATA-ELEMENTS", (_element(paths.VARIABLE, each, known) for each in interface.elements))
    return tag("SENDER-RECEIVER-INTERFACE", text, _service(None), elements, name=interface.name)


def _element(kind: str, element: model.DataElement, known: Library) -> Tag:
    access = tag("SW-CALIBRATION-ACCESS", text="READ-WRITE" if kind == paths.PARAMETER else "READ-ONLY")
    policy = tag("SW-IMPL-POLICY", text="QUEUED" if element.queued else "STANDARD")
    return tag(
        kind,
        description(element.description),
        trace([("VssPath", element.vss_path), ("Unit", element.unit)]),
        definition_properties(access, policy),
        known.type_reference("TYPE-TREF", element.type),
        name=element.name,
    )


def _parameters(interface: model.ParameterInterface, known: Library) -> Tag:
    elements = (_element(paths.PARAMETER, each, known) for each in interface.elements)
    return tag("PARAMETER-INTERFACE", _service(None), listed("PARAMETERS", elements), name=interface.name)


def _client_server(interface: model.ClientServerInterface, known: Library) -> Tag:
    path = known.path(paths.INTERFACES, interface.name)
    errors = (tag("APPLICATION-ERROR", {"ERROR-CODE": each.value}, name=each.name) for each in interface.errors or ())
    return tag(
        "CLIENT-SERVER-INTERFACE",
        _service(interface.service),
        listed("OPERATIONS", (_operation(each, path, known) for each in interface.operations)),
        listed("POSSIBLE-ERRORS", errors),
        name=interface.name,
    )


def _operation(operation: model.Operation, interface: str, known: Library) -> Tag:
    errors = (f"{interface}/{name}" for name in operation.errors or ())
    return tag(
        paths.OPERATION,
        description(operation.description),
        listed("ARGUMENTS", (_argument(each, known) for each in operation.arguments)),
        references("POSSIBLE-ERROR-REF", errors, "APPLICATION-ERROR"),
        name=operation.name,
    )


def _argument(argument: model.OperationArgument, known: Library) -> Tag:
    return tag(
        "ARGUMENT-DATA-PROTOTYPE",
        trace([("Unit", argument.unit)]),
        reference("TYPE-TREF", known.implementation_path(argument.type), paths.IMPLEMENTATION_TYPE),
        {"DIRECTION": argument.direction, "SERVER-ARGUMENT-IMPL-POLICY": "USE-ARGUMENT-TYPE"},
        name=argument.name,
    )


def _mode_switch(interface: model.ModeSwitchInterface, known: Library) -> Tag:
    group = reference("TYPE-TREF", known.path(paths.MODE_GROUPS, interface.group), paths.MODE_GROUP)
    prototype = tag("MODE-GROUP", group, name=interface.prototype)
    return tag("MODE-SWITCH-INTERFACE", _service(interface.service), prototype, name=interface.name)
