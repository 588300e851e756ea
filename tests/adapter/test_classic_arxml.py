"""An integration becomes ARXML of a release of AUTOSAR Classic."""

import json
from functools import cache

import pytest
from autosar_data import AutosarVersion

from sigcat.adapter.autosar_classic.arxml.classic_arxml import PLATFORM_FILE, generate
from sigcat.adapter.autosar_classic.arxml.field_targets import TABLES
from sigcat.errors import InputRefused
from sigcat.function.function_json.wire import written
from sigcat.integration.autosar_classic.classic_integration import derive
from sigcat.integration.autosar_classic.deployment.releases import RELEASES
from sigcat.integration.autosar_classic.deployment.settings import NO_SETTINGS, AutosarClassicSettings
from sigcat.integration.autosar_classic.document import read_integration
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT
from tests.adapter import arxml_made
from tests.adapter.arxml_made import COLOURS, METHOD, lost, tags
from tests.adapter.arxml_requirements import dangling, doubled_names, loaded, misplaced, version_of
from tests.adapter.ecuc_definitions import definitions, wrong_values
from tests.function.shipped import resolved
from tests.integration.autosar_adaptive.sets import at, examples, function, parameter, signal
from tests.reference_tools import checked_with

VERSIONS = {"4.4.0": AutosarVersion.AUTOSAR_00046, "R23-11": AutosarVersion.AUTOSAR_00052}
ROOT = "/CoreAcc_and_EcoControlMpc_and_WheelSpeedCalculation"

POINT = arxml_made.POINT | {"Fields": [arxml_made.POINT["Fields"][0], {"Name": "IsValid", "Datatype": "DT_Bool"}]}
POINTS = arxml_made.POINTS | {"cDef": "struct Point", "Length": 3}
"""As those of the adaptive platform, without what grows: no RTE has it."""


def every_kind():
    """A function with every kind of datatype and element."""
    return function(
        "Demo",
        [
            signal("Points", "Provider", Datatype="DT_Points", VssPath="Vehicle.A.Points", VssDatatype="Types.Point[]"),
            signal("Colour", Datatype="DT_Colour", VssPath="Vehicle.A.Colour", VssDatatype="string", InitValue=7),
            at("Vehicle.B.Speed", Timeout="150", TimeoutError="Demo_Late_ErrorSts"),
        ],
        [POINT, POINTS, COLOURS],
        contract={"MethodList": [METHOD], "ParameterList": [parameter()]},
    )


def integrated(functions, settings=NO_SETTINGS):
    return derive([resolved(each) for each in functions], DEFAULT_DEPLOYMENT, settings)[0]


@cache
def document(name):
    return integrated(examples() if name == "examples" else (every_kind(),))


@cache
def made(name, release="R23-11"):
    return generate(document(name), release)


def model_of(files):
    """The files with the definitions of parameters, which every vendor has."""
    return loaded((*files, definitions(version_of(loaded(files)))))


SETS = pytest.mark.parametrize("name", ["examples", "every kind"])
EACH_RELEASE = pytest.mark.parametrize("release", RELEASES)


def values(model, path):
    """Texts of the elements below a path, by element; of several the last one."""
    found = model.get_element_by_path(path)
    return {e.element_name: str(e.character_data) for _, e in found.elements_dfs if e.character_data is not None}


# -- as AUTOSAR has it ------------------------------------------------------------------------------------------------


@checked_with(
    "autosar-data",
    "ARXML loads strictly, its references lead somewhere, its elements have the order of the metamodel of their release",
)
@SETS
@EACH_RELEASE
def test_the_files_are_right_under_the_metamodel_of_their_release(name, release):
    files = made(name, release)
    model = model_of(files)
    assert version_of(model) == VERSIONS[release]
    assert dangling(model) == []
    assert misplaced(model) == []
    assert doubled_names(loaded(files)) == []


@SETS
@EACH_RELEASE
def test_nothing_in_the_files_is_of_the_adaptive_platform_alone(name, release):
    model = loaded(made(name, release))
    restricted = {e.element_name for _, e in model.elements_dfs if e.element_type.std_restriction == "AdaptivePlatform"}
    assert restricted == set()


@SETS
def test_every_value_of_the_configuration_is_of_the_kind_of_its_definition(name):
    files = made(name)
    assert wrong_values(model_of(files)) == []
    text = next(file for file in files if file.name == "configuration.arxml").data.decode()
    spoiled = text.replace(">FULL<", ">SOMETIMES<").replace("RteMappedToTaskRef<", "RteMappedToTask<")
    others = [file for file in files if file.name != "configuration.arxml"]
    with pytest.raises(AssertionError):
        assert wrong_values(model_of([*others, files[0]._replace(name="configuration.arxml", data=spoiled.encode())])) == []  # fmt: skip


@checked_with("autosar-data", "ARXML stays the same when it is read and written again")
@SETS
def test_the_files_survive_a_round_trip(name):
    for file in made(name):
        again = loaded([file]).serialize_files()[file.name]
        assert again.rstrip("\n") == file.data.decode().rstrip("\n")


def test_the_same_model_gives_the_same_bytes():
    assert generate(document("examples"), "R23-11") == made("examples")


def test_the_release_is_that_of_the_deployment_or_the_one_that_is_asked_for():
    older = integrated((every_kind(),), AutosarClassicSettings.model_validate({"release": "4.4.0"}))
    assert {b"AUTOSAR_00046.xsd" in file.data for file in generate(older)} == {True}
    assert {b"AUTOSAR_00052.xsd" in file.data for file in generate(older, "R23-11")} == {True}


# -- what an RTE generator looks for ----------------------------------------------------------------------------------


def test_the_files_are_those_that_integrators_expect():
    assert [file.name for file in made("examples")] == [
        PLATFORM_FILE, "types.arxml", "interfaces.arxml", "components.arxml", "composition.arxml", "system.arxml",
        "diagnosis.arxml", "configuration.arxml",
    ]  # fmt: skip


def test_platform_types_are_where_every_vendor_has_them():
    model = loaded([file for file in made("every kind") if file.name == PLATFORM_FILE])
    found = values(model, "/AUTOSAR_Platform/ImplementationDataTypes/float32")
    assert found["BASE-TYPE-REF"] == "/AUTOSAR_Platform/BaseTypes/float32"
    assert found["TYPE-EMITTER"] == "Platform_Type"
    assert values(model, "/AUTOSAR_Platform/BaseTypes/float32")["BASE-TYPE-ENCODING"] == "IEEE754"


@SETS
def test_every_event_starts_a_runnable_and_is_mapped_to_a_task(name):
    model, integration = loaded(made(name)), document(name)
    for component in integration.components:
        for event in component.events:
            path = f"{model_root(integration)}/ComponentTypes/{component.name}/{component.name}_Behavior/{event.name}"
            users = [each.parent.element_name for each in model.get_references_to(path)]
            assert "ECUC-REFERENCE-VALUE" in users, path
            assert values(model, path)["START-ON-EVENT-REF"].endswith(f"/{event.runnable}")


def model_root(integration):
    return f"/{integration.deployment.package}"


@SETS
def test_every_required_port_is_connected_or_of_the_base_software(name):
    model, integration = loaded(made(name)), document(name)
    for component in integration.components:
        for port in component.ports:
            path = f"{model_root(integration)}/ComponentTypes/{component.name}/{port.name}"
            users = {each.parent.element_name for each in model.get_references_to(path)}
            connected = {"PROVIDER-IREF", "REQUESTER-IREF", "R-PORT-IN-COMPOSITION-INSTANCE-REF",
                         "P-PORT-IN-COMPOSITION-INSTANCE-REF"}  # fmt: skip
            assert bool(users & connected) != bool(port.service), path


@SETS
def test_ports_that_are_connected_have_one_interface(name):
    model = loaded(made(name))
    for _, element in model.elements_dfs:
        if element.element_name == "ASSEMBLY-SW-CONNECTOR":
            ends = [e.reference_target for _, e in element.elements_dfs if e.element_name.startswith("TARGET-")]
            interfaces = {
                str(child.character_data)
                for end in ends for child in end.sub_elements if child.element_name.endswith("INTERFACE-TREF")
            }  # fmt: skip
            assert len(interfaces) == 1


def test_a_cyclic_call_has_its_period_its_task_and_an_alarm():
    model = loaded(made("examples"))
    behavior = f"{ROOT}/ComponentTypes/CoreAcc/CoreAcc_Behavior"
    timing = [e for _, e in model.get_element_by_path(behavior).elements_dfs if e.element_name == "TIMING-EVENT"]
    assert timing
    cycle, tick = 0.05, 0.001  # at each tick, windows of supervision are evaluated
    assert {float(values(model, each.path)["PERIOD"]) for each in timing} == {cycle, tick}
    mapping = next(each for each in model.get_references_to(timing[0].path)).named_parent
    used = [str(e.character_data) for _, e in mapping.elements_dfs if e.element_name == "VALUE-REF"]
    assert any("/Os/Task_Cycle_" in path for path in used)
    assert any("/Os/Alarm_" in path for path in used)


def test_init_of_every_component_is_run_by_the_batch_and_by_no_task():
    model = loaded(made("examples"))
    for name in ("CoreAcc", "EcoControlMpc"):
        event = f"{ROOT}/ComponentTypes/{name}/{name}_Behavior/OnInit"
        mapping = next(
            each for each in model.get_references_to(event) if each.named_parent.item_name == "OnInit_Mapping"
        ).named_parent
        used = [str(e.character_data) for _, e in mapping.elements_dfs if e.element_name == "VALUE-REF"]
        assert [path.rpartition("/")[2] for path in used if path != event] == ["InitComponents"]


def test_values_before_the_first_one_are_what_their_types_mean():
    model = loaded(made("every kind"))
    colour = port_with(model, "A_Colour")
    assert "<VT>GREEN</VT>" in colour.serialize()
    points = port_with(model, "A_Points").serialize()
    assert points.count("<RECORD-VALUE-SPECIFICATION>") == 3


def port_with(model, text):
    return next(
        e for _, e in model.elements_dfs
        if e.element_name.endswith("-PORT-PROTOTYPE") and text in e.item_name and "COM-SPECS" in e.serialize()
    )  # fmt: skip


def test_com_checks_no_age_since_the_core_does():
    speed = port_with(loaded(made("every kind")), "B_Speed").serialize()
    assert "<ALIVE-TIMEOUT>0</ALIVE-TIMEOUT>" in speed.replace("0.0", "0")
    assert "<ENABLE-UPDATE>true</ENABLE-UPDATE>" in speed
    assert "<HANDLE-TIMEOUT-TYPE>NONE</HANDLE-TIMEOUT-TYPE>" in speed


def test_an_error_is_an_event_of_the_dem_that_does_not_debounce_it():
    model = loaded(made("examples"))
    events = [e for _, e in model.elements_dfs if e.element_name == "DIAGNOSTIC-EVENT-NEEDS"]
    assert events
    assert all("DIAG-EVENT-DEBOUNCE-MONITOR-INTERNAL" in each.serialize() for each in events)
    assert {each.item_name for each in events} == {
        e.item_name for _, e in model.elements_dfs if e.element_name == "DIAGNOSTIC-EVENT"
    }


def test_what_is_kept_is_a_block_of_the_nvram_manager_over_a_memory_of_the_component():
    model = loaded(made("examples"))
    block = next(e for _, e in model.elements_dfs if e.element_name == "NV-BLOCK-NEEDS")
    dependency = block.named_parent
    found = values(model, dependency.path)
    assert found["USED-PIM-REF"].endswith("/Stored")
    assert (found["RESTORE-AT-START"], found["STORE-AT-SHUTDOWN"]) == ("true", "true")
    assert "<ROLE>NvMService</ROLE>" in dependency.serialize()


def test_a_runnable_is_in_the_section_that_the_code_names():
    """The RTE declares it between `Component_START_SEC_NAME` and `_STOP_SEC_`, with the name of the method."""
    model = loaded(made("examples"))
    methods = {str(e.character_data) for _, e in model.elements_dfs if e.element_name == "SW-ADDR-METHOD-REF"}
    assert methods
    assert {path.rpartition("/")[2] for path in methods} <= {
        section.name for component in document("examples").components for section in component.sections
    }


def test_names_of_two_enumerations_cannot_clash_in_the_code_of_a_component():
    integration = document("examples")
    prefixes = {each.name: each.literal_prefix for each in integration.implementation_types if each.compu_method}
    assert set(prefixes.values()) == {f"{name}_" for name in prefixes}
    text = b"".join(file.data for file in generate(integration)).decode()
    assert all(f"<LITERAL-PREFIX>{prefix}</LITERAL-PREFIX>" in text for prefix in prefixes.values())


def test_the_ecu_extract_maps_every_component_to_the_ecu():
    model, integration = loaded(made("examples")), document("examples")
    mapping = next(e for _, e in model.elements_dfs if e.element_name == "SWC-TO-ECU-MAPPING")
    targets = [str(e.character_data) for _, e in mapping.elements_dfs if e.element_name == "TARGET-COMPONENT-REF"]
    assert len(targets) == len(integration.composition.prototypes)
    assert "<CATEGORY>ECU_EXTRACT</CATEGORY>" in mapping.parent.parent.parent.parent.serialize()


# -- nothing is lost --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("part", TABLES)
def test_each_field_of_the_document_has_a_place_in_the_arxml(part):
    parts = {each.__name__ for each in TABLES}
    inner = {
        name
        for name, info in part.model_fields.items()
        if any(word in parts for word in str(info.annotation).replace("[", " ").replace(",", " ").replace(".", " ").replace("'", " ").replace(">", " ").split())
    }  # fmt: skip
    wanted = {info.alias for info in part.model_fields.values()}
    held = {part.model_fields[name].alias for name in inner}
    assert wanted - held <= TABLES[part][1].keys() <= wanted


ELSEWHERE = {"Kind", "Direction", "Category", "Alignment", "Mask", "Activation", "Release", "Moment", "ServiceKind",
             "Preemptable", "Tick", "ExpectedIndications", "Queued", "Element", "Length", "Factor", "Offset"}  # fmt: skip
"""Fields whose values are other words or numbers in ARXML."""


@SETS
def test_no_value_of_the_document_is_lost(name):
    integration = document(name).model_copy(update={"functions": None})
    assert lost(written(integration), generate(integration), ELSEWHERE) == []


def test_a_document_that_was_written_is_read_and_gives_the_same_files():
    again = read_integration(written(document("examples")), "integration.json")
    assert generate(again, "R23-11") == made("examples")


# -- documents that were edited -----------------------------------------------------------------------------------------


def places(value, above=()):
    """Pointers to what a document has, and the values there."""
    yield above, value
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, each in inner:
        yield from places(each, (*above, key))


def spoiled(value):
    """A document with one thing wrong, of each kind of place once or more: a name that is none, one thing twice or away."""
    seen = set()
    for place, content in places(value):
        kind = tuple(key if isinstance(key, str) else 0 for key in place)
        if not place or kind in seen:
            continue
        seen.add(kind)
        for other in others(content):
            copied = json.loads(json.dumps(value))
            holder = copied
            for key in place[:-1]:
                holder = holder[key]
            holder[place[-1]] = other
            yield "/".join(map(str, place)), copied


def others(content):
    if isinstance(content, list) and content:
        yield from ([], [*content, content[0]])
    elif isinstance(content, str):
        yield "Nowhere"
    elif isinstance(content, int | float) and not isinstance(content, bool):
        yield -1


def test_a_document_that_is_wrong_somewhere_is_refused_with_findings_or_gives_files_that_are_right():
    wrong = []
    for place, value in spoiled(json.loads(written(document("every kind").model_copy(update={"functions": None})))):
        try:
            files = generate(read_integration(json.dumps(value).encode(), "integration.json"))
        except InputRefused as refused:
            wrong += [] if refused.findings else [place]
            continue
        if dangling(model_of(files)) or doubled_names(loaded(files)):
            wrong.append(place)
    assert wrong == []


# -- texts that want to get out ---------------------------------------------------------------------------------------


@checked_with("autosar-data", "ARXML loads for any text or name of a function")
@pytest.mark.parametrize(
    "text", ['"><script>alert(1)</script>', "*/ #include <x>", "]]><!--", "\u0000\u0001", "\ufffe", "été 🚗", "x" * 5000,
             "class", "1st", "Demo", "Init"]
)  # fmt: skip
def test_hostile_texts_stay_texts_and_hostile_names_resolve(text):
    one = function(
        text,
        [signal(text, "Provider", Description=text, Units=text), signal(f"{text}x", VssPath=f"Vehicle.A.{text}")],
        contract={"MethodList": [METHOD | {"Name": text, "Description": text}]},
    )
    files = generate(integrated([one]))
    model = model_of(files)
    assert dangling(model) == []
    assert doubled_names(loaded(files)) == []
    assert not [element for element in tags(files) if element.tag.lower().endswith("script")]


# -- end-to-end protection --------------------------------------------------------------------------------------------


STATES = ("INIT", "INVALID", "VALID")


def protected(windows=None):
    """A function with a protected signal, and the windows of a deployment."""
    speed = at("Vehicle.Speed", E2eError="Demo_Late_ErrorSts")
    settings = AutosarClassicSettings.model_validate({"e2e": windows or {}})
    return integrated((function("Demo", [speed]),), settings)


@EACH_RELEASE
def test_a_protected_port_has_the_option_and_the_windows_of_its_state_machine(release):
    wide = {name: {"windowSize": 5, "minOkState": 3, "maxErrorState": 1} for name in ("init", "valid", "invalid")}
    files = generate(protected(wide), release)
    model = model_of(files)
    assert (dangling(model), misplaced(model)) == ([], [])
    component = "/Demo/ComponentTypes/Demo"
    found = values(model, f"{component}/Vehicle_Speed")
    sizes = {"WINDOW-SIZE": "5"} if release == "4.4.0" else {f"WINDOW-SIZE-{each}": "5" for each in STATES}
    expected = {
        **{f"MAX-ERROR-STATE-{each}": "1" for each in STATES}, **{f"MIN-OK-STATE-{each}": "3" for each in STATES}, **sizes,
    }  # fmt: skip
    assert {name: text for name, text in found.items() if "STATE" in name or "WINDOW" in name} == expected
    options = values(model, f"{component}/Demo_Behavior")
    assert options["ERROR-HANDLING"] == "TRANSFORMER-ERROR-HANDLING"
    assert options["PORT-REF"] == f"{component}/Vehicle_Speed"


def test_windows_of_several_sizes_are_refused_in_a_release_with_one():
    model = protected({"valid": {"windowSize": 3}})
    assert generate(model, "R23-11")
    with pytest.raises(InputRefused) as refused:
        generate(model, "4.4.0")
    (finding,) = refused.value.findings
    assert (finding.rule, finding.pointer) == ("K011", "/Components/0/Ports/3/Elements/0/E2eWindows")
    assert "one window for all states" in finding.message
