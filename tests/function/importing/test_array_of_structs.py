"""Arrays of structs that the code imports: from the import to the simulation."""

import shutil

import pytest

from scripts.cases import CODE as CASES
from scripts.cases import ROOT
from sigcat.cli import main

CODE = ROOT / CASES.folder / "imported_array_of_structs/code"
TRACE = """time,Vehicle.Mixer.Channels0Level,Vehicle.Mixer.Channels1Level,Vehicle.Mixer.Channels1Gain,Vehicle.Mixer.Limits1Left
0,1,10,2,0.5
0.02,2,10,3,0.5
"""


@pytest.fixture
def imported(tmp_path):
    shutil.copytree(CODE, tmp_path / "code")
    assert (
        main(["function", "new", "Mixer", "--from-c", str(tmp_path / "code"), "--define-under", "Vehicle.Mixer"]) == 0
    )
    return tmp_path / "code/function.yaml"


def test_it_is_simulated(imported, tmp_path, capsys):
    (tmp_path / "trace.csv").write_text(TRACE)
    capsys.readouterr()
    assert main(["simulate", str(imported), "--trace", str(tmp_path / "trace.csv")]) == 0
    rows = [line.split(",") for line in capsys.readouterr().out.splitlines()]
    assert (rows[2][-1], rows[-1][-1]) == ("21.5", "32.5")


@pytest.mark.parametrize(
    ("before", "after", "rule"),
    [
        ("length: 3", "length: 4", "F211"),
        ("length: 3, definedBy: adapter", "length: 3", "F203"),
        ("length: 3", "length: 0", "F203"),
        ("length: 3", "length: 4000000000", "F203"),
    ],
)
def test_a_length_that_is_wrong_is_reported_at_its_object(imported, before, after, rule, capsys):
    imported.write_text(imported.read_text().replace(before, after))
    capsys.readouterr()
    assert main(["lint", str(imported)]) == 1
    line = next(number for number, text in enumerate(imported.read_text().splitlines(), 1) if "name: Channels" in text)
    assert any(f":{line}:" in each and f"error {rule} " in each for each in capsys.readouterr().out.splitlines())
