"""EcoControl's drive as frames: the FMU sends what a simulation sends for the trace that the gateway makes of the log."""

import csv
import gzip
import re
import struct
from itertools import groupby

import pytest

from sigcat.cli import main
from sigcat.data import EXAMPLES
from sigcat.runs.recording.times import nanoseconds
from tests.adapter.fmi.bus.operations import Instance, transmit
from tests.adapter.fmi.fmus import run
from tests.needs import cmake

pytest.importorskip("fmpy", reason="FMPy: pip install fmpy")
pytest.importorskip("cantools", reason="cantools: pip install 'sigcat[can]'")
pytestmark = cmake
CAN = EXAMPLES / "ecocontrol/can"
FILES = [str(EXAMPLES / name / "function.yaml") for name in ("core_acc", "eco_control_mpc")]
FRAMES = 4000


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """An FMU of the set, the first frames of the log, their trace, and what a simulation sends for it."""
    folder = tmp_path_factory.mktemp("drive")
    dbc, mappings = str(CAN / "ecocontrol.dbc"), str(CAN / "can.vspec")
    (folder / "deployment.yaml").write_text(
        f"name: Eco\nfmi: {{fmus: set, bus: {{name: Powertrain, dbc: ['{dbc}']}}}}\n"
    )
    options = ["-l", mappings, "--deployment", str(folder / "deployment.yaml"), "-o", str(folder / "fmi.json")]
    assert main(["integrate", "fmi", *FILES, *options]) == 0
    assert main(["generate", "fmi", str(folder / "fmi.json"), "-o", str(folder / "made")]) == 0
    settings = [f"-DCORE_ACC_CODE={EXAMPLES / 'core_acc'}", f"-DECO_CONTROL_MPC_CODE={EXAMPLES / 'eco_control_mpc'}"]
    run("cmake", "-S", folder / "made", "-B", folder / "build", *settings)
    run("cmake", "--build", folder / "build")
    with gzip.open(CAN / "drive.log.gz", "rt") as log:
        lines = [next(log) for _ in range(FRAMES)]
    (folder / "drive.log").write_text("".join(lines))
    trace = ["-o", str(folder / "trace.csv"), "--from-zero"]
    assert main(["gateway", str(folder / "drive.log"), "--dbc", dbc, "-l", mappings, *trace]) == 0
    assert main(["simulate", *FILES, "--trace", str(folder / "trace.csv"), "-o", str(folder / "sent.csv")]) == 0
    return folder


def frames_of(folder):
    """Operations by their times, in ns from the first frame."""
    found = [re.match(r"\((\S+)\) \S+ (\w+)#(\w*)", line) for line in (folder / "drive.log").open()]
    rows = [(nanoseconds(each[1]) or 0, int(each[2], 16), bytes.fromhex(each[3])) for each in found if each]
    for time, group in groupby(rows, key=lambda row: row[0]):
        yield time - rows[0][0], b"".join(transmit(identifier, data) for _, identifier, data in group)


def sent_numbers(folder, instance):
    """Numbers that the simulation sends, with their times."""
    for row in csv.DictReader((folder / "sent.csv").open(newline="", encoding="utf-8")):
        for name, cell in row.items():
            if cell and name in instance.variables and instance.variables[name].type == "Float32":
                yield nanoseconds(row["time"]) or 0, name, struct.pack("f", float(cell))


def test_the_drive_over_a_bus_is_that_of_a_simulation(folder):
    instance = Instance(folder / "build/Eco.fmu")
    sent = [*sent_numbers(folder, instance), (2**63, "", b"")]
    known: dict[str, bytes] = {}
    compared = at = 0
    for time, data in frames_of(folder):
        if time > 0:
            instance.step(time / 1e9)
            instance.fmu.enterEventMode()
        instance.settle(data)
        while sent[at][0] <= time:
            known[sent[at][1]] = sent[at][2]
            at += 1
        for name, value in known.items():
            assert struct.pack("f", instance.get(name)) == value, (time, name)
            compared += 1
    instance.close()
    assert compared > 1000
    assert len(set(known)) == 2
