"""Result of `pip install .`: a command that works from any folder, with its data inside.

The wheel is built and unpacked into a separate folder, far from the checkout; then a real service answers.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import httpx
import pytest

from tests.waiting import DEADLINE

PROJECT = Path(__file__).parents[1]


@pytest.fixture(scope="session")
def installed(tmp_path_factory):
    """A folder with the installed package."""
    wheels, target = tmp_path_factory.mktemp("wheels"), tmp_path_factory.mktemp("installed")
    pip = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check"]
    subprocess.run([*pip, "wheel", "--no-deps", "--no-build-isolation", "-w", wheels, PROJECT], check=True)
    (wheel,) = wheels.glob("*.whl")
    subprocess.run([*pip, "install", "--no-deps", "--target", target, wheel], check=True)
    return target


@pytest.fixture(scope="session")
def environment(installed):
    return {**os.environ, "PYTHONPATH": str(installed), "PYTHONDONTWRITEBYTECODE": "1"}


@pytest.fixture
def run(installed, environment, tmp_path):
    """Run the installed command in an empty folder."""

    def run_sigcat(*arguments: str) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, str(installed / "bin" / "sigcat"), *arguments]
        return subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, env=environment, check=False)

    return run_sigcat


@pytest.fixture(scope="module")
def service(installed, environment, tmp_path_factory):
    """A client of the installed service, run as a process on a free port."""
    process = subprocess.Popen(
        [sys.executable, str(installed / "bin" / "sigcat"), "serve", "--port", "0"],
        stdout=subprocess.PIPE,
        text=True,
        cwd=tmp_path_factory.mktemp("elsewhere"),
        env=environment,
    )
    assert process.stdout is not None
    address = next(word for word in process.stdout.readline().split() if word.startswith("http"))
    try:
        with httpx.Client(base_url=address, timeout=DEADLINE) as client:
            yield client
    finally:
        process.terminate()
        assert process.wait(DEADLINE) in (0, -15)


def test_the_data_travels_inside(installed):
    for file in (
        "vspec/VehicleSignalSpecification.vspec",
        "overlays/error.vspec",
        "interface_rules/vss.yaml",
        "docs/README.md",
    ):
        assert (installed / "sigcat" / "_data" / file).is_file()


def test_it_lives_beside_another_package_called_app(installed, environment, tmp_path):
    """Many web projects have a package of that name; nothing of sigcat is in its way."""
    (tmp_path / "app").mkdir()
    (tmp_path / "app" / "__init__.py").write_text("OWNER = 'another project'\n")
    assert not (installed / "app").exists()
    assert (installed / "sigcat" / "py.typed").is_file()
    code = "import app, sigcat.names; print(app.OWNER, '|', sigcat.names.camel_case('wheel_speed'))"
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=tmp_path, env=environment, check=True
    )
    assert result.stdout == "another project | WheelSpeed\n"


def test_the_command_explains_itself(run):
    result = run("--help")
    assert result.returncode == 0
    assert "usage: sigcat" in result.stdout


def test_the_linter_works_far_from_the_checkout(run, tmp_path):
    (tmp_path / "overlay.vspec").write_text("Vehicle.Sped:\n  min: 0\n")
    result = run("lint", "overlay.vspec")
    assert result.returncode == 1
    assert "overlay.vspec:1:1" in result.stdout


def test_from_the_tree_to_the_function_json_of_core_acc(service):
    """The whole way, over HTTP: catalogues, a node, a search, the declared function, its Function JSON."""
    catalogues = service.get("/api/v1/catalogues").raise_for_status().json()
    names = [entry["id"] for entry in catalogues["catalogues"]]
    assert "interfaces" in names
    base = "/api/v1/catalogues/interfaces"
    root = service.get(f"{base}/nodes/Vehicle").raise_for_status().json()
    assert "Vehicle.Speed" in json.dumps(root)
    found = service.get(f"{base}/search", params={"q": "brake cylinder pressure"}).raise_for_status().json()
    assert "Vehicle.Chassis.Brake.CylP" in json.dumps(found)
    declaration = (PROJECT / "examples" / "core_acc" / "function.yaml").read_bytes()
    built = service.post(
        "/api/v1/functions/build", content=declaration, headers={"Content-Type": "application/yaml"}
    ).raise_for_status()
    function = built.json()
    assert function["FunctionInfo"]["FunctionName"] == "CoreAcc"
    steps = function["ComponentList"][0]["functionList"]
    assert [step["Name"] for step in steps] == ["CoreAcc_Init", "CoreAcc_Step", "CoreAcc_Terminate"]
    checked = service.post(
        "/api/v1/functions/validate", content=built.content, headers={"Content-Type": "application/json"}
    ).raise_for_status()
    assert not [finding for finding in checked.json()["findings"] if finding["severity"] == "error"]


def test_the_tree_opens_in_a_browser(service):
    assert "/tree/interfaces" in service.get("/").raise_for_status().text
    page = service.get("/tree/interfaces").raise_for_status()
    assert page.headers["content-type"].startswith("text/html")
    assert "Vehicle" in page.text
