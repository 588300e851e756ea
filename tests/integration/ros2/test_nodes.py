"""Nodes: their parameters, schedules, errors, reactions, modes and services."""

import json

import pytest

from sigcat.platforms.deployment_file import DEPLOYMENT_FILE
from tests.integration.ros2.derived import ends, messages
from tests.integration.ros2.functions import (
    document,
    example,
    examples,
    function,
    rules,
    signal,
    topics,
)


def node(functions, index=0):
    return document(functions)["NodePackageList"][0]["Nodes"][index]


def test_transitions_make_the_calls_of_the_life_cycle():
    made = {each["Transition"]: each for each in node([example("core_acc")])["Lifecycle"]}
    assert made["configure"]["Runnables"] == ["CoreAcc_Init"]
    assert made["activate"]["Starts"] == made["deactivate"]["Stops"] == ["CoreAcc_Step"]
    for name in ("cleanup", "shutdown", "error"):
        assert made[name]["Runnables"] == ["CoreAcc_Terminate"]


def test_a_cyclic_call_has_a_timer_and_runs_in_its_modes():
    (step,) = node([example("core_acc")])["Schedules"]
    assert (step["Trigger"], step["Period"], step["ThreadPriority"]) == ("Timer", 50, 10)
    assert step["ActiveModes"] == ["STANDBY", "ACTIVE"]


@pytest.mark.parametrize(("priority", "number"), [(" +7 ", 7), ("0", None), ("1.5", None), ("high", None)])
def test_a_priority_is_a_whole_number_from_1_to_99(priority, number):
    (step,) = node([function(signal(), call={"Priority": priority})])["Schedules"]
    assert step.get("ThreadPriority") == number


def test_an_event_triggered_call_runs_on_what_it_consumes():
    call = {"Runtype": "EventTriggered", "Cycletime": None, "DebounceDelay": "5"}
    (step,) = node([function(signal(), call=call)])["Schedules"]
    assert (step["Trigger"], step["Topics"], step["Debounce"]) == ("Topics", ["vehicle/speed"], 5)
    assert ("N215", "Acc_Step") in rules([function(call=call)])
    other = signal("Mass", "Vehicle.Mass")
    for event in ("Speed", "Vehicle.Speed"):
        (step,) = node([function(signal(), other, call=call | {"EventList": event})])["Schedules"]
        assert step["Topics"] == ["vehicle/speed"]


def test_queued_data_keeps_what_signals_have():
    queue = signal() | {"AsilInfo": "QM", "QueueLength": 8, "Factor": 1, "Offset": 0, "InitValue": 0, "Units": ""}
    queue |= {"Default": 5, "Access": "Buffered"}
    end = topics([function(contract={"DataQList": [queue]})])["Subscription", "vehicle/speed"]
    field = end["DataMappingList"][0]["FieldList"][0]
    assert (field["Default"], field["Access"]) == (5, "Buffered")


def test_modes_have_topics_with_a_constant_for_each_mode():
    topic = node([example("core_acc")])["ModeTopics"][0]
    assert (topic["TopicName"], topic["Role"]) == ("core_acc/mode_in", "Subscription")
    constants = messages([example("core_acc")])["CoreAccModeIn"]["Constants"]
    assert [(each["Name"], each["Value"]) for each in constants] == [("OFF", "0"), ("STANDBY", "1"), ("ACTIVE", "2")]


def test_every_node_of_a_function_is_told_its_mode_and_the_first_one_tells_it():
    core = example("core_acc")
    second = core.components[0].model_copy(update={"name": "Arbiter", "runnables": ()})
    both = core.model_copy(update={"components": (*core.components, second)})
    nodes = document([both])["NodePackageList"][0]["Nodes"]
    assert [[topic["TopicName"] for topic in each["ModeTopics"]] for each in nodes] == [
        ["core_acc/mode_in", "core_acc/mode_out"],
        ["core_acc/mode_in"],
    ]
    assert len([name for name in messages([both]) if "Mode" in name]) == 2


def test_parameters_have_the_catalogues_unit_and_range():
    made = {each["Name"]: each for each in node([example("wheel_speed_calculation")])["Parameters"]}
    tire = made["tire_dia_frnt"]
    assert (tire["Units"], tire["VariableUnits"]) == ("inch", "mm")
    assert tire["Default"] == pytest.approx(650 / 25.4)
    assert tire["Conversion"]["Factor"] == "25.4"


def parameter(**more):
    base = {
        "Name": "Limit", "Description": "A limit.", "Datatype": "DT_Float32", "Asillevel": "QM", "Min": 0, "Max": 9,
        "Default": 1, "InitValue": 2, "RangeErrorAction": "Default", "Interfacetype": "Calibration",
        "Attribute": "Normal", "Units": "m", "Variable": "par.Limit",
    }  # fmt: skip
    return base | more


@pytest.mark.parametrize(
    ("more", "kind", "default", "bounds"),
    [
        ({}, "double", 2.0, (0, 9)),
        ({"VssDatatype": "uint16", "Max": 65535}, "integer", 2, (0, 65535)),
        ({"VssDatatype": "int64", "Min": -(2**63), "Max": 2**63 - 1}, "integer", 2, (None, None)),
        ({"VssDatatype": "boolean", "Max": 1}, "bool", True, (None, None)),
        ({"VssDatatype": "string", "DefaultText": "left", "Max": 0}, "string", "left", (None, None)),
        ({"Datatype": "DT_Float32Array3", "VssDatatype": "float[]"}, "double_array", [2.0, 2.0, 2.0], (None, None)),
        ({"Datatype": "DT_Side", "VssDatatype": "string"}, "string", "RIGHT", (None, None)),
    ],
)
def test_a_parameter_has_a_type_of_nodes(more, kind, default, bounds):
    types = [
        {"typeRef": "DT_Float32Array3", "category": "userdefined", "cDef": "float[3]", "Kind": "array",
         "ElementType": "DT_Float32", "Length": 3},
        {"typeRef": "DT_Side", "category": "userdefined", "cDef": "uint8_t", "Kind": "enumeration",
         "Symbols": [{"Symbol": "LEFT", "Value": 0}, {"Symbol": "RIGHT", "Value": 2}]},
    ]  # fmt: skip
    (made,) = node([function(contract={"ParameterList": [parameter(**more)]}, datatypes=types)])["Parameters"]
    assert (made["Type"], made["Default"], (made.get("From"), made.get("To"))) == (kind, default, bounds)


def test_elements_of_an_array_have_a_range_in_words():
    pair = {"typeRef": "DT_Pair", "category": "userdefined", "cDef": "float[2]", "Kind": "array",
            "ElementType": "DT_Float32", "Length": 2}  # fmt: skip
    listed = parameter(Datatype="DT_Pair", VssDatatype="float[]", Min=-0.5)
    (made,) = node([function(contract={"ParameterList": [listed]}, datatypes=[pair])])["Parameters"]
    assert made["AdditionalConstraints"] == "each element from -0.5 to 9"


@pytest.mark.parametrize(
    ("rule", "more"),
    [
        ("N209", {"Interfacetype": "Measurement"}),
        ("N209", {"VssDatatype": "uint64", "Max": 2**64 - 1}),
        ("N209", {"Datatype": "DT_Point", "VssDatatype": "Types.Point"}),
    ],
)
def test_a_parameter_that_nodes_do_not_have_is_told(rule, more):
    point = {"typeRef": "DT_Point", "category": "userdefined", "cDef": "struct Point", "Kind": "struct", "Fields": []}
    made = function(contract={"ParameterList": [parameter(VssPath="Vehicle.Limit", **more)]}, datatypes=[point])
    assert (rule, "Vehicle.Limit") in rules([made])


def test_a_parameter_that_is_scaled_in_the_code_is_converted_from_there():
    scaled = parameter(Datatype="DT_UInt16", VssDatatype="float", Factor="0.5", Offset="-1", ConversionFactor="2")
    word = {"typeRef": "DT_UInt16", "category": "primitive", "cDef": "uint16_t"}
    (made,) = node([function(contract={"ParameterList": [scaled]}, datatypes=[word])])["Parameters"]
    assert (made["Default"], made["From"], made["To"]) == (4.0, 0, 18)
    assert (made["Conversion"]["Factor"], made["Conversion"]["Offset"]) == ("1", "2")


def test_a_parameter_starts_with_the_elements_that_its_author_gave():
    listed = parameter(Datatype="DT_Pair", VssDatatype="float[]", DefaultText="[1, 2]", InitElements="[3, 4.5]")
    pair = {"typeRef": "DT_Pair", "category": "userdefined", "cDef": "float[2]", "Kind": "array",
            "ElementType": "DT_Float32", "Length": 2}  # fmt: skip
    (made,) = node([function(contract={"ParameterList": [listed]}, datatypes=[pair])])["Parameters"]
    assert made["Default"] == [3.0, 4.5]


def test_a_parameter_does_not_take_the_name_of_one_that_every_node_has():
    made = function(contract={"ParameterList": [parameter(Name="LockStep", VssPath="Vehicle.LockStep")]})
    assert [each["Name"] for each in node([made])["Parameters"]] == ["lock_step_2"]
    assert ("N210", "Vehicle.LockStep") in rules([made])


def test_an_error_does_not_take_the_topic_of_transitions():
    error = {
        "Name": "Acc_TransitionEvent_ErrorSts", "Description": "It is.", "Datatype": "DT_Float32", "Dependancy": [],
        "OccurenceCountLimit": 0, "IgnitionCountLimit": 0, "MaturationTime": 0, "Severity": "None.", "ResetCondition": "",
    }  # fmt: skip
    made = node([function(contract={"ErrorList": [error]})])
    assert made["ErrorTopics"][0]["TopicName"] == "acc/transition_event_2"


def test_what_a_graph_and_a_signal_say_is_not_in_words():
    error = {
        "Name": "Acc_Order_ErrorSts", "Description": "The order is broken.", "Datatype": "DT_Float32", "Dependancy": [],
        "OccurenceCountLimit": 0, "IgnitionCountLimit": 0, "MaturationTime": 0, "Severity": "None.",
        "ResetCondition": "A restart.",
    }  # fmt: skip
    watchdog = {"AliveSupervision": None, "DeadlineSupervision": None, "LogicalSupervision": "After init."}
    told, graph = {"Watchdog": watchdog}, {"Checkpoint": {"BeginsSequence": True}}
    in_words = function(call=told, contract={"ErrorList": [error]})
    assert {("N205", "Acc_Step"), ("N206", "Acc_Order_ErrorSts")} <= set(rules([in_words]))
    drawn = function(call=told | graph, contract={"ErrorList": [error | {"Reset": "Restart"}]})
    assert not {"N205", "N206"} & {rule for rule, _ in rules([drawn])}
    (step,) = document([drawn])["ComponentList"][0]["functionList"]
    assert (step["Checkpoint"], step["funcContractList"][0]["ErrorList"][0]["Reset"]) == (
        {"BeginsSequence": True},
        "Restart",
    )


def test_a_document_has_each_function_whole_as_it_was_given():
    given = [example("core_acc"), example("eco_control_mpc")]
    made = document(given)["SourceFunctionList"]
    assert made == [json.loads(each.model_dump_json(by_alias=True)) for each in given]


def test_a_set_is_two_packages_named_after_it_one_of_nodes_and_one_of_messages():
    made = document(examples(), DEPLOYMENT_FILE.model_validate({"name": "EcoControl"}))
    (interfaces,), (package,) = made["InterfacePackageList"], made["NodePackageList"]
    assert (package["Name"], interfaces["Name"]) == ("eco_control", "eco_control_interfaces")
    assert [(each["NodeName"], each["Executable"], each["Plugin"]) for each in package["Nodes"]] == [
        ("core_acc", "core_acc_node", "eco_control::CoreAccNode"),
        ("eco_control_mpc", "eco_control_mpc_node", "eco_control::EcoControlMpcNode"),
        ("wheel_speed_calculation", "wheel_speed_calculation_node", "eco_control::WheelSpeedCalculationNode"),
    ]
    assert "eco_control_interfaces" in package["Dependencies"]


def test_a_package_of_messages_with_the_name_of_the_set_keeps_it():
    made = document(examples(), DEPLOYMENT_FILE.model_validate({"name": "Acc", "ros2": {"messagePackage": "acc"}}))
    assert [made[key][0]["Name"] for key in ("InterfacePackageList", "NodePackageList")] == ["acc", "acc_2"]


def test_a_call_follows_those_of_its_node_that_it_names_but_for_init():
    last = function(call={"PrevRunnable": "Acc_Init, Acc_Read, Acc_Filter, Hmi_Step"})
    (step,) = last.components[0].runnables
    first = [
        step.model_copy(update={"name": name, "run_type": kind, "previous_runnable": None})
        for name, kind in (("Acc_Init", "Init"), ("Acc_Read", "Cyclic"), ("Acc_Filter", "Cyclic"))
    ]
    component = last.components[0].model_copy(update={"runnables": (*first, step)})
    made = last.model_copy(update={"components": (component,)})
    after = {each["RunnableName"]: each.get("After") for each in node([made])["Schedules"]}
    assert after == {"Acc_Read": None, "Acc_Filter": None, "Acc_Step": "Acc_Read, Acc_Filter"}
    assert {("N204", "Acc_Step")} == {found for found in rules([made]) if found[0] == "N204"}


def test_errors_are_diagnostics_and_depend_on_those_of_other_nodes():
    statuses = {each["Error"]: each for each in node(examples())["Diagnostics"]}
    assert statuses["CoreAcc_ProposalTimeout_ErrorSts"]["Dependencies"] == [
        "eco_control_mpc: EcoControlMpc_NoSolutionError_ErrorSts",
        "eco_control_mpc: EcoControlMpc_DeadlineError_ErrorSts",
    ]
    assert ("N216", "CoreAcc_ProposalTimeout_ErrorSts") in rules([example("core_acc")])


def test_errors_have_topics_on_which_other_nodes_hear_them():
    assert ends(node(examples()), "ErrorTopics") == [
        ("Publisher", "core_acc/brake_pressure_timeout", None),
        ("Publisher", "core_acc/steering_angle_timeout", None),
        ("Publisher", "core_acc/proposal_timeout", None),
        ("Publisher", "core_acc/alive_error", None),
        ("Subscription", "eco_control_mpc/no_solution_error", "eco_control_mpc"),
        ("Subscription", "eco_control_mpc/deadline_error", "eco_control_mpc"),
    ]
    published = [(role, topic) for role, topic, _ in ends(node(examples(), 1), "ErrorTopics")]
    assert {("Publisher", "eco_control_mpc/no_solution_error"), ("Publisher", "eco_control_mpc/deadline_error")} <= {
        *published
    }


def test_an_error_from_outside_is_heard_where_its_own_set_tells_it():
    alone, together = (ends(node(those), "ErrorTopics")[-1][:2] for those in ([example("core_acc")], examples()))
    assert alone == together


def test_what_is_told_of_errors_and_reactions_is_reliable_and_kept_for_who_starts_late():
    made = node(examples())
    told = [(each["QualityOfService"], each["MessageType"], each["Field"])
            for each in (*made["ErrorTopics"], *made["SafetyReactionTopics"])]  # fmt: skip
    assert {(quality["Reliability"], quality["Durability"], quality["Depth"]) for quality, _, _ in told} == {
        ("reliable", "transient_local", 1)
    }
    assert {(message, field) for _, message, field in told} == {
        ("vehicle_msgs/msg/ErrorStatus", "status"), ("vehicle_msgs/msg/SafetyReaction", "state"),
    }  # fmt: skip


def test_a_safety_condition_is_told_on_a_topic_of_the_node_and_heard_from_the_platform():
    made = node([example("core_acc")])
    (condition,) = made["SafetyReactions"]
    assert condition["Statuses"][0] == "core_acc: CoreAcc_BrakePressureTimeout_ErrorSts"
    assert condition["TopicName"] == "core_acc/acc_req_invalid"
    assert ends(made, "SafetyReactionTopics") == [
        ("Publisher", "core_acc/acc_req_invalid", None), ("Subscription", "safety_management/acc_req_invalid", None),
    ]  # fmt: skip


def test_an_error_and_a_reaction_of_one_name_have_two_topics():
    base = {"Description": "It is.", "Datatype": "DT_Float32"}
    error = base | {
        "Name": "Acc_Fault_ErrorSts", "Dependancy": [], "OccurenceCountLimit": 0, "IgnitionCountLimit": 0,
        "MaturationTime": 0, "Severity": "None.", "ResetCondition": "",
    }  # fmt: skip
    reaction = base | {"Name": "Fault_SftyCondSts", "ErrorList": ["Acc_Fault_ErrorSts"], "AsilLevel": "QM"}
    both = function(contract={"ErrorList": [error], "SafetyReactionList": [reaction]})
    made = node([both])
    assert ends(made, "ErrorTopics")[0][1] == "acc/fault"
    assert ends(made, "SafetyReactionTopics")[0][1] == "acc/fault_2"
    assert ("N210", "Fault_SftyCondSts") in rules([both])


def test_every_set_has_the_same_messages_for_errors_reactions_and_steps():
    package = document([function(signal("Status", "Vehicle.Error.Status"))])["InterfacePackageList"][0]
    made = {each["Name"]: each for each in package["Messages"]}
    numbers = {name: [(each["Name"], each["Value"]) for each in made[name]["Constants"]]
               for name in ("ErrorStatus", "SafetyReaction")}  # fmt: skip
    assert numbers == {
        "ErrorStatus": [("PASSED", "0"), ("FAILED", "1")],
        "SafetyReaction": [("INACTIVE", "0"), ("ACTIVE", "1")],
    }
    assert [each["Name"] for each in package["Services"]] == ["Step"]
    assert "ErrorStatus2" in made
