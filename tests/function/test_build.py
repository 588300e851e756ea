"""A declaration and a catalogue become Function JSON."""

import json
import re
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.errors import InputRefused
from sigcat.function.function_file import build_function, check_function
from sigcat.function.function_json.model import function_schema, to_json
from tests.function.shipped import FUNCTIONS, interfaces
from tests.published.schemas import schema
from tests.reference_tools import checked_with

CORE_ACC = {
    # name: datatype, min, max, default, start value: the figures of the published CoreAcc, in correct datatypes
    "BrkCylP": ("DT_Float64", -30, 276.9, None, 0),
    "SteerWhlAg": ("DT_Float64", -16, 16.766, None, -16),
    "EnaGACC": ("DT_Bool", 0, 1, 0, 0),
    "VehM": ("DT_Float64", None, None, 2495, 2495),
    "SpdLimUnit": ("DT_ADASMapDFSMapDataSpdUnitTyp", 0, 3, None, 0),
    "HstVehALgtFild": ("DT_Float64", -20, 20.94, None, -20),
    "AsmAcc_AccIntSts": ("DT_UInt8", 0, 15, 0, 0),
}


def built(path: Path) -> Any:
    function, _ = build_function(path.read_bytes(), str(path), interfaces())
    return json.loads(to_json(function))


def example(name: str) -> Any:
    return built(next(path for path in FUNCTIONS if path.parent.name == name))


def step(document: Any) -> Any:
    return next(call for call in document["ComponentList"][0]["functionList"] if call["Name"].endswith("_Step"))


def signals(document: Any) -> Any:
    return {signal["Name"]: signal for signal in step(document)["funcContractList"][0]["SignalList"]}


def declared(*items: str, key: str = "data") -> bytes:
    listed = "".join(f"\n          - {item}" for item in items)
    if key != "errors":
        listed += "\n        errors: [CoreAcc_AliveError_ErrorSts]"
    return (
        "function: CoreAcc\ndescription: Cruise control.\nresponsible: Cruise control team\n"
        "components:\n  - name: CoreAcc\n    runnables:\n      - CoreAcc_Init\n      - interface: CoreAcc_Step\n"
        f"        {key}:{listed}\n      - CoreAcc_Terminate\n"
    ).encode()


def signal(item: str) -> Any:
    function, _ = build_function(declared(item), "function.yaml", interfaces())
    return signals(json.loads(to_json(function)))


def findings(*items: str, key: str = "data") -> list[tuple[str, int, str]]:
    found = check_function(declared(*items, key=key), "function.yaml", interfaces())
    return [(finding.rule, finding.line, finding.pointer) for finding in found if finding.rule != "F090"]


# -- the examples -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("path", FUNCTIONS, ids=lambda path: path.parent.name)
def test_every_example_is_built_without_a_finding(path):
    assert check_function(path.read_bytes(), str(path), interfaces()) == ()


@checked_with("jsonschema", "Documents are valid under our schemas, and the schemas are valid")
@pytest.mark.parametrize("path", FUNCTIONS, ids=lambda path: path.parent.name)
def test_every_example_validates_under_our_schema(path):
    jsonschema.Draft202012Validator(function_schema()).validate(built(path))


@checked_with("published", "Documents that sigcat writes are valid under their schemas")
@pytest.mark.parametrize("path", FUNCTIONS, ids=lambda path: path.parent.name)
def test_every_example_validates_under_the_published_schema(path):
    jsonschema.Draft202012Validator(schema("function_json")).validate(built(path))


@pytest.mark.parametrize(
    ("name", "cycle", "previous"),
    [("core_acc", 50, None), ("eco_control_mpc", 500, "CoreAcc_Step"), ("wheel_speed_calculation", 10, None)],
)
def test_calls_come_from_the_scheduling_overlay(name, cycle, previous):
    document = example(name)
    function = document["FunctionInfo"]["FunctionName"]
    calls = {call["Name"]: call for call in document["ComponentList"][0]["functionList"]}
    assert list(calls) == [f"{function}_Init", f"{function}_Step", f"{function}_Terminate"]
    assert [call["Runtype"] for call in calls.values()] == ["Init", "Cyclic", "Shutdown"]
    assert calls[f"{function}_Step"]["Cycletime"] == cycle
    assert calls[f"{function}_Step"].get("PrevRunnable") == previous
    assert calls[f"{function}_Init"]["Scheduling"] == "Non-Preemptive"


@pytest.mark.parametrize("name", CORE_ACC)
def test_core_acc_has_the_figures_of_the_published_one(name):
    one = signals(example("core_acc"))[name]
    figures = tuple(one.get(key) for key in ("Datatype", "Min", "Max", "Default", "InitValue"))
    assert figures == CORE_ACC[name]
    assert one["Role"] == ("Provider" if name == "AsmAcc_AccIntSts" else "Consumer")
    assert one["AsilLevel"] == "QM"


def test_wheel_speed_calculation_has_an_interface_of_every_category():
    document = example("wheel_speed_calculation")
    contract = step(document)["funcContractList"][0]
    assert contract["ErrorList"][0]["Name"] == "WheelSpeedCalculation_RangeError_ErrorSts"
    assert [reaction["Name"] for reaction in contract["SafetyReactionList"]] == ["WhlSpdRLInvalid_SftyCondSts"]
    modes = [mode["Name"] for mode in document["ModeInterfaceList"]]
    assert modes == ["WheelSpeedCalculation_Mode_In", "WheelSpeedCalculation_Mode_Out"]
    assert len(contract["SignalList"]) == 8
    assert len(contract["ParameterList"]) == 4


def test_every_field_of_the_paper_about_errors_is_carried():
    error = step(example("wheel_speed_calculation"))["funcContractList"][0]["ErrorList"][0]
    assert error["MaturationTime"] == 50
    assert error["ResetTime"] == 1000
    assert error["ResetCondition"].startswith("Every wheel speed")
    assert error["OccurenceCountLimit"] == 3
    assert error["AsilLevel"] == "B"
    assert error["Datatype"] == "DT_WheelSpeedCalculationErrorSts"


def test_watchdog_and_allocation_are_carried():
    call = step(example("wheel_speed_calculation"))
    assert call["SupervisionType"] == ["Alive", "Deadline", "Logical"]
    alive = {"Min": 9, "Max": 11, "Ref": 10, "ErrorName": "WheelSpeedCalculation_AliveError_ErrorSts"}
    assert call["Watchdog"]["AliveSupervision"] == alive
    assert call["Watchdog"]["DeadlineSupervision"]["Max"] == 5
    assert call["Watchdog"]["LogicalError"] == "WheelSpeedCalculation_SequenceError_ErrorSts"
    assert (call["StackSize"], call["ExecOffset"], call["DebounceDelay"], call["Priority"]) == ("2048", "2", "5", "10")


def test_dependencies_on_errors_of_other_functions_are_carried():
    errors = step(example("core_acc"))["funcContractList"][0]["ErrorList"]
    proposal = next(error for error in errors if "Proposal" in error["Name"])
    assert proposal["Dependancy"] == ["EcoControlMpc_NoSolutionError_ErrorSts", "EcoControlMpc_DeadlineError_ErrorSts"]


# -- what the catalogue knows -------------------------------------------------------------------------------------


def test_datatype_unit_range_and_description_come_from_the_catalogue():
    one = signal("{path: Vehicle.Chassis.Brake.CylP, role: consumed}")["CylP"]
    node = interfaces().nodes["Vehicle.Chassis.Brake.CylP"]
    assert (one["Datatype"], one["Units"], one["Min"], one["Max"]) == ("DT_Float64", "bar", -30, 276.9)
    assert one["Description"] == node.values["description"]
    assert (one["VssPath"], one["VssDatatype"], one["Type"]) == (node.path, "double", "sensor")


def test_another_unit_is_converted_exactly():
    one = signal("{path: Vehicle.Speed, role: consumed, unit: m/s, min: 0, max: 100, asil: QM}")["Speed"]
    assert (one["Units"], one["VssUnit"]) == ("m/s", "km/h")
    assert (one["ConversionFactor"], one["ConversionOffset"]) == ("3.6", "0")


def test_the_catalogues_range_and_default_are_given_in_the_codes_unit():
    item = "{path: Vehicle.Chassis.Brake.CylP, role: consumed, unit: kPa}"
    one = signal(item)["CylP"]
    assert (one["Min"], one["Max"]) == (-3000, 27690)


def test_a_scale_is_written_as_factor_and_offset():
    item = "{path: Vehicle.Speed, role: provided, datatype: uint16, factor: 0.01, offset: -50, min: -50, max: 600}"
    one = signal(item)["Speed"]
    assert (one["Datatype"], one["Factor"], one["Offset"]) == ("DT_UInt16", "0.01", "-50")


def test_a_queued_signal_goes_to_the_queues():
    function, _ = build_function(
        declared("{path: Vehicle.Speed, role: consumed, queueLength: 8, asil: QM, access: Buffered}"),
        "f.yaml",
        interfaces(),
    )
    contract = step(json.loads(to_json(function)))["funcContractList"][0]
    assert contract["SignalList"] is None
    assert contract["DataQList"][0]["QueueLength"] == 8
    assert contract["DataQList"][0]["Units"] == "km/h"
    assert contract["DataQList"][0]["Access"] == "Buffered"


def test_allowed_texts_become_an_enumeration_numbered_by_position():
    item = "{path: Vehicle.LowVoltageSystemState, role: consumed, init: 'OFF', asil: QM}"
    function, _ = build_function(declared(item), "f.yaml", interfaces())
    datatype = next(d for d in function.datatypes if d.kind == "enumeration")
    assert datatype.c_definition == "uint8_t"
    assert [(s.symbol, s.value) for s in datatype.symbols or ()][:3] == [("UNDEFINED", 0), ("LOCK", 1), ("OFF", 2)]
    assert signals(json.loads(to_json(function)))["LowVoltageSystemState"]["InitValue"] == 2


def test_an_array_has_a_datatype_with_its_element_and_length():
    datatypes = {d["typeRef"]: d for d in example("eco_control_mpc")["Datatypes"]}
    array = datatypes["DT_Float32Array50"]
    assert (array["ElementType"], array["Length"], array["cDef"]) == ("DT_Float32", 50, "float[50]")


def test_a_parameter_without_limits_has_those_of_its_datatype():
    parameters = step(example("eco_control_mpc"))["funcContractList"][0]["ParameterList"]
    mass = next(parameter for parameter in parameters if parameter["Name"] == "VehM")
    assert mass["Default"] == 2495
    assert mass["Min"] == -mass["Max"]
    assert mass["Max"] > 3e38


def test_struct_types_are_resolved_with_their_members():
    types = b"""
Types: {type: branch, description: Types.}
Types.Point: {type: struct, description: A point.}
Types.Point.X: {type: property, datatype: double, unit: m, description: X.}
Types.Point.Next: {type: property, datatype: 'Types.Point[]', description: Points after it.}
"""
    tree = b"""
Vehicle: {type: branch, description: A vehicle.}
Vehicle.Place: {type: sensor, datatype: Types.Point, description: Where it is.}
"""
    catalogue = compose(
        [layer_from_text(tree, "tree", is_overlay=False), *interfaces().layers[2:]],
        interfaces().vocabulary,
        [layer_from_text(types, "types", is_overlay=False)],
    )
    function, _ = build_function(declared("{path: Vehicle.Place, role: consumed, asil: QM}"), "f.yaml", catalogue)
    structs = {d.reference: d for d in function.datatypes if d.kind == "struct"}
    assert [(f.name, f.datatype, f.units) for f in structs["DT_Point"].fields or ()] == [
        ("X", "DT_Float64", "m"),
        ("Next", "DT_PointArray", None),
    ]


def test_methods_carry_their_arguments():
    item = "{name: SetSpeed, description: Sets it., role: provided, inputs: [{name: v, datatype: float, unit: km/h}]}"
    function, _ = build_function(declared(item, key="methods"), "f.yaml", interfaces())
    method = step(json.loads(to_json(function)))["funcContractList"][0]["MethodList"][0]
    assert method["InDataTypeList"] == [{"Name": "v", "Datatype": "DT_Float32", "Units": "km/h"}]
    assert method["OutDataTypeList"] == []


def test_whole_numbers_stay_whole_however_large():
    tree = b"Vehicle: {type: branch, description: A.}\nVehicle.N: {type: sensor, datatype: uint64, max: 18446744073709551615, description: N.}\n"
    catalogue = compose([layer_from_text(tree, "tree", is_overlay=False), *interfaces().layers[2:]])
    function, _ = build_function(declared("{path: Vehicle.N, role: consumed, asil: QM}"), "f.yaml", catalogue)
    assert b'"Max": 18446744073709551615' in to_json(function)


# -- findings -----------------------------------------------------------------------------------------------------


def test_every_problem_is_told_at_once_with_line_and_pointer():
    found = findings(
        "{path: Vehicle.Sped, role: consumed}",
        "{path: Vehicle.Speed, role: consumed, unit: kg}",
        "{path: Vehicle.Chassis.Brake.CylP, role: consumed, max: 300, init: 400}",
        "{path: Vehicle.IsMoving, role: consumed, timeout: 10, timeoutError: CoreAcc_Nothing_ErrorSts}",
    )
    at = "/components/0/runnables/1/data"
    assert found == [
        ("F010", 10, f"{at}/0/path"),
        ("F021", 11, f"{at}/1/unit"),
        ("F022", 12, f"{at}/2/max"),
        ("F024", 12, f"{at}/2/init"),
        ("F040", 13, f"{at}/3/timeout"),
        ("F013", 13, f"{at}/3/timeoutError"),
    ]


def test_an_unknown_path_is_answered_with_the_nearest_ones():
    with pytest.raises(InputRefused) as refused:
        build_function(declared("{path: Vehicle.Sped, role: consumed}"), "function.yaml", interfaces())
    assert str(refused.value) == "function.yaml cannot be built: 1 error."
    assert "Did you mean 'Vehicle.Speed'" in refused.value.findings[0].fix


def test_a_path_without_its_instances_is_answered_with_one_that_has_them():
    found = check_function(declared("{path: Vehicle.Chassis.Axle.Wheel.Speed, role: consumed}"), "f.yaml", interfaces())
    assert found[0].fix == "Name one, such as 'Vehicle.Chassis.Axle.Row1.Wheel.Left.Speed'."


def test_a_finding_about_a_value_from_the_catalogue_points_at_the_item():
    assert findings("CoreAcc_ProposalTimeout_ErrorSts", key="errors") == [
        ("F056", 8, "/components/0/runnables/1"),
    ]


@pytest.mark.parametrize(
    ("item", "rule"),
    [
        ("{path: Vehicle.Speed, role: provided, datatype: uint8, factor: 1}", None),
        ("{path: Vehicle.Speed, role: consumed, datatype: uint8, factor: 1}", "F020"),
        ("{path: Vehicle.Speed, role: consumed, datatype: double}", None),
        ("{path: Vehicle.CurrentLocation.Altitude, role: consumed, datatype: float}", "F020"),
        ("{path: Vehicle.CurrentLocation.Altitude, role: consumed, datatype: float, min: -500, max: 9000}", None),
        ("{path: Vehicle.TraveledDistance, role: consumed, datatype: uint16}", "F020"),
        ("{path: Vehicle.TraveledDistance, role: consumed, datatype: uint16, factor: 100000}", None),
        ("{path: Vehicle.ADAS.PowerOptimizeLevel, role: provided, datatype: int16}", None),
        ("{path: Vehicle.TraveledDistance, role: provided, datatype: int32}", "F020"),
        ("{path: Vehicle.IsMoving, role: consumed, datatype: uint8}", None),
        ("{path: Vehicle.ADAS.EcoControl.Status, role: consumed, datatype: int8}", None),
        ("{path: Vehicle.Speed, role: consumed, factor: 0}", "F020"),
    ],
)
def test_a_datatype_that_would_lose_range_is_refused(item, rule):
    rules = [found[0] for found in findings(item)]
    assert rules == ([rule] if rule else [])


@pytest.mark.parametrize("unit", ["furlong", "kg", "kmh"])
def test_nothing_is_compared_in_a_unit_that_is_unfit_itself(unit):
    item = f"{{path: Vehicle.Speed, role: consumed, datatype: uint8, unit: {unit}, max: 1000, init: 999}}"
    assert [found[0] for found in findings(item)] == ["F021"]


# -- the same bytes -----------------------------------------------------------------------------------------------


def test_the_same_input_gives_the_same_bytes_wherever_it_stands():
    data = FUNCTIONS[0].read_bytes()
    first, _ = build_function(data, "/one/place/function.yaml", interfaces())
    second, _ = build_function(data, "elsewhere/function.yaml", interfaces())
    assert to_json(first) == to_json(second)


def test_the_document_remembers_what_it_was_made_from():
    made = example("core_acc")["Provenance"]
    assert made["Catalogue"] == "interfaces"
    assert made["CatalogueDigest"] == interfaces().digest
    assert made["Release"] == "6.0.0"
    assert [layer["Name"] for layer in made["Layers"]][:2] == ["VehicleSignalSpecification.vspec", "ecocontrol.vspec"]
    assert [layer["Digest"] for layer in made["Layers"]] == [layer.digest for layer in interfaces().layers]
    assert re.fullmatch("[0-9a-f]{64}", made["DeclarationDigest"])


def test_the_document_holds_no_date_that_the_author_did_not_write():
    function, _ = build_function(declared("{path: Vehicle.Speed, role: consumed}"), "f.yaml", interfaces())
    assert "Date" not in json.loads(to_json(function))["MetaInfo"]


@pytest.mark.parametrize(
    ("item", "expected"),
    [
        (
            "{path: Vehicle.VehicleIdentification.Year, role: consumed, init: 1.5}",
            ("F024", "init", "`init` of 'Year' must be a whole number from 0 to 65535, not 1.5."),
        ),
        (
            "{path: Vehicle.VehicleIdentification.Year, role: consumed, init: -1}",
            ("F024", "init", "`init` of 'Year' must be a whole number from 0 to 65535, not -1."),
        ),
        (
            "{path: Vehicle.Speed, role: consumed, init: true}",
            ("F024", "init", "`init` of 'Vehicle.Speed' must be a number, not true."),
        ),
        (
            "{path: Vehicle.Speed, role: consumed, min: 80, max: 70, init: 0}",
            ("F023", "min", "`min` of 'Speed' must be at most `max` (70), not 80. Exchange `min` and `max`."),
        ),
        (
            "{path: Vehicle.Speed, role: consumed, min: 80, max: 70, init: 0, timeout: 200, timeoutValue: Init}",
            ("F023", "min", "`min` of 'Speed' must be at most `max` (70), not 80. Exchange `min` and `max`."),
        ),
        (
            "{path: Vehicle.Speed, role: consumed, unit: km/hour}",
            ("F021", "unit", "Unknown unit 'km/hour'. Use 'km/h' or one that it converts to: m/s."),
        ),
        (
            "{path: Vehicle.Function.CoreAcc.Error.AliveError, role: consumed}",
            (
                "F011",
                "path",
                (
                    "'Vehicle.Function.CoreAcc.Error.AliveError' must be a data interface, not an error interface. "
                    "List it under `errors`, `safetyReactions` or `modes`."
                ),
            ),
        ),
        (
            "{path: Vehicle.Speed, role: consumed, timeout: 100, timeoutError: ProposalTimeout}",
            (
                "F041",
                "timeoutError",
                (
                    "The timeout error of 'Speed' must be one that the function declares, not 'CoreAcc_ProposalTimeout_ErrorSts'. "
                    "Add it to the errors of the call."
                ),
            ),
        ),
    ],
)
def test_one_mistake_is_one_finding_that_says_what_to_do(item, expected):
    found = [f for f in check_function(declared(item), "f.yaml", interfaces()) if f.rule != "F090"]
    told = [(f.rule, f.pointer.rpartition("/")[2], f"{f.message} {f.fix}".strip()) for f in found]
    assert told == [expected]


def test_a_boolean_may_start_as_true():
    assert signal("{path: Vehicle.IsMoving, role: consumed, asil: QM, init: true}")["IsMoving"]["InitValue"] == 1
