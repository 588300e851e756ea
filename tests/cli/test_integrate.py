"""`sigcat integrate` and `sigcat schema`, as people type them."""

import json
from pathlib import Path

import jsonschema_rs
import pytest

from sigcat.cli import main
from sigcat.data import EXAMPLES, ROOT_FILE
from sigcat.platforms.schemas import SCHEMAS
from sigcat.platforms.table import PLATFORMS

CORE_ACC = str(EXAMPLES / "core_acc" / "function.yaml")
MPC = str(EXAMPLES / "eco_control_mpc" / "function.yaml")


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def written(name):
    return json.loads(Path(name).read_text(encoding="utf-8"))


@pytest.mark.parametrize("platform", PLATFORMS)
def test_a_set_of_functions_becomes_one_document_and_a_report(platform, capsys):
    assert main(["integrate", platform, CORE_ACC, MPC, "-o", "out.json", "--report", "report.md"]) == 0
    names = ("CoreAcc", "EcoControlMpc")
    assert [name for name in names if f'"{name}"' not in json.dumps(written("out.json"))] == []
    assert Path("report.md").read_text(encoding="utf-8").startswith("| function | interface |")
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize("platform", PLATFORMS)
def test_a_function_json_gives_the_same_as_its_declaration(platform):
    assert main(["function", "build", CORE_ACC, "-o", "function.json"]) == 0
    assert main(["integrate", platform, CORE_ACC, "-o", "one.json"]) == 0
    assert main(["integrate", platform, "function.json", "-o", "two.json"]) == 0
    assert Path("one.json").read_bytes() == Path("two.json").read_bytes()


def test_findings_go_to_standard_error_and_the_document_to_standard_output(capsys):
    assert main(["integrate", "ros2", CORE_ACC]) == 0
    output = capsys.readouterr()
    assert json.loads(output.out)["FunctionInfo"]["FunctionName"] == "CoreAcc"
    assert "info N202 CoreAcc_Step" in output.err


def test_a_report_can_be_json():
    assert main(["integrate", "ros2", CORE_ACC, "-o", "out.json", "--report", "report.json"]) == 0
    assert {"function", "interface", "kind", "field", "target"} <= set(written("report.json")[0])


def test_ids_are_those_of_an_id_catalogue_and_of_earlier_arxml():
    Path("ids.csv").write_text("name,id\nVehicleChassisService,0x1234\n")
    assert main(["integrate", "autosar-adaptive", CORE_ACC, "--identifiers", "ids.csv", "-o", "one.json"]) == 0
    chassis = [s for s in written("one.json")["ComponentList"][0]["ServiceInterfaceList"] if "Chassis" in s["Name"]]
    assert [service["ServiceID"] for service in chassis] == [0x1234]
    assert main(["generate", "arxml", "one.json", "-o", "arxml"]) == 0
    earlier = str(Path("arxml") / "deployment.arxml")
    assert main(["integrate", "autosar-adaptive", CORE_ACC, "--identifiers", earlier, "-o", "two.json"]) == 0
    assert Path("one.json").read_bytes() == Path("two.json").read_bytes()


def test_an_id_catalogue_that_is_none_is_refused_at_its_line(capsys):
    Path("ids.csv").write_text("name,id\nVehicleChassisService,many\n")
    assert main(["integrate", "autosar-adaptive", CORE_ACC, "--identifiers", "ids.csv"]) == 1
    assert "ids.csv:2:1: error A009" in capsys.readouterr().err
    assert main(["integrate", "autosar-adaptive", CORE_ACC, "--identifiers", "none.csv"]) == 2


def test_a_deployment_file_changes_what_it_names():
    Path("deployment.yaml").write_text("name: EcoControl\nros2: {namespace: /ego}\n")
    assert main(["integrate", "ros2", CORE_ACC, "--deployment", "deployment.yaml", "-o", "out.json"]) == 0
    assert written("out.json")["FunctionInfo"]["FunctionName"] == "EcoControl"
    node = written("out.json")["NodePackageList"][0]["Nodes"][0]
    assert node["Namespace"] == "/ego"


def test_a_misspelled_key_of_a_deployment_is_refused_with_its_line(capsys):
    Path("deployment.yaml").write_text("name: EcoControl\nros2:\n  namespac: /ego\n")
    assert main(["integrate", "ros2", CORE_ACC, "--deployment", "deployment.yaml", "-o", "out.json"]) == 1
    assert "deployment.yaml:3" in capsys.readouterr().err
    assert not Path("out.json").exists()


def test_a_missing_file_is_said(capsys):
    assert main(["integrate", "ros2", "nothing.yaml"]) == 2
    assert "nothing.yaml: there is no such file" in capsys.readouterr().err


def test_a_function_given_twice_is_refused(capsys):
    assert main(["integrate", "ros2", CORE_ACC, CORE_ACC]) == 2
    assert "CoreAcc is named twice, as " in capsys.readouterr().err


def test_a_document_with_errors_is_not_written(capsys):
    assert main(["function", "build", CORE_ACC, "-o", "function.json"]) == 0
    Path("function.json").write_text(Path("function.json").read_text().replace('"uint8_t"', '"no_type"'))
    assert main(["integrate", "ros2", "function.json", "-o", "out.json"]) == 1
    assert "error" in capsys.readouterr().err
    assert not Path("out.json").exists()


@pytest.mark.parametrize("name", SCHEMAS)
def test_every_format_has_a_schema(name, capsys):
    assert main(["schema", name]) == 0
    schema = json.loads(capsys.readouterr().out)
    assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    jsonschema_rs.meta.validate(schema)


@pytest.fixture(scope="module")
def documents(tmp_path_factory):
    """A folder with the Function JSON of a function, and its Integration JSON for each platform."""
    folder = tmp_path_factory.mktemp("documents")
    assert main(["function", "build", CORE_ACC, "-o", str(folder / "function.json")]) == 0
    for platform in PLATFORMS:
        assert main(["integrate", platform, CORE_ACC, "-o", str(folder / f"{platform}.json")]) == 0
    return folder


@pytest.mark.parametrize(
    ("command", "kind"),
    [
        (("generate", "arxml", "function.json", "-o", "out"), "Function JSON"),
        (("generate", "arxml", "ros2.json", "-o", "out"), "Integration JSON for ROS 2"),
        (("generate", "ros2", "autosar-adaptive.json", "-o", "out"), "Integration JSON for AUTOSAR adaptive"),
        (("integrate", "ros2", "autosar-adaptive.json"), "Integration JSON for AUTOSAR adaptive"),
        (("integrate", "ros2", str(ROOT_FILE)), "a vspec file"),
        (("function", "build", str(ROOT_FILE)), "a vspec file"),
    ],
)
def test_a_document_of_another_kind_is_one_finding_that_says_what_it_is(command, kind, documents, monkeypatch, capsys):
    monkeypatch.chdir(documents)
    assert main(list(command)) == 1
    told = [line for line in capsys.readouterr().err.splitlines() if not line.startswith("  ")]  # but for excerpts
    assert len(told) == 2
    assert f", not {kind}." in told[0]
