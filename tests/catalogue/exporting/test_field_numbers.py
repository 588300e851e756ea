"""Numbers of Protocol Buffers fields that stay from export to export."""

import json
import re

import pytest

from sigcat.catalogue.exporting.export import export
from sigcat.catalogue.exporting.field_numbers import EMPTY, Lock, continued, lock_bytes, read_lock
from sigcat.cli import main
from sigcat.errors import InputRefused, UsageError
from sigcat.limits import DEFAULT_LIMITS
from tests.catalogue.comparing.running import signal
from tests.catalogue.trees import ROOT, catalogue_of

DOOR = "Vehicle.Door:\n  type: branch\n  description: A door.\n  instances: [{}]\n"
OPEN = signal("Vehicle.Door.IsOpen")
MODE = "Vehicle.Mode:\n  type: sensor\n  datatype: string\n  allowed: [{}]\n  description: Mode.\n"


def proto(text: str, lock=None, **options: object) -> str:
    """The exported file; the lock, if there is one, is continued."""
    given = {"keep_numbers_of": lock} if lock else {}
    files = export(catalogue_of(ROOT + text), "protobuf", {**given, **options})
    for file in files:
        if file.option:
            lock.write_bytes(file.data)
    return files[0].data.decode()


def numbers(text: str) -> dict[str, int]:
    return {name: int(number) for name, number in re.findall(r"(\w+) = (\d+);", text)}


@pytest.fixture
def lock(tmp_path):
    return tmp_path / "numbers.json"


def test_the_first_numbers_are_those_of_an_export_without_a_lock(lock):
    text = signal("Vehicle.A") + DOOR.format("Left, Right") + OPEN + MODE.format("ECO, SPORT")
    assert proto(text, lock) == proto(text)


def test_a_signal_in_the_middle_gets_the_next_number(lock):
    proto(signal("Vehicle.A") + signal("Vehicle.C"), lock)
    new = signal("Vehicle.A") + signal("Vehicle.B") + signal("Vehicle.C")
    assert numbers(proto(new, lock)) == {"A": 1, "C": 2, "B": 3}


def test_the_number_of_a_removed_signal_is_not_given_again_and_comes_back_with_it(lock):
    proto(signal("Vehicle.A") + signal("Vehicle.B"), lock)
    assert numbers(proto(signal("Vehicle.A") + signal("Vehicle.C"), lock)) == {"A": 1, "C": 3}
    assert numbers(proto(signal("Vehicle.B") + signal("Vehicle.C"), lock)) == {"B": 2, "C": 3}


def test_instances_have_numbers_of_their_own(lock):
    proto(DOOR.format("Left, Right") + OPEN, lock)
    found = numbers(proto(DOOR.format("Middle, Left, Right") + OPEN, lock))
    assert (found["Left"], found["Right"], found["Middle"]) == (1, 2, 3)


def test_texts_of_an_enumeration_keep_their_numbers(lock):
    proto(MODE.format("ECO, SPORT"), lock)
    found = numbers(proto(MODE.format("SNOW, SPORT, ECO"), lock))
    assert (found["ECO"], found["SPORT"], found["SNOW"]) == (0, 1, 2)


def test_a_removed_text_keeps_its_number(lock):
    proto(MODE.format("PARK, REVERSE, NEUTRAL"), lock)
    found = numbers(proto(MODE.format("PARK, NEUTRAL, DRIVE"), lock))
    assert (found["PARK"], found["REVERSE"], found["NEUTRAL"], found["DRIVE"]) == (0, 1, 2, 3)


def test_after_the_largest_number_there_is_none(lock):
    lock.write_bytes(lock_bytes(Lock({"Vehicle": {"B": 2**29 - 1}}, {})))
    with pytest.raises(UsageError, match="no larger one"):
        proto(signal("Vehicle.A"), lock)


def test_fields_that_two_branches_gave_one_number_are_named(lock):
    lock.write_bytes(lock_bytes(Lock({"Vehicle": {"A": 1, "W": 2, "Y": 2}}, {})))
    with pytest.raises(InputRefused) as refused:
        read_lock(lock)
    (finding,) = refused.value.findings
    assert finding.message == "Vehicle.W and Vehicle.Y must not both have the number 2."
    assert "take the file from git" in finding.fix


def test_a_static_uid_in_the_tree_is_no_number_of_the_lock(lock):
    assert numbers(proto(signal("Vehicle.A", staticUID="0x1000"), lock)) == {"A": 1}


def test_a_strict_export_takes_the_numbers(lock):
    assert numbers(proto(signal("Vehicle.A"), lock, strict=True)) == {"A": 1}


def test_numbers_that_protobuf_reserves_are_passed_over():
    catalogue = catalogue_of(ROOT + signal("Vehicle.A") + signal("Vehicle.B"))
    assert continued(Lock({"Vehicle": {"A": 18_999}}, {}), catalogue).messages["Vehicle"]["B"] == 20_000


def test_a_lock_is_read_as_it_was_written(lock):
    made = continued(EMPTY, catalogue_of(ROOT + signal("Vehicle.A") + MODE.format("ECO, SPORT")))
    lock.write_bytes(lock_bytes(made))
    assert read_lock(lock) == made


def test_two_ways_to_number_are_refused(lock):
    with pytest.raises(UsageError, match="either --keep-numbers-of or --static-uid"):
        proto(signal("Vehicle.A"), lock, static_uid=True)


@pytest.mark.parametrize(
    "content",
    [
        "", "[]", "{", "[" * 100_000, '{"messages": {}}', '{"messages": [], "enumerations": {}}',
        '{"messages": {"Vehicle": 1}, "enumerations": {}}', '{"messages": {"Vehicle": {"A": 0}}, "enumerations": {}}',
        '{"messages": {"Vehicle": {"A": true}}, "enumerations": {}}', '{"messages": {"Vehicle": {"A": 19500}}, "enumerations": {}}',
        '{"messages": {"Vehicle": {"A": 1e400}}, "enumerations": {}}', '{"messages": {"Vehicle": {"A": 536870912}}, "enumerations": {}}',
        '{"messages": {"Vehicle": {"A": 1, "B": 1}}, "enumerations": {}}', '{"messages": {}, "enumerations": {"Vehicle.A": [1]}}',
    ],
)  # fmt: skip
def test_a_file_that_is_no_lock_is_a_finding_and_nothing_is_written(content, lock, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "tree.vspec").write_text(ROOT + signal("Vehicle.A"))
    lock.write_text(content)
    status = main(["export", "protobuf", "-s", "tree.vspec", "--keep-numbers-of", lock.name, "-o", "tree.proto"])
    assert status == 1
    assert "numbers.json:1" in capsys.readouterr().err
    assert lock.read_text() == content
    assert not (tmp_path / "tree.proto").exists()


def test_the_command_writes_the_lock_beside_the_file(tmp_path, monkeypatch, capsysbinary):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "tree.vspec").write_text(ROOT + signal("Vehicle.A"))
    assert main(["export", "protobuf", "-s", "tree.vspec", "--keep-numbers-of", "numbers.json"]) == 0
    assert b"float A = 1;" in capsysbinary.readouterr().out
    assert json.loads((tmp_path / "numbers.json").read_text())["messages"] == {"Vehicle": {"A": 1}}


def test_a_lock_that_is_too_large_is_refused(lock):
    lock.write_text(" " * 100)
    with pytest.raises(InputRefused):
        read_lock(lock, DEFAULT_LIMITS._replace(file_bytes=99))


def test_no_file_has_numbers_that_the_lock_does_not_remember(tmp_path, monkeypatch, capsys):
    (tmp_path / "tree.vspec").write_text(ROOT + signal("Vehicle.Speed"))
    monkeypatch.chdir(tmp_path)
    assert (
        main(["export", "protobuf", "-s", "tree.vspec", "--keep-numbers-of", "tree.vspec/no.json", "-o", "a.proto"])
        == 2
    )
    assert not (tmp_path / "a.proto").exists()
    assert "tree.vspec must be a folder, not a file" in capsys.readouterr().err


CHANGED = {
    "a new signal in the middle": (signal("Vehicle.A") + signal("Vehicle.C"), signal("Vehicle.B"), ("A", "B", "C")),
    "another order": (signal("Vehicle.A") + signal("Vehicle.C"), "", ("C", "A")),
}


@pytest.mark.parametrize(("text", "more", "order"), CHANGED.values(), ids=CHANGED)
def test_a_comparison_takes_the_numbers_too(text, more, order, tmp_path, capsys, lock):
    proto(text, lock)
    parts = {"A": signal("Vehicle.A"), "B": more, "C": signal("Vehicle.C")}
    for name, content in (("old", text), ("new", "".join(parts[part] for part in order))):
        (tmp_path / f"{name}.vspec").write_text(ROOT + content)
    sides = [str(tmp_path / f"{name}.vspec") for name in ("old", "new")]
    command = ["diff", "--isolated", *sides, "--binding", "protobuf", "--fail-on", "breaking"]
    assert main(command) == 1
    assert main([*command, "--keep-numbers-of", str(lock)]) == 0
    lock.write_bytes(lock_bytes(EMPTY))
    assert main([*command, "--keep-numbers-of", str(lock)]) == 1, "numbers that the file does not have"
    lock.write_text("[]")
    assert main([*command, "--keep-numbers-of", str(lock)]) == 1
    assert "numbers.json:1:1: error R007" in capsys.readouterr().err
    lock.unlink()
    assert main([*command, "--keep-numbers-of", str(lock)]) == 2
    assert "numbers.json: No such file or directory" in capsys.readouterr().err


def test_a_comparison_takes_the_places_of_texts_too(tmp_path, capsys, lock):
    proto(MODE.format("A, B"), lock)
    for name, allowed in (("old", "A, B"), ("new", "B, C, A")):
        (tmp_path / f"{name}.vspec").write_text(ROOT + MODE.format(allowed))
    command = ["diff", "--isolated", *(str(tmp_path / f"{name}.vspec") for name in ("old", "new"))]
    assert main([*command, "--binding", "protobuf"]) == 0
    assert "[breaking" in capsys.readouterr().out
    assert main([*command, "--binding", "protobuf", "--keep-numbers-of", str(lock)]) == 0
    assert "[breaking" not in capsys.readouterr().out
    assert main([*command, "--binding", "c", "--keep-numbers-of", str(lock)]) == 0
    assert "[breaking" in capsys.readouterr().out
