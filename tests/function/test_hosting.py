"""Functions of a service: what is found in the folders of its configuration, and read again when it changes."""

from pathlib import Path

import pytest

from sigcat.catalogue.hosting.library import Library, shipped_sources
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.data import EXAMPLES
from sigcat.errors import NotFound
from sigcat.function.function_file import build_function
from sigcat.function.function_json.model import to_json
from sigcat.function.hosting import FunctionLibrary, _read, built_over, function_over, functions_over
from sigcat.limits import HOSTED_FUNCTION_BYTES
from tests.unreadable import unreadable

NOISE = """\
function: {name}
description: Watches the noise in the cabin.
responsible: Acoustics
define:
  scheduling:
    Init: {{asil: QM, description: Clears the mean.}}
    Step: {{cycleTime: 100, asil: QM, description: Adds a value to the mean.}}
    Terminate: {{asil: QM, description: Gives resources back.}}
components:
  - name: {name}
    runnables:
      - Init
      - interface: Step
        data:
          - {{path: {path}, role: consumed, variable: speed, asil: QM}}
      - Terminate
"""


def noise(name: str = "CabinNoise", path: str = "Vehicle.Speed") -> str:
    return NOISE.format(name=name, path=path)


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Library(shipped_sources()).default.catalogue


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    folder = tmp_path / "functions"
    (folder / "cabin_noise").mkdir(parents=True)
    (folder / "cabin_noise" / "function.yaml").write_text(noise())
    return folder


def ids(library: FunctionLibrary) -> list[str]:
    return [file.id for file in library.files]


def test_a_folder_that_cannot_be_read_is_logged(folder: Path, monkeypatch, caplog) -> None:
    (folder / "closed").mkdir()
    unreadable(folder / "closed", monkeypatch)
    assert ids(FunctionLibrary((folder,), has_shipped=False)) == ["cabin_noise"]
    assert f"{folder / 'closed'}: Permission denied" in caplog.text


def test_without_folders_it_has_what_sigcat_ships() -> None:
    assert sorted(ids(FunctionLibrary())) == sorted(path.parent.name for path in EXAMPLES.glob("*/function.yaml"))
    assert ids(FunctionLibrary(has_shipped=False)) == []


def test_functions_of_ones_own_come_before_shipped_ones(folder: Path) -> None:
    library = FunctionLibrary([folder])
    assert ids(library)[0] == "cabin_noise"
    assert [file.name for file in library.files if not file.is_shipped] == ["functions/cabin_noise/function.yaml"]


def test_a_function_is_named_by_its_folder_or_its_file(folder: Path) -> None:
    (folder / "door.function.yaml").write_text(noise("Door"))
    (folder / "deep" / "door").mkdir(parents=True)
    (folder / "deep" / "door" / "function.yaml").write_text(noise("OtherDoor"))
    assert ids(FunctionLibrary([folder], has_shipped=False)) == ["cabin_noise", "door", "door-2"]


def test_a_file_is_read_once_for_all_catalogues(folder: Path) -> None:
    files = FunctionLibrary([folder], has_shipped=False).files
    before = _read.cache_info().misses
    for hosted in Library(shipped_sources()):
        assert len(built_over(files, hosted.catalogue)) == 1
    assert _read.cache_info().misses - before <= 1


def test_a_file_that_is_too_large_is_skipped_and_named(folder: Path) -> None:
    large = folder / "large.function.yaml"
    large.write_text(noise("Large") + "#" * HOSTED_FUNCTION_BYTES)
    library = FunctionLibrary([folder], has_shipped=False)
    assert (ids(library), library.skipped) == (["cabin_noise"], ("functions/large.function.yaml",))
    large.write_text(noise("Large"))
    library.reload()
    assert (ids(library), library.skipped) == (["cabin_noise", "large"], ())


def test_a_file_that_became_too_large_stays_as_it_was_last_good(folder: Path) -> None:
    library = FunctionLibrary([folder], has_shipped=False)
    file = folder / "cabin_noise" / "function.yaml"
    file.write_text(noise() + "#" * HOSTED_FUNCTION_BYTES)
    (kept,) = library.reload()
    assert (kept.data.decode(), [finding.rule for finding in kept.rejected]) == (noise(), ["R003"])
    assert library.skipped == ()
    file.write_text(noise("Quiet"))
    (fresh,) = library.reload()
    assert (fresh.rejected, b"Quiet" in fresh.data) == ((), True)


def test_only_functions_are_taken_from_a_folder(folder: Path) -> None:
    (folder / "deployment.yaml").write_text("ros2: {package: noise}\n")
    (folder / "integration.json").write_text('{"FunctionInfo": {}, "CommunicationList": []}')
    (folder / ".hidden").mkdir()
    (folder / ".hidden" / "function.yaml").write_text(noise("Hidden"))
    assert ids(FunctionLibrary([folder], has_shipped=False)) == ["cabin_noise"]


def test_function_json_is_taken_unless_its_declaration_is_there(folder: Path, catalogue: Catalogue) -> None:
    for name in ("CabinNoise", "Other"):
        made, _ = build_function(noise(name).encode(), "function.yaml", catalogue)
        (folder / f"{name}.json").write_bytes(to_json(made))
    functions = functions_over(FunctionLibrary([folder], has_shipped=False).files, catalogue)
    assert [(each.id, each.name, each.file.is_json) for each in functions] == [
        ("Other", "Other", True),
        ("cabin_noise", "CabinNoise", False),
    ]


def test_a_function_uses_what_another_one_of_its_folder_defines(folder: Path, catalogue: Catalogue) -> None:
    defining = noise("Giver").replace(
        "define:\n", "define:\n  data:\n    Vehicle.Cabin.Hum: {type: sensor, datatype: float, description: A hum.}\n"
    )
    (folder / "giver.function.yaml").write_text(defining)
    (folder / "taker.function.yaml").write_text(noise("Taker", "Vehicle.Cabin.Hum"))
    files = FunctionLibrary([folder]).files
    assert function_over(files, catalogue, "taker").findings == ()


def test_what_is_wrong_with_one_function_leaves_the_others_as_they_are(folder: Path, catalogue: Catalogue) -> None:
    (folder / "broken.function.yaml").write_text("function: [")
    files = FunctionLibrary([folder]).files
    assert function_over(files, catalogue, "broken").findings[0].file == "functions/broken.function.yaml"
    assert [each.id for each in functions_over(files, catalogue) if each.function is None] == ["broken"]


def test_one_of_ones_own_replaces_a_shipped_one_of_the_same_id(folder: Path, catalogue: Catalogue) -> None:
    (folder / "core_acc").mkdir()
    (folder / "core_acc" / "function.yaml").write_text(noise("OurAcc"))
    assert function_over(FunctionLibrary([folder]).files, catalogue, "core_acc").name == "OurAcc"


def test_near_names_are_proposed(catalogue: Catalogue) -> None:
    with pytest.raises(NotFound) as missing:
        function_over(FunctionLibrary().files, catalogue, "core_ac")
    assert "core_acc" in missing.value.nearest


def test_a_file_that_may_be_half_written_is_read_once_it_is_the_same_at_two_looks(folder: Path) -> None:
    library = FunctionLibrary([folder], has_shipped=False)
    assert not library.reload_settled()
    for text in (noise("New"), noise("Newer")):
        (folder / "new.function.yaml").write_text(text)
        assert not library.reload_settled()
    assert ids(library) == ["cabin_noise"]
    assert library.reload_settled()
    assert ids(library) == ["cabin_noise", "new"]
    assert not library.reload_settled()


def test_changes_in_the_folder_are_seen(folder: Path) -> None:
    library = FunctionLibrary([folder], has_shipped=False)
    before = library.digest
    assert not library.reload_changed()
    (folder / "new.function.yaml").write_text(noise("New"))
    assert library.reload_changed()
    assert ids(library) == ["cabin_noise", "new"]
    assert library.digest != before
    (folder / "new.function.yaml").unlink()
    assert library.reload_changed()
    assert (ids(library), library.digest) == (["cabin_noise"], before)
