"""Hosted functions whose files break: the last valid state stays, and the errors are reported."""

from collections.abc import Mapping
from pathlib import Path

import pytest

from sigcat.catalogue.hosting.library import Library, Source, shipped_sources
from sigcat.data import OVERLAYS, ROOT_FILE
from sigcat.findings import Finding
from sigcat.function.hosted_files import HostedFile
from sigcat.function.hosting import FunctionLibrary, function_over
from tests.function.test_hosting import noise

BROKEN = noise().replace("Step: {cycleTime: 100", "Step: {cycleTime: often")
HALF = "function: Cabin"
UNKNOWN = noise(path="Vehicle.Sped")


@pytest.fixture(scope="module")
def catalogues(tmp_path_factory: pytest.TempPathFactory) -> Library:
    overlay = tmp_path_factory.mktemp("acme") / "hum.vspec"
    overlay.write_text("Vehicle.Cabin.Hum: {type: sensor, datatype: float, description: A hum.}\n")
    return Library([*shipped_sources(), Source("acme", "Acme", ROOT_FILE, (overlay,), (OVERLAYS / "units.yaml",))])


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    folder = tmp_path / "functions"
    folder.mkdir()
    (folder / "noise.function.yaml").write_text(noise())
    return folder


@pytest.fixture
def functions(folder: Path, catalogues: Library) -> FunctionLibrary:
    return FunctionLibrary([folder], has_shipped=False, catalogues=catalogues)


def rejected(functions: FunctionLibrary) -> Mapping[str, list[str]]:
    return {file.id: [finding.rule for finding in file.rejected] for file in functions.reload()}


def data(functions: FunctionLibrary, function_id: str = "noise") -> str:
    return next(file.data.decode() for file in functions.files if file.id == function_id)


@pytest.mark.parametrize(
    "text", [BROKEN, HALF, UNKNOWN, "", "- no function\n", "Vehicle: {type: branch}\n", "function: ["]
)
def test_a_file_that_breaks_keeps_its_last_good_state(folder: Path, functions: FunctionLibrary, text: str) -> None:
    (folder / "noise.function.yaml").write_text(text)
    assert rejected(functions)["noise"]
    assert data(functions) == noise()


def test_the_log_names_what_is_wrong(
    folder: Path, functions: FunctionLibrary, caplog: pytest.LogCaptureFixture
) -> None:
    (folder / "noise.function.yaml").write_text(BROKEN)
    assert rejected(functions)["noise"]
    said, *findings = caplog.messages
    assert "the last good state stays" in said
    assert any("noise.function.yaml" in each and "F004" in each for each in findings)


def test_it_is_taken_as_soon_as_it_is_good_again(folder: Path, functions: FunctionLibrary, catalogues: Library) -> None:
    for text in (BROKEN, HALF):
        (folder / "noise.function.yaml").write_text(text)
        assert rejected(functions)["noise"]
    better = noise(path="Vehicle.Cabin.HVAC.AmbientAirTemperature")
    (folder / "noise.function.yaml").write_text(better)
    assert rejected(functions) == {"noise": []}
    assert data(functions) == better
    assert function_over(functions.files, catalogues.default.catalogue, "noise").function


def test_it_is_good_if_it_builds_over_any_catalogue(folder: Path, functions: FunctionLibrary) -> None:
    (folder / "noise.function.yaml").write_text(noise(path="Vehicle.Cabin.Hum"))
    assert rejected(functions) == {"noise": []}


def test_the_findings_are_those_where_it_fits_best(folder: Path, functions: FunctionLibrary) -> None:
    (folder / "noise.function.yaml").write_text(
        noise(path="Vehicle.Cabin.Hum").replace("cycleTime: 100", "cycleTime: often")
    )
    assert rejected(functions) == {"noise": ["F004"]}


def test_what_was_never_good_is_shown_as_it_is(folder: Path, functions: FunctionLibrary) -> None:
    (folder / "new.function.yaml").write_text(HALF)
    assert rejected(functions) == {"new": [], "noise": []}
    (folder / "new.function.yaml").write_text(BROKEN)
    assert rejected(functions) == {"new": [], "noise": []}
    assert data(functions, "new") == BROKEN


def test_a_file_that_goes_is_gone(folder: Path, functions: FunctionLibrary) -> None:
    (folder / "noise.function.yaml").write_text(HALF)
    assert rejected(functions)["noise"]
    (folder / "noise.function.yaml").unlink()
    assert rejected(functions) == {}


def test_others_use_the_last_good_state_of_what_they_share(folder: Path, functions: FunctionLibrary) -> None:
    """One defines what the other reads, and breaks in the same moment as the other begins to read more of it."""
    giver = noise("Giver").replace(
        "define:\n", "define:\n  data:\n    Vehicle.Cabin.Buzz: {type: sensor, datatype: float, description: A buzz.}\n"
    )
    (folder / "giver.function.yaml").write_text(giver)
    (folder / "taker.function.yaml").write_text(noise("Taker", "Vehicle.Cabin.Buzz"))
    assert rejected(functions) == {"giver": [], "noise": [], "taker": []}
    more = giver.replace("Buzz:", "Buzzing:").replace("cycleTime: 100", "cycleTime: often")
    (folder / "giver.function.yaml").write_text(more)
    (folder / "taker.function.yaml").write_text(noise("Taker", "Vehicle.Cabin.Buzzing"))
    assert {name for name, rules in rejected(functions).items() if rules} == {"giver", "taker"}
    assert data(functions, "giver") == giver
    assert data(functions, "taker") == noise("Taker", "Vehicle.Cabin.Buzz")


def test_without_catalogues_files_are_taken_as_they_are(folder: Path) -> None:
    functions = FunctionLibrary([folder], has_shipped=False)
    (folder / "noise.function.yaml").write_text(BROKEN)
    assert rejected(functions) == {"noise": []}
    assert data(functions) == BROKEN


def test_a_file_that_cannot_be_read_any_more_stays(
    folder: Path, functions: FunctionLibrary, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(_: Path, _mode: str) -> bytes:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "open", refuse)
    assert rejected(functions) == {"noise": ["R012"]}
    monkeypatch.undo()
    assert rejected(functions) == {"noise": []}


def test_a_hosted_file_knows_where_it_is(folder: Path, functions: FunctionLibrary) -> None:
    file = HostedFile("deep", "functions/a/b.function.yaml", b"", str(folder), (Finding("F001", "error", "Wrong."),))
    assert file.path == folder / "a" / "b.function.yaml"
    assert [each.path for each in functions.files] == [folder / "noise.function.yaml"]
