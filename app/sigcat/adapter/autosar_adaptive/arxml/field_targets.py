"""For every field of an Integration JSON: its place in the ARXML."""

from sigcat.adapter.arxml.document_report import Tables, document_report
from sigcat.integration.autosar_adaptive import model
from sigcat.integration.autosar_adaptive.e2e import E2eProtection
from sigcat.integration.report import Entry, FieldTarget

_SHORT_NAME = "SHORT-NAME"
_DESCRIPTION = "DESC"
_ADMIN = "admin data"
_PORT = "components.arxml: admin data of the port"
_CALL = FieldTarget("components.arxml: admin data of the component", "the manifests have no element for calls")
_PARAMETER = FieldTarget("components.arxml: admin data of the PERSISTENCY-DATA-ELEMENT")
_TRACED = FieldTarget("components.arxml: admin data of the outermost package")
_GENERATED = FieldTarget("none", "the components say it all; adapters are generated from the functions")
_HEADERS = FieldTarget("none", "a vendor's generator lays out its headers, and adapters include them where they are")
_VALUE = "PERSISTENCY-DATA-ELEMENT"
_PRESENTED = "SW-DATA-DEF-PROPS: {}"
_COMPONENT = "components.arxml: ADAPTIVE-APPLICATION-SW-COMPONENT-TYPE, "
_INTERFACE = "interfaces.arxml: SERVICE-INTERFACE, "
_EVENT = "interfaces.arxml: VARIABLE-DATA-PROTOTYPE, "
_FIELD = "interfaces.arxml: FIELD, "
_METHOD = "interfaces.arxml: CLIENT-SERVER-OPERATION, "
_ARGUMENT = "interfaces.arxml: ARGUMENT-DATA-PROTOTYPE, "
_SOMEIP = "deployment.arxml: SOMEIP-"
_TYPE = "types.arxml: STD-CPP-IMPLEMENTATION-DATA-TYPE, "
_SETTING = "deployment.arxml"

TABLES: Tables = {
    model.MetaInformation: ("document", dict.fromkeys(("Authority", "Author", "Date", "Version"), _TRACED)),
    model.FunctionInformation: (
        "document", dict.fromkeys(("FunctionName", "Responsible", "Description", "Functions"), _TRACED),
    ),
    model.IntegrationModel: ("document", {"Provenance": _TRACED, "SourceFunctionList": _GENERATED}),
    model.ArxmlDeployment: ("deployment", {
        "Package": "the outermost AR-PACKAGE of each file", "FunctionGroup": "deployment.arxml: the function group",
        "Release": "the schema of each file", "Namespace": _INTERFACE + "NAMESPACES",
        "TypeNamespace": _TYPE + "NAMESPACES", "Transformation": _SETTING + ": transformation properties",
        "ServiceDiscovery": _SETTING + ": timing of service discovery", "Units": "types.arxml: UNIT",
        "HeaderFolders": _HEADERS,
    }),
    model.Component: ("component", {
        "Name": _COMPONENT + _SHORT_NAME, "ExecutableName": "components.arxml: EXECUTABLE, " + _SHORT_NAME,
        "HeaderFiles": _COMPONENT + _ADMIN, "FunctionGroupModes": "deployment.arxml: states of the process",
        "Function": _COMPONENT + _ADMIN, "Version": _COMPONENT + _ADMIN, "Code": _COMPONENT + _ADMIN, "Description": _COMPONENT + _DESCRIPTION,
        "Startup": "deployment.arxml: STARTUP-CONFIG",
    }),
    model.FurtherProcess: ("process", {"Name": "deployment.arxml: PROCESS"}),
    model.ProcessInstance: ("process", {
        "Service": _SOMEIP + "SERVICE-INSTANCE", "ServiceInstanceID": _SOMEIP + "SERVICE-INSTANCE",
    }),
    model.Call: ("call", dict.fromkeys((
        "Name", "Modes", "RunType", "CycleTime", "Scheduling", "Function", "Description", "Trigger", "EventList",
        "Triggers", "FunctionModes", "PrevRunnable", "ExecOffset", "DebounceDelay", "Priority", "ParallelProcessing",
        "StackSize", "AsilLevel", "SupervisionType", "Watchdog", "ContractTypes", "VssPath", "Code",
    ), _CALL)),
    model.FunctionMode: ("mode", dict.fromkeys(("Function", "Name", "Description", "Calls"), _COMPONENT + _ADMIN)),
    model.ParameterEntry: ("parameter", {
        "Name": f"components.arxml: {_VALUE}, {_SHORT_NAME}", "Description": f"components.arxml: {_VALUE}, {_DESCRIPTION}",
        **dict.fromkeys((
            "RangeErrorAction", "InterfaceType", "Attribute", "Function", "Calls", "AsilLevel", "CodeDatatype",
            "Variable", "VssPath", "VssDatatype", "VssUnit", "VssSymbols", "ConversionFactor", "ConversionOffset",
            "Code",
        ), _PARAMETER),
    }),
    model.ParameterType: ("parameter", {
        **dict.fromkeys(("Datatype", "DataType", "Name", "Class", "Field", "TypeRef"), f"components.arxml: {_VALUE}, TYPE-TREF"),
        **dict.fromkeys(("MinValue", "MaxValue"), "types.arxml: DATA-CONSTR"),
        **dict.fromkeys(("Default", "InitValue", "Offset", "Scaling"), _PARAMETER), "Unit": "types.arxml: UNIT",
    }),
    model.ServiceInterface: ("service", {
        "Name": _INTERFACE + _SHORT_NAME, "Role": "components.arxml: P-PORT-PROTOTYPE or R-PORT-PROTOTYPE",
        "ServiceID": _SOMEIP + "SERVICE-INTERFACE-DEPLOYMENT", "ServiceInstanceID": _SOMEIP + "SERVICE-INSTANCE",
        **dict.fromkeys(("MajorVersion", "MinorVersion"), f"{_INTERFACE}, {_SOMEIP}SERVICE-INTERFACE-VERSION"),
        "Namespace": _INTERFACE + "NAMESPACES", "Transformation": _SETTING + ": transformation properties",
        "Transport": _SETTING + ": transport protocols, event groups and multicast", "Origin": _INTERFACE + _ADMIN,
    }),
    model.Services: ("service", {}),
    model.Provider: ("provider", {
        "Name": _PORT, "ServiceDeploymentType": _SOMEIP + "SERVICE-INTERFACE-DEPLOYMENT",
        "ServiceInstanceID": _SOMEIP + "SERVICE-INSTANCE", "ContractName": _PORT,
    }),
    model.EventGroup: ("event group", dict.fromkeys(("Name", "EventGroupID"), _SOMEIP + "EVENT-GROUP")),
    model.Event: ("event", {
        "Name": _EVENT + _SHORT_NAME, "DataType": _EVENT + "TYPE-TREF", "DataMappingList": _PORT,
        "Description": _EVENT + _DESCRIPTION, "EventID": _SOMEIP + "EVENT-DEPLOYMENT",
        "EventGroup": _SOMEIP + "EVENT-GROUP", "SegmentLength": _SOMEIP + "EVENT-DEPLOYMENT, MAXIMUM-SEGMENT-LENGTH",
        "Unit": _EVENT + _PRESENTED.format("UNIT"),
        "Min": _EVENT + _PRESENTED.format("DATA-CONSTR"), "Max": _EVENT + _PRESENTED.format("DATA-CONSTR"),
        "Scaling": _EVENT + _PRESENTED.format("COMPU-METHOD"), "Offset": _EVENT + _PRESENTED.format("COMPU-METHOD"),
        "CycleTime": _EVENT + _ADMIN, "VssPath": _EVENT + _ADMIN,
    }),
    E2eProtection: ("event", {
        "Profile": _SETTING + ": E-2-E-PROFILE-CONFIGURATION", "MaxDeltaCounter": _SETTING + ": E-2-E-PROFILE-CONFIGURATION",
        "DataID": _SETTING + ": END-2-END-EVENT-PROTECTION-PROPS",
    }),
    model.Use: ("use", dict.fromkeys(
        ("Function", "Component", "Call", "CodeDatatype", "CodeSymbols", "Signal", "Queue"), _PORT,
    )),
    model.Method: ("method", {
        "Name": _METHOD + _SHORT_NAME, "Description": _METHOD + _DESCRIPTION,
        "MethodID": _SOMEIP + "METHOD-DEPLOYMENT", "Calls": _PORT, "Uses": _PORT,
    }),
    model.MethodArgument: ("argument", {
        "Name": _ARGUMENT + _SHORT_NAME, "DataType": _ARGUMENT + "TYPE-TREF",
        "Unit": _ARGUMENT + _PRESENTED.format("UNIT"), "CodeDatatype": _PORT, "Argument": _PORT,
    }),
    model.ServiceField: ("field", {
        "Name": _FIELD + _SHORT_NAME, "Description": _FIELD + _DESCRIPTION, "DataType": _FIELD + "TYPE-TREF",
        "NotifierID": _SOMEIP + "EVENT-DEPLOYMENT", "GetterID": _SOMEIP + "METHOD-DEPLOYMENT",
        "EventGroup": _SOMEIP + "EVENT-GROUP", "Calls": _PORT, "VssPath": _FIELD + _ADMIN,
        **dict.fromkeys(("Error", "SafetyReaction", "Mode"), _FIELD + _ADMIN),
    }),
    model.TypeEntry: ("datatype", {
        "Name": _TYPE + _SHORT_NAME, "Class": _TYPE + "CATEGORY", "cDef": _TYPE + "TYPE-REFERENCE",
        "Type": _TYPE + "TEMPLATE-ARGUMENTS", "Dimension": _TYPE + "ARRAY-SIZE", "TypeRef": _TYPE + _ADMIN,
        "StorageType": _TYPE + "TYPE-REFERENCE", "VssDatatype": _TYPE + _ADMIN, "Description": _TYPE + _DESCRIPTION,
    }),
    model.StructField: ("member", {
        "Name": "types.arxml: CPP-IMPLEMENTATION-DATA-TYPE-ELEMENT, " + _SHORT_NAME,
        "Type": "types.arxml: CPP-IMPLEMENTATION-DATA-TYPE-ELEMENT, TYPE-REFERENCE",
        "Description": "types.arxml: CPP-IMPLEMENTATION-DATA-TYPE-ELEMENT, " + _DESCRIPTION,
        **dict.fromkeys(
            ("Unit", "MinValue", "MaxValue"), "types.arxml: admin data of the CPP-IMPLEMENTATION-DATA-TYPE-ELEMENT",
        ),
    }),
    model.Symbol: ("value", dict.fromkeys(("Symbol", "Value"), "types.arxml: COMPU-SCALE of the COMPU-METHOD")),
}  # fmt: skip


def field_targets(document: model.IntegrationModel) -> tuple[Entry, ...]:
    """An entry for each field that has a value, in the order of the document."""
    return document_report(document, TABLES)
