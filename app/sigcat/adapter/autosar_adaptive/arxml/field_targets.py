"""For every field of an Integration JSON: its place in the ARXML."""

from sigcat.adapter.arxml.document_report import Tables, document_report, part
from sigcat.integration.autosar_adaptive import model
from sigcat.integration.autosar_adaptive.e2e import E2eProtection
from sigcat.integration.report import Entry, FieldTarget

_SHORT_NAME = "SHORT-NAME"
_DESCRIPTION = "DESC"
_PORT = FieldTarget("components.arxml: admin data of the port")
_CALL = FieldTarget("components.arxml: admin data of the component", "the manifests have no element for calls")
_PARAMETER = FieldTarget("components.arxml: admin data of the PERSISTENCY-DATA-ELEMENT")
_TRACED = FieldTarget("components.arxml: admin data of the outermost package")
_GENERATED = FieldTarget("none", "the components say it all; adapters are generated from the functions")
_HEADERS = FieldTarget("none", "a vendor's generator lays out its headers, and adapters include them where they are")
_VALUE = "components.arxml: PERSISTENCY-DATA-ELEMENT, "
_COMPONENT = "components.arxml: ADAPTIVE-APPLICATION-SW-COMPONENT-TYPE, "
_INTERFACE = "interfaces.arxml: SERVICE-INTERFACE, "
_EVENT = "interfaces.arxml: VARIABLE-DATA-PROTOTYPE, "
_FIELD = "interfaces.arxml: FIELD, "
_METHOD = "interfaces.arxml: CLIENT-SERVER-OPERATION, "
_ARGUMENT = "interfaces.arxml: ARGUMENT-DATA-PROTOTYPE, "
_SOMEIP = "deployment.arxml: SOMEIP-"
_TYPE = "types.arxml: STD-CPP-IMPLEMENTATION-DATA-TYPE, "
_EVENT_GROUP = FieldTarget(_SOMEIP + "EVENT-GROUP")
_MEMBER = FieldTarget("types.arxml: admin data of the CPP-IMPLEMENTATION-DATA-TYPE-ELEMENT")
_PRESENTED = "SW-DATA-DEF-PROPS: "

TABLES: Tables = {
    model.MetaInformation: ("document", dict.fromkeys(("Authority", "Author", "Date", "Version"), _TRACED)),
    model.FunctionInformation: (
        "document", dict.fromkeys(("FunctionName", "Responsible", "Description", "Functions"), _TRACED),
    ),
    model.IntegrationModel: part("document", "", Provenance=_TRACED, SourceFunctionList=_GENERATED),
    model.ArxmlDeployment: part(
        "deployment", "", Package="the outermost AR-PACKAGE of each file",
        FunctionGroup="deployment.arxml: the function group", Release="the schema of each file",
        Namespace=_INTERFACE + "NAMESPACES", TypeNamespace=_TYPE + "NAMESPACES",
        Transformation="deployment.arxml: transformation properties",
        ServiceDiscovery="deployment.arxml: timing of service discovery", Units="types.arxml: UNIT",
        HeaderFolders=_HEADERS,
    ),
    model.Component: part(
        "component", _COMPONENT, "HeaderFiles", "Function", "Version", "Code", Name=_SHORT_NAME,
        ExecutableName=FieldTarget("components.arxml: EXECUTABLE, SHORT-NAME"),
        FunctionGroupModes=FieldTarget("deployment.arxml: states of the process"), Description=_DESCRIPTION,
        Startup=FieldTarget("deployment.arxml: STARTUP-CONFIG"),
    ),
    model.FurtherProcess: part("process", "", Name="deployment.arxml: PROCESS"),
    model.ProcessInstance: part("process", _SOMEIP, Service="SERVICE-INSTANCE", ServiceInstanceID="SERVICE-INSTANCE"),
    model.Call: ("call", dict.fromkeys((
        "Name", "Modes", "RunType", "CycleTime", "Scheduling", "Function", "Description", "Trigger", "EventList",
        "Triggers", "FunctionModes", "PrevRunnable", "ExecOffset", "DebounceDelay", "Priority", "ParallelProcessing",
        "StackSize", "AsilLevel", "SupervisionType", "Watchdog", "ContractTypes", "VssPath", "Code",
    ), _CALL)),
    model.FunctionMode: part("mode", _COMPONENT, "Function", "Name", "Description", "Calls"),
    model.ParameterEntry: part("parameter", _VALUE, Name=_SHORT_NAME, Description=_DESCRIPTION, **dict.fromkeys((
        "RangeErrorAction", "InterfaceType", "Attribute", "Function", "Calls", "AsilLevel", "CodeDatatype",
        "Variable", "VssPath", "VssDatatype", "VssUnit", "VssSymbols", "ConversionFactor", "ConversionOffset", "Code",
    ), _PARAMETER)),
    model.ParameterType: ("parameter", {
        **dict.fromkeys(("Datatype", "DataType", "Name", "Class", "Field", "TypeRef"), _VALUE + "TYPE-TREF"),
        **dict.fromkeys(("MinValue", "MaxValue"), "types.arxml: DATA-CONSTR"), "Unit": "types.arxml: UNIT",
        **dict.fromkeys(("Default", "InitValue", "Offset", "Scaling"), _PARAMETER),
    }),
    model.ServiceInterface: part(
        "service", _INTERFACE, "Origin", Name=_SHORT_NAME,
        Role=FieldTarget("components.arxml: P-PORT-PROTOTYPE or R-PORT-PROTOTYPE"),
        ServiceID=FieldTarget(_SOMEIP + "SERVICE-INTERFACE-DEPLOYMENT"),
        ServiceInstanceID=FieldTarget(_SOMEIP + "SERVICE-INSTANCE"), Namespace="NAMESPACES",
        **dict.fromkeys(("MajorVersion", "MinorVersion"), f", {_SOMEIP}SERVICE-INTERFACE-VERSION"),
        Transformation=FieldTarget("deployment.arxml: transformation properties"),
        Transport=FieldTarget("deployment.arxml: transport protocols, event groups and multicast"),
    ),
    model.Services: part("service", ""),
    model.Provider: part(
        "provider", _SOMEIP, Name=_PORT, ServiceDeploymentType="SERVICE-INTERFACE-DEPLOYMENT",
        ServiceInstanceID="SERVICE-INSTANCE", ContractName=_PORT,
    ),
    model.EventGroup: part("event group", _SOMEIP, Name="EVENT-GROUP", EventGroupID="EVENT-GROUP"),
    model.Event: part(
        "event", _EVENT, "CycleTime", "VssPath", Name=_SHORT_NAME, DataType="TYPE-TREF", Description=_DESCRIPTION,
        DataMappingList=_PORT, EventID=FieldTarget(_SOMEIP + "EVENT-DEPLOYMENT"), EventGroup=_EVENT_GROUP,
        SegmentLength=FieldTarget(_SOMEIP + "EVENT-DEPLOYMENT, MAXIMUM-SEGMENT-LENGTH"), Unit=_PRESENTED + "UNIT",
        **dict.fromkeys(("Min", "Max"), _PRESENTED + "DATA-CONSTR"),
        **dict.fromkeys(("Scaling", "Offset"), _PRESENTED + "COMPU-METHOD"),
    ),
    E2eProtection: part(
        "event", "deployment.arxml: ", DataID="END-2-END-EVENT-PROTECTION-PROPS",
        **dict.fromkeys(("Profile", "MaxDeltaCounter"), "E-2-E-PROFILE-CONFIGURATION"),
    ),
    model.Use: ("use", dict.fromkeys(
        ("Function", "Component", "Call", "CodeDatatype", "CodeSymbols", "Signal", "Queue"), _PORT,
    )),
    model.Method: part(
        "method", _METHOD, Name=_SHORT_NAME, Description=_DESCRIPTION,
        MethodID=FieldTarget(_SOMEIP + "METHOD-DEPLOYMENT"), Calls=_PORT, Uses=_PORT,
    ),
    model.MethodArgument: part(
        "argument", _ARGUMENT, Name=_SHORT_NAME, DataType="TYPE-TREF", Unit=_PRESENTED + "UNIT",
        CodeDatatype=_PORT, Argument=_PORT,
    ),
    model.ServiceField: part(
        "field", _FIELD, "VssPath", "Error", "SafetyReaction", "Mode", Name=_SHORT_NAME, Description=_DESCRIPTION,
        DataType="TYPE-TREF", NotifierID=FieldTarget(_SOMEIP + "EVENT-DEPLOYMENT"), EventGroup=_EVENT_GROUP,
        GetterID=FieldTarget(_SOMEIP + "METHOD-DEPLOYMENT"), Calls=_PORT,
    ),
    model.TypeEntry: part(
        "datatype", _TYPE, "TypeRef", "VssDatatype", Name=_SHORT_NAME, Class="CATEGORY", cDef="TYPE-REFERENCE",
        StorageType="TYPE-REFERENCE", Type="TEMPLATE-ARGUMENTS", Dimension="ARRAY-SIZE", Description=_DESCRIPTION,
    ),
    model.StructField: part(
        "member", "types.arxml: CPP-IMPLEMENTATION-DATA-TYPE-ELEMENT, ", Name=_SHORT_NAME, Type="TYPE-REFERENCE",
        Description=_DESCRIPTION, **dict.fromkeys(("Unit", "MinValue", "MaxValue"), _MEMBER),
    ),
    model.Symbol: ("value", dict.fromkeys(("Symbol", "Value"), "types.arxml: COMPU-SCALE of the COMPU-METHOD")),
}  # fmt: skip


def field_targets(document: model.IntegrationModel) -> tuple[Entry, ...]:
    """An entry for each field that has a value, in the order of the document."""
    return document_report(document, TABLES)
