"""Input that cannot be used is refused with findings."""

import pytest

from sigcat.errors import InputRefused, UsageError
from sigcat.function.document.text import Text
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.wire import written
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.platforms.deployment_file import read_deployment
from tests.growth import LINEAR, growth
from tests.integration.autosar_adaptive.derived import events, rules, services
from tests.integration.autosar_adaptive.sets import at, deployed, derive, example, function, parameter, signal


@pytest.mark.parametrize("name", ["", "1st", "x" * 490, "été", "class", "a name - of words", "linux", "UINT8_MAX"])
def test_other_names_become_short_names(name):
    model = derive([function(name, signals=[signal(name), signal(f"{name}2", "Provider")])]).model
    read_integration(written(model), "integration.json")


def test_what_the_deployment_says_of_nothing_is_told_with_what_was_meant():
    settings = {
        "components": {"Dem": {"executable": "X"}},
        "identifiers": {"VehicleAServic": 7},
        "services": [{"name": "Map", "paths": ["Vehicle.AB"]}],
    }
    derived = derive(
        [function(signals=[at("Vehicle.A.B")])], deployed(paths={"Demo.C": "V.A"}, autosarAdaptive=settings)
    )
    assert rules(derived) == ["A014"] * 4
    assert "Did you mean 'Demo'?" in [finding.fix for finding in derived.findings]
    assert any(finding.fix.startswith("Did you mean 'VehicleAService'") for finding in derived.findings)


def test_what_the_deployment_says_of_nothing_is_told_where_it_stands():
    text = (
        "paths: {Demo.C: V.A}\nautosarAdaptive:\n  components:\n    Dem: {executable: X}\n"
        "  services:\n    - name: Map\n      paths: [Vehicle.A.B, Vehicle.AB]\n"
    )
    derived = derive([function(signals=[at("Vehicle.A.B")])], read_deployment(text.encode(), "d.yaml"))
    found = [(each.rule, each.file, each.line, each.column, each.path) for each in derived.findings]
    assert found == [
        ("A014", "d.yaml", 1, 9, "Demo.C"), ("A014", "d.yaml", 4, 5, "Dem"), ("A014", "d.yaml", 7, 28, "Vehicle.AB"),
    ]  # fmt: skip


def test_a_word_that_the_published_schema_lacks_is_told_and_not_written():
    words = parameter(Interfacetype="calibration", Attribute="Odd", RangeErrorAction="Ignore")
    derived = derive([function(contract={"ParameterList": [words]})])
    assert rules(derived) == ["A013"] * 3
    assert derived.model.components[0].parameters is not None
    entry = derived.model.components[0].parameters[0]
    assert (entry.interface_type, entry.attribute, entry.range_error_action) == ("Calibration", "NA", None)


def test_a_parameter_has_its_storage_class_datatype_and_values():
    parameters = derive([example("CoreAcc")]).model.components[0].parameters
    assert parameters is not None
    one = parameters[0]
    assert (one.name, one.interface_type, one.variable) == ("ALatMax", "Calibration", "core_params.ALatMax")
    assert (one.datatype.datatype, one.datatype.min, one.datatype.max, one.datatype.unit) == ("float", 0.5, 8, "m/s^2")


def test_the_code_of_a_component_and_its_calls_goes_along():
    component = derive([example("EcoControlMpc")]).model.components[0]
    assert component.code is not None
    assert (component.code.signature, component.header_files) == ("Pointers", ("EcoControlMpc.h",))
    init = component.calls[0].code
    assert init is not None
    assert (init.symbol, init.arguments) == ("EcoControlMpc_initialize", ("EcoControlMpc_M",))


def test_a_call_may_leave_its_scheduling_open():
    derived = derive([function(call={"Scheduling": ""})])
    assert derived.model.components[0].calls[0].scheduling is None
    assert "A011" not in rules(derived)


def test_a_parameter_keeps_its_scale_its_key_and_its_elements():
    scaled = parameter(Factor="0.5", Offset="-1", Key="gain", Storage="Learned", RangeError="Demo_Range_ErrorSts")
    derived = derive([function(contract={"ParameterList": [scaled]})])
    assert derived.model.components[0].parameters is not None
    (entry,) = derived.model.components[0].parameters
    assert (entry.datatype.scaling, entry.datatype.offset) == (0.5, -1)
    assert entry.code is not None
    assert (entry.code.key, entry.code.storage, entry.code.range_error) == ("gain", "Learned", "Demo_Range_ErrorSts")


def test_each_side_of_a_method_keeps_its_code():
    method = {"Name": "Ask", "Description": "Asks.", "Role": "Provider", "InDataTypeList": [], "OutDataTypeList": []}
    user = function("User", contract={"MethodList": [method | {"Role": "Consumer", "RequestVariable": "out.ask"}]})
    model = derive([function(contract={"MethodList": [method | {"Symbol": "Demo_ask"}]}), user]).model
    offered = services(model)["DemoService", "Provider"].services[0].methods[0].uses
    used = services(model)["DemoService", "Consumer"].services[0].methods[0].uses
    assert offered is not None
    assert used is not None
    assert [use.method.symbol for use in offered] == ["Demo_ask"]
    assert [use.method.request_variable for use in used] == ["out.ask"]


def test_who_provides_from_outside_is_the_provider():
    one = function(signals=[at("Vehicle.A.B", ExternalProvider="Gateway")])
    provider = services(derive([one]).model)["VehicleAService", "Consumer"].providers
    assert provider is not None
    assert [item.name for item in provider] == [Text("Gateway")]


def test_a_queue_is_an_event_that_keeps_its_length():
    queue = {
        "Name": "Q", "Description": "Counts.", "Role": "Provider", "AsilInfo": "QM", "QueueLength": 8,
        "Datatype": "DT_Float32", "Factor": 1, "Offset": 0, "InitValue": 0, "Units": "m",
    }  # fmt: skip
    model = derive([function(contract={"DataQList": [queue]})]).model
    uses = events(model)["DemoService", "Q"].uses
    assert uses is not None
    assert uses[0].queue is not None
    assert uses[0].queue.queue_length == 8


def test_two_components_of_one_function_talk_over_a_service():
    base = function(signals=[at("Vehicle.A.B", "Provider")]).model_dump(mode="json")
    other = function(signals=[at("Vehicle.A.B")]).model_dump(mode="json")["ComponentList"][0]
    base["ComponentList"].append({**other, "Name": "Reader"})
    model = derive([FunctionJson.model_validate(base)]).model
    assert ("DemoService", "Consumer") in services(model, "Reader")
    assert [component.executable for component in model.components] == ["DemoExecutable", "ReaderExecutable"]


def test_a_deployment_with_an_unknown_key_is_refused_with_its_line():
    with pytest.raises(InputRefused) as refused:
        read_deployment(b"name: X\nautosarAdaptive:\n  prot: 3\n", "deployment.yaml")
    assert [(finding.rule, finding.line) for finding in refused.value.findings] == [("F003", 3)]


def test_no_function_is_refused():
    with pytest.raises(UsageError):
        derive([])


def test_ten_times_the_signals_take_about_ten_times_as_long():
    def deriving(count):
        one = function(signals=[at(f"Vehicle.Branch{i % 50}.Signal{i}") for i in range(count)])
        return lambda: derive([one])

    assert growth(deriving, 200) < LINEAR


def test_what_is_wrong_with_a_deployment_is_told_in_the_order_of_its_lines():
    with pytest.raises(InputRefused) as refused:
        read_deployment(b"pakage: X\nautosarAdaptive: {identifiers: {A: 99999999999}}\nros2: {topics: x}\n", "d.yaml")
    assert [finding.line for finding in refused.value.findings] == [1, 2, 3]


def failing(name, *dependencies):
    """A function that reports an error, which errors of others set too."""
    error = {
        "Name": f"{name}_Bad_ErrorSts", "Description": "Is bad.", "Datatype": "DT_Bool", "Dependancy": dependencies,
        "OccurenceCountLimit": 0, "IgnitionCountLimit": 0, "MaturationTime": 0, "Severity": "Error",
    }  # fmt: skip
    return function(name, contract={"ErrorList": [error]})


def test_a_component_consumes_the_errors_that_set_its_own():
    one, other = failing("Sense"), failing("Act", "Sense_Bad_ErrorSts", "Base_Gone_ErrorSts")
    derived = derive([other, one])
    found = services(derived.model)["SenseService", "Consumer"]
    assert [field.name for field in found.services[0].fields] == ["Sense_Bad_ErrorSts"]
    assert [provider.name for provider in found.providers or ()] == [Text("Sense")]
    (act,) = [component for component in derived.model.components if component.name == "Act"]
    assert {service.name for service in act.services} == {"SenseService", "ActService"}
    told = [entry for entry in derived.report if entry.interface == "Sense_Bad_ErrorSts"]
    assert {entry.function for entry in told} == {"Sense"}


def test_a_component_consumes_the_errors_that_set_its_safety_reactions():
    reaction = {
        "Name": "Invalid_SftyCondSts", "Description": "Nothing is valid.", "Datatype": "DT_Bool",
        "ErrorList": ["Sense_Bad_ErrorSts"],
    }  # fmt: skip
    derived = derive([failing("Sense"), function("Act", contract={"SafetyReactionList": [reaction]})])
    found = services(derived.model)["SenseService", "Consumer"]
    assert [field.name for field in found.services[0].fields] == ["Sense_Bad_ErrorSts"]


def test_the_deployment_names_who_provides_safety_conditions_and_modes():
    derived = derive([example("CoreAcc")], deployed(safetyManager="SafetyCluster", modeManager="StateManagement"))
    found = services(derived.model)
    named = {service: [each.name for each in interface.providers or ()] for (service, _), interface in found.items()}
    assert named["SafetyManagementService"] == [Text("SafetyCluster")]
    assert named["ModeManagementService"] == [Text("StateManagement")]


def test_an_interface_above_qm_has_no_protection():
    assert rules(derive([function(signals=[at("Vehicle.A.B", AsilLevel="C")])])) == ["A019"]
