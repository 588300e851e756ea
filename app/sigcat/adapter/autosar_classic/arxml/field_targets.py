"""For every field of an Integration JSON: its place in the ARXML."""

from sigcat.adapter.arxml.document_report import Tables, document_report, part
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.model import ApplicationInformation, ClassicDeployment, MetaInformation
from sigcat.integration.report import Entry, FieldTarget

_NAME = "SHORT-NAME"
_TEXT = "DESC"
_GENERATED = FieldTarget("none", "the components say it all; the code is generated from the functions")
_TYPES, _INTERFACES, _COMPONENTS = "types.arxml: ", "interfaces.arxml: ", "components.arxml: "
_COMPOSITION, _SYSTEM, _CONFIGURATION = "composition.arxml: ", "system.arxml: ", "configuration.arxml: "
_DOCUMENT = FieldTarget("composition.arxml: admin data of the outermost package")
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

TABLES: Tables = {
    MetaInformation: ("document", dict.fromkeys(("Authority", "Author", "Date", "Version"), _DOCUMENT)),
    ApplicationInformation: (
        "document", dict.fromkeys(("Name", "Responsible", "Description", "Functions"), _DOCUMENT),
    ),
    ClassicDeployment: part(
        "deployment", "", Package="the outermost AR-PACKAGE of each file", Release="the schema of each file",
        Tick=_CONFIGURATION + "OsCounter, OsSecondsPerTick",
    ),
    model.ClassicIntegration: ("document", {"Provenance": _DOCUMENT, "SourceFunctionList": _GENERATED}),
    model.Unit: part("unit", _TYPES + "UNIT, ", Name=_NAME, DisplayName="DISPLAY-NAME"),
    model.CompuMethod: part(
        "compu method", _TYPES, Name="COMPU-METHOD, SHORT-NAME", Category="COMPU-METHOD, CATEGORY",
        Unit="COMPU-METHOD, UNIT-REF", Factor="COMPU-RATIONAL-COEFFS", Offset="COMPU-RATIONAL-COEFFS",
    ),
    model.Symbol: part("value", _TYPES, Symbol="COMPU-SCALE", Value="COMPU-SCALE"),
    model.DataConstraint: part(
        "constraint", _TYPES, Name="DATA-CONSTR, SHORT-NAME", Min="LOWER-LIMIT", Max="UPPER-LIMIT",
    ),
    model.ImplementationType: part(
        "implementation type", _IMPLEMENTATION, "TypeRef", Name=_NAME, Category="CATEGORY",
        Base="IMPLEMENTATION-DATA-TYPE-REF, or the platform type", ElementType="SUB-ELEMENTS", Length="ARRAY-SIZE",
        CompuMethod="COMPU-METHOD-REF",
        LiteralPrefix=FieldTarget(_COMPONENTS + "INCLUDED-DATA-TYPE-SET, LITERAL-PREFIX"),
    ),
    model.ApplicationType: part(
        "application type", _APPLICATION, Name=_NAME, Category="CATEGORY",
        ImplementationType=FieldTarget(_TYPES + "DATA-TYPE-MAP"), CompuMethod="COMPU-METHOD-REF",
        DataConstraint="DATA-CONSTR-REF", Unit="UNIT-REF", ElementType="ELEMENT", Length="MAX-NUMBER-OF-ELEMENTS",
        Description=_TEXT,
    ),
    model.TypeMember: part("member", _TYPES + "element of the type, ", Name=_NAME, Type="reference", Description=_TEXT),
    model.ModeGroup: part(
        "mode group", _INTERFACES, Name="MODE-DECLARATION-GROUP, SHORT-NAME", InitialMode="INITIAL-MODE-REF",
        Type=FieldTarget(_TYPES + "MODE-REQUEST-TYPE-MAP"), OnTransitionValue="ON-TRANSITION-VALUE",
    ),
    model.ModeNumber: part("mode", _INTERFACES, Name="MODE-DECLARATION", Value="MODE-DECLARATION"),
    model.SenderReceiverInterface: part(
        "interface", _INTERFACES + "SENDER-RECEIVER-INTERFACE, ", Name=_NAME, Description=_TEXT,
    ),
    model.ParameterInterface: part("interface", _INTERFACES + "PARAMETER-INTERFACE, ", Name=_NAME),
    model.DataElement: part(
        "data element", _ELEMENT, "VssPath", "Unit", Name=_NAME, Type="TYPE-TREF", Description=_TEXT,
        Queued="SW-IMPL-POLICY",
    ),
    model.ClientServerInterface: part(
        "interface", _INTERFACES + "CLIENT-SERVER-INTERFACE, ", Name=_NAME, ServiceKind="SERVICE-KIND",
    ),
    model.Operation: part("operation", _OPERATION, Name=_NAME, PossibleErrors="POSSIBLE-ERROR-REF", Description=_TEXT),
    model.OperationArgument: part("argument", _ARGUMENT, "Unit", Name=_NAME, Type="TYPE-TREF", Direction="DIRECTION"),
    model.ApplicationError: part("application error", _INTERFACES, Name="APPLICATION-ERROR", Value="APPLICATION-ERROR"),
    model.ModeSwitchInterface: part(
        "interface", _INTERFACES, Name="MODE-SWITCH-INTERFACE, SHORT-NAME", ModeGroup="MODE-GROUP, TYPE-TREF",
        Prototype="MODE-GROUP, SHORT-NAME", ServiceKind="MODE-SWITCH-INTERFACE, SERVICE-KIND",
    ),
    model.Component: part(
        "component", _COMPONENTS + "component type, ", "Function", "Version", "AsilLevel", "Code", Name=_NAME,
        Kind=FieldTarget(_COMPONENTS + "APPLICATION-SW-COMPONENT-TYPE"), Description=_TEXT,
    ),
    model.ParameterComponent: part("component", _COMPONENTS + "PARAMETER-SW-COMPONENT-TYPE, ", Name=_NAME),
    model.Port: part(
        "port", _PORT, Name=_NAME, Direction="P-PORT-PROTOTYPE or R-PORT-PROTOTYPE", Kind="DEST of the reference",
        Interface="INTERFACE-TREF", ServiceKind=FieldTarget(_INTERFACES + "SERVICE-KIND of its interface"),
        Description=_TEXT,
    ),
    model.Element: part(
        "element", _SPEC, Name="reference", InitValue="INIT-VALUE", QueueLength="QUEUE-LENGTH",
        HandleNeverReceived="HANDLE-NEVER-RECEIVED", EnableUpdate="ENABLE-UPDATE", AliveTimeout="ALIVE-TIMEOUT",
        TransformerErrors=FieldTarget(_COMPONENTS + "PORT-API-OPTION, ERROR-HANDLING"),
    ),
    model.E2eWindows: part("windows", ""),
    model.E2eWindow: part(
        "window", _WINDOW, WindowSize="WINDOW-SIZE-INIT, -VALID or -INVALID; WINDOW-SIZE in 4.4.0",
        MinOkState="MIN-OK-STATE-INIT, -VALID or -INVALID", MaxErrorState="MAX-ERROR-STATE-INIT, -VALID or -INVALID",
    ),
    model.Use: part("use", _PORT, "Interface", "Kind", "Function", "Call", "Timeout"),
    model.Runnable: part(
        "runnable", _RUNNABLE, "Role", "Call", "Method", "AsilLevel", Name=_NAME, Symbol="SYMBOL", Description=_TEXT,
        CanBeInvokedConcurrently="CAN-BE-INVOKED-CONCURRENTLY", MinimumStartInterval="MINIMUM-START-INTERVAL",
        ExclusiveAreas="exclusive areas", Parameters="PARAMETER-ACCESSS", Section="SW-ADDR-METHOD-REF",
        StackSize=FieldTarget(_COMPONENTS + "ROUGH-ESTIMATE-STACK-USAGE of the SWC-IMPLEMENTATION"),
    ),
    model.Access: part(
        "access", _RUNNABLE, "Reason", Name="access point, SHORT-NAME", Kind="list of the access point",
        Port="access point, reference to the port", Element="access point, reference to the element",
    ),
    model.Event: part(
        "event", _EVENT, Name=_NAME, Kind="its element", Runnable="START-ON-EVENT-REF", Period="PERIOD",
        Offset="OFFSET", Port="instance reference", Element="instance reference", Source="EVENT-SOURCE-REF",
        Mode="MODE-IREF", Activation="ACTIVATION",
    ),
    model.ExclusiveArea: part("exclusive area", _COMPONENTS + "EXCLUSIVE-AREA, ", Name=_NAME, Description=_TEXT),
    model.PerInstanceMemory: part(
        "memory", _COMPONENTS + "PER-INSTANCE-MEMORY, ", "Header", Name=_NAME, Type="TYPE",
        TypeDefinition="TYPE-DEFINITION", Description=_TEXT,
    ),
    model.InternalParameter: part(
        "parameter", _COMPONENTS + "SHARED-PARAMETERS, ", "Uses", Name=_NAME, Type="TYPE-TREF", InitValue="INIT-VALUE",
    ),
    model.MemorySection: part(
        "section", _COMPONENTS, Name="MEMORY-SECTION, SHORT-NAME", Kind="SW-ADDR-METHOD, SECTION-TYPE",
        AsilLevel="SW-ADDR-METHOD, admin data", Alignment="MEMORY-SECTION, ALIGNMENT",
        StackSize="MEMORY-SECTION, admin data",
    ),
    model.NvBlock: part(
        "NV block", _NV, "Parameters", "Errors", "AsilLevel", Name=_NAME,
        PerInstanceMemory=FieldTarget(_COMPONENTS + "ROLE-BASED-DATA-ASSIGNMENT"),
        Port=FieldTarget(_COMPONENTS + "ROLE-BASED-PORT-ASSIGNMENT"), Reliability="RELIABILITY",
        RestoreAtStart="RESTORE-AT-START", StoreAtShutdown="STORE-AT-SHUTDOWN",
    ),
    model.DiagnosticEvent: part(
        "diagnostic event", _DEM, "Error", "Severity", "OccurrenceCountLimit", "AsilLevel", Name=_NAME,
        Port=FieldTarget(_COMPONENTS + "ROLE-BASED-PORT-ASSIGNMENT"), Description=_TEXT,
        Debouncing="DIAG-EVENT-DEBOUNCE-MONITOR-INTERNAL",
        IgnitionCountLimit=FieldTarget("diagnosis.arxml: DIAGNOSTIC-EVENT, threshold"),
    ),
    model.Inhibition: part(
        "inhibition", _FIM, "Condition", Name=_NAME,
        Events=FieldTarget("diagnosis.arxml: DIAGNOSTIC-INHIBIT-SOURCE-EVENT-MAPPING"),
        Mask=FieldTarget("diagnosis.arxml: DIAGNOSTIC-FUNCTION-IDENTIFIER-INHIBIT, INHIBITION-MASK"),
    ),
    model.SupervisedEntity: part("supervised entity", _WDGM, Name=_NAME),
    model.Checkpoint: part(
        "checkpoint", _POINT, "Name", "Number", "Call", "Moment", "Initial", "Final",
        Port=FieldTarget(_COMPONENTS + "ROLE-BASED-PORT-ASSIGNMENT"),
    ),
    model.AliveSupervision: part(
        "alive supervision", _WDGM + "times of alive cycles, ", "Checkpoint", "ExpectedIndications", "MinMargin",
        "MaxMargin", "ReferenceCycle", "Error",
    ),
    model.DeadlineSupervision: part("deadline supervision", _WDGM, "Start", "End", "Min", "Max", "Error"),
    model.LogicalTransition: part("transition", _WDGM, "Source", "Target"),
    model.Composition: part("composition", _COMPOSITION + "COMPOSITION-SW-COMPONENT-TYPE, ", Name=_NAME),
    model.Prototype: part("prototype", _COMPOSITION, Name="SW-COMPONENT-PROTOTYPE", Type="SW-COMPONENT-PROTOTYPE"),
    model.OuterPort: part(
        "port", _COMPOSITION + "port, ", "ExternalProvider", Name=_NAME,
        Direction=FieldTarget(_COMPOSITION + "P-PORT-PROTOTYPE or R-PORT-PROTOTYPE"), Kind="DEST of the reference",
        Interface="INTERFACE-TREF", InitValue="INIT-VALUE",
    ),
    model.PortReference: part(
        "port", _COMPOSITION, Component="connector, instance reference", Port="connector, instance reference",
    ),
    model.Assembly: part("connector", _COMPOSITION + "ASSEMBLY-SW-CONNECTOR, ", Name=_NAME),
    model.Delegation: part(
        "connector", _COMPOSITION, Name="DELEGATION-SW-CONNECTOR, SHORT-NAME", Outer="OUTER-PORT-REF",
    ),
    model.Ecu: part("ECU", _SYSTEM + "ECU-INSTANCE, ", Name=_NAME),
    model.SystemSignal: part(
        "system signal", _SYSTEM, Port="SENDER-RECEIVER-TO-SIGNAL-MAPPING", Element="SENDER-RECEIVER-TO-SIGNAL-MAPPING",
        SystemSignal="SYSTEM-SIGNAL, SHORT-NAME", Length="I-SIGNAL, LENGTH", Message="SYSTEM-SIGNAL, admin data",
        Database="SYSTEM-SIGNAL, admin data",
    ),
    model.InitBatch: part("init batch", _CONFIGURATION + "RteInitializationRunnableBatch, ", "Reason", Name=_NAME),
    model.Task: part(
        "task", _TASK, "Period", "Offset", "StackSize", "Reason", Name=_NAME, Priority="OsTaskPriority",
        Preemptable="OsTaskSchedule",
    ),
    model.TaskEvent: part(
        "event of a task or batch", _MAPPING, Component=FieldTarget(_CONFIGURATION + "RteSwComponentInstance"),
        Event="RteEventRef", Position="RtePositionInTask",
    ),
}  # fmt: skip


def field_targets(document: model.ClassicIntegration) -> tuple[Entry, ...]:
    """An entry for each field that has a value, in the order of the document."""
    return document_report(document, TABLES)
