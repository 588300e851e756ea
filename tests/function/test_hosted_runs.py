"""Runs of a service: which files of its folders are runs, of which function each is, and that a new one is seen."""

import os
from pathlib import Path

import pytest

from sigcat.catalogue.hosting.library import Library, shipped_sources
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.data import EXAMPLES
from sigcat.errors import NotFound
from sigcat.function import hosted_runs
from sigcat.function.hosted_runs import run_named
from sigcat.function.hosting import FunctionLibrary, function_over
from sigcat.limits import RUN_HEADER_BYTES

PROPOSAL = "Vehicle.ADAS.EcoControl.AccelerationProposal"
HEADER = f"time,call,{PROPOSAL},EcoControlMpc_Mode_Out\n"
RUN = f"{HEADER}0.000000000,EcoControlMpc_Init,,OFF\n"


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Library(shipped_sources()).default.catalogue


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with both functions of EcoControl."""
    folder = tmp_path / "functions"
    for name in ("core_acc", "eco_control_mpc"):
        (folder / name).mkdir(parents=True)
        (folder / name / "function.yaml").write_bytes((EXAMPLES / name / "function.yaml").read_bytes())
    return folder


def run_ids(library: FunctionLibrary, catalogue: Catalogue, function: str) -> list[str]:
    return [run.id for run in library.runs_of(function_over(library.files, catalogue, function))]


def test_every_shipped_function_has_a_run(catalogue: Catalogue) -> None:
    library = FunctionLibrary()
    found = {file.id: run_ids(library, catalogue, file.id) for file in library.files}
    assert found == {
        "core_acc": ["ecocontrol"],
        "eco_control_mpc": ["ecocontrol"],
        "wheel_speed_calculation": ["wheel_speed_calculation"],
    }
    assert FunctionLibrary(has_shipped=False).runs == ()


def test_a_run_is_of_the_functions_of_its_folder_that_send_something_in_it(folder: Path, catalogue: Catalogue) -> None:
    (folder / "drive.csv").write_text(RUN)
    library = FunctionLibrary([folder])
    assert run_ids(library, catalogue, "eco_control_mpc") == ["drive"]
    assert run_ids(library, catalogue, "core_acc") == []
    assert run_ids(library, catalogue, "wheel_speed_calculation") == ["wheel_speed_calculation"]


def test_a_safety_reaction_that_another_function_decides_too_makes_no_run(folder: Path, catalogue: Catalogue) -> None:
    (folder / "drive.csv").write_text("time,call,AccReqInvalid_SftyCondSts\n")
    assert run_ids(FunctionLibrary([folder]), catalogue, "core_acc") == []


@pytest.mark.parametrize(
    "data",
    [
        b"time,Vehicle.Speed,EcoControlMpc_Mode_Out\n0,1,OFF\n",
        b"call,time,EcoControlMpc_Mode_Out\n",
        b"name;amount\nscrews;7\n",
        b"",
        b"\x00" * 5000,
        RUN.encode("utf-16"),
        b'"time,call\nEcoControlMpc_Mode_Out',
        b"time,call," + b"x" * RUN_HEADER_BYTES + b",EcoControlMpc_Mode_Out\n",
        b"time,call,\xff,EcoControlMpc_Mode_Out\n",
    ],
    ids=["a trace", "order", "of another tool", "empty", "zeros", "UTF-16", "a quote", "a long header", "Latin-1"],
)
def test_what_has_no_header_of_a_run_is_none(folder: Path, catalogue: Catalogue, data: bytes) -> None:
    (folder / "drive.csv").write_bytes(data)
    library = FunctionLibrary([folder])
    assert run_ids(library, catalogue, "eco_control_mpc") == []
    assert len(library.files) == 3


@pytest.mark.parametrize("data", [b"\xef\xbb\xbf" + RUN.encode(), RUN.replace("\n", "\r\n").encode(), HEADER.encode()])
def test_spreadsheets_write_the_header_in_several_ways(folder: Path, catalogue: Catalogue, data: bytes) -> None:
    (folder / "drive.csv").write_bytes(data)
    assert run_ids(FunctionLibrary([folder]), catalogue, "eco_control_mpc") == ["drive"]


def test_a_run_is_named_by_its_file_or_its_folder(folder: Path, catalogue: Catalogue) -> None:
    for name in ("drive.csv", "old/drive.CSV", "hills/run.csv", "run.csv", ".hidden/drive.csv", "bad\nname.csv"):
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(RUN)
    library = FunctionLibrary([folder], has_shipped=False)
    found = {run.id: run.name for run in library.runs}
    assert found == {
        "drive": "functions/drive.csv",
        "drive-2": "functions/old/drive.CSV",
        "hills": "functions/hills/run.csv",
        "functions": "functions/run.csv",
    }
    runs = library.runs_of(function_over(library.files, catalogue, "eco_control_mpc"))
    assert run_named("hills", runs).name == "functions/hills/run.csv"
    with pytest.raises(NotFound) as missing:
        run_named("hill", runs)
    assert "hills" in missing.value.nearest


def test_of_very_many_runs_the_first_ones_are_taken(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(hosted_runs, "RUNS", 3)
    for number in range(5):
        (folder / f"drive{number}.csv").write_text(RUN)
    assert [run.id for run in FunctionLibrary([folder], has_shipped=False).runs] == ["drive0", "drive1", "drive2"]


def test_what_cannot_be_read_is_left_out(folder: Path) -> None:
    os.mkfifo(folder / "pipe.csv")
    (folder / "gone.csv").symlink_to(folder / "nowhere.csv")
    (folder / "folder.csv").mkdir()
    assert FunctionLibrary([folder], has_shipped=False).runs == ()


def test_a_new_run_is_seen_and_one_that_is_gone(folder: Path, catalogue: Catalogue) -> None:
    library = FunctionLibrary([folder], has_shipped=False)
    digest = library.digest
    (folder / "drive.csv").write_text(RUN)
    assert library.reload_changed()
    assert run_ids(library, catalogue, "eco_control_mpc") == ["drive"]
    (folder / "drive.csv").write_text("time,call\n")
    assert library.reload_changed()
    assert run_ids(library, catalogue, "eco_control_mpc") == []
    (folder / "drive.csv").unlink()
    assert library.reload_changed()
    assert not library.reload_changed()
    assert library.digest == digest
