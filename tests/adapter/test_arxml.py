"""An integration becomes ARXML of a release of AUTOSAR adaptive."""

import pytest

from sigcat.adapter.autosar_adaptive.arxml.adaptive_arxml import generate
from sigcat.integration.autosar_adaptive.deployment.releases import RELEASES
from tests.adapter.arxml_made import document, every_kind, made, refused, tags, texts
from tests.adapter.arxml_requirements import (
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
from tests.integration.autosar_adaptive.sets import at, deployed, derive, examples, function
from tests.reference_tools import checked_with

RANGES = {"SERVICE-INTERFACE-ID": (1, 0xFFFD), "SERVICE-INSTANCE-ID": (1, 0xFFFE), "EVENT-ID": (0x8000, 0xFFFE),
          "METHOD-ID": (1, 0x7FFF), "EVENT-GROUP-ID": (1, 0xFFFE)}  # fmt: skip


SETS = pytest.mark.parametrize("name", ["examples", "every kind"])


EACH_RELEASE = pytest.mark.parametrize("release", RELEASES)

# -- as AUTOSAR has it ---------------------------------------------------------------------------------------------------


@checked_with(
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


@checked_with("autosar-data", "ARXML stays the same when it is read and written again")
@SETS
def test_the_files_survive_a_round_trip(name):
    files = made(name)
    assert files
    for file in files:
        again = loaded([file]).serialize_files()[file.name]
        assert again.rstrip("\n") == file.data.decode().rstrip("\n")


def test_the_check_of_order_finds_errors():
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


# -- what an integrator looks for ----------------------------------------------------------------------------------------


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
    """Texts of the contents of an element, by tag."""
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


HEIGHTS = {"typeRef": "DT_Heights", "category": "userdefined", "cDef": "float[1000]", "Kind": "array", "Length": 1000,
           "ElementType": "DT_Float32"}  # fmt: skip


@EACH_RELEASE
def test_messages_of_a_service_are_sent_as_the_deployment_says(release):
    long = {**at("Vehicle.Heights", "Provider"), "Datatype": "DT_Heights", "VssDatatype": "float[1000]"}
    chosen = {"protocol": "TCP", "multicast": {"threshold": 2, "address": "239.1.2.3", "port": 30500}}
    derived = derive(
        [function(signals=[long, at("Vehicle.Speed")], datatypes=[HEIGHTS])],
        deployed(autosarAdaptive={"transport": {"DemoService": chosen}}),
    )
    files = generate(derived.model, release)
    assert texts(files, "TRANSPORT-PROTOCOL") == ["TCP", "UDP"]
    assert texts(files, "MULTICAST-THRESHOLD") == ["2"]
    assert texts(files, "IPV-4-MULTICAST-IP-ADDRESS") == ["239.1.2.3"]
    assert texts(files, "EVENT-MULTICAST-UDP-PORT") == ["30500"]
    assert texts(files, "MAXIMUM-SEGMENT-LENGTH") == []
    assert "A024" not in {each.rule for each in derived.findings}
    model = loaded(files)
    assert (dangling(model), misplaced(model)) == ([], [])


@EACH_RELEASE
def test_an_event_that_is_longer_than_a_datagram_is_sent_in_segments(release):
    long = {**at("Vehicle.Heights"), "Datatype": "DT_Heights", "VssDatatype": "float[1000]"}
    derived = derive([function(signals=[long, at("Vehicle.Speed")], datatypes=[HEIGHTS])])
    files = generate(derived.model, release)
    assert texts(files, "MAXIMUM-SEGMENT-LENGTH") == ["1392"]
    model = loaded(files)
    assert (dangling(model), misplaced(model)) == ([], [])
    (finding,) = [each for each in derived.findings if each.rule == "A024"]
    assert "4,004 bytes" in finding.message
