"""Functions in, Integration JSON out, over HTTP."""

import io
import json
import zipfile
from pathlib import Path

import pytest

from sigcat.adapter.core.core_files import runtime_files
from sigcat.api.application import create_app
from sigcat.api.settings import DEFAULT_SETTINGS
from sigcat.catalogue.hosting.library import Library, shipped_sources
from sigcat.data import EXAMPLES
from sigcat.platforms.schemas import SCHEMAS
from sigcat.platforms.table import PLATFORMS
from tests.api.conftest import asker

CORE_ACC = (EXAMPLES / "core_acc" / "function.yaml").read_text(encoding="utf-8")
FUNCTIONS = Path(__file__).parents[1] / "function"
MPC = (EXAMPLES / "eco_control_mpc" / "function.yaml").read_text(encoding="utf-8")

DISPLAY = """\
function: Display
description: Shows the torque.
responsible: Display team
define:
  scheduling: {Init: {description: Starts.}, Step: {cycleTime: 100, asil: B, description: Shows.}, Terminate: {description: Stops.}}
components:
  - name: Display
    runnables:
      - Display_Init
      - interface: Display_Step
        data: [{path: Vehicle.ADAS.LaneKeeping.Torque, role: consumed}]
      - Display_Terminate
"""


@pytest.fixture(scope="module")
def shipped():
    sources = [source for source in shipped_sources() if source.id == "interfaces"]
    return asker(create_app(Library(sources), DEFAULT_SETTINGS))


def posted(ask, address, body):
    text = body if isinstance(body, str | bytes) else json.dumps(body)
    return ask(address, "POST", content=text, headers={"content-type": "application/json"})


@pytest.mark.parametrize("platform", PLATFORMS)
def test_a_declaration_becomes_integration_json(shipped, platform):
    answer = posted(shipped, f"/api/v1/integrate/{platform}", CORE_ACC)
    assert answer.status_code == 200
    assert '"CoreAcc"' in json.dumps(answer.json())


@pytest.mark.parametrize("base", ["uint8x", "uint999999999", "sint999999999", "uint", "float128"])
@pytest.mark.parametrize("generator", ["autosar-classic", "classic-arxml"])
def test_a_datatype_that_no_platform_has_is_refused_before_its_range_is_computed(shipped, base, generator):
    document = posted(shipped, "/api/v1/integrate/autosar-classic", CORE_ACC).json()
    document["ImplementationTypes"][0]["Base"] = base
    answer = posted(shipped, f"/api/v1/generate/{generator}", document)
    assert answer.status_code == 422
    assert any("/ImplementationTypes/0" in finding["pointer"] for finding in answer.json()["findings"])


@pytest.mark.parametrize("platform", PLATFORMS)
def test_a_set_is_a_list_of_functions_of_either_kind(shipped, platform):
    built = posted(shipped, "/api/v1/functions/build", CORE_ACC).json()
    body = {"functions": [built, MPC], "deployment": {"name": "EcoControl"}}
    answer = posted(shipped, f"/api/v1/integrate/{platform}", body)
    assert answer.status_code == 200, answer.text
    assert [name for name in ("CoreAcc", "EcoControlMpc") if f'"{name}"' not in json.dumps(answer.json())] == []


def test_ids_come_from_the_texts_of_id_catalogues(shipped):
    body = {"functions": [CORE_ACC], "identifiers": ["name,id\nVehicleChassisService,0x4242\n", "name,id\nOther,5\n"]}
    services = posted(shipped, "/api/v1/integrate/autosar-adaptive", body)
    assert services.status_code == 200, services.text
    assert "16962" in services.text
    assert "16962" not in posted(shipped, "/api/v1/integrate/autosar-adaptive", CORE_ACC).text
    answer = posted(shipped, "/api/v1/generate/arxml", services.content)
    earlier = zipfile.ZipFile(io.BytesIO(answer.content)).read("deployment.arxml").decode()
    again = posted(shipped, "/api/v1/integrate/autosar-adaptive", {**body, "identifiers": [earlier]})
    assert again.json() == services.json()


@pytest.mark.parametrize(
    ("platform", "identifiers", "told"),
    [
        ("autosar-adaptive", ["name,id\nA,x\n"], "identifiers 1"),
        ("autosar-adaptive", ["name,id\nA,1\n", "name,id\nA,2\n"], "one id in all id catalogues"),
        ("autosar-adaptive", [{"A": 1}], "`identifiers`, a list of texts"),
        ("autosar-adaptive", "name,id", "`identifiers`, a list of texts"),
        ("ros2", ["name,id\nA,1\n"], "nothing else"),
    ],
)
def test_what_is_no_id_catalogue_is_told(shipped, platform, identifiers, told):
    answer = posted(shipped, f"/api/v1/integrate/{platform}", {"functions": [CORE_ACC], "identifiers": identifiers})
    assert answer.status_code == 422
    assert told in answer.text


def test_an_archive_has_the_report_and_the_findings_too(shipped):
    answers = [posted(shipped, "/api/v1/integrate/ros2/archive", CORE_ACC) for _ in range(2)]
    assert answers[0].content == answers[1].content
    archive = zipfile.ZipFile(io.BytesIO(answers[0].content))
    assert archive.namelist() == ["ros2.json", "ros2.report.json", "ros2.report.md", "ros2.findings.json"]
    assert json.loads(archive.read("ros2.findings.json"))[0]["rule"]


def test_arxml_is_an_archive(shipped):
    document = posted(shipped, "/api/v1/integrate/autosar-adaptive", CORE_ACC).content
    answer = posted(shipped, "/api/v1/generate/arxml", document)
    assert answer.status_code == 200, answer.text
    archive = zipfile.ZipFile(io.BytesIO(answer.content))
    assert archive.namelist()
    assert all(name.endswith(".arxml") for name in archive.namelist())


def test_an_application_is_an_archive_with_the_bench_on_request(shipped):
    document = posted(shipped, "/api/v1/integrate/autosar-adaptive", CORE_ACC).content
    plain, bench = (
        zipfile.ZipFile(io.BytesIO(posted(shipped, f"/api/v1/generate/autosar-adaptive{query}", document).content))
        for query in ("", "?bench=true")
    )
    assert "CoreAccExecutable/main.cpp" in plain.namelist()
    assert {name.partition("/")[0] for name in set(bench.namelist()) - set(plain.namelist())} == {
        "bench",
        "generated",
        "player",
    }


def test_packages_are_an_archive_of_the_distribution_that_is_asked_for(shipped):
    document = posted(shipped, "/api/v1/integrate/ros2", CORE_ACC).content
    jazzy, humble = (
        zipfile.ZipFile(io.BytesIO(posted(shipped, f"/api/v1/generate/ros2{query}", document).content))
        for query in ("", "?distribution=humble")
    )
    assert {name.partition("/")[0] for name in jazzy.namelist()} == {
        "README.md", "core_acc", "core_acc_interfaces", "core_acc_py",
    }  # fmt: skip
    assert [b"ROS 2 Jazzy" in jazzy.read("README.md"), b"ROS 2 Humble" in humble.read("README.md")] == [True, True]
    assert posted(shipped, "/api/v1/generate/ros2?distribution=noetic", document).status_code == 422


def test_arxml_is_of_the_release_that_is_asked_for(shipped):
    document = posted(shipped, "/api/v1/integrate/autosar-adaptive", CORE_ACC).content
    answer = posted(shipped, "/api/v1/generate/arxml?release=R20-11", document)
    assert answer.status_code == 200, answer.text
    archive = zipfile.ZipFile(io.BytesIO(answer.content))
    assert all(b"AUTOSAR_00049.xsd" in archive.read(name) for name in archive.namelist())


def test_the_core_of_each_function_is_an_archive(shipped):
    answers = [posted(shipped, "/api/v1/generate/core", {"functions": [CORE_ACC, MPC]}) for _ in range(2)]
    assert [answer.status_code for answer in answers] == [200, 200], answers[0].text
    assert answers[0].content == answers[1].content
    archive = zipfile.ZipFile(io.BytesIO(answers[0].content))
    names = [f"{name}_adapter.{end}" for name in ("CoreAcc", "EcoControlMpc") for end in ("h", "c")]
    assert archive.namelist() == [*names, *(file.name for file in runtime_files())]
    assert b"bool EcoControlMpc_Adapter_Init(" in archive.read("EcoControlMpc_adapter.h")


def test_a_function_without_its_variables_has_no_core(shipped):
    answer = posted(shipped, "/api/v1/generate/core", {"functions": [DISPLAY, CORE_ACC]})
    assert answer.status_code == 422
    assert {finding["rule"] for finding in answer.json()["findings"]} >= {"F010"}


@pytest.mark.parametrize(
    ("address", "body", "status"),
    [
        ("/api/v1/integrate/ros3", "{}", 422),
        ("/api/v1/integrate/ros2", "", 422),
        ("/api/v1/integrate/ros2", "function: [", 422),
        ("/api/v1/integrate/ros2", {"functions": []}, 422),
        ("/api/v1/integrate/ros2", {"functions": [1]}, 422),
        ("/api/v1/integrate/ros2", {"functions": ["function: X"]}, 422),
        ("/api/v1/integrate/ros2", {"functions": [CORE_ACC], "deploymnt": {}}, 422),
        ("/api/v1/integrate/ros2", {"functions": [CORE_ACC], "deployment": {"nme": 1}}, 422),
        ("/api/v1/integrate/ros2", {"functions": [CORE_ACC, CORE_ACC]}, 422),
        ("/api/v1/integrate/ros2", b"\xff\xfe", 422),
        ("/api/v1/generate/core", {"functions": [CORE_ACC], "deployment": {}}, 422),
        ("/api/v1/generate/core", {"functions": [CORE_ACC, CORE_ACC]}, 422),
        ("/api/v1/generate/core", "function: [", 422),
        ("/api/v1/generate/arxml", "{}", 422),
        ("/api/v1/generate/arxml", '"><script>', 422),
        ("/api/v1/generate/arxml?release=R19-11", "{}", 422),
        ("/api/v1/schemas/nothing.json", None, 405),
    ],
)
def test_bad_input_is_a_problem(shipped, address, body, status):
    answer = posted(shipped, address, body)
    assert answer.status_code == status, answer.text
    assert answer.headers["content-type"] == "application/problem+json"


@pytest.mark.parametrize("name", SCHEMAS)
def test_schemas_are_served(shipped, name):
    listed = shipped("/api/v1/schemas").json()["schemas"]
    assert f"/api/v1/schemas/{name}.json" in listed
    assert shipped(f"/api/v1/schemas/{name}.json").json()["$schema"].endswith("2020-12/schema")


def test_the_example_of_each_body_can_be_sent(shipped):
    paths = shipped("/openapi.json").json()["paths"]
    for path in ("/api/v1/integrate/ros2", "/api/v1/functions/build"):
        content = paths[path.replace("ros2", "{platform}")]["post"]["requestBody"]["content"]
        answer = posted(shipped, path, content["application/octet-stream"]["example"])
        assert answer.status_code == 200, answer.text


def test_what_one_function_of_a_set_defines_the_others_may_use(shipped):
    lanes = (FUNCTIONS / "lane_keeping.function.yaml").read_text(encoding="utf-8")
    body = {"functions": [DISPLAY, lanes]}
    assert posted(shipped, "/api/v1/functions/validate", body).json()["findings"] == []
    assert posted(shipped, "/api/v1/integrate/ros2", body).status_code == 200
    assert posted(shipped, "/api/v1/integrate/ros2", DISPLAY).status_code == 422


@pytest.mark.parametrize("address", ["/api/v1/functions/validate", "/api/v1/lint?kind=function"])
def test_a_set_is_checked_together(shipped, address):
    built = posted(shipped, "/api/v1/functions/build", MPC).json()
    built["FunctionInfo"]["FunctionName"] = "Another"
    report = posted(shipped, address, {"functions": [built, MPC, CORE_ACC]}).json()
    told = [finding for finding in report["findings"] if finding["rule"] == "F104"]
    assert told
    assert {finding["file"].rpartition(", ")[2] for finding in told} == {"function 2.yaml"}
    assert not report["ok"]
    assert posted(shipped, address, {"functions": [MPC, CORE_ACC]}).json()["ok"]


@pytest.mark.parametrize("body", [{"functions": []}, {"functions": 5}, {"functions": [CORE_ACC], "deployment": {}}])
def test_what_is_no_set_is_told(shipped, body):
    report = posted(shipped, "/api/v1/functions/validate", body).json()
    assert [(finding["rule"], finding["pointer"]) for finding in report["findings"]] == [
        ("F003", "/deployment" if "deployment" in body else "/functions")
    ]


def test_a_schema_that_does_not_exist_is_a_404_with_the_nearest(shipped):
    answer = shipped("/api/v1/schemas/functon.json")
    assert answer.status_code == 404
    assert "function" in answer.json()["nearest"]
