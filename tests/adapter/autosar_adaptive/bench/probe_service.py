"""A service with everything that a service can have, as an Integration JSON: what the tests of the bench generate and run."""

import json
from typing import Any

SERVICE_ID, INSTANCE_ID, REAR_INSTANCE_ID = 0x1234, 0x0042, 0x0043
SPEED, TRACK, IMAGE, MODE = 0x8001, 0x8002, 0x8003, 0x8004
ADD, RESET, GET_MODE = 0x0001, 0x0002, 0x0003
FAST, FIELDS = 0x0010, 0x0020

_ELEMENTS = {
    "Events": [
        {"Name": name, "DataType": datatype, "EventID": number, "EventGroup": "Fast", "DataMappingList": None}
        for name, datatype, number in (
            ("Speed", "float", SPEED),
            ("Track", "Track_T", TRACK),
            ("Image", "Image_T", IMAGE),
        )
    ],
    "Fields": [
        {"Name": "Mode", "DataType": "Mode_T", "NotifierID": MODE, "GetterID": GET_MODE, "EventGroup": "Fields"},
    ],
    "Methods": [
        {
            "Name": "Add",
            "MethodID": ADD,
            "InArguments": [{"Name": "left", "DataType": "int32"}, {"Name": "right", "DataType": "int32"}],
            "OutArguments": [{"Name": "sum", "DataType": "int32"}],
        },
        {"Name": "Reset", "MethodID": RESET},
    ],
}
_TYPES = [
    {"Name": "Mode_T", "Class": "enumeration", "StorageType": "uint8_t",
     "EnumField": [{"Symbol": "OFF", "Value": 0}, {"Symbol": "ON", "Value": 1}]},
    {"Name": "Corners_T", "Class": "array", "Type": "int16_t", "Dimension": 4},
    {"Name": "Image_T", "Class": "array", "Type": "uint8_t", "Dimension": "dynamic"},
    {"Name": "Flags_T", "Class": "array", "Type": "bool", "Dimension": "dynamic"},
    {"Name": "Track_T", "Class": "structure", "Field": [
        {"Name": "name", "Type": "string"},
        {"Name": "mode", "Type": "Mode_T"},
        {"Name": "corners", "Type": "Corners_T"},
        {"Name": "flags", "Type": "Flags_T"},
        {"Name": "distance", "Type": "double"},
    ]},
]  # fmt: skip


def integration_json(**transformation: Any) -> bytes:
    """The document; `transformation` as in a deployment file."""
    document = {
        "MetaInformation": {"Authority": "Tests", "Author": "Tests", "Date": "2026-01-01", "Version": "1.0.0"},
        "FunctionInformation": {"FunctionName": "Probe", "Responsible": "Tests", "Description": "A service of tests."},
        "ComponentList": [_component("Sender", "Provider"), _component("Receiver", "Consumer")],
        "DataTypes": _TYPES,
        "Deployment": {
            "Package": "Probe",
            "FunctionGroup": "ProbeGroup",
            "Namespace": "probe::demo",
            "Transformation": transformation,
            "ServiceDiscovery": {
                "initialDelayMin": 5, "initialDelayMax": 10, "repetitionsMax": 2, "repetitionsBaseDelay": 20,
                "offerCyclicDelay": 200, "offerTimeToLive": 1, "subscribeTimeToLive": 1,
                "responseDelayMin": 0, "responseDelayMax": 5,
            },
        },
    }  # fmt: skip
    return json.dumps(document).encode("utf-8")


def _component(name: str, role: str) -> dict[str, Any]:
    return {
        "Name": name,
        "ExecutableName": f"{name}Executable",
        "HeaderFiles": None,
        "ParameterList": None,
        "FunctionGroupModes": ["Run"],
        "FunctionList": [],
        "Processes": [
            {
                "Name": f"Rear{name}",
                "Instances": [{"Service": "ProbeService", "ServiceInstanceID": REAR_INSTANCE_ID}],
            }
        ],
        "ServiceInterfaceList": [
            {
                "Name": "ProbeService",
                "Role": role,
                "Provider": None,
                "ServiceID": SERVICE_ID,
                "ServiceInstanceID": INSTANCE_ID,
                "EventGroups": [
                    {"Name": "Fast", "EventGroupID": FAST},
                    {"Name": "Fields", "EventGroupID": FIELDS},
                ],
                "ServiceList": [_ELEMENTS],
            }
        ],
    }
