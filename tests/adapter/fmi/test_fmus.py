"""FMUs in an importer of others (FMPy): what they send is what a simulation sends, bit for bit."""

import json
import shlex
import shutil
import zipfile
from pathlib import Path

import pytest

from scripts.cases import ROOT, RUNS
from sigcat.cli import main
from sigcat.data import EXAMPLES
from tests.adapter.fmi.fmus import built, differences, sampled, simulated, write_fmu_trace, write_trace
from tests.needs import cmake

fmpy = pytest.importorskip("fmpy", reason="FMPy: pip install fmpy")
from fmpy.validation import validate_fmu  # noqa: E402 -- where it is there

pytestmark = cmake
AVERAGING = Path(__file__).with_name("averaging") / "function.yaml"
MILLISECOND = 10**6
FOLDER = ROOT / RUNS.folder
CASES = [
    name for name in RUNS.names if name != "calls_that_take_time"
]  # a call in an FMU takes no time of the simulation


def files_of(name):
    words = shlex.split((FOLDER / name / "options").read_text())
    return [FOLDER / name / word for word in words[: words.index("--trace")]], FOLDER / name / "trace.csv"


def compare(made, trace, step, end, folder):
    """Compare one trace, and return the number of compared values."""
    points = list(sampled(trace, made, step, end))
    write_trace(points, made, folder / "simulated.csv")
    write_fmu_trace(points, made, folder / "trace.csv")
    sent = simulated(made, folder / "simulated.csv", folder / "sent.csv", end)
    given = [
        "--fmu",
        str(made.file),
        "--trace",
        str(folder / "trace.csv"),
        "--step",
        str(step / MILLISECOND),
        "--duration",
        str(end / 1e9),
    ]
    assert main(["simulate", *given, "-o", str(folder / "played.csv")]) == 0
    compared, wrong = differences(made, sent, folder / "played.csv", step, end)
    assert not wrong, wrong[:5]
    return compared


@pytest.mark.parametrize("name", CASES)
def test_an_fmu_sends_what_a_simulation_sends(name, tmp_path):
    files, trace = files_of(name)
    made = built(files, tmp_path)
    assert not validate_fmu(str(made.file))
    for step in (1, 10, 70):
        assert compare(made, trace, step * MILLISECOND, 350 * MILLISECOND, tmp_path)


@pytest.fixture(scope="module")
def ecocontrol(tmp_path_factory):
    return built(
        [EXAMPLES / name / "function.yaml" for name in ("core_acc", "eco_control_mpc")], tmp_path_factory.mktemp("fmu")
    )


@pytest.mark.parametrize("step", [1, 10, 50, 70])
def test_ecocontrol_at_each_step(ecocontrol, step, tmp_path):
    seconds = 7 if step == 1 else 70
    assert compare(ecocontrol, EXAMPLES / "ecocontrol/drive.csv", step * MILLISECOND, seconds * 10**9, tmp_path) > 1000


def test_each_function_has_an_fmu_and_the_system_connects_them(tmp_path):
    paths = [str(EXAMPLES / name / "function.yaml") for name in ("core_acc", "eco_control_mpc")]
    assert main(["integrate", "fmi", *paths, "-o", str(tmp_path / "fmi.json")]) == 0
    document = json.loads((tmp_path / "fmi.json").read_text())
    assert [each["Name"] for each in document["FmuList"]] == ["CoreAcc", "EcoControlMpc"]
    connected = {(each["StartFmu"], each["EndFmu"], each["EndVariable"]) for each in document["ConnectionList"]}
    assert ("EcoControlMpc", "CoreAcc", "Vehicle.ADAS.EcoControl.AccelerationProposal") in connected
    assert main(["generate", "fmi", str(tmp_path / "fmi.json"), "-o", str(tmp_path / "made")]) == 0
    system = tmp_path / "EcoControl.ssp"
    with zipfile.ZipFile(system, "w") as file:
        file.write(tmp_path / "made/SystemStructure.ssd", "SystemStructure.ssd")
    from fmpy.ssp.ssd import read_ssd

    read = read_ssd(str(system))
    assert len(read.system.connections) == len(document["ConnectionList"])


def test_an_fmu_without_sources_has_its_binary(tmp_path):
    made = built([AVERAGING], tmp_path, "-DFMU_SOURCES=OFF")
    with zipfile.ZipFile(made.file) as file:
        names = file.namelist()
    assert any(name.startswith("binaries/") and name.endswith(".so") for name in names)
    assert not any(name.startswith("sources/") for name in names)


def test_the_sources_in_an_fmu_compile_without_the_project(tmp_path):
    """FMPy compiles them by buildDescription.xml."""
    from fmpy.build import build_platform_binary

    made = built([AVERAGING], tmp_path)
    unpacked = Path(fmpy.extract(str(made.file), str(tmp_path / "unpacked")))
    shutil.rmtree(unpacked / "binaries")
    build_platform_binary(unpacked)
    assert list(unpacked.glob("binaries/*/*"))
