"""Components, ports, runnables and needs, as they follow from the declaration."""

import json

import jsonschema_rs
import pytest

from sigcat.function.document.text import Text
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.wire import document_schema, written
from sigcat.integration.autosar_classic.document import read_integration
from sigcat.integration.autosar_classic.field_targets import CALL_TARGETS, PARAMETER_TARGETS, TABLES
from sigcat.integration.autosar_classic.model import ClassicIntegration
from sigcat.integration.report import NOT_CARRIED
from sigcat.platforms.deployment_file import read_deployment
from tests.growth import LINEAR, growth
from tests.integration.autosar_adaptive.sets import at, deployed, examples, function, parameter, scaled_array, signal
from tests.integration.autosar_classic.classic import (
    accesses,
    component,
    derive,
    port,
    rules,
    runnable,
    starts,
)

CYLP = "Chassis_Brake_CylP"


@pytest.fixture(scope="module")
def whole():
    return derive(examples()).model


@pytest.fixture(scope="module")
def core_acc(whole):
    return component(whole, "CoreAcc")


# -- the document -----------------------------------------------------------------------------------------------------


def test_the_examples_are_integrated_without_a_finding_but_for_their_asil_and_priorities():
    assert rules(derive(examples())) <= {"K008", "K010"}


def test_what_is_written_is_read_again_and_fits_its_schema(whole):
    data = written(whole)
    assert written(read_integration(data, "integration.json")) == data
    jsonschema_rs.validate(document_schema(ClassicIntegration), json.loads(data))


def test_each_function_is_carried_whole(whole):
    assert whole.functions == tuple(examples())


def test_an_array_is_sent_with_the_elements_of_the_catalogue():
    types = {each.name: each for each in derive([scaled_array()]).model.implementation_types}
    assert (types["DT_Float32Array4"].element, types["DT_Float32Array4"].length) == ("float32", 4)


def test_ten_times_the_signals_take_about_ten_times_as_long():
    def deriving(count):
        one = function(signals=[at(f"Vehicle.Branch{i % 50}.Signal{i}", Timeout="100") for i in range(count)])
        return lambda: derive([one])

    assert growth(deriving, 200) < LINEAR


def test_the_order_of_the_functions_does_not_matter(whole):
    assert written(derive(list(reversed(examples()))).model) == written(whole)


# -- data -------------------------------------------------------------------------------------------------------------


def test_a_signal_is_an_interface_of_one_element_named_by_its_path(whole, core_acc):
    interface = next(each for each in whole.sender_receiver_interfaces if each.name == CYLP)
    assert [(each.name, each.vss_path, each.unit) for each in interface.elements] == [
        ("CylP", "Vehicle.Chassis.Brake.CylP", "bar")
    ]
    assert (port(core_acc, CYLP).direction, port(core_acc, CYLP).interface) == ("Required", CYLP)


def test_com_has_no_time_out_and_the_rte_tells_what_is_fresh(core_acc):
    (element,) = port(core_acc, CYLP).elements
    assert (element.alive_timeout, element.update, element.never_received) == (0, True, True)
    assert element.uses[0].timeout == 200


def test_values_travel_in_the_datatype_and_unit_of_the_catalogue():
    consumer = at("Vehicle.Speed", ConversionFactor="3.6", Units="m/s", InitValue=10, Max=100)
    model = derive([function(signals=[{**consumer, "Datatype": "DT_Float32", "VssDatatype": "uint16"}])]).model
    (demo,) = model.components
    (kind,) = [each for each in model.application_types if each.name == "Vehicle_Speed"]
    assert (kind.implementation, kind.unit) == ("uint16", "km_per_h")
    assert port(demo, "Vehicle_Speed").elements[0].init == 36


def test_a_range_is_that_of_the_catalogue():
    model = derive([function(signals=[at("Vehicle.Speed", VssMin=-250, VssMax=250)])]).model
    assert [(each.min, each.max) for each in model.constraints] == [(-250, 250)]


def test_the_start_of_an_enumeration_is_a_number_that_it_has():
    enumeration = {"typeRef": "DT_Gear", "category": "userdefined", "cDef": "unsigned char", "Kind": "enumeration",
                   "Symbols": [{"Symbol": "P", "Value": 3}, {"Symbol": "D", "Value": 7}]}  # fmt: skip
    sent = [{"Symbol": "P", "Value": 1}, {"Symbol": "D", "Value": 2}]
    gear = {**signal("Gear", VssPath="Vehicle.Gear", VssDatatype="uint8"), "Datatype": "DT_Gear", "VssSymbols": sent}
    (declared,) = derive([function(signals=[{**gear, "InitValue": 7}], datatypes=[enumeration])]).model.components
    (undeclared,) = derive([function(signals=[{**gear, "InitValue": None}], datatypes=[enumeration])]).model.components
    assert port(declared, "Vehicle_Gear").elements[0].init == 2
    assert port(undeclared, "Vehicle_Gear").elements[0].init == 1


def test_an_array_of_a_fixed_length_has_types_for_the_whole_and_its_elements():
    array = {"typeRef": "DT_Row", "category": "userdefined", "cDef": "float[3]", "Kind": "array",
             "ElementType": "DT_Float32", "Length": 3}  # fmt: skip
    row = {**signal("Row", VssPath="Vehicle.Row", VssDatatype="float[]", VssUnit="m"), "Datatype": "DT_Row"}
    model = derive([function(signals=[row], datatypes=[array])]).model
    kinds = {each.name: each for each in model.application_types}
    assert (kinds["Vehicle_Row"].category, kinds["Vehicle_Row"].length) == ("ARRAY", 3)
    assert kinds[kinds["Vehicle_Row"].element].unit == "m"
    (code,) = [each for each in model.implementation_types if each.category == "ARRAY"]
    assert (code.element, code.length) == ("float32", 3)


def test_a_queue_makes_the_element_queued_for_all_sides():
    queue = {
        "Name": "Hits", "Description": "Hits.", "Role": "Consumer", "AsilInfo": "QM", "QueueLength": 7, "Datatype": "DT_Float32",
        "Factor": 1, "Offset": 0, "InitValue": 0, "Units": "", "VssPath": "Vehicle.Hits", "VssDatatype": "float",
    }  # fmt: skip
    sender = function("Sender", [at("Vehicle.Hits", "Provider")])
    plain = function("Plain", [at("Vehicle.Hits")])
    queued = function("Queued", contract={"DataQList": [queue]})
    model = derive([sender, plain, queued]).model
    assert all(each.elements[0].queued for each in model.sender_receiver_interfaces if each.name == "Vehicle_Hits")
    assert port(component(model, "Queued"), "Vehicle_Hits").elements[0].queue_length == 14
    assert port(component(model, "Plain"), "Vehicle_Hits").elements[0].queue_length == 16
    assert accesses(component(model, "Sender"), "Step")["Vehicle_Hits"] == "QueuedSend"
    assert accesses(component(model, "Queued"), "Step")["Vehicle_Hits"] == "QueuedReceive"


@pytest.mark.parametrize("name", ["Clock", "EcuMode", "Parameters", "AdapterClock", "NvMService", "Demo_Parameters"])
def test_a_signal_may_have_the_name_of_what_the_adapter_needs(name):
    derived = derive([function(signals=[signal(name)], contract={"ParameterList": [parameter(Variable="p")]})])
    assert rules(derived) == {"K004"}


@pytest.mark.parametrize("name", ["Demo_Init", "Demo_Receive", "Demo_Core", "Demo_Stored", "Demo_OnInit"])
def test_a_step_may_have_the_name_of_what_the_adapter_has(name):
    (demo,) = derive([function(signals=[at("Vehicle.Speed")], call={"Name": name})]).model.components
    assert [each.call for each in demo.runnables if each.role == "Step"] == [name]


def test_what_an_rte_would_refuse_is_found_when_it_is_derived():
    mode = {"Name": "Demo_Mode_In", "Description": "Mode.", "Direction": "In", "Datatype": "DT_Bool", "Modes": []}
    assert rules(derive([function(signals=[at("Vehicle.Speed")], ModeInterfaceList=[mode])])) == {"K011"}


def test_a_function_whose_core_would_have_too_long_names_is_told_so_at_its_name():
    name = "A" * 114
    (finding,) = [each for each in derive([function(name, [at("Vehicle.Speed")])]).findings if each.rule == "K011"]
    assert finding.pointer == "/FunctionInfo/FunctionName"
    assert "113 characters" in finding.message
    assert "K011" not in rules(derive([function(name[:-1], [at("Vehicle.Speed")])]))


E2E_ERROR = {
    "ErrorList": [{
        "Name": "Demo_E2e_ErrorSts", "Description": "Rejected.", "Datatype": "DT_Bool", "Dependancy": [],
        "OccurenceCountLimit": 0, "IgnitionCountLimit": 0, "MaturationTime": 0, "Severity": "None.",
    }]
}  # fmt: skip

# -- how values are read ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("more", "kind"),
    [
        ({}, "ImplicitRead"),
        ({"Access": "Buffered"}, "ImplicitRead"),
        ({"Access": "Immediate"}, "ExplicitRead"),
        ({"Timeout": "100"}, "ExplicitRead"),
        ({"E2eError": "Demo_E2e_ErrorSts"}, "ExplicitRead"),
    ],
)
def test_the_access_follows_from_what_the_core_must_know(more, kind):
    (demo,) = derive([function(signals=[at("Vehicle.Speed", **more)], contract=E2E_ERROR)]).model.components
    assert accesses(demo, "Step")["Vehicle_Speed"] == kind


def test_what_is_read_explicitly_is_taken_when_it_comes(core_acc):
    assert ("DataReceived", CYLP) in starts(core_acc, "Receive")
    assert ("ModeSwitch", "STANDBY") in starts(core_acc, "Receive")
    assert ("DataReceived", "Vehicle_Speed") not in starts(core_acc, "Receive")


def test_what_triggers_a_step_is_taken_when_it_comes_and_the_core_says_what_is_due():
    call = {"Runtype": "EventTriggered", "Cycletime": None, "EventList": "Speed"}
    signals = [at("Vehicle.Speed"), at("Vehicle.Mass")]
    (demo,) = derive([function(signals=signals, call=call)]).model.components
    assert starts(demo, "Receive") == {("DataReceived", "Vehicle_Speed")}
    assert starts(demo, "Step") == {("InternalTrigger", "Receive"), ("InternalTrigger", "Step")}
    assert accesses(demo, "Step") | {"Clock": ""} == {"Clock": "", "Vehicle_Speed": "ExplicitRead", "Vehicle_Mass": "ImplicitRead", "Step": "InternalTrigger"}  # fmt: skip


def test_a_step_that_waits_for_its_debounce_time_is_looked_for_at_each_tick():
    call = {"Runtype": "EventTriggered", "Cycletime": None, "EventList": "Speed", "DebounceDelay": "5"}
    (demo,) = derive([function(signals=[at("Vehicle.Speed")], call=call)]).model.components
    assert starts(demo, "Step") == {("InternalTrigger", "Receive"), ("InternalTrigger", "Step"), ("Timing", 0.001)}


def test_a_rejected_message_is_told_by_the_rte():
    signals = [at("Vehicle.Speed", E2eError="Demo_E2e_ErrorSts")]
    (demo,) = derive([function(signals=signals, contract=E2E_ERROR)]).model.components
    assert port(demo, "Vehicle_Speed").elements[0].transformer_errors


def test_windows_of_the_end_to_end_state_machine_are_those_of_the_deployment():
    """For all, for an element by its path or its port, and those of one message otherwise."""
    signals = [at(f"Vehicle.{name}", E2eError="Demo_E2e_ErrorSts") for name in ("Speed", "Mass")] + [
        at("Vehicle.Width")
    ]
    text = """\
autosarClassic:
  e2e:
    valid: {windowSize: 5, minOkState: 2, maxErrorState: 3}
    elements:
      Vehicle.Speed: {init: {windowSize: 4}}
      Vehicle_Mass: {valid: {windowSize: 2}}
"""
    demo_of = function(signals=signals, contract=E2E_ERROR)
    derived = derive([demo_of], read_deployment(text.encode(), "deployment.yaml"))
    (demo,) = derived.model.components
    assert _windows(demo, "Vehicle_Speed") == ((4, 1, 0), (5, 2, 3), (1, 1, 0))
    assert _windows(demo, "Vehicle_Mass") == ((1, 1, 0), (2, 1, 0), (1, 1, 0))
    assert port(demo, "Vehicle_Width").elements[0].windows is None
    assert "K007" not in rules(derived)


def _windows(demo, name):
    windows = port(demo, name).elements[0].windows
    return tuple((each.size, each.min_ok, each.max_error) for each in (windows.init, windows.valid, windows.invalid))


def test_windows_of_data_that_nothing_protects_are_reported():
    text = "autosarClassic:\n  e2e:\n    elements:\n      Vehicle.Spede: {valid: {windowSize: 2}}\n"
    signals = [at("Vehicle.Speed", E2eError="Demo_E2e_ErrorSts")]
    demo_of = function(signals=signals, contract=E2E_ERROR)
    derived = derive([demo_of], read_deployment(text.encode(), "deployment.yaml"))
    (finding,) = [each for each in derived.findings if each.rule == "K007"]
    assert (finding.file, finding.line) == ("deployment.yaml", 4)
    assert finding.fix == "Did you mean 'Vehicle.Speed' or 'Vehicle_Speed'?"


# -- runnables --------------------------------------------------------------------------------------------------------


def test_each_call_is_a_runnable_with_a_symbol_of_its_own(core_acc):
    assert [(each.name, each.role, each.call) for each in core_acc.runnables] == [
        ("Init", "Init", "CoreAcc_Init"), ("Receive", "Receive", None), ("Step", "Step", "CoreAcc_Step"),
        ("Supervise", "Supervise", None), ("JudgeWindows", "JudgeWindows", None), ("Terminate", "Terminate", "CoreAcc_Terminate"),
    ]  # fmt: skip
    assert runnable(core_acc, "Step").symbol == "CoreAcc_Run_Step"


@pytest.mark.parametrize(("longest", "period"), [(7.4, 0.007), (30, 0.02), (0.4, 0.001)])
def test_supervision_keeps_the_longest_period_of_the_core(longest, period):
    """The period is the shorter one of cycle and longest duration, in whole ticks, and at least a tick."""
    limits = {"Min": 0, "Max": longest, "Ref": 0, "ErrorName": "Demo_Deadline_ErrorSts"}
    call = {
        "Cycletime": 20,
        "Watchdog": {"DeadlineSupervision": limits, "AliveSupervision": None, "LogicalSupervision": None},
    }
    (demo,) = derive([function(call=call)]).model.components
    assert [event.period for event in demo.events if event.runnable == "Supervise"] == [period]


def test_a_cyclic_step_has_a_timing_event_in_seconds():
    call = {"Cycletime": 10, "ExecOffset": "2.5"}
    (demo,) = derive([function(signals=[at("Vehicle.Speed")], call=call)], deployed(autosarClassic={"tick": 500})).model.components  # fmt: skip
    (event,) = [each for each in demo.events if each.kind == "Timing"]
    assert (event.period, event.offset) == (0.01, 0.0025)


def test_the_rte_holds_no_runnable_back_since_the_core_debounces():
    call = {"Cycletime": 10, "DebounceDelay": "5"}
    (demo,) = derive([function(signals=[at("Vehicle.Speed")], call=call)]).model.components
    assert {each.minimum_start_interval for each in demo.runnables} == {0}
    assert starts(demo, "Step") == {("Timing", 0.01), ("Timing", 0.001)}


def test_terminate_tells_what_the_core_says_last(core_acc):
    assert accesses(core_acc, "Terminate")["CoreAcc_Mode_Out"] == "ModeSwitch"


def test_terminate_is_started_when_the_ecu_shuts_down(core_acc):
    assert starts(core_acc, "Terminate") == {("ModeSwitch", "SHUTDOWN")}


def test_a_call_that_the_core_finds_due_is_triggered_by_whoever_asked(core_acc):
    assert ("InternalTrigger", "Receive") in starts(core_acc, "Step")
    assert {each.kind for each in runnable(core_acc, "Receive").accesses if each.element == "Step"} == {"InternalTrigger"}  # fmt: skip


def test_offered_methods_are_runnables_and_used_ones_take_their_answer():
    method = {"Name": "Reset", "Description": "Resets.", "OutDataTypeList": [],
              "InDataTypeList": [{"Name": "Why", "Datatype": "DT_Float32", "Units": ""}]}  # fmt: skip
    server = function("Server", contract={"MethodList": [{**method, "Role": "Provider"}]})
    client = function("Client", contract={"MethodList": [{**method, "Role": "Consumer"}]})
    model = derive([server, client]).model
    assert starts(component(model, "Server"), "Serve_Reset") == {("OperationInvoked", "Reset")}
    assert starts(component(model, "Client"), "Answer_Reset") == {("CallReturns", "Reset")}
    assert accesses(component(model, "Client"), "Step")["Reset"] == "AsynchronousCall"
    (interface,) = [each for each in model.client_server_interfaces if each.name == "Reset"]
    assert [(each.name, each.direction, each.type) for each in interface.operations[0].arguments] == [("Why", "IN", "float32")]  # fmt: skip


# -- statuses and the base software -----------------------------------------------------------------------------------


def test_an_error_is_an_event_that_the_core_has_matured(core_acc):
    event = next(each for each in core_acc.diagnostic_events if each.error == "CoreAcc_AliveError_ErrorSts")
    assert (event.debouncing, event.port) == ("MonitorInternal", "Event_CoreAcc_AliveError_ErrorSts")
    assert port(core_acc, event.port).service == "DiagnosticEventManager"


def test_what_is_counted_and_learned_is_one_block(core_acc):
    (block,) = core_acc.nv_blocks
    assert "CoreAcc_AliveError_ErrorSts" in block.errors
    assert (block.restore_at_start, block.store_at_shutdown) == (True, True)
    (memory,) = core_acc.memories
    assert (memory.name, memory.type_definition) == (block.memory, "CoreAcc_Adapter_Stored")


def test_a_learned_parameter_is_kept_and_not_calibrated():
    learned = parameter(Name="Gain", Attribute="LearningParameter", Interfacetype="PersistenceMemory", Variable="gain")
    (demo,) = derive([function(contract={"ParameterList": [learned, parameter(Name="Limit", Variable="limit")]})]).model.components  # fmt: skip
    assert demo.nv_blocks[0].parameters == ("Gain",)
    assert [each.name for each in port(demo, "Parameters").elements] == ["Limit"]


def test_parameters_are_provided_by_a_component_of_their_own(whole, core_acc):
    (calibration,) = whole.parameter_components
    provided = next(each for each in calibration.ports if each.interface == "CoreAcc_Parameters")
    assert [(each.name, each.init) for each in provided.elements] == [("ALatMax", 3)]
    assert port(core_acc, "Parameters").interface == "CoreAcc_Parameters"


def test_parameters_may_stay_within_their_component():
    model = derive(examples(), deployed(autosarClassic={"parameters": "internal"})).model
    assert not model.parameter_components
    assert "ALatMax" in {each.name for each in component(model, "CoreAcc").parameters}


def test_supervision_is_an_entity_with_checkpoints_around_the_call(core_acc):
    (entity,) = core_acc.supervised_entities
    (alive,) = entity.alive
    assert (alive.checkpoint, alive.expected, alive.min_margin, alive.max_margin, alive.reference_cycle) == ("Step_End", 10, 2, 2, 0.5)  # fmt: skip
    assert all(port(core_acc, point.port).service == "WatchdogManager" for point in entity.checkpoints)


def test_a_safety_condition_inhibits_others_and_is_told_to_the_outside_alone(whole, core_acc):
    (inhibition,) = core_acc.inhibitions
    assert inhibition.condition == "AccReqInvalid_SftyCondSts"
    assert "CoreAcc_AliveError_ErrorSts" in inhibition.events
    connected = {(each.requester.component, each.requester.port) for each in whole.composition.assemblies}
    assert ("CoreAcc", "AccReqInvalid_SftyCondSts") not in connected
    assert {"AccReqInvalid_SftyCondSts", "CoreAcc_AccReqInvalid_SftyCondSts_Out"} <= {
        each.name for each in whole.composition.ports
    }


def test_modes_have_the_numbers_of_the_catalogue(whole, core_acc):
    group = next(each for each in whole.mode_groups if each.name == "CoreAcc_Mode_In_Modes")
    assert [(mode.name, mode.value) for mode in group.modes] == [("OFF", 0), ("STANDBY", 1), ("ACTIVE", 2)]
    assert (group.initial, port(core_acc, "CoreAcc_Mode_Out").direction) == ("OFF", "Provided")


def test_an_error_that_no_function_of_the_set_reports_comes_from_outside():
    error = {
        "Name": "Demo_Own_ErrorSts", "Description": "Own.", "Datatype": "DT_Bool", "Dependancy": ["Hmi_Fault_ErrorSts"],
        "OccurenceCountLimit": 0, "IgnitionCountLimit": 0, "MaturationTime": 0, "Severity": "None.",
    }  # fmt: skip
    model = derive([function(contract={"ErrorList": [error]})]).model
    (demo,) = model.components
    (element,) = port(demo, "Hmi_Fault_ErrorSts").elements
    assert (element.uses[0].interface, element.uses[0].kind) == ("Hmi_Fault_ErrorSts", "error")
    assert ("DataReceived", "Hmi_Fault_ErrorSts") in starts(demo, "Receive")
    assert "Hmi_Fault_ErrorSts" in {each.name for each in model.composition.ports}


def test_every_runnable_has_the_asil_of_the_core_that_it_writes():
    derived = derive([function(signals=[at("Vehicle.Speed")], call={"AsilLevel": "B", "StackSize": "512"})])
    (demo,) = derived.model.components
    sections = {(each.name, each.asil_level, each.stack_size) for each in demo.sections}
    assert sections == {("CODE_ASIL_B", "B", 512), ("VAR_CLEARED_ASIL_B_UNSPECIFIED", "B", None)}
    assert {(each.asil_level, each.section) for each in demo.runnables} == {("B", "CODE_ASIL_B")}
    rows = {each.interface: each for each in derived.report if each.kind == "runnable"}
    assert rows.keys() == {f"Demo/{each.name}" for each in demo.runnables}
    assert rows["Demo/Terminate"].target == "ASIL B: code in CODE_ASIL_B, memory in VAR_CLEARED_ASIL_B_UNSPECIFIED"
    assert rows["Demo/Terminate"].note == "writes the core, whose ASIL is B for Demo_Step"


# -- together ---------------------------------------------------------------------------------------------------------


def test_what_one_component_provides_is_connected_with_all_who_require_it(whole):
    ends = {
        (each.provider.component, each.requester.component, each.requester.port)
        for each in whole.composition.assemblies
    }
    assert ("EcoControlMpc", "CoreAcc", "ADAS_EcoControl_AccelerationProposal") in ends


def test_what_comes_from_outside_names_who_provides_it(whole):
    outer = next(each for each in whole.composition.ports if each.name == CYLP)
    assert (outer.direction, outer.provider) == ("Required", Text("Brake control unit"))


def test_a_data_element_is_carried_by_the_signal_that_the_deployment_names():
    settings = {
        "signals": {"Vehicle.Speed": {"message": "Status", "signal": "Speed", "database": "can.dbc", "length": 16}}
    }
    derived = derive([function(signals=[at("Vehicle.Speed")])], deployed(autosarClassic=settings))
    (one,) = derived.model.ecu.signals
    assert (one.port, one.element, one.signal, one.database, one.length) == ("Vehicle_Speed", "Speed", "Status_Speed", Text("can.dbc"), 16)  # fmt: skip
    assert "K007" not in rules(derived)


def test_the_shorter_the_period_the_higher_the_priority_of_its_task(whole):
    cyclic = [task for task in whole.ecu.tasks if task.period is not None and task.name != "Task_Windows"]
    assert [task.period for task in sorted(cyclic, key=lambda each: -each.priority)] == sorted(task.period for task in cyclic)  # fmt: skip
    assert len({task.priority for task in whole.ecu.tasks}) == len(whole.ecu.tasks)


def test_windows_that_may_end_at_any_tick_are_evaluated_after_steps(whole):
    """Those of calls that a mode excludes: they begin when the call comes back."""
    (windows,) = [task for task in whole.ecu.tasks if task.name == "Task_Windows"]
    assert (windows.period, [event.component for event in windows.events]) == (
        0.001,
        ["CoreAcc", "WheelSpeedCalculation"],
    )
    assert [task.name for task in whole.ecu.tasks if task.priority < windows.priority] == ["Task_Life"]


def test_init_of_every_component_runs_before_the_tasks_do(whole):
    (batch,) = whole.ecu.init_batches
    assert {(each.component, each.event) for each in batch.events} == {
        (each.name, "OnInit") for each in whole.components
    }
    assert [each.position for each in batch.events] == list(range(1, len(whole.components) + 1))
    assert "OnInit" not in {event.event for task in whole.ecu.tasks for event in task.events}


def test_a_queue_of_the_rte_is_longer_than_that_of_the_core_so_that_the_core_decides_what_is_lost():
    def queue(length, role):
        return {
            "Name": "Hits", "Description": "Hits.", "Role": role, "AsilInfo": "QM", "QueueLength": length, "Datatype": "DT_Float32",
            "Factor": 1, "Offset": 0, "InitValue": 0, "Units": "", "VssPath": "Vehicle.Hits", "VssDatatype": "float",
        }  # fmt: skip

    def length(sent, received):
        functions = [function("Taker", contract={"DataQList": [queue(received, "Consumer")]})]
        if sent:
            functions.append(function("Sender", contract={"DataQList": [queue(sent, "Provider")]}))
        return port(component(derive(functions).model, "Taker"), "Vehicle_Hits").elements[0].queue_length

    assert length(sent=None, received=3) == 6
    assert length(sent=2, received=3) == 6
    assert length(sent=8, received=3) == 11


def test_all_events_of_a_runnable_are_in_one_task(whole):
    homes: dict[tuple[str, str], set[str]] = {}
    for task in whole.ecu.tasks:
        for event in task.events:
            of = next(each.runnable for each in component(whole, event.component).events if each.name == event.event)
            homes.setdefault((event.component, of), set()).add(task.name)
    assert homes
    assert all(len(tasks) == 1 for tasks in homes.values())


# -- the report -------------------------------------------------------------------------------------------------------


def test_every_field_of_the_examples_has_a_place():
    report = derive(examples()).report
    assert len(report) > 400
    assert not [entry for entry in report if entry.target == NOT_CARRIED]


@pytest.mark.parametrize("kind", [Signal, DataQueue, MethodInterface, ErrorInterface, SafetyReaction, ModeInterface])
def test_every_field_of_an_interface_has_a_place(kind):
    _, known = TABLES[kind]
    assert {str(field.alias) for field in kind.model_fields.values()} <= set(known)


def test_every_field_of_calls_and_parameters_has_a_place():
    assert {str(field.alias) for field in Runnable.model_fields.values()} <= set(CALL_TARGETS)
    assert {str(field.alias) for field in ParameterInterface.model_fields.values()} <= set(PARAMETER_TARGETS)


def test_a_field_that_nobody_knows_is_told_with_its_place():
    (finding,) = [
        f for f in derive([function(signals=[at("Vehicle.Speed", Colour="red")])]).findings if f.rule == "K009"
    ]
    assert "Colour" in finding.message


def test_several_providers_are_reported_at_the_second_component():
    one = function("One", [at("Vehicle.Speed", "Provider"), at("Vehicle.Speed", "Provider")])
    two = function("Two", [at("Vehicle.Speed", "Provider")])
    (finding,) = (each for each in derive([one, two]).findings if each.rule == "K002")
    assert (finding.file, "One, Two" in finding.message) == ("Two.json", True)
