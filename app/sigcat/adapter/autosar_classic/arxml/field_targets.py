"""For every field of an Integration JSON: its place in the ARXML."""

from sigcat.adapter.arxml.document_report import Tables, document_report
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.model import ApplicationInformation, ClassicDeployment, MetaInformation
from sigcat.integration.report import Entry, FieldTarget

_NAME = "SHORT-NAME"
_TEXT = "DESC"
_ADMIN = "admin data"
_DOCUMENT = "composition.arxml: admin data of the outermost package"
_GENERATED = FieldTarget("none", "the components say it all; the code is generated from the functions")
_TYPES, _INTERFACES, _COMPONENTS = "types.arxml: ", "interfaces.arxml: ", "components.arxml: "
_COMPOSITION, _SYSTEM, _CONFIGURATION = "composition.arxml: ", "system.arxml: ", "configuration.arxml: "
_RUNNABLE = _COMPONENTS + "RUNNABLE-ENTITY, "
_EVENT = _COMPONENTS + "event of the SWC-INTERNAL-BEHAVIOR, "
_PORT = _COMPONENTS + "port, "
_SPEC = _COMPONENTS + "COM-SPECS of the port, "
_WINDOW = _SPEC + "END-TO-END-TRANSFORMATION-COM-SPEC-PROPS, "
_ELEMENT = _INTERFACES + "VARIABLE-DATA-PROTOTYPE or PARAMETER-DATA-PROTOTYPE, "
_OPERATION = _INTERFACES + "CLIENT-SERVER-OPERATION, "
_ARGUMENT = _INTERFACES + "ARGUMENT-DATA-PROTOTYPE, "
_IMPLEMENTATION = _TYPES + "IMPLEMENTATION-DATA-TYPE, "
_APPLICATION = _TYPES + "application data type, "
_NV = _COMPONENTS + "NV-BLOCK-NEEDS, "
_DEM = _COMPONENTS + "DIAGNOSTIC-EVENT-NEEDS, "
_FIM = _COMPONENTS + "FUNCTION-INHIBITION-NEEDS, "
_WDGM = _COMPONENTS + "SUPERVISED-ENTITY-NEEDS, "
_POINT = _COMPONENTS + "SUPERVISED-ENTITY-CHECKPOINT-NEEDS, "
_TASK = _CONFIGURATION + "OsTask, "
_MAPPING = _CONFIGURATION + "RteEventToTaskMapping, "


def _same(names: tuple[str, ...], target: str) -> dict[str, FieldTarget | str]:
    return dict.fromkeys(names, target)


_DATA: Tables = {
    MetaInformation: ("document", _same(("Authority", "Author", "Date", "Version"), _DOCUMENT)),
    ApplicationInformation: ("document", _same(("Name", "Responsible", "Description", "Functions"), _DOCUMENT)),
    ClassicDeployment: ("deployment", {
        "Package": "the outermost AR-PACKAGE of each file", "Release": "the schema of each file",
        "Tick": _CONFIGURATION + "OsCounter, OsSecondsPerTick",
    }),
    model.ClassicIntegration: ("document", {"Provenance": _DOCUMENT, "SourceFunctionList": _GENERATED}),
    model.Unit: ("unit", {"Name": _TYPES + "UNIT, " + _NAME, "DisplayName": _TYPES + "UNIT, DISPLAY-NAME"}),
    model.CompuMethod: ("compu method", {
        "Name": _TYPES + "COMPU-METHOD, " + _NAME, "Category": _TYPES + "COMPU-METHOD, CATEGORY",
        "Unit": _TYPES + "COMPU-METHOD, UNIT-REF", **_same(("Factor", "Offset"), _TYPES + "COMPU-RATIONAL-COEFFS"),
    }),
    model.Symbol: ("value", _same(("Symbol", "Value"), _TYPES + "COMPU-SCALE")),
    model.DataConstraint: ("constraint", {
        "Name": _TYPES + "DATA-CONSTR, " + _NAME, "Min": _TYPES + "LOWER-LIMIT", "Max": _TYPES + "UPPER-LIMIT",
    }),
    model.ImplementationType: ("implementation type", {
        "Name": _IMPLEMENTATION + _NAME, "Category": _IMPLEMENTATION + "CATEGORY",
        "Base": _IMPLEMENTATION + "IMPLEMENTATION-DATA-TYPE-REF, or the platform type",
        "ElementType": _IMPLEMENTATION + "SUB-ELEMENTS", "Length": _IMPLEMENTATION + "ARRAY-SIZE",
        "CompuMethod": _IMPLEMENTATION + "COMPU-METHOD-REF", "TypeRef": _IMPLEMENTATION + _ADMIN,
        "LiteralPrefix": _COMPONENTS + "INCLUDED-DATA-TYPE-SET, LITERAL-PREFIX",
    }),
    model.ApplicationType: ("application type", {
        "Name": _APPLICATION + _NAME, "Category": _APPLICATION + "CATEGORY",
        "ImplementationType": _TYPES + "DATA-TYPE-MAP", "CompuMethod": _APPLICATION + "COMPU-METHOD-REF",
        "DataConstraint": _APPLICATION + "DATA-CONSTR-REF", "Unit": _APPLICATION + "UNIT-REF",
        "ElementType": _APPLICATION + "ELEMENT", "Length": _APPLICATION + "MAX-NUMBER-OF-ELEMENTS",
        "Description": _APPLICATION + _TEXT,
    }),
    model.TypeMember: ("member", {
        "Name": "types.arxml: element of the type, " + _NAME, "Type": "types.arxml: element of the type, reference",
        "Description": "types.arxml: element of the type, " + _TEXT,
    }),
    model.ModeGroup: ("mode group", {
        "Name": _INTERFACES + "MODE-DECLARATION-GROUP, " + _NAME, "InitialMode": _INTERFACES + "INITIAL-MODE-REF",
        "Type": _TYPES + "MODE-REQUEST-TYPE-MAP", "OnTransitionValue": _INTERFACES + "ON-TRANSITION-VALUE",
    }),
    model.ModeNumber: ("mode", _same(("Name", "Value"), _INTERFACES + "MODE-DECLARATION")),
}  # fmt: skip
_INTERFACE_TABLES: Tables = {
    model.SenderReceiverInterface: ("interface", {
        "Name": _INTERFACES + "SENDER-RECEIVER-INTERFACE, " + _NAME,
        "Description": _INTERFACES + "SENDER-RECEIVER-INTERFACE, " + _TEXT,
    }),
    model.ParameterInterface: ("interface", {"Name": _INTERFACES + "PARAMETER-INTERFACE, " + _NAME}),
    model.DataElement: ("data element", {
        "Name": _ELEMENT + _NAME, "Type": _ELEMENT + "TYPE-TREF", "Description": _ELEMENT + _TEXT,
        "Queued": _ELEMENT + "SW-IMPL-POLICY", "VssPath": _ELEMENT + _ADMIN, "Unit": _ELEMENT + _ADMIN,
    }),
    model.ClientServerInterface: ("interface", {
        "Name": _INTERFACES + "CLIENT-SERVER-INTERFACE, " + _NAME,
        "ServiceKind": _INTERFACES + "CLIENT-SERVER-INTERFACE, SERVICE-KIND",
    }),
    model.Operation: ("operation", {
        "Name": _OPERATION + _NAME, "PossibleErrors": _OPERATION + "POSSIBLE-ERROR-REF", "Description": _OPERATION + _TEXT,
    }),
    model.OperationArgument: ("argument", {
        "Name": _ARGUMENT + _NAME, "Type": _ARGUMENT + "TYPE-TREF", "Direction": _ARGUMENT + "DIRECTION",
        "Unit": _ARGUMENT + _ADMIN,
    }),
    model.ApplicationError: ("application error", _same(("Name", "Value"), _INTERFACES + "APPLICATION-ERROR")),
    model.ModeSwitchInterface: ("interface", {
        "Name": _INTERFACES + "MODE-SWITCH-INTERFACE, " + _NAME, "ModeGroup": _INTERFACES + "MODE-GROUP, TYPE-TREF",
        "Prototype": _INTERFACES + "MODE-GROUP, " + _NAME,
        "ServiceKind": _INTERFACES + "MODE-SWITCH-INTERFACE, SERVICE-KIND",
    }),
}  # fmt: skip
_COMPONENT_TABLES: Tables = {
    model.Component: ("component", {
        "Name": _COMPONENTS + "component type, " + _NAME, "Kind": _COMPONENTS + "APPLICATION-SW-COMPONENT-TYPE",
        "Description": _COMPONENTS + "component type, " + _TEXT,
        **_same(("Function", "Version", "AsilLevel", "Code"), _COMPONENTS + "component type, " + _ADMIN),
    }),
    model.ParameterComponent: ("component", {"Name": _COMPONENTS + "PARAMETER-SW-COMPONENT-TYPE, " + _NAME}),
    model.Port: ("port", {
        "Name": _PORT + _NAME, "Direction": _PORT + "P-PORT-PROTOTYPE or R-PORT-PROTOTYPE",
        "Kind": _PORT + "DEST of the reference", "Interface": _PORT + "INTERFACE-TREF",
        "ServiceKind": _INTERFACES + "SERVICE-KIND of its interface", "Description": _PORT + _TEXT,
    }),
    model.Element: ("element", {
        "Name": _SPEC + "reference", "InitValue": _SPEC + "INIT-VALUE", "QueueLength": _SPEC + "QUEUE-LENGTH",
        "HandleNeverReceived": _SPEC + "HANDLE-NEVER-RECEIVED", "EnableUpdate": _SPEC + "ENABLE-UPDATE",
        "AliveTimeout": _SPEC + "ALIVE-TIMEOUT", "TransformerErrors": _COMPONENTS + "PORT-API-OPTION, ERROR-HANDLING",
    }),
    model.E2eWindows: ("windows", {}),
    model.E2eWindow: ("window", {
        "WindowSize": _WINDOW + "WINDOW-SIZE-INIT, -VALID or -INVALID; WINDOW-SIZE in 4.4.0",
        "MinOkState": _WINDOW + "MIN-OK-STATE-INIT, -VALID or -INVALID",
        "MaxErrorState": _WINDOW + "MAX-ERROR-STATE-INIT, -VALID or -INVALID",
    }),
    model.Use: ("use", _same(("Interface", "Kind", "Function", "Call", "Timeout"), _PORT + _ADMIN)),
    model.Runnable: ("runnable", {
        "Name": _RUNNABLE + _NAME, "Symbol": _RUNNABLE + "SYMBOL", "Description": _RUNNABLE + _TEXT,
        **_same(("Role", "Call", "Method", "AsilLevel"), _RUNNABLE + _ADMIN),
        "CanBeInvokedConcurrently": _RUNNABLE + "CAN-BE-INVOKED-CONCURRENTLY",
        "MinimumStartInterval": _RUNNABLE + "MINIMUM-START-INTERVAL", "ExclusiveAreas": _RUNNABLE + "exclusive areas",
        "Parameters": _RUNNABLE + "PARAMETER-ACCESSS", "Section": _RUNNABLE + "SW-ADDR-METHOD-REF",
        "StackSize": _COMPONENTS + "ROUGH-ESTIMATE-STACK-USAGE of the SWC-IMPLEMENTATION",
    }),
    model.Access: ("access", {
        "Name": _RUNNABLE + "access point, " + _NAME, "Kind": _RUNNABLE + "list of the access point",
        "Port": _RUNNABLE + "access point, reference to the port",
        "Element": _RUNNABLE + "access point, reference to the element", "Reason": _RUNNABLE + _ADMIN,
    }),
    model.Event: ("event", {
        "Name": _EVENT + _NAME, "Kind": _EVENT + "its element", "Runnable": _EVENT + "START-ON-EVENT-REF",
        "Period": _EVENT + "PERIOD", "Offset": _EVENT + "OFFSET", "Port": _EVENT + "instance reference",
        "Element": _EVENT + "instance reference", "Source": _EVENT + "EVENT-SOURCE-REF", "Mode": _EVENT + "MODE-IREF",
        "Activation": _EVENT + "ACTIVATION",
    }),
    model.ExclusiveArea: ("exclusive area", {
        "Name": _COMPONENTS + "EXCLUSIVE-AREA, " + _NAME, "Description": _COMPONENTS + "EXCLUSIVE-AREA, " + _TEXT,
    }),
    model.PerInstanceMemory: ("memory", {
        "Name": _COMPONENTS + "PER-INSTANCE-MEMORY, " + _NAME, "Type": _COMPONENTS + "PER-INSTANCE-MEMORY, TYPE",
        "TypeDefinition": _COMPONENTS + "PER-INSTANCE-MEMORY, TYPE-DEFINITION",
        "Header": _COMPONENTS + "PER-INSTANCE-MEMORY, " + _ADMIN,
        "Description": _COMPONENTS + "PER-INSTANCE-MEMORY, " + _TEXT,
    }),
    model.InternalParameter: ("parameter", {
        "Name": _COMPONENTS + "SHARED-PARAMETERS, " + _NAME, "Type": _COMPONENTS + "SHARED-PARAMETERS, TYPE-TREF",
        "InitValue": _COMPONENTS + "SHARED-PARAMETERS, INIT-VALUE", "Uses": _COMPONENTS + "SHARED-PARAMETERS, " + _ADMIN,
    }),
    model.MemorySection: ("section", {
        "Name": _COMPONENTS + "MEMORY-SECTION, " + _NAME, "Kind": _COMPONENTS + "SW-ADDR-METHOD, SECTION-TYPE",
        "AsilLevel": _COMPONENTS + "SW-ADDR-METHOD, " + _ADMIN, "Alignment": _COMPONENTS + "MEMORY-SECTION, ALIGNMENT",
        "StackSize": _COMPONENTS + "MEMORY-SECTION, " + _ADMIN,
    }),
}  # fmt: skip
_NEEDS: Tables = {
    model.NvBlock: ("NV block", {
        "Name": _NV + _NAME, "PerInstanceMemory": _COMPONENTS + "ROLE-BASED-DATA-ASSIGNMENT",
        "Port": _COMPONENTS + "ROLE-BASED-PORT-ASSIGNMENT", **_same(("Parameters", "Errors", "AsilLevel"), _NV + _ADMIN),
        "Reliability": _NV + "RELIABILITY", "RestoreAtStart": _NV + "RESTORE-AT-START",
        "StoreAtShutdown": _NV + "STORE-AT-SHUTDOWN",
    }),
    model.DiagnosticEvent: ("diagnostic event", {
        "Name": _DEM + _NAME, "Port": _COMPONENTS + "ROLE-BASED-PORT-ASSIGNMENT", "Description": _DEM + _TEXT,
        "Debouncing": _DEM + "DIAG-EVENT-DEBOUNCE-MONITOR-INTERNAL",
        **_same(("Error", "Severity", "OccurrenceCountLimit", "AsilLevel"), _DEM + _ADMIN),
        "IgnitionCountLimit": "diagnosis.arxml: DIAGNOSTIC-EVENT, threshold",
    }),
    model.Inhibition: ("inhibition", {
        "Name": _FIM + _NAME, "Condition": _FIM + _ADMIN,
        "Events": "diagnosis.arxml: DIAGNOSTIC-INHIBIT-SOURCE-EVENT-MAPPING",
        "Mask": "diagnosis.arxml: DIAGNOSTIC-FUNCTION-IDENTIFIER-INHIBIT, INHIBITION-MASK",
    }),
    model.SupervisedEntity: ("supervised entity", {"Name": _WDGM + _NAME}),
    model.Checkpoint: ("checkpoint", {
        "Port": _COMPONENTS + "ROLE-BASED-PORT-ASSIGNMENT",
        **_same(("Name", "Number", "Call", "Moment", "Initial", "Final"), _POINT + _ADMIN),
    }),
    model.AliveSupervision: ("alive supervision", _same(
        ("Checkpoint", "ExpectedIndications", "MinMargin", "MaxMargin", "ReferenceCycle", "Error"),
        _WDGM + "times of alive cycles, " + _ADMIN,
    )),
    model.DeadlineSupervision: ("deadline supervision", _same(("Start", "End", "Min", "Max", "Error"), _WDGM + _ADMIN)),
    model.LogicalTransition: ("transition", _same(("Source", "Target"), _WDGM + _ADMIN)),
}  # fmt: skip
_WHOLE: Tables = {
    model.Composition: ("composition", {"Name": _COMPOSITION + "COMPOSITION-SW-COMPONENT-TYPE, " + _NAME}),
    model.Prototype: ("prototype", _same(("Name", "Type"), _COMPOSITION + "SW-COMPONENT-PROTOTYPE")),
    model.OuterPort: ("port", {
        "Name": _COMPOSITION + "port, " + _NAME, "Direction": _COMPOSITION + "P-PORT-PROTOTYPE or R-PORT-PROTOTYPE",
        "Kind": _COMPOSITION + "port, DEST of the reference", "Interface": _COMPOSITION + "port, INTERFACE-TREF",
        "InitValue": _COMPOSITION + "port, INIT-VALUE", "ExternalProvider": _COMPOSITION + "port, " + _ADMIN,
    }),
    model.PortReference: ("port", _same(("Component", "Port"), _COMPOSITION + "connector, instance reference")),
    model.Assembly: ("connector", {"Name": _COMPOSITION + "ASSEMBLY-SW-CONNECTOR, " + _NAME}),
    model.Delegation: ("connector", {
        "Name": _COMPOSITION + "DELEGATION-SW-CONNECTOR, " + _NAME, "Outer": _COMPOSITION + "OUTER-PORT-REF",
    }),
    model.Ecu: ("ECU", {"Name": _SYSTEM + "ECU-INSTANCE, " + _NAME}),
    model.SystemSignal: ("system signal", {
        **_same(("Port", "Element"), _SYSTEM + "SENDER-RECEIVER-TO-SIGNAL-MAPPING"),
        "SystemSignal": _SYSTEM + "SYSTEM-SIGNAL, " + _NAME, "Length": _SYSTEM + "I-SIGNAL, LENGTH",
        **_same(("Message", "Database"), _SYSTEM + "SYSTEM-SIGNAL, " + _ADMIN),
    }),
    model.InitBatch: ("init batch", {
        "Name": _CONFIGURATION + "RteInitializationRunnableBatch, " + _NAME,
        "Reason": _CONFIGURATION + "RteInitializationRunnableBatch, " + _ADMIN,
    }),
    model.Task: ("task", {
        "Name": _TASK + _NAME, "Priority": _TASK + "OsTaskPriority", "Preemptable": _TASK + "OsTaskSchedule",
        **_same(("Period", "Offset", "StackSize", "Reason"), _TASK + _ADMIN),
    }),
    model.TaskEvent: ("event of a task or batch", {
        "Component": _CONFIGURATION + "RteSwComponentInstance", "Event": _MAPPING + "RteEventRef",
        "Position": _MAPPING + "RtePositionInTask",
    }),
}  # fmt: skip
TABLES: Tables = {**_DATA, **_INTERFACE_TABLES, **_COMPONENT_TABLES, **_NEEDS, **_WHOLE}


def field_targets(document: model.ClassicIntegration) -> tuple[Entry, ...]:
    """An entry for each field that has a value, in the order of the document."""
    return document_report(document, TABLES)
