"""`sigcat generate … -o DIR` replaces what it has written before, and nothing else without being told."""

import shutil
from pathlib import Path

import pytest

from sigcat.adapter.core.core_files import runtime_files
from sigcat.cli import main
from sigcat.cli.generated_folder import LIST
from sigcat.data import EXAMPLES
from sigcat.digest import digest_of
from sigcat.platforms.table import PLATFORMS

FUNCTION = EXAMPLES / "core_acc" / "function.yaml"
PLATFORM_OF = {generator.name: platform.name for platform in PLATFORMS.values() for generator in platform.generators}


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture(autouse=True)
def named(folder):
    """Sets of any functions have one name."""
    Path("named.yaml").write_text("name: Set\n")


def core(*options):
    return main(["generate", "core", str(FUNCTION), "-o", "out", *options])


def contents(folder):
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in Path(folder).rglob("*") if path.is_file()
    }


def test_the_list_names_what_was_written_and_can_be_read():
    assert core() == 0
    first, *rows = Path("out", LIST).read_text(encoding="utf-8").splitlines()
    assert first.startswith("# Written by `sigcat generate`")
    names = [row.rpartition(" ")[2] for row in rows]
    assert rows == [f"core {digest_of(Path('out', name).read_bytes())} {name}" for name in names]
    assert names == ["CoreAcc_adapter.c", "CoreAcc_adapter.h", *(file.name for file in runtime_files())]
    assert set(contents("out")) == {*names, LIST}


@pytest.mark.parametrize("name", [*PLATFORM_OF, "core"])
def test_a_file_of_others_is_not_replaced_and_nothing_else_is_written(name, capsys):
    source = str(FUNCTION)
    if name != "core":
        source = "integration.json"
        assert main(["integrate", PLATFORM_OF[name], str(FUNCTION), "-o", source]) == 0
    assert main(["generate", name, source, "-o", "all"]) == 0
    last = max(set(contents("all")) - {LIST})
    Path("out", last).parent.mkdir(parents=True)
    Path("out", last).write_text("mine\n")
    capsys.readouterr()
    assert main(["generate", name, source, "-o", "out"]) == 2
    message = capsys.readouterr().err
    assert str(Path("out", last)) in message
    assert "--force" in message
    assert contents("out") == {last: b"mine\n"}
    assert main(["generate", name, source, "-o", "out", "--force"]) == 0
    assert contents("out") == contents("all")


def older(path):
    """Let a file be what an older run has written there."""
    path = Path(path)
    text = path.with_name(LIST) if path.with_name(LIST).is_file() else Path("out", LIST)
    was = digest_of(path.read_bytes())
    path.write_text("older\n")
    text.write_text(text.read_text().replace(was, digest_of(path.read_bytes())))


def test_what_was_written_before_is_replaced():
    assert core() == 0
    before = contents("out")
    older("out/CoreAcc_adapter.c")
    assert core() == 0
    assert contents("out") == before


def test_what_was_changed_since_is_not_lost(capsys):
    assert core() == 0
    Path("out/CoreAcc_adapter.c").write_text("mine\n")
    assert core() == 2
    assert (
        "out/CoreAcc_adapter.c is not a file that `sigcat generate` wrote, or was changed since"
        in capsys.readouterr().err
    )
    assert Path("out/CoreAcc_adapter.c").read_text() == "mine\n"
    assert core("--force") == 0


def test_the_list_goes_with_the_folder_as_in_a_clone():
    assert core() == 0
    shutil.move("out", "elsewhere")
    older("elsewhere/CoreAcc_adapter.h")
    assert main(["generate", "core", str(FUNCTION), "-o", "elsewhere"]) == 0


def test_a_function_that_left_the_set_leaves_no_files_behind():
    other = EXAMPLES / "eco_control_mpc" / "function.yaml"
    for name, functions in (("both.json", (FUNCTION, other)), ("one.json", (FUNCTION,))):
        assert main(["integrate", "ros2", *map(str, functions), "--deployment", "named.yaml", "-o", name]) == 0
    assert main(["generate", "ros2", "both.json", "-o", "out"]) == 0
    leaving = {name for name in contents("out") if "eco_control_mpc" in name}
    changed = min(leaving)
    Path("out", changed).write_text("mine\n")
    Path("out", "notes.txt").write_text("mine too\n")
    assert main(["generate", "ros2", "one.json", "-o", "out"]) == 0
    assert main(["generate", "ros2", "one.json", "-o", "alone"]) == 0
    assert set(contents("out")) == {*contents("alone"), changed, "notes.txt"}


def test_functions_may_be_generated_one_after_the_other():
    assert core() == 0
    assert main(["generate", "core", str(EXAMPLES / "eco_control_mpc" / "function.yaml"), "-o", "out"]) == 0
    assert Path("out/CoreAcc_adapter.c").is_file()


@pytest.mark.parametrize("name", ["../mine.txt", "/mine.txt"])
def test_a_list_that_names_files_elsewhere_removes_none(tmp_path, name):
    assert main(["integrate", "ros2", str(FUNCTION), "-o", "one.json"]) == 0
    assert main(["generate", "ros2", "one.json", "-o", "out"]) == 0
    mine = tmp_path / "mine.txt"
    mine.write_text("mine\n")
    name = name if name.startswith("..") else str(mine)
    with Path("out", LIST).open("a") as file:
        file.write(f"ros2 {digest_of(mine.read_bytes())} {name}\n")
    assert main(["generate", "ros2", "one.json", "-o", "out"]) == 0
    assert mine.is_file()


def test_files_that_are_the_same_already_need_no_list():
    assert core() == 0
    Path("out", LIST).unlink()
    assert core() == 0
    assert Path("out", LIST).is_file()


def test_two_generators_share_a_folder_and_each_knows_its_files():
    assert main(["integrate", "autosar-adaptive", str(FUNCTION), "-o", "autosar.json"]) == 0
    arxml = ["generate", "arxml", "autosar.json", "-o", "out"]
    assert main(arxml) == 0
    assert core() == 0
    older("out/types.arxml")
    older("out/CoreAcc_adapter.c")
    assert main(arxml) == 0
    assert core() == 0


def test_what_was_deleted_is_forgotten_so_that_a_file_of_the_same_name_is_not_lost():
    assert main(["integrate", "autosar-adaptive", str(FUNCTION), "-o", "autosar.json"]) == 0
    assert main(["generate", "arxml", "autosar.json", "-o", "out"]) == 0
    Path("out/types.arxml").unlink()
    assert core() == 0
    Path("out/types.arxml").write_text("mine\n")
    assert main(["generate", "arxml", "autosar.json", "-o", "out"]) == 2
    assert Path("out/types.arxml").read_text() == "mine\n"


def test_a_link_is_a_file_of_others_even_if_it_leads_nowhere_yet():
    Path("out").mkdir()
    Path("out/CoreAcc_adapter.c").symlink_to("../elsewhere.c")
    assert core() == 2
    assert not Path("elsewhere.c").exists()


def test_the_first_file_of_several_is_named_and_the_others_are_counted(capsys):
    Path("out").mkdir()
    for name in ("CoreAcc_adapter.c", "CoreAcc_adapter.h"):
        Path("out", name).write_text("mine\n")
    assert core() == 2
    assert "(and 1 more)" in capsys.readouterr().err
