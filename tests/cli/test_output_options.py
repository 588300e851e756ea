"""No command writes over a file that it reads, however the two are spelled, nor two results into one file."""

import os
import shutil
from pathlib import Path

import pytest

from sigcat.cli import main

PROJECT = Path(__file__).parents[2]
TREE = """\
Vehicle:
  type: branch
  description: A vehicle.
#include part.vspec Vehicle
"""
PART = """\
Speed:
  type: sensor
  datatype: float
  unit: km/h
  description: How fast it is.
"""
OVERLAY = """\
Vehicle.Speed:
  type: sensor
  datatype: float
  unit: km/h
  description: How fast the vehicle is.
"""
UNITS = "km/h:\n  definition: Kilometres per hour\n  unit: kilometre per hour\n  quantity: velocity\n  allowed-datatypes: ['numeric']\n"
QUANTITIES = "velocity:\n  definition: Distance in a time\n"
TYPES = "Types:\n  type: branch\n  description: Types.\n"

TREE_OPTIONS = (
    "-s",
    "tree/tree.vspec",
    "-l",
    "overlay.vspec",
    "-u",
    "units.yaml",
    "-q",
    "quantities.yaml",
    "-t",
    "types.vspec",
)
EXPORT = ("export", "json", *TREE_OPTIONS)
ROS2 = ("integrate", "ros2", "function.yaml")
OVERWRITING = {
    "the tree": (*EXPORT, "-o", "tree/tree.vspec"),
    "the tree, by an absolute path": (*EXPORT, "-o", "{here}/tree/tree.vspec"),
    "the tree, by steps up": (*EXPORT, "-o", "tree/../tree/tree.vspec"),
    "the tree, by a link": (*EXPORT, "-o", "link.vspec"),
    "the tree, by a second name": (*EXPORT, "-o", "second.vspec"),
    "the tree, of which a link was read": ("export", "json", "-s", "link.vspec", "-I", "tree", "-o", "tree/tree.vspec"),
    "an included file": (*EXPORT, "-o", "tree/part.vspec"),
    "a file of the folder": ("export", "json", "-s", "tree", "-o", "tree/tree.vspec"),
    "an overlay": (*EXPORT, "-o", "overlay.vspec"),
    "units": (*EXPORT, "-o", "units.yaml"),
    "units beside the tree, which no option names": ("export", "json", "-s", "tree/tree.vspec", "-o", "tree/units.yaml"),
    "quantities": (*EXPORT, "-o", "quantities.yaml"),
    "struct types": (*EXPORT, "-o", "types.vspec"),
    "the tree, by the second output": (*EXPORT, "-o", "new", "--types-output", "tree/tree.vspec"),
    "with vss-tools": ("export", "csv", *TREE_OPTIONS, "-o", "tree/part.vspec"),
    "exceptions": (*EXPORT, "--strict-exceptions", "exceptions.yaml", "-o", "exceptions.yaml"),
    "the function, built": ("function", "build", "function.yaml", "-o", "function.yaml"),
    "the function, its overlay": ("function", "overlay", "function.yaml", "-o", "function.yaml"),
    "the function, its types": ("function", "overlay", "function.yaml", "-o", "new", "--types-output", "function.yaml"),
    "the function, integrated": (*ROS2, "-o", "function.yaml"),
    "the function, in the report": (*ROS2, "-o", "new", "--report", "function.yaml"),
    "the deployment": (*ROS2, "--deployment", "deployment.yaml", "-o", "deployment.yaml"),
    "a side": ("diff", "tree", "other.vspec", "-o", "other.vspec"),
    "an included file of a side": ("diff", "tree", "other.vspec", "-o", "tree/part.vspec"),
    "an overlay of a side": ("diff", "tree+overlay.vspec", "tree", "-o", "overlay.vspec"),
    "an exported side": ("diff", "tree.json", "tree.json", "-o", "tree.json"),
    "a linted file": ("lint", "tree/tree.vspec", "-o", "tree/tree.vspec"),
    "a file of a linted folder": ("lint", "tree", "-o", "tree/part.vspec"),
    "a linted file, as baseline": ("lint", "tree/tree.vspec", "--write-baseline", "tree/tree.vspec"),
    "the tree of a linted overlay": ("lint", "overlay.vspec", "-s", "tree", "-o", "tree/part.vspec"),
    "the tree of a linted function": ("lint", "function.yaml", "-s", "tree", "-o", "tree/part.vspec"),
    "the configuration of a lint": ("lint", "overlay.vspec", "-o", "sigcat.toml"),
    "the rules of a lint": ("lint", "overlay.vspec", "-o", "rules.yaml"),
    "the baseline that is compared with": ("lint", "tree", "--baseline", "known.json", "--write-baseline", "known.json"),
}  # fmt: skip
TWICE = {
    "the report": (*ROS2, "-o", "new", "--report", "new"),
    "the report, spelled otherwise": (*ROS2, "-o", "new", "--report", "./new"),
    "the report, over an old file": (*ROS2, "-o", "old", "--report", "{here}/old"),
    "struct types": ("export", "csv", *TREE_OPTIONS, "-o", "new", "--types-output", "new"),
    "struct types of a function": ("function", "overlay", "function.yaml", "-o", "new", "--types-output", "new"),
    "baseline": ("lint", "tree", "--write-baseline", "new", "-o", "new"),
}


@pytest.fixture(scope="module")
def prepared(tmp_path_factory):
    """A folder with every kind of input, and with what commands make of it."""
    folder = tmp_path_factory.mktemp("prepared")
    texts = {
        "tree/tree.vspec": TREE, "tree/part.vspec": PART, "tree/units.yaml": UNITS, "tree/quantities.yaml": QUANTITIES,
        "overlay.vspec": OVERLAY, "units.yaml": UNITS, "quantities.yaml": QUANTITIES, "types.vspec": TYPES,
        "other.vspec": TREE.partition("#")[0], "exceptions.yaml": "{}\n", "deployment.yaml": "{}\n", "old": "old\n",
        "sigcat.toml": '[lint]\nrules = ["rules.yaml"]\n', "rules.yaml": "{}\n",
    }  # fmt: skip
    (folder / "tree").mkdir()
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    shutil.copy(PROJECT / "examples/core_acc/function.yaml", folder / "function.yaml")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        assert main(["export", "json", "-s", "tree", "-o", "tree.json"]) == 0
        assert main(["lint", "tree", "--write-baseline", "known.json"]) == 0
    return folder


@pytest.fixture(autouse=True)
def folder(prepared, tmp_path, monkeypatch):
    shutil.copytree(prepared, tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    Path("link.vspec").symlink_to("tree/tree.vspec")
    os.link("tree/tree.vspec", "second.vspec")
    return tmp_path


def contents(folder):
    return {file: file.read_bytes() for file in folder.rglob("*") if file.is_file()}


def run(command, folder):
    return main([part.format(here=folder) for part in command])


@pytest.mark.parametrize("command", OVERWRITING.values(), ids=OVERWRITING)
def test_what_is_read_is_not_written(command, folder, capsys):
    before = contents(folder)
    assert run(command, folder) == 2
    assert "would be lost" in capsys.readouterr().err
    assert contents(folder) == before


SOURCES = {
    "C code": (("diff", "tree", "other.vspec", "-o", "step.c"), "C or C++ code"),
    "a header": (("lint", "tree", "-o", "step.hpp"), "C or C++ code"),
    "a function that is not read": (("export", "csv", "-s", "tree", "-o", "function.yaml"), "a function"),
    "a deployment that is not read": (
        ("diff", "tree", "other.vspec", "-o", "project/deploy.yaml"),
        "a file of a project",
    ),
    "an overlay of a project": (("lint", "tree", "-o", "project/acme.vspec"), "a file of a project"),
    "the project file": (("schema", "deployment", "-o", "project/sigcat.toml"), "a file of a project"),
    "a baseline over code": (("lint", "tree", "--write-baseline", "step.c"), "C or C++ code"),
}


@pytest.mark.parametrize(("command", "kind"), SOURCES.values(), ids=SOURCES)
def test_sources_are_not_written_though_the_command_does_not_read_them(command, kind, folder, capsys):
    Path("step.c").write_text("int step;\n")
    Path("step.hpp").write_text("extern int step;\n")
    Path("project").mkdir()
    Path("project/deploy.yaml").write_text("name: Acme\n")
    Path("project/acme.vspec").write_text(OVERLAY)
    Path("project/sigcat.toml").write_text(
        'deployment = "deploy.yaml"\n[[catalogue]]\nid = "acme"\ntitle = "Acme"\nrelease = "shipped"\noverlays = ["acme.vspec"]\n'
    )
    before = contents(folder)
    assert run(command, folder) == 2
    assert f"is {kind}, which people write, and would be lost" in capsys.readouterr().err
    assert contents(folder) == before


def test_a_report_that_is_refused_is_not_written_after_the_error(folder, capsys):
    before = contents(folder)
    command = (
        "simulate",
        "function.yaml",
        "-s",
        "tree",
        "--trace",
        "units.yaml",
        "-o",
        "out.csv",
        "--report",
        "units.yaml",
    )
    assert run(command, folder) == 2
    assert "is read by this command" in capsys.readouterr().err
    assert contents(folder) == before


def test_a_report_that_is_a_file_of_the_tree_is_not_written_after_the_error(folder, capsys):
    before = contents(folder)
    trace = folder / "trace.csv"
    trace.write_text("time\n0\n")
    assert (
        run(("simulate", "function.yaml", *TREE_OPTIONS, "--trace", str(trace), "--report", "tree/part.vspec"), folder)
        == 2
    )
    trace.unlink()
    assert contents(folder) == before


@pytest.mark.parametrize("command", TWICE.values(), ids=TWICE)
def test_two_results_need_two_files(command, folder, capsys):
    before = contents(folder)
    assert run(command, folder) == 2
    assert "is named for two results" in capsys.readouterr().err
    assert contents(folder) == before


def test_what_a_generator_writes_into_a_folder_is_not_what_it_reads(folder, capsys):
    """The name of the input is that of a generated file."""
    assert main(["integrate", "autosar-adaptive", "function.yaml", "-o", "integration.json"]) == 0
    assert main(["generate", "arxml", "integration.json", "-o", "arxml"]) == 0
    generated = Path("arxml/types.arxml")
    shutil.copy("integration.json", generated)
    before = contents(folder)
    assert main(["generate", "arxml", str(generated), "-o", "arxml"]) == 2
    assert "is read by this command" in capsys.readouterr().err
    assert contents(folder) == before


def test_the_report_of_a_generator_is_none_of_its_files(folder):
    assert main(["integrate", "autosar-adaptive", "function.yaml", "-o", "integration.json"]) == 0
    assert main(["generate", "arxml", "integration.json", "-o", "arxml"]) == 0
    before = contents(folder)
    for generated in ("arxml/types.arxml", "arxml/.sigcat-generated"):
        assert main(["generate", "arxml", "integration.json", "-o", "arxml", "--report", generated]) == 2
    assert contents(folder) == before


def test_a_result_may_stand_beside_what_is_read_and_be_written_again(folder):
    for _ in range(2):
        assert main(["lint", "tree", "--format", "json", "-o", "tree/report.json"]) == 0
        assert main([*EXPORT, "-o", "tree/tree.json"]) == 0


def test_two_results_may_go_to_one_device():
    assert main([*ROS2, "-o", "/dev/null", "--report", "/dev/null"]) == 0


def test_a_baseline_of_the_configuration_is_written_anew():
    Path("sigcat.toml").write_text('[lint]\nbaseline = "known.json"\n', encoding="utf-8")
    assert main(["lint", "tree", "--write-baseline", "known.json"]) == 0
