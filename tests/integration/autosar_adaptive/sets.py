"""Functions to integrate: the shipped examples, and small ones that are written for a case."""

from functools import cache

from sigcat.function.function_file import build_function
from sigcat.function.function_json.model import FunctionJson
from sigcat.integration.autosar_adaptive import adaptive_integration as deriving
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT, DEPLOYMENT_FILE
from tests.function.shipped import FUNCTIONS, interfaces, resolved


@cache
def examples() -> tuple[FunctionJson, ...]:
    """The shipped examples."""
    return tuple(build_function(path.read_bytes(), path.name, interfaces())[0] for path in FUNCTIONS)


def derive(functions, deployment=DEFAULT_DEPLOYMENT):
    """The integration with the deployment of a file."""
    return deriving.derive([resolved(each) for each in functions], deployment, deployment.autosar_adaptive)


def deployed(**settings):
    """A deployment with these settings."""
    return DEPLOYMENT_FILE.model_validate(settings)


def example(name: str) -> FunctionJson:
    """One of them."""
    return next(function for function in examples() if function.info.function_name == name)


def signal(name, role="Consumer", **more):
    """A signal of Function JSON."""
    return {
        "Name": name, "Description": f"Meaning of {name}.", "Role": role, "AsilLevel": "QM", "Timeout": None,
        "Access": None, "Datatype": "DT_Float32", "Factor": None, "Offset": None, "Min": 0, "Max": 10,
        "Default": None, "InitValue": 0, "Units": "km/h", "RangeErrorAction": None, **more,
    }  # fmt: skip


def at(path, role="Consumer", **more):
    """A signal at a VSS path."""
    return signal(path.rpartition(".")[2], role, VssPath=path, VssDatatype="float", VssUnit="km/h", **more)


def function(name="Demo", signals=(), datatypes=(), call=None, contract=None, **more):
    """A function with one cyclic call."""
    contract = {
        "Type": None, "SignalList": list(signals) or None, "DataQList": None, "MethodList": None, "ParameterList": None,
        "ErrorList": None, "SafetyReactionList": None, **(contract or {}),
    }  # fmt: skip
    step = {
        "Name": f"{name}_Step", "Description": "Runs.", "Runtype": "Cyclic", "Cycletime": 50, "Watchdog": None,
        "Scheduling": "Preemptive", "Priority": "1", "funcContractList": [contract], **(call or {}),
    }  # fmt: skip
    document = {
        "MetaInfo": {"Authority": "Us", "SchemaAuthor": "We", "Date": "12.09.2025", "SchemaVersion": "1.0.0"},
        "FunctionInfo": {"FunctionName": name, "FunctionResponsible": "Team", "Description": f"Does {name}."},
        "ComponentList": [{"Name": name, "functionList": [step]}],
        "ModesList": None,
        "Datatypes": [
            {"typeRef": "DT_Float32", "category": "primitive", "cDef": "float"},
            {"typeRef": "DT_Bool", "category": "primitive", "cDef": "bool"},
            {"typeRef": "DT_String", "category": "primitive", "cDef": "char *"},
            *datatypes,
        ],
        **more,
    }
    return FunctionJson.model_validate(document)


def parameter(**more):
    """A parameter of a function."""
    return {
        "Name": "P", "Description": "Tunes.", "Datatype": "DT_Float32", "Asillevel": "QM", "Min": 0, "Max": 1,
        "Default": 0, "InitValue": 0, "RangeErrorAction": "Default", "Interfacetype": "Calibration",
        "Attribute": "Normal", "Units": "", **more,
    }  # fmt: skip


def scaled_array() -> FunctionJson:
    """A function whose code takes an array of the catalogue's floats as scaled integers."""
    numbers = {"typeRef": "DT_UInt16", "category": "primitive", "cDef": "uint16_t"}
    array = {
        "typeRef": "DT_UInt16Array4", "category": "userdefined", "cDef": "uint16_t[4]", "Kind": "array",
        "ElementType": "DT_UInt16", "Length": 4,
    }  # fmt: skip
    cells = signal("Cells", Datatype="DT_UInt16Array4", Factor="0.001", VssPath="Vehicle.Cells", VssDatatype="float[]")
    made: FunctionJson = function(signals=[cells], datatypes=[numbers, array])
    return made
