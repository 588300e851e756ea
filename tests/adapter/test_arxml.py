"""An integration becomes ARXML of a release of AUTOSAR adaptive."""

import html
import json
import xml.etree.ElementTree as ET
from functools import cache

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sigcat.adapter.autosar_adaptive.arxml.field_targets import TABLES
from sigcat.adapter.autosar_adaptive.arxml.generate import generate
from sigcat.cli import main
from sigcat.errors import InputRefused
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.integration.autosar_adaptive.model import to_json
from sigcat.integration.autosar_adaptive.releases import RELEASES
from sigcat.integration.autosar_adaptive.storages import stored_parameters
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT
from tests.adapter.arxml_judge import (
    VERSIONS,
    dangling,
    doubled_names,
    doubled_numbers,
    loaded,
    misplaced,
    numbers,
    version_of,
    without_number,
)
from tests.integration.autosar_adaptive.sets import at, deployed, derive, examples, function, parameter, signal
from tests.judges import judged_by
from tests.needs import published, published_files

RANGES = {"SERVICE-INTERFACE-ID": (1, 0xFFFD), "SERVICE-INSTANCE-ID": (1, 0xFFFE), "EVENT-ID": (0x8000, 0xFFFE),
          "METHOD-ID": (1, 0x7FFF), "EVENT-GROUP-ID": (1, 0xFFFE)}  # fmt: skip

POINT = {
    "typeRef": "DT_Point", "category": "userdefined", "cDef": "struct Point", "Kind": "struct",
    "Description": "A place.",
    "Fields": [{"Name": "X", "Datatype": "DT_Float32", "Units": "m", "Description": "Ahead.", "Min": -2, "Max": 7.5},
               {"Name": "Label", "Datatype": "DT_String"}],
}  # fmt: skip
POINTS = {
    "typeRef": "DT_Points", "category": "userdefined", "cDef": "struct Point *", "Kind": "array", "ElementType": "DT_Point",
}  # fmt: skip
COLOURS = {
    "typeRef": "DT_Colour", "category": "userdefined", "cDef": "uint8_t", "Kind": "enumeration",
    "Symbols": [{"Symbol": "RED", "Value": 0}, {"Symbol": "GREEN", "Value": 7}],
}  # fmt: skip
METHOD = {
    "Name": "SetSpeed", "Description": "Sets <it> & more.", "Role": "Provider",
    "InDataTypeList": [{"Name": "v", "Datatype": "DT_Float32", "Units": "km/h"}],
    "OutDataTypeList": [{"Name": "done", "Datatype": "DT_Bool", "Units": ""}],
}  # fmt: skip


def every_kind():
    """A function with every kind of datatype and element."""
    return function(
        "Demo",
        [
            signal("Points", "Provider", Datatype="DT_Points", VssPath="Vehicle.A.Points", VssDatatype="Types.Point[]"),
            signal("Colour", Datatype="DT_Colour", VssPath="Vehicle.A.Colour", VssDatatype="string"),
            signal("Text", Datatype="DT_String", VssPath="Vehicle.A.Text", VssDatatype="string"),
            signal("Scaled", Factor="0.01", Offset="-40", Units="celsius"),
            at("Vehicle.B.Speed"),
        ],
        [POINT, POINTS, COLOURS],
        contract={"MethodList": [METHOD]},
    )


@cache
def made(name, release="R23-11"):
    functions = examples() if name == "examples" else (every_kind(),)
    protected = {"profile": 4, "events": {"DemoService": {"profile": 5, "maxDeltaCounter": 3}}}
    deployment = DEFAULT_DEPLOYMENT if name == "examples" else deployed(autosarAdaptive={"e2e": protected})
    return generate(derive(functions, deployment).model, release)


SETS = pytest.mark.parametrize("name", ["examples", "every kind"])
EACH_RELEASE = pytest.mark.parametrize("release", RELEASES)


def tags(files):
    return [element for file in files for element in ET.fromstring(file.data).iter()]


def texts(files, tag):
    return [element.text for element in tags(files) if element.tag.endswith(f"}}{tag}")]


# -- as AUTOSAR has it --------------------------------------------------------------------------------------------


@judged_by(
    "autosar-data",
    "ARXML loads strictly, its references lead somewhere, its elements have the order of the metamodel of their release",
)
@SETS
@EACH_RELEASE
def test_the_files_are_right_under_the_metamodel_of_their_release(name, release):
    model = loaded(made(name, release))
    assert version_of(model) == VERSIONS[release]
    assert dangling(model) == []
    assert misplaced(model) == []
    assert doubled_names(model) == []


@SETS
def test_ids_exist_and_are_unique_and_in_range(name):
    model = loaded(made(name))
    assert without_number(model) == []
    assert doubled_numbers(model) == []
    assert {kind for _, kind, _, _ in numbers(model)} >= {"SERVICE-INTERFACE-ID", "EVENT-ID"}
    assert all(RANGES[kind][0] <= number <= RANGES[kind][1] for _, kind, _, number in numbers(model))


@judged_by("autosar-data", "ARXML stays the same when it is read and written again")
@SETS
def test_the_files_survive_a_round_trip(name):
    files = made(name)
    assert files
    for file in files:
        again = loaded([file]).serialize_files()[file.name]
        assert again.rstrip("\n") == file.data.decode().rstrip("\n")


def test_the_judge_of_order_sees_what_is_wrong():
    file = made("examples")[3]
    text = file.data.decode()
    first, second = text.index("<EVENT-GROUPS>"), text.index("</EVENT-GROUPS>") + len("</EVENT-GROUPS>")
    at_id = text.index("<SERVICE-INTERFACE-REF", 0)
    swapped = text[:at_id] + text[first:second] + text[at_id:first] + text[second:]
    with pytest.raises(Exception, match=r"."):
        assert misplaced(loaded([file._replace(data=swapped.encode())])) == []


def test_the_release_is_r23_11_or_as_the_deployment_says_or_as_is_asked_for():
    earlier = derive(examples(), deployed(autosarAdaptive={"release": "R20-11"})).model
    assert {b"AUTOSAR_00052.xsd" in file.data for file in generate(derive(examples()).model)} == {True}
    assert {b"AUTOSAR_00049.xsd" in file.data for file in generate(earlier)} == {True}
    assert {b"AUTOSAR_00051.xsd" in file.data for file in generate(earlier, "R22-11")} == {True}


def test_a_release_that_the_writer_does_not_know_is_refused_where_it_stands():
    value = document()
    value["Deployment"]["Release"] = "R19-11"
    assert [finding.pointer for finding in refused(value)] == ["/Deployment/Release"]


def test_the_same_model_gives_the_same_bytes():
    assert generate(derive(examples()).model) == made("examples")


# -- what an integrator looks for ---------------------------------------------------------------------------------


def test_the_files_are_those_that_integrators_expect():
    assert [file.name for file in made("examples")] == [
        "types.arxml", "interfaces.arxml", "components.arxml", "deployment.arxml",
    ]  # fmt: skip


def test_every_executable_has_a_root_component_and_a_process_in_the_states_of_its_calls():
    model = loaded(made("examples"))
    root = "/CoreAcc_and_EcoControlMpc_and_WheelSpeedCalculation"
    assert model.get_element_by_path(f"{root}/Executables/CoreAccExecutable/CoreAcc_Root") is not None
    process = model.get_element_by_path(f"{root}/Processes/CoreAccProcess")
    states = [
        str(element.character_data).rpartition("/")[2]
        for _, element in process.elements_dfs
        if element.element_name == "TARGET-MODE-DECLARATION-REF"
    ]
    assert states == ["Startup", "Run", "Terminate"]


def test_every_service_of_every_component_is_mapped_to_a_port():
    services = [interface for part in derive(examples()).model.components for interface in part.services]
    assert len(texts(made("examples"), "TARGET-PORT-PROTOTYPE-REF")) == len(services)


def test_an_event_is_traced_to_its_vss_path_and_has_unit_and_limits():
    model = loaded(made("examples"))
    root = "/CoreAcc_and_EcoControlMpc_and_WheelSpeedCalculation"
    event = model.get_element_by_path(f"{root}/ServiceInterfaces/VehicleChassisService/Chassis_Brake_CylP")
    text = event.serialize()
    assert '<SD GID="VssPath">Vehicle.Chassis.Brake.CylP</SD>' in text
    assert f"{root}/Units/bar" in text
    assert f"{root}/CompuMethods/CM_bar" in text
    assert "DC_m30_to_276_9" in text


def test_a_struct_an_array_of_it_an_enumeration_and_a_scaling_have_their_elements():
    files = made("every kind")
    categories = texts(files, "CATEGORY")
    assert {"STRUCTURE", "VECTOR", "STRING", "VALUE", "TYPE_REFERENCE", "TEXTTABLE", "LINEAR"} <= set(categories)
    assert texts(files, "VT") == ["RED", "GREEN"]
    assert texts(files, "COMPU-NUMERATOR") != []
    assert "Sets <it> & more." in texts(files, "L-2")


def test_a_struct_says_what_it_is_and_its_members_keep_their_unit_and_limits():
    files = made("every kind")
    assert {"A place.", "Ahead."} <= set(texts(files, "L-2"))
    facts = [(element.get("GID"), element.text) for element in tags(files) if element.tag.rpartition("}")[2] == "SD"]
    assert {("Unit", "m"), ("Min", "-2"), ("Max", "7.5")} <= set(facts)


def test_what_a_call_has_beyond_the_metamodel_stands_in_words_of_no_programming_language():
    facts = {
        element.get("GID"): element.text for element in tags(made("examples")) if element.tag.rpartition("}")[2] == "SD"
    }
    assert facts["CoreAcc_Step.FunctionModes"] == "STANDBY, ACTIVE"
    assert facts["CoreAcc_Step.ParallelProcessing"] == "false"
    assert facts["CoreAcc_Step.Watchdog.AliveSupervision.Ref"] == "10"
    assert not [text for text in facts.values() if text and text[0] in "[{"]


def test_a_process_is_started_as_the_deployment_says():
    startup = {"policy": "SCHED_RR", "priority": 7, "enterTimeout": 1500, "exitTimeout": 250,
               "arguments": ["-v", "eco.json"], "environment": {"LEVEL": "debug"}, "restartAttempts": 2}  # fmt: skip
    model = with_settings(components={"Demo": {"startup": startup}})
    found = model.get_element_by_path("/Eco/StartupConfigurations/Demo_Startup")
    assert [str(e.character_data) for _, e in found.elements_dfs if e.element_name == "ARGUMENT"] == ["-v", "eco.json"]
    stated = values(model, found.path)
    assert (stated["KEY"], stated["VALUE"]) == ("LEVEL", "debug")
    assert (stated["SCHEDULING-POLICY"], stated["SCHEDULING-PRIORITY"]) == ("SCHED_RR", "7")
    assert (stated["ENTER-TIMEOUT-VALUE"], stated["EXIT-TIMEOUT-VALUE"]) == ("1.5", "0.25")
    assert stated["TERMINATION-BEHAVIOR"] == "PROCESS-IS-NOT-SELF-TERMINATING"
    assert values(model, "/Eco/Processes/DemoProcess")["NUMBER-OF-RESTART-ATTEMPTS"] == "2"


def test_a_further_process_of_an_executable_has_instances_of_its_own():
    model = with_settings(
        identifiers={"DemoService:instance": 2}, components={"Demo": {"processes": {"RearDemo": {"DemoService": 3}}}}
    )
    for process, instance, number in (
        ("DemoProcess", "Demo_DemoService_PPort_Instance", "2"),
        ("RearDemo", "RearDemo_DemoService_PPort_Instance", "3"),
    ):
        assert values(model, f"/Eco/ServiceInstances/{instance}")["SERVICE-INSTANCE-ID"] == number
        mapping = values(model, f"/Eco/PortMappings/{instance}_Mapping")
        assert mapping["PROCESS-REF"] == f"/Eco/Processes/{process}"
        assert mapping["TARGET-PORT-PROTOTYPE-REF"].endswith("/DemoService_PPort")
        assert values(model, f"/Eco/Processes/{process}")["DESIGN-REF"] == "/Eco/ProcessDesigns/Demo_Design"


def test_a_further_process_is_refused_where_it_stands():
    value = document()
    value["ComponentList"][0]["Processes"] = [
        {"Name": "Rear", "Instances": [{"Service": "Nothing", "ServiceInstanceID": 3}]}
    ]
    (finding,) = refused(value)
    assert "Nothing" in finding.message
    assert finding.line > 1


def test_a_unit_has_its_dimension_and_its_factor_to_si_units():
    model = with_settings()
    assert values(model, "/Eco/Units/km_h") == {
        "SHORT-NAME": "km_h", "DISPLAY-NAME": "km/h", "FACTOR-SI-TO-UNIT": "3.6", "OFFSET-SI-TO-UNIT": "0.0",
        "PHYSICAL-DIMENSION-REF": "/Eco/PhysicalDimensions/Length_per_Time",
    }  # fmt: skip
    assert values(model, "/Eco/Units/celsius")["OFFSET-SI-TO-UNIT"] == "-273.15"
    assert values(model, "/Eco/PhysicalDimensions/Length_per_Time") == {
        "SHORT-NAME": "Length_per_Time", "LENGTH-EXP": "1", "TIME-EXP": "-1",
    }  # fmt: skip


@pytest.mark.parametrize(
    ("stated", "name"),
    [
        ({"factor": 2}, "Dimensionless"),
        ({"factor": 0.5, "time": -1}, "One_per_Time"),
        ({"factor": 1e-9, "offset": 5, "mass": 1, "length": 2, "time": -3}, "Length2_Mass_per_Time3"),
        ({"factor": -1e300, "molarAmount": 1, "luminousIntensity": -2}, "MolarAmount_per_LuminousIntensity2"),
    ],
)
def test_a_unit_of_a_company_is_as_the_deployment_describes_it(stated, name):
    one = function(signals=[at("Vehicle.A.B") | {"VssUnit": "u"}])
    files = generate(derive([one], deployed(name="Eco", autosarAdaptive={"units": {"u": stated}})).model)
    model = loaded(files)
    assert dangling(model) == []
    found = values(model, "/Eco/Units/u")
    assert found["PHYSICAL-DIMENSION-REF"] == f"/Eco/PhysicalDimensions/{name}"
    assert float(found["FACTOR-SI-TO-UNIT"]) == stated["factor"]


def test_a_unit_that_nothing_is_known_of_has_its_name_alone():
    files = generate(derive([function(signals=[at("Vehicle.A.B") | {"VssUnit": "knots"}])], deployed(name="Eco")).model)
    assert values(loaded(files), "/Eco/Units/knots") == {"SHORT-NAME": "knots", "DISPLAY-NAME": "knots"}


def test_every_process_has_a_design_that_names_its_executable():
    model = loaded(made("examples"))
    root = "/CoreAcc_and_EcoControlMpc_and_WheelSpeedCalculation"
    assert values(model, f"{root}/Processes/CoreAccProcess")["DESIGN-REF"] == f"{root}/ProcessDesigns/CoreAcc_Design"
    design = values(model, f"{root}/ProcessDesigns/CoreAcc_Design")
    assert design["EXECUTABLE-REF"] == f"{root}/Executables/CoreAccExecutable"


def with_settings(**settings):
    """ARXML of the function with every kind of element, as one model; it is right under every release."""
    derived = derive((every_kind(),), deployed(name="Eco", autosarAdaptive=settings)).model
    models = {release: loaded(generate(derived, release)) for release in RELEASES}
    for model in models.values():
        assert dangling(model) == []
        assert misplaced(model) == []
        assert doubled_names(model) == []
    return models["R23-11"]


def values(model, path):
    """Texts of what is in an element, by tag."""
    element = model.get_element_by_path(path)
    return {
        each.element_name: str(each.character_data)
        for _, each in element.elements_dfs
        if each.character_data is not None
    }


def symbols(model, path):
    """Namespaces of an element, the outermost first."""
    element = model.get_element_by_path(path)
    return [str(each.character_data) for _, each in element.elements_dfs if each.element_name == "SYMBOL"]


def test_services_and_datatypes_have_the_namespace_of_the_application_or_those_of_the_deployment():
    plain = with_settings()
    assert symbols(plain, "/Eco/ServiceInterfaces/VehicleAService") == ["eco"]
    assert symbols(plain, "/Eco/DataTypes/DT_Point") == ["eco"]
    chosen = with_settings(
        namespace="acme::control",
        typeNamespace="acme::types",
        services=[{"name": "ChassisService", "paths": ["Vehicle.A"], "namespace": "acme::acme"}],
    )
    assert symbols(chosen, "/Eco/ServiceInterfaces/ChassisService") == ["acme", "acme"]
    assert symbols(chosen, "/Eco/ServiceInterfaces/DemoService") == ["acme", "control"]
    for name in ("DT_Point", "DT_Points", "DT_Colour", "String"):
        assert symbols(chosen, f"/Eco/DataTypes/{name}") == ["acme", "types"]
    assert symbols(chosen, "/Eco/DataTypes/float") == []


def test_a_namespace_named_like_a_member_beside_it_keeps_its_symbol():
    assert symbols(with_settings(typeNamespace="X::Label"), "/Eco/DataTypes/DT_Point") == ["X", "Label"]


def test_the_layout_of_what_is_sent_is_stated_for_every_element_of_every_service():
    model = with_settings(transformation={"byteOrder": "little-endian", "stringEncoding": "UTF-16", "arrayLength": 2})
    assert values(model, "/Eco/TransformationProperties/SomeIp/Default") == {
        "SHORT-NAME": "Default", "ALIGNMENT": "8", "BYTE-ORDER": "MOST-SIGNIFICANT-BYTE-LAST",
        "SESSION-HANDLING": "SESSION-HANDLING-ACTIVE", "SIZE-OF-ARRAY-LENGTH-FIELD": "2",
        "SIZE-OF-STRING-LENGTH-FIELD": "4", "SIZE-OF-STRUCT-LENGTH-FIELD": "0", "STRING-ENCODING": "UTF-16",
    }  # fmt: skip
    sent = {"VARIABLE-DATA-PROTOTYPE", "FIELD", "CLIENT-SERVER-OPERATION"}
    elements = {e.path for _, e in model.elements_dfs if e.element_name in sent}
    mapped = model.get_element_by_path("/Eco/TransformationProperties")
    assert elements == {str(e.character_data) for _, e in mapped.elements_dfs if e.element_name in _MAPPED}


def test_a_service_from_outside_keeps_the_layout_of_its_provider():
    own = {"name": "ChassisService", "paths": ["Vehicle.A"], "transformation": {"byteOrder": "little-endian"}}
    model = with_settings(services=[own])
    package = "/Eco/TransformationProperties"
    properties = f"{package}/SomeIp/ChassisService_Properties"
    assert values(model, properties)["BYTE-ORDER"] == "MOST-SIGNIFICANT-BYTE-LAST"
    assert values(model, f"{package}/ChassisService_Transformation")["TRANSFORMATION-PROPS-REF"] == properties
    other = values(model, f"{package}/DemoService_Transformation")["TRANSFORMATION-PROPS-REF"]
    assert other == f"{package}/SomeIp/Default"


def test_a_protected_event_has_its_profile_and_data_id_at_each_instance():
    model = with_settings(
        e2e={"events": {"DemoService.A_Points": {"profile": 5, "maxDeltaCounter": 3}}},
        identifiers={"DemoService.A_Points:dataId": 77},
    )
    configuration = "/Eco/E2eProfiles/Profiles/Profile05_MaxDeltaCounter3"
    assert values(model, configuration) == {
        "SHORT-NAME": "Profile05_MaxDeltaCounter3", "MAX-DELTA-COUNTER": "3", "PROFILE-NAME": "PROFILE_05",
    }  # fmt: skip
    kind = "END-2-END-EVENT-PROTECTION-PROPS"
    found = [element.path for _, element in model.elements_dfs if element.element_name == kind]
    assert [values(model, path) for path in found] == [{
        "SHORT-NAME": "A_Points_E2e", "DATA-ID": "77", "E-2-E-PROFILE-CONFIGURATION-REF": configuration,
        "EVENT-REF": "/Eco/ServiceDeployments/DemoService_SomeIp/A_Points_SomeIp",
    }]  # fmt: skip


_MAPPED = {"EVENT-REF", "FIELD-REF", "METHOD-REF"}


def test_every_instance_and_event_group_has_the_timing_of_service_discovery_in_seconds():
    model = with_settings(serviceDiscovery={"offerCyclicDelay": 2500, "offerTimeToLive": 5, "initialDelayMin": 0.5})
    assert values(model, "/Eco/ServiceDiscovery/Server") == {
        "SHORT-NAME": "Server", "INITIAL-DELAY-MAX-VALUE": "0.1", "INITIAL-DELAY-MIN-VALUE": "0.0005",
        "INITIAL-REPETITIONS-BASE-DELAY": "0.2", "INITIAL-REPETITIONS-MAX": "3", "OFFER-CYCLIC-DELAY": "2.5",
        "MAX-VALUE": "0.1", "MIN-VALUE": "0.01", "SERVICE-OFFER-TIME-TO-LIVE": "5",
    }  # fmt: skip
    for kind, timed in {
        "PROVIDED-SOMEIP-SERVICE-INSTANCE": "SD-SERVER-CONFIG-REF",
        "REQUIRED-SOMEIP-SERVICE-INSTANCE": "SD-CLIENT-CONFIG-REF",
        "SOMEIP-PROVIDED-EVENT-GROUP": "SD-SERVER-EVENT-GROUP-TIMING-CONFIG-REF",
        "SOMEIP-REQUIRED-EVENT-GROUP": "SD-CLIENT-EVENT-GROUP-TIMING-CONFIG-REF",
    }.items():
        found = [element for _, element in model.elements_dfs if element.element_name == kind]
        assert found
        assert all(any(child.element_name == timed for child in element.sub_elements) for element in found)


# -- Integration JSON from elsewhere ------------------------------------------------------------------------------


@published_files
def test_the_published_example_becomes_arxml_with_ids_by_rule():
    files = generate(read_integration(published("integration_model_AA_core_acc.json"), "published.json"))
    model = loaded(files)
    assert dangling(model) == []
    assert misplaced(model) == []
    assert without_number(model) == []
    assert doubled_numbers(model) == []


def document(**changes):
    base = json.loads(to_json(derive([function(signals=[at("Vehicle.A.B")])]).model))
    return {**base, **changes}


def refused(value):
    with pytest.raises(InputRefused) as caught:
        read_integration(json.dumps(value, indent=1).encode(), "integration.json")
    return caught.value.findings


def test_what_autosar_cannot_name_is_refused_where_it_stands():
    value = document()
    value["ComponentList"][0]["ServiceInterfaceList"][0]["ServiceList"][0]["Events"][0]["Name"] = '"/><script>'
    found = refused(value)
    assert [finding.rule for finding in found] == ["A020"]
    assert found[0].pointer == "/ComponentList/0/ServiceInterfaceList/0/ServiceList/0/Events/0"
    assert found[0].line > 1


@pytest.mark.parametrize(
    ("codes", "words"),
    [
        (({"Key": "gain/x"},), "key name"),
        (({"Storage": "1st"},), "storage name must be"),
        (({"Storage": "Adapter"},), "that of another port"),
        (({"Key": "Gain"}, {"Key": "gain"}), "key names 'Gain' and 'gain'"),
        (({"Storage": "Cal"}, {"Storage": "CAL"}), "storage names 'Cal' and 'CAL'"),
    ],
)
def test_storages_and_keys_that_autosar_cannot_have_are_refused(codes, words):
    listed = [parameter(Name=f"P{index}", Variable=f"g_{index}", **code) for index, code in enumerate(codes)]
    value = json.loads(to_json(derive([function(contract={"ParameterList": listed})]).model))
    found = refused(value)
    assert {finding.rule for finding in found} == {"A020"}
    assert words in found[0].message
    assert found[0].pointer == f"/ComponentList/0/ParameterList/{len(codes) - 1}"


def test_a_parameter_that_two_calls_describe_differently_is_stored_once():
    listed = [parameter(Key="gain", Variable="g_gain", Description=text) for text in ("A gain.", "Another gain.")]
    model = derive([function(contract={"ParameterList": listed})]).model
    assert [each.key for each in stored_parameters(model.components[0])][:1] == ["gain"]
    read_integration(to_json(model), "integration.json")


def test_a_datatype_that_is_not_defined_is_refused():
    value = document()
    value["ComponentList"][0]["ServiceInterfaceList"][0]["ServiceList"][0]["Events"][0]["DataType"] = "DT_Nothing"
    assert "'DT_Nothing' of A_B is not defined" in refused(value)[0].message


@pytest.mark.parametrize(
    "entry",
    [
        {"Name": "uint8_t", "Class": "type_reference", "cDef": "bool"},
        {"Name": "A/B", "Class": "structure", "Field": []},
        {"Name": "E", "Class": "enumeration", "EnumField": [{"Symbol": "</VT>", "Value": 1}]},
        {"Name": "S", "Class": "structure", "Field": [{"Name": "a", "Type": "bool"}, {"Name": "A", "Type": "bool"}]},
        {"Name": "S", "Class": "structure", "Field": [{"Name": "a", "Type": "nothing"}]},
        {"Name": "L", "Class": "array", "Dimension": 3},
    ],
)
def test_datatypes_that_autosar_cannot_have_are_refused(entry):
    assert refused(document(DataTypes=[entry]))[0].rule == "A020"


@pytest.mark.parametrize(("key", "value"), [("Package", "a b"), ("FunctionGroup", "1")])
def test_names_of_the_deployment_are_checked(key, value):
    base = document()
    base["Deployment"][key] = value
    assert refused(base)[0].pointer == f"/Deployment/{key}"


def test_an_array_of_open_length_needs_a_length():
    value = document(DataTypes=[{"Name": "L", "Class": "array", "Type": "float", "Dimension": "dynamic"}])
    value["Deployment"]["Transformation"]["arrayLength"] = 0
    assert [finding.pointer for finding in refused(value)] == ["/Deployment/Transformation/arrayLength"]


def test_an_id_that_two_have_is_refused():
    model = derive([function(signals=[at("Vehicle.A.B"), at("Vehicle.A.C")])]).model
    value = json.loads(to_json(model))
    for event in value["ComponentList"][0]["ServiceInterfaceList"][0]["ServiceList"][0]["Events"]:
        event["EventID"] = 32770
    assert "must have different ids, not both 32770" in refused(value)[0].message


@pytest.mark.parametrize("data", [b"", b"[]", b"{}", b"\xff\xfe", b"nonsense", b'{"ComponentList": 3}', b"[" * 100_000])
def test_what_is_no_integration_json_is_refused(data):
    with pytest.raises(InputRefused) as caught:
        read_integration(data, "integration.json")
    assert caught.value.findings


# -- texts that want to get out -----------------------------------------------------------------------------------

HOSTILE = [
    '"><script>alert(1)</script>',
    "*/ #include <x>",
    "]]><!--",
    "&amp;&lt;",
    "\u0000\u0001\u001f",
    "\ufffe",
    "été 🚗",
    "a\nb\tc",
]


@judged_by("autosar-data", "Whatever text or name a function has, its ARXML loads")
@pytest.mark.parametrize("text", HOSTILE)
def test_hostile_texts_stay_texts(text):
    method = METHOD | {"Description": text}
    one = function(
        "Demo",
        [signal("S", Description=text, Variable=text, Units=text, VssPath="Vehicle.A.S")],
        contract={"MethodList": [method]},
    )
    files = generate(derive([one]).model)
    model = loaded(files)
    assert dangling(model) == []
    assert not [element for element in tags(files) if element.tag.lower().endswith("script")]
    if text.isprintable():
        assert text in texts(files, "L-2")


@judged_by("autosar-data", "Whatever text or name a function has, its ARXML loads")
@pytest.mark.parametrize("name", [*HOSTILE, "x" * 5000, "class", "1st"])
def test_hostile_names_load_and_resolve(name):
    one = function(
        name, [signal(name, "Provider"), signal(f"{name}x")], contract={"MethodList": [METHOD | {"Name": name}]}
    )
    model = loaded(generate(derive([one]).model))
    assert dangling(model) == []
    assert doubled_names(model) == []


@pytest.mark.parametrize("number", ["", "abc", "</V>", "1e999999999", "05", "1_0", "nan", "-0.5", "1e-5", "1/3"])
def test_scalings_and_conversions_that_are_no_numbers_do_no_harm(number):
    scaled = signal("S", Factor=number, Offset=number, VssPath=None)
    largest = 1.7976931348623157e308
    converted = at("Vehicle.A.B", ConversionFactor=number, ConversionOffset=number) | {"Max": largest}
    over = at("Vehicle.A.C", ConversionFactor="3.6", ConversionOffset="0") | {"Max": largest}
    assert dangling(loaded(generate(derive([function(signals=[scaled, converted, over])]).model))) == []


@judged_by("autosar-data", "Whatever text or name a function has, its ARXML loads")
@settings(max_examples=60)
@given(st.text(max_size=200), st.text(max_size=200), st.text(max_size=200))
def test_any_text_is_carried_and_any_name_has_a_place(name, path, text):
    one = function(
        name,
        [signal(text, VssPath=path or None, Description=text, Units=name), signal(name, "Provider", Variable=text)],
    )
    model = loaded(generate(derive([one]).model))
    assert dangling(model) == []
    assert doubled_names(model) == []
    assert misplaced(model) == []


# -- the command --------------------------------------------------------------------------------------------------


def test_the_command_writes_the_files(tmp_path):
    source = tmp_path / "integration.json"
    source.write_bytes(to_json(derive(examples()).model))
    assert main(["generate", "arxml", str(source), "-o", str(tmp_path / "out")]) == 0
    written = {path.name: path.read_bytes() for path in (tmp_path / "out").glob("*.arxml")}
    assert written == {file.name: file.data for file in made("examples")}


def test_the_command_refuses_what_is_no_integration(tmp_path, capsys):
    source = tmp_path / "integration.json"
    source.write_text("{}", encoding="utf-8")
    assert main(["generate", "arxml", str(source), "-o", str(tmp_path / "out")]) == 1
    assert "F002" in capsys.readouterr().err
    assert main(["generate", "arxml", str(tmp_path / "none.json"), "-o", str(tmp_path / "out")]) == 2


def test_the_command_writes_a_release_that_is_asked_for(tmp_path, capsys):
    source = tmp_path / "integration.json"
    source.write_bytes(to_json(derive(examples()).model))
    assert main(["generate", "arxml", str(source), "-o", str(tmp_path / "out"), "--release", "R22-11"]) == 0
    written = {path.name: path.read_bytes() for path in (tmp_path / "out").glob("*.arxml")}
    assert written == {file.name: file.data for file in made("examples", "R22-11")}
    with pytest.raises(SystemExit, match="2"):
        main(["generate", "arxml", str(source), "-o", str(tmp_path / "out"), "--release", "R19-11"])
    assert "R20-11" in capsys.readouterr().err


# -- the report ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("part", TABLES)
def test_each_field_of_the_document_has_a_place_in_the_arxml(part):
    parts = [f".{each.__name__}" for each in TABLES]
    inner = {
        name
        for name, info in part.model_fields.items()
        if any(f"{each}, ...]" in str(info.annotation) or f"{each} |" in str(info.annotation) for each in parts)
        or info.annotation in TABLES
    }
    wanted = {info.alias for name, info in part.model_fields.items()}
    held = {part.model_fields[name].alias for name in inner}
    assert wanted - held <= TABLES[part][1].keys() <= wanted


def test_no_value_of_the_document_is_lost():
    model = derive(examples()).model.model_copy(update={"functions": None})
    written = b"".join(file.data for file in generate(model)).decode()
    texts = html.unescape(written)
    assert [text for text in leaves(json.loads(to_json(model))) if text not in texts] == []


ELSEWHERE = {"Class", "HeaderFolders", "Release", "Transformation"}
"""Fields whose words are other ones in ARXML: categories, the schema, byte orders; or that it has no place for."""


def leaves(value):
    if isinstance(value, dict):
        return [text for key, inner in value.items() if key not in ELSEWHERE for text in leaves(inner)]
    if isinstance(value, list):
        return [text for inner in value for text in leaves(inner)]
    return [str(value).lower() if isinstance(value, bool) else str(value)] if value not in (None, "") else []


def test_what_a_call_makes_of_a_value_stands_in_admin_data():
    value = at(
        "Vehicle.A.B", Timeout="150", TimeoutError="Demo_Late_ErrorSts", RangeErrorAction="Init", Variable="bus.b"
    )
    value |= {"ConversionFactor": "5/18", "ConversionOffset": "0"}
    written = {file.name: file.data.decode() for file in generate(derive([function(signals=[value])]).model)}
    for key, text in (("Timeout", "150"), ("RangeErrorAction", "Init"), ("Variable", "bus.b"), ("ConversionFactor", "5/18")):  # fmt: skip
        assert f'<SD GID="A_B.Demo_Step.{key}">{text}</SD>' in written["components.arxml"]


def test_the_command_reports_where_each_field_went(tmp_path):
    (tmp_path / "integration.json").write_bytes(to_json(derive(examples()).model))
    report = tmp_path / "report.json"
    arguments = ["generate", "arxml", str(tmp_path / "integration.json"), "-o", str(tmp_path / "out")]
    assert main([*arguments, "--report", str(report)]) == 0
    rows = json.loads(report.read_text(encoding="utf-8"))
    assert {"event", "call", "parameter", "service"} <= {row["kind"] for row in rows}
    assert [row for row in rows if row["target"] == "not carried"] == []
