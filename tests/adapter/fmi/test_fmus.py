"""FMUs in an importer of others (FMPy): what they send is what a simulation sends, bit for bit."""

import csv
import shlex
import shutil
import sys
import zipfile
from pathlib import Path

import pytest

from scripts.cases import ROOT, RUNS
from sigcat.data import EXAMPLES
from sigcat.runs.recording.cells import cell_of
from tests.adapter.fmi.fmus import (
    built,
    compare,
    differences,
    leaves_of,
    run,
    sampled,
    simulated,
    write_trace,
)
from tests.needs import FMUSIM, cmake, fmusim, slow

fmpy = pytest.importorskip("fmpy", reason="FMPy: pip install fmpy")
import numpy as np  # noqa: E402 -- FMPy brings it
from fmpy.validation import validate_fmu  # noqa: E402 -- where it is there

pytestmark = cmake
AVERAGING = Path(__file__).with_name("averaging") / "function.yaml"
MILLISECOND = 10**6
FOLDER = ROOT / RUNS.folder
NUMPY = {"Boolean": "?", "Enumeration": "i8", "Float32": "f4", "Float64": "f8"}
CASES = [
    name for name in RUNS.names if name != "calls_that_take_time"
]  # a call in an FMU takes no time of the simulation


def files_of(name):
    words = shlex.split((FOLDER / name / "options").read_text())
    return [FOLDER / name / word for word in words[: words.index("--trace")]], FOLDER / name / "trace.csv"


def played(made, trace, step, end, folder):
    """Compare one trace, and return the number of compared values."""
    return compare(made, list(sampled(trace, made, step, end)), step, end, folder)


@pytest.mark.parametrize("name", CASES)
def test_an_fmu_sends_what_a_simulation_sends(name, tmp_path):
    files, trace = files_of(name)
    made = built(files, tmp_path)
    assert not validate_fmu(str(made.file))
    for step in (1, 10, 70):
        assert played(made, trace, step * MILLISECOND, 350 * MILLISECOND, tmp_path)


def test_headers_in_folders_of_the_code_are_packed(tmp_path):
    (tmp_path / "code").mkdir()
    for name in ("averaging.c", "averaging.h"):
        shutil.copy(AVERAGING.parent / name, tmp_path / "code")
    text = AVERAGING.read_text().replace("[averaging.", "[code/averaging.")
    (tmp_path / "function.yaml").write_text(text)
    with zipfile.ZipFile(built([tmp_path / "function.yaml"], tmp_path).file) as file:
        assert "sources/code/averaging.h" in file.namelist()


@pytest.fixture(scope="module")
def ecocontrol(tmp_path_factory):
    return built(
        [EXAMPLES / name / "function.yaml" for name in ("core_acc", "eco_control_mpc")], tmp_path_factory.mktemp("fmu")
    )


@pytest.mark.parametrize("step", [1, 10, 50, 70])
def test_ecocontrol_at_each_step(ecocontrol, step, tmp_path):
    seconds = 7 if step == 1 else 70
    assert played(ecocontrol, EXAMPLES / "ecocontrol/drive.csv", step * MILLISECOND, seconds * 10**9, tmp_path) > 1000


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


@pytest.mark.parametrize("step", [10, 50, 70])
def test_ecocontrol_in_the_master_of_fmpy(ecocontrol, step, tmp_path):
    """The master sets every input before each step, and so does the simulation. FMPy 0.3.32 takes no table of arrays."""
    step *= MILLISECOND
    points, sent = driven(ecocontrol, step, 1000 * step, tmp_path)
    outputs = [each for each in ecocontrol.variables if each.causality == "output"]
    result = fmpy.simulate_fmu(
        str(ecocontrol.file), stop_time=1000 * step / 1e9, output_interval=step / 1e9, input=signals(ecocontrol, points),
        output=[each.name for each in outputs],
    )  # fmt: skip
    assert len(result) == 1001
    with (tmp_path / "played.csv").open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["time", *(each.name for each in outputs)])
        writer.writerows(
            [f"{row['time']:.9f}", *(cell_of(row[each.name].item(), each.number) for each in outputs)] for row in result
        )
    compared, wrong = differences(ecocontrol, sent, tmp_path / "played.csv", step, 1000 * step)
    assert compared > 1000
    assert not wrong, wrong[:5]


@fmusim
@pytest.mark.parametrize("step", [10, 50, 70])
def test_ecocontrol_in_the_importer_of_the_reference_fmus(ecocontrol, step, tmp_path):
    step *= MILLISECOND
    points, sent = driven(ecocontrol, step, 300 * step, tmp_path)
    given = signals(ecocontrol, points)
    with (tmp_path / "input.csv").open("w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([given.dtype.names, *(map(repr, map(as_number, row)) for row in given.tolist())])
    outputs = [each.name for each in ecocontrol.variables if each.causality == "output" and each.length is None]
    recorded = [word for name in outputs for word in ("--output-variable", name)]
    run(
        *(FMUSIM, "--stop-time", 300 * step / 1e9, "--output-interval", step / 1e9, *recorded),
        *("--input-file", tmp_path / "input.csv", "--output-file", tmp_path / "played.csv", ecocontrol.file),
    )
    compared, wrong = differences(ecocontrol, sent, tmp_path / "played.csv", step, 300 * step)
    assert compared > 1000
    assert not wrong, wrong[:5]


def driven(made, step, end, folder):
    """The drive of the example with every input set at each step, and what a simulation of it sends."""
    points = list(every_input_set(sampled(EXAMPLES / "ecocontrol/drive.csv", made, step, end)))
    write_trace(points, made, folder / "trace.csv")
    return points, simulated(made, folder / "trace.csv", folder / "sent.csv", end)


def as_number(value):
    return int(value) if isinstance(value, bool) else value


def every_input_set(points):
    """Points with the last value of every number; one that is set later has its first value from the beginning."""
    points = [
        (point, {name: each for name, each in values.items() if not isinstance(each, list)}) for point, values in points
    ]
    known = {name: value for _, values in reversed(points) for name, value in values.items()}
    for point, values in points:
        known |= values
        yield point, dict(known)


def signals(made, points):
    """The inputs as FMPy takes them."""
    names = list(points[0][1])
    leaves = [leaves_of(made, name)[0] for name in names]
    rows = [(point / 1e9, *(values[name] for name in names)) for point, values in points]
    return np.array(rows, dtype=[("time", "f8"), *((each.name, NUMPY[each.type]) for each in leaves)])


def names_in(file):
    with zipfile.ZipFile(file) as archive:
        return [name for name in archive.namelist() if name.startswith("binaries/") and not name.endswith("/")]


def test_an_fmu_has_the_libraries_of_other_builds(tmp_path):
    """A build for another machine is that of this one by another name."""
    (tmp_path / "other").mkdir()
    other = built([AVERAGING], tmp_path / "other", "-DFMU_PLATFORM=aarch64-linux")
    assert names_in(other.file) == ["binaries/aarch64-linux/Tested.so"]
    both = built([AVERAGING], tmp_path, f"-DFMU_WITH={other.file.parent}", "-DFMU_PLATFORM=x86_64-linux")
    assert sorted(names_in(both.file)) == ["binaries/aarch64-linux/Tested.so", "binaries/x86_64-linux/Tested.so"]
    assert not validate_fmu(str(both.file))


@slow
@pytest.mark.parametrize(
    ("target", "system", "architecture", "beginning"),
    [
        ("x86_64-linux-gnu", "Linux", "x86_64", b"\x7fELF\x02\x01\x01" + bytes(9) + b"\x03\x00\x3e\x00"),
        ("aarch64-linux-gnu", "Linux", "aarch64", b"\x7fELF\x02\x01\x01" + bytes(9) + b"\x03\x00\xb7\x00"),
        ("x86_64-windows-gnu", "Windows", "x86_64", b"MZ"),
    ],
)
def test_zig_compiles_for_other_machines(target, system, architecture, beginning, tmp_path):
    pytest.importorskip("ziglang", reason="Zig: pip install ziglang")
    compiler = f"-DCMAKE_C_COMPILER={sys.executable};-m;ziglang;cc;-target;{target}"
    machine = [f"-DCMAKE_SYSTEM_NAME={system}", f"-DCMAKE_SYSTEM_PROCESSOR={architecture}"]
    made = built([AVERAGING], tmp_path, compiler, *machine)
    (name,) = names_in(made.file)
    assert name.startswith(f"binaries/{architecture}-{system.lower()}/Tested.")
    with zipfile.ZipFile(made.file) as archive:
        library = archive.read(name)
    assert library.startswith(beginning)
    assert b"fmi3DoStep\0" in library
