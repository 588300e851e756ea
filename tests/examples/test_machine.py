"""The templates of a machine complete the generated ARXML of EcoControl: nothing is missing, and every reference leads to an element."""

import pytest

from sigcat.adapter.files import GeneratedFile
from sigcat.data import EXAMPLES
from tests.adapter.arxml_requirements import VERSIONS, dangling, doubled_names, loaded, misplaced, version_of

FOLDERS = (EXAMPLES / "ecocontrol/expected/arxml", EXAMPLES / "ecocontrol/machine")


@pytest.fixture(scope="module")
def model():
    """The generated files and the templates, together."""
    paths = [path for folder in FOLDERS for path in sorted(folder.glob("*.arxml"))]
    return loaded([GeneratedFile(path.name, path.read_bytes()) for path in paths])


def paths(model, *kinds):
    """Paths of the elements of these kinds."""
    return {path for path, each in model.identifiable_elements if each.element_name in kinds}


def referred(model, tag):
    """Paths that references of a kind lead to."""
    return {each.character_data for _, each in model.elements_dfs if each.element_name == tag}


def test_the_set_is_right_under_the_metamodel(model):
    assert version_of(model) == VERSIONS["R23-11"]
    assert (dangling(model), misplaced(model), doubled_names(model)) == ([], [], [])


def test_every_process_and_every_service_instance_is_on_the_machine(model):
    instances = paths(model, "PROVIDED-SOMEIP-SERVICE-INSTANCE", "REQUIRED-SOMEIP-SERVICE-INSTANCE")
    mapped = {
        each.character_data
        for path, mapping in model.identifiable_elements
        if mapping.element_name == "SOMEIP-SERVICE-INSTANCE-TO-MACHINE-MAPPING"
        for _, each in mapping.elements_dfs
        if each.element_name == "SERVICE-INSTANCE-REF"
    }
    assert instances == mapped
    placed = {
        each.character_data
        for path, mapping in model.identifiable_elements
        if mapping.element_name == "PROCESS-TO-MACHINE-MAPPING"
        for _, each in mapping.elements_dfs
        if each.element_name == "PROCESS-REF"
    }
    assert placed == paths(model, "PROCESS")


def test_every_storage_and_every_monitor_has_its_mapping(model):
    storages = paths(model, "PERSISTENCY-KEY-VALUE-STORAGE")
    assert storages == referred(model, "KEY-VALUE-STORAGE-REF")
    assert len(storages) == len(paths(model, "PERSISTENCY-KEY-VALUE-STORAGE-INTERFACE"))
    monitors = {path for path in paths(model, "R-PORT-PROTOTYPE") if path.endswith("_Monitor")}
    assert monitors <= referred(model, "TARGET-R-PORT-PROTOTYPE-REF")
