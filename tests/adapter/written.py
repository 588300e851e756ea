"""Function JSON of small functions, written in a line or two."""

import json
from typing import Any

from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import parts

FLOAT, DOUBLE, BOOL = "DT_Float32", "DT_Float64", "DT_Bool"
U8, S8, U16, S16, U32, S32, U64, S64 = (f"DT_{sign}Int{bits}" for bits in (8, 16, 32, 64) for sign in "US")
PRIMITIVES = {
    FLOAT: "float", DOUBLE: "double", BOOL: "bool", U8: "uint8_t", S8: "int8_t", U16: "uint16_t", S16: "int16_t",
    U32: "uint32_t", S32: "int32_t", U64: "uint64_t", S64: "int64_t",
}  # fmt: skip
ERROR, REACTION = "DT_ErrorSts", "DT_SftyCondSts"

Json = dict[str, Any]


def signal(name: str, datatype: str = FLOAT, role: str = "Consumer", **fields: Any) -> Json:
    """A signal; its variable is `name` in lower case. It has no catalogue, unless `VssDatatype` is given."""
    known = {"Name": name, "Description": f"{name}.", "Role": role, "Datatype": datatype, "Variable": name.lower()}
    return {**known, **fields}


def absent(item: Json) -> Json:
    """An optional signal or queue that the vehicle does not have."""
    return {**item, "Optional": True, "IsAbsent": True}


def output(name: str, datatype: str = FLOAT, **fields: Any) -> Json:
    """A signal that is provided."""
    return signal(name, datatype, "Provider", **fields)


def queue(name: str, length: int, datatype: str = U8, role: str = "Consumer", **fields: Any) -> Json:
    """A queue."""
    known = {"AsilInfo": "QM", "QueueLength": length, "Factor": 1, "Offset": 0, "InitValue": 0, "Units": ""}
    return {**signal(name, datatype, role), **known, **fields}


def parameter(name: str, datatype: str = FLOAT, low: float = 0, high: float = 100, **fields: Any) -> Json:
    """A parameter."""
    return {
        "Name": name, "Description": f"{name}.", "Datatype": datatype, "Asillevel": "QM", "Min": low, "Max": high,
        "Default": 0, "InitValue": 0, "RangeErrorAction": "Default", "Interfacetype": "Calibration",
        "Attribute": "Normal", "Units": "", "Variable": name.lower(), **fields,
    }  # fmt: skip


def error(name: str, *dependencies: str, **fields: Any) -> Json:
    """An error."""
    return {
        "Name": name, "Description": f"{name}.", "Datatype": ERROR, "Dependancy": list(dependencies),
        "OccurenceCountLimit": 0, "IgnitionCountLimit": 0, "MaturationTime": 0, "Severity": "", **fields,
    }  # fmt: skip


def reaction(name: str, *errors: str, **fields: Any) -> Json:
    """A safety reaction."""
    known = {"Name": name, "Description": f"{name}.", "Datatype": REACTION, "ErrorList": list(errors)}
    return {**known, "Variable": name.lower(), **fields}


def method(name: str, role: str, inputs: Json | None = None, outputs: Json | None = None, **fields: Any) -> Json:
    """A method, whose arguments are given with their datatypes."""
    return {
        "Name": name, "Description": f"{name}.", "Role": role, "InDataTypeList": _arguments(inputs or {}),
        "OutDataTypeList": _arguments(outputs or {}), **fields,
    }  # fmt: skip


def _arguments(items: Json) -> list[Json]:
    return [
        {"Name": name, "Datatype": datatype, "Units": "", "Variable": name.lower()} for name, datatype in items.items()
    ]


def mode_interface(direction: str, *modes: str, **fields: Any) -> Json:
    """The mode that is received or reported; its datatype numbers the modes from 10."""
    name = f"F_Mode_{direction}"
    known = {"Name": name, "Description": f"{name}.", "Direction": direction, "Datatype": f"DT_Mode{direction}"}
    return {**known, "Modes": list(modes), "Variable": f"mode_{direction.lower()}", **fields}


def call(name: str, run_type: str, *contents: Json, **fields: Any) -> Json:
    """A call `F_<name>`, with what it reads, writes and lists."""
    return {
        "Name": f"F_{name}", "Description": f"{name}.", "Runtype": run_type, "Watchdog": None, "Scheduling": "Preemptive",
        "Priority": "0", "funcContractList": [_contract(contents)], **fields,
    }  # fmt: skip


def step(*contents: Json, name: str = "Step", cycle: int = 10, **fields: Any) -> Json:
    """A cyclic call."""
    return call(name, "Cyclic", *contents, **{"Cycletime": cycle, **fields})


def on_event(*contents: Json, name: str = "Step", **fields: Any) -> Json:
    """An event-triggered call."""
    return call(name, "EventTriggered", *contents, **fields)


def watchdog(
    alive: tuple[float, float, float, str] | None = None,
    deadline: tuple[float, float, str] | None = None,
    logical_error: str | None = None,
) -> Json:
    """Supervision: limits and error."""
    found: Json = {"AliveSupervision": None, "DeadlineSupervision": None, "LogicalSupervision": None}
    if alive:
        found["AliveSupervision"] = dict(zip(("Min", "Max", "Ref", "ErrorName"), alive, strict=True))
    if deadline:
        low, high, name = deadline
        found["DeadlineSupervision"] = {"Min": low, "Max": high, "Ref": 0, "ErrorName": name}
    return {**found, "LogicalError": logical_error} if logical_error else found


_LISTS = (
    ("DataQList", "QueueLength"), ("MethodList", "InDataTypeList"), ("ParameterList", "Interfacetype"),
    ("ErrorList", "Severity"), ("SafetyReactionList", "ErrorList"), ("SignalList", "Role"),
)  # fmt: skip


def _contract(contents: tuple[Json, ...]) -> Json:
    contract: Json = {key: [] for key, _ in _LISTS}
    for item in contents:
        key = next(key for key, field in _LISTS if field in item)
        is_absent = item.get("IsAbsent", False)
        listed = {name: value for name, value in item.items() if name != "IsAbsent"}
        contract.setdefault(f"Absent{key}" if is_absent else key, []).append(listed)
    return contract


def enumeration(reference: str, c: str = "uint8_t", /, **numbers: int) -> Json:
    """An enumeration."""
    return {
        "typeRef": reference, "category": "userdefined", "cDef": c, "Kind": "enumeration",
        "Symbols": symbols(**numbers),
    }  # fmt: skip


def symbols(**numbers: int) -> list[Json]:
    """Names and numbers."""
    return [{"Symbol": name, "Value": number} for name, number in numbers.items()]


def array(reference: str, element: str, length: int) -> Json:
    """An array."""
    return {
        "typeRef": reference, "category": "userdefined", "cDef": "", "Kind": "array", "ElementType": element,
        "Length": length,
    }  # fmt: skip


def structure(reference: str, **members: Any) -> Json:
    """A struct; a member is a datatype, or a datatype with its limits."""
    fields = []
    for name, given in members.items():
        datatype, *limits = given if isinstance(given, tuple) else (given,)
        ends = {key: end for key, end in zip(("Min", "Max"), limits, strict=False) if end is not None}
        fields.append({"Name": name, "Datatype": datatype, **ends})
    return {
        "typeRef": reference, "category": "userdefined", "cDef": f"struct {reference}", "Kind": "struct",
        "Fields": fields,
    }  # fmt: skip


def function(
    *calls: Json, datatypes: tuple[Json, ...] = (), active: dict[str, list[str]] | None = None, modes: tuple[Json, ...] = (),
    **fields: Any,
) -> FunctionJson:  # fmt: skip
    """A function `F`. `active` has the calls of each mode, by their last names."""
    primitives = [{"typeRef": name, "category": "primitive", "cDef": c} for name, c in PRIMITIVES.items()]
    usual = [
        enumeration(ERROR, PASSED=0, FAILED=1),
        enumeration(REACTION, INACTIVE=0, ACTIVE=1),
        *(enumeration(each["Datatype"], "uint8_t", **_numbered(each["Modes"])) for each in modes),
    ]
    known = {each["typeRef"] for each in datatypes}
    document = {
        "MetaInfo": {},
        "FunctionInfo": {"FunctionName": "F", "FunctionResponsible": "Tests", "Description": "F."},
        "ComponentList": [{"Name": "F", "functionList": list(calls)}],
        "ModesList": _modes(active),
        "Datatypes": [*primitives, *(each for each in usual if each["typeRef"] not in known), *datatypes],
        "ModeInterfaceList": list(modes),
        **fields,
    }
    made = FunctionJson.model_validate_json(json.dumps(document))
    unknown = [(*at, key) for at, part in parts(made) for key in part.model_extra or ()]
    assert not unknown, f"Function JSON does not have {unknown}"
    return made


def _numbered(modes: list[str]) -> dict[str, int]:
    return {name: number for number, name in enumerate(modes, 10)}


def _modes(active: dict[str, list[str]] | None) -> list[Json] | None:
    if active is None:
        return None
    return [
        {"Name": name, "Description": f"{name}.", "RunnablesList": [f"F_{call}" for call in calls]}
        for name, calls in active.items()
    ]
