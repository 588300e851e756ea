"""A set as FMUs of its functions, and as a system (SSP) that connects them; what an FMU says of itself."""

import json
import shutil
import subprocess
import zipfile
from pathlib import Path

import pytest

from sigcat.cli import main
from sigcat.data import EXAMPLES
from tests.adapter.fmi.fmus import run
from tests.needs import cmake

fmpy = pytest.importorskip("fmpy", reason="FMPy: pip install fmpy")
from fmpy.ssp.simulation import simulate_ssp  # noqa: E402 -- where FMPy is there
from fmpy.ssp.ssd import read_ssd  # noqa: E402
from fmpy.validation import validate_fmu  # noqa: E402
from lxml import etree  # type: ignore[import-untyped]  # noqa: E402 -- FMPy brings it

pytestmark = cmake
SCHEMAS = Path(fmpy.__file__).parent
FUNCTIONS = {"core_acc": "CORE_ACC_CODE", "eco_control_mpc": "ECO_CONTROL_MPC_CODE"}
PROPOSAL = "Vehicle.ADAS.EcoControl.AccelerationProposal"


@pytest.fixture(scope="module", params=["3.0", "2.0"])
def system(request, tmp_path_factory):
    """The folder of the FMUs of EcoControl, and the version of FMI."""
    folder = tmp_path_factory.mktemp("system")
    (folder / "deployment.yaml").write_text(f"name: EcoControl\nfmi: {{version: '{request.param}'}}\n")
    paths = [str(EXAMPLES / name / "function.yaml") for name in FUNCTIONS]
    options = ["--deployment", str(folder / "deployment.yaml"), "-o", str(folder / "fmi.json")]
    assert main(["integrate", "fmi", *paths, *options]) in (0, 1)
    assert main(["generate", "fmi", str(folder / "fmi.json"), "-o", str(folder)]) == 0
    code = [f"-D{setting}={EXAMPLES / name}" for name, setting in FUNCTIONS.items()]
    run("cmake", "-S", folder, "-B", folder / "build", *code)
    run("cmake", "--build", folder / "build")
    return folder, request.param


def test_fmus_of_functions_exchange_what_functions_of_a_set_exchange(system):
    folder, _ = system
    document = json.loads((folder / "fmi.json").read_text())
    assert [each["Name"] for each in document["FmuList"]] == ["CoreAcc", "EcoControlMpc"]
    assert {each["EndVariable"]: each["StartVariable"] for each in document["ConnectionList"]} == {
        PROPOSAL: PROPOSAL,
        "EcoControlMpc_NoSolutionError_ErrorSts": "Vehicle.Function.EcoControlMpc.Error.NoSolutionError",
        "EcoControlMpc_DeadlineError_ErrorSts": "Vehicle.Function.EcoControlMpc.Error.DeadlineError",
    }


def test_the_package_of_the_system_has_its_fmus_units_and_parameters(system):
    folder, _ = system
    package = folder / "build" / "EcoControl.ssp"
    with zipfile.ZipFile(package) as archive:
        names = archive.namelist()
        document = etree.fromstring(archive.read("SystemStructure.ssd"))
    assert {"resources/CoreAcc.fmu", "resources/EcoControlMpc.fmu"} <= set(names)
    schema = etree.XMLSchema(etree.parse(SCHEMAS / "ssp/schema/SystemStructureDescription.xsd"))
    assert schema.validate(document), schema.error_log
    text = etree.tostring(document).decode()
    assert '<ssc:Real unit="km/h"/>' in text
    assert '<ssc:BaseUnit m="1" s="-1" factor="0.2777777777777778" offset="0.0"/>' in text
    assert '<ssv:Real value="2495.0" unit="kg"/>' in text
    system_of_fmpy = read_ssd(str(package)).system
    assert {each.name for each in system_of_fmpy.connectors} >= {PROPOSAL, "Vehicle.Speed"}


def test_fmpy_simulates_the_system(system):
    folder, version = system
    if version != "2.0":
        pytest.skip("FMPy 0.3.32 simulates systems of FMI 2.0 alone")
    result = simulate_ssp(str(folder / "build/EcoControl.ssp"), stop_time=1.0, step_size=0.05)
    assert len(result) == 20
    assert PROPOSAL in result.dtype.names


@pytest.mark.parametrize("name", ["CoreAcc", "EcoControlMpc"])
def test_an_fmu_describes_units_and_dependencies(system, name):
    folder, _ = system
    file = folder / "build" / f"{name}.fmu"
    assert not validate_fmu(str(file))
    description = fmpy.read_model_description(str(file))
    variables = {each.name: each for each in description.modelVariables}
    proposal = variables[PROPOSAL]
    assert proposal.declaredType.name == "Float32[m/s^2]"
    assert (proposal.declaredType.unit, proposal.declaredType.displayUnit) == ("m/s^2", "m/s^2")
    (unit,) = (each for each in description.unitDefinitions if each.name == "m/s^2")
    assert (unit.baseUnit.m, unit.baseUnit.s, unit.baseUnit.factor) == (1, -2, 1.0)
    inputs = {each.name for each in variables.values() if each.causality == "input"}
    for output in description.outputs:
        assert {each.name for each in output.dependencies} == inputs | {"time"}
    assert all(each.dependencies == [] for each in description.initialUnknowns)


def test_an_fmu_has_an_icon_licences_and_the_digest_of_its_declaration(system):
    folder, version = system
    with zipfile.ZipFile(folder / "build/CoreAcc.fmu") as archive:
        icon = archive.read("model.png" if version == "2.0" else "terminalsAndIcons/icon.png")
        licences = archive.read("documentation/licenses/license.html").decode()
        page = archive.read("documentation/index.html").decode()
    assert icon.startswith(b"\x89PNG")
    assert "Apache License 2.0" in licences
    assert "SHA-256" in page


@pytest.mark.skipif(
    not shutil.which("fmutool"), reason="the FMU Manipulation Toolbox: pip install fmu-manipulation-toolbox"
)
@pytest.mark.parametrize("name", ["CoreAcc", "EcoControlMpc"])
def test_the_checker_of_the_toolbox_finds_nothing(system, name):
    folder, _ = system
    command = ["fmutool", "-input", str(folder / "build" / f"{name}.fmu"), "-check"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    told = done.stdout + done.stderr
    assert (done.returncode, "No semantic error" in told, "ERROR" in told) == (0, True, False), told
