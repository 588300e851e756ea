"""Supervisions that the ARXML passes to the health management, and ports of the kind that its mappings require."""

import json

import pytest
from autosar_data import AutosarModel, Element

from sigcat.adapter.autosar_adaptive.application.report import report
from sigcat.adapter.autosar_adaptive.arxml.adaptive_arxml import generate
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.limits import DEFAULT_LIMITS
from tests.adapter.arxml_requirements import VERSIONS, dangling, doubled_names, loaded, misplaced
from tests.adapter.autosar_adaptive.application.generated import full_integration

MONITOR_PORT = "/Full/Components/Full/Full_Late_ErrorSts_Monitor"
ROOT = "/Full/Executables/FullExecutable/Full_Root"


def document(**error: object) -> bytes:
    """The function that uses everything; its alive supervision has an error with these properties."""
    found = json.loads(full_integration())
    changed = [each for each in _errors(found["ComponentList"]) if each["Name"] == "Full_Alive_ErrorSts"]
    assert changed
    for each in changed:
        each.update(error)
    return json.dumps(found).encode()


def _errors(part: object) -> list[dict[str, object]]:
    if isinstance(part, list):
        return [each for item in part for each in _errors(item)]
    if not isinstance(part, dict):
        return []
    own = [part] if "MaturationTime" in part else []
    return own + [each for item in part.values() for each in _errors(item)]


def arxml(data: bytes, release: str = "R23-11") -> AutosarModel:
    return loaded(generate(read_integration(data, "integration.json", DEFAULT_LIMITS), release))


def all_of(model: AutosarModel, name: str) -> list[Element]:
    return [element for _, element in model.elements_dfs if element.element_name == name]


def texts(element: Element) -> dict[str, object]:
    return {child.element_name: child.character_data for child in element.sub_elements}


@pytest.mark.parametrize("release", VERSIONS)
def test_an_alive_supervision_that_is_final_has_its_limits_there(release):
    """One to three ends of the step in two cycles of 50 ms."""
    model = arxml(document(Reset="Restart"), release)
    (alive,) = all_of(model, "ALIVE-SUPERVISION")
    said = texts(alive)
    assert float(str(said["ALIVE-REFERENCE-CYCLE"])) == 0.1
    limits = [int(str(said[name])) for name in ("EXPECTED-ALIVE-INDICATIONS", "MIN-MARGIN", "MAX-MARGIN")]
    assert limits == [2, 1, 1]
    assert dangling(model) == misplaced(model) == doubled_names(model) == []


def test_it_is_of_the_checkpoint_that_the_process_reports_and_active_where_the_call_runs():
    model = arxml(document(Reset="Restart"))
    (point,) = all_of(model, "SUPERVISION-CHECKPOINT")
    (declared,) = all_of(model, "PHM-CHECKPOINT")
    assert texts(point)["CHECKPOINT-ID"] == texts(declared)["CHECKPOINT-ID"]
    (state,) = [text for each in all_of(model, "FUNCTION-GROUP-STATE-IREF")[-1:] for text in [texts(each)]]
    assert str(state["TARGET-MODE-DECLARATION-REF"]).endswith("/Run")


def test_each_process_of_an_executable_is_supervised_for_itself():
    whole = json.loads(document(Reset="Restart"))
    instances = [{"Service": "FullService", "ServiceInstanceID": 3}]
    whole["ComponentList"][0]["Processes"] = [{"Name": "RearFull", "Instances": instances}]
    for release in VERSIONS:
        model = arxml(json.dumps(whole).encode(), release)
        assert dangling(model) == misplaced(model) == doubled_names(model) == []
        points = all_of(model, "SUPERVISION-CHECKPOINT")
        assert {texts(point)["PROCESS-REF"] for point in points} == {
            "/Full/Processes/FullProcess",
            "/Full/Processes/RearFull",
        }
        checked = [texts(alive)["CHECKPOINT-REF"] for alive in all_of(model, "ALIVE-SUPERVISION")]
        assert checked == [point.path for point in points]


@pytest.mark.parametrize("error", [{}, {"Reset": "Restart", "MaturationTime": 10}, {"Reset": "Vehicle.Full.Reset"}])
def test_one_whose_error_matures_or_heals_has_none(error):
    """There, an expired supervision stays expired, at once."""
    model = arxml(document(**error))
    assert all_of(model, "PLATFORM-HEALTH-MANAGEMENT-CONTRIBUTION") == []
    assert len(all_of(model, "PHM-CHECKPOINT")) == 1


@pytest.mark.parametrize(("reset", "said"), [(None, "has no limits for it"), ("Restart", "with the same limits")])
def test_the_report_tells_which(reset, said):
    entries = report(document(Reset=reset), "integration.json", DEFAULT_LIMITS)
    (alive,) = [each for each in entries if each.field == "SupervisionType Alive"]
    assert alive.target == "core and ara::phm::SupervisedEntity"
    assert said in alive.note


def test_the_diagnosis_maps_the_port_of_a_monitor():
    """The metamodel itself is asked: its mapping takes a required port, and finds ours."""
    model = arxml(full_integration())
    (mapping,) = model.root_element.sub_elements
    package = mapping.create_named_sub_element("AR-PACKAGE", "Machine").create_sub_element("ELEMENTS")
    own = package.create_named_sub_element("DIAGNOSTIC-MONITOR-PORT-MAPPING", "Late")
    place = own.create_sub_element("R-PORT-PROTOTYPE-IN-EXECUTABLE-IREF")
    for name, path in (
        ("CONTEXT-ROOT-SW-COMPONENT-PROTOTYPE-REF", ROOT),
        ("TARGET-R-PORT-PROTOTYPE-REF", MONITOR_PORT),
    ):
        target = model.get_element_by_path(path)
        assert target is not None
        place.create_sub_element(name).reference_target = target
    assert dangling(model) == []
