"""`sigcat export FORMAT` writes to standard output, a file, a folder or a zip archive."""

import zipfile

import pytest

from sigcat.catalogue.exporting.vss_tools.exporters import VHAL_MAP
from sigcat.cli import main
from tests.catalogue.exporting.test_same_bytes import TREE

SPEED = "Vehicle:\n  type: branch\n  description: V.\nVehicle.Speed:\n  type: sensor\n  datatype: float\n  description: S.\n"


@pytest.fixture
def tree(tmp_path, monkeypatch):
    (tmp_path / "tree.vspec").write_text(SPEED)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_file_goes_to_standard_output(tree, capfd, as_a_command):
    assert main(["export", "tree", "-s", "tree.vspec"]) == 0
    assert capfd.readouterr().out == "Vehicle\n└── Speed\n"


def test_bytes_go_to_standard_output_unchanged(tree, capfdbinary):
    assert main(["export", "binary", "-s", "tree.vspec"]) == 0
    assert capfdbinary.readouterr().out.startswith(b"\x07Vehicle\x06branch")


def test_a_folder_needs_a_name(tree, capsys):
    assert main(["export", "ros2interface", "-s", "tree.vspec"]) == 2
    assert "name it with -o" in capsys.readouterr().err


def test_a_folder_with_the_name_of_a_file_is_refused_with_a_name_for_it(tree, capsys):
    assert main(["export", "s2dm", "-s", "tree.vspec", "-o", "f.json"]) == 2
    assert "s2dm writes a folder, not f.json: pass `-o f`, or `-o f.zip`" in capsys.readouterr().err


def test_a_folder_is_written_into_a_folder(tree, as_a_command):
    assert main(["export", "ros2interface", "-s", "tree.vspec", "-o", "ros", "--package-name", "cars"]) == 0
    assert (tree / "ros/cars/msg/Vehicle.msg").is_file()


def test_a_folder_without_files_is_written_with_a_warning(tree, capsys):
    assert main(["export", "ros2interface", "-s", "tree.vspec", "-o", "build/ros", "--topics", "NO_MATCH"]) == 0
    assert list((tree / "build/ros").iterdir()) == []
    assert "warning X002 vss-tools exported nothing as ros2interface." in capsys.readouterr().err


def test_folders_above_a_file_are_created(tree):
    assert main(["export", "json", "-s", "tree.vspec", "-o", "a/b/tree.json"]) == 0
    assert (tree / "a/b/tree.json").is_file()


@pytest.mark.parametrize(
    ("name", "spelled"),
    [
        ("samm", ["--target-folder", "out", "-tns", "a.b"]),
        ("samm", ["-tf", "out"]),
        ("apigear", ["--output-dir", "out"]),
        ("vhal", ["--aosp-workspace-path", "out"]),
    ],
)
def test_the_folder_may_be_spelled_as_vspec_spells_it(tree, name, spelled):
    assert main(["export", name, "-s", "tree.vspec", *spelled]) == 0
    assert list((tree / "out").iterdir())


def test_a_mistyped_spelling_of_vspec_is_refused_with_the_near_one(capsys):
    with pytest.raises(SystemExit, match="2"):
        main(["export", "samm", "--target-foldr", "out"])
    assert "unknown option --target-foldr. Did you mean '--target-folder'?" in capsys.readouterr().err


def test_or_into_a_zip_archive(tree):
    assert main(["export", "ros2interface", "-s", "tree.vspec", "-o", "ros.zip", "--package-name", "cars"]) == 0
    assert "cars/msg/Vehicle.msg" in zipfile.ZipFile("ros.zip").namelist()


def test_types_go_where_they_are_asked_for(tree):
    typed = ["-s", str(TREE / "tree.vspec"), "-t", str(TREE / "types.vspec")]
    (tree / "types").mkdir()
    assert main(["export", "csv", *typed, "-o", "x.csv", "--types-output", "types/x.csv"]) == 0
    assert "Types.Geo.Time" in (tree / "types/x.csv").read_text()
    assert main(["export", "protobuf", *typed, "-o", "x.proto", "--types-out-dir", "types"]) == 0
    assert (tree / "types/Types/Geo/Geo.proto").is_file()


def test_a_second_file_goes_beside_the_first(tree, capsys):
    typed = ["-s", str(TREE / "tree.vspec"), "-t", str(TREE / "types.vspec")]
    assert main(["export", "id", *typed]) == 2
    assert "name the first with -o" in capsys.readouterr().err
    assert main(["export", "id", *typed, "-o", "ids.yaml"]) == 0
    assert (tree / "structs_ids.yaml").is_file()


def test_android_properties_keep_their_numbers_from_export_to_export(tree):
    assert main(["export", "vhal", "-s", "tree.vspec", "-o", "android"]) == 0
    first = (tree / "android" / VHAL_MAP).read_text()
    (tree / "tree.vspec").write_text(SPEED.replace("Speed:", "A:") + SPEED.partition("V.\n")[2])
    assert main(["export", "vhal", "-s", "tree.vspec", "-o", "android"]) == 0
    second = (tree / "android" / VHAL_MAP).read_text()
    assert first.strip(" []\n") in second


def test_warnings_of_vss_tools_go_to_standard_error(tree, capfd, as_a_command):
    assert main(["export", "apigear", "-s", "tree.vspec", "-o", "api"]) == 0
    assert "vss-tools: No layers provided" in capfd.readouterr().err


def test_help_of_a_format_names_its_options(capsys):
    with pytest.raises(SystemExit):
        main(["export", "ros2interface", "--help"])
    text = capsys.readouterr().out
    assert "--package-name" in text
    assert "--topics-case-sensitive" in text


STRUCTS = """\
Vehicle: {type: branch, description: A vehicle.}
Vehicle.Speed: {type: sensor, datatype: float, unit: km/h, description: The speed.}
Vehicle.Object: {type: sensor, datatype: Types.Object, description: The object ahead.}
Vehicle.Objects: {type: sensor, datatype: 'Types.Object[]', arraysize: 3, description: All objects.}
"""
TYPES = """\
Types: {type: branch, description: Types.}
Types.Object: {type: struct, description: An object.}
Types.Object.Distance: {type: property, datatype: float, unit: m, description: How far it is.}
"""


@pytest.mark.parametrize("exporter", ["vhal", "ros2interface"])
def test_signals_of_struct_types_are_named_where_vss_tools_knows_none(exporter, tmp_path, capsys):
    (tmp_path / "tree.vspec").write_text(STRUCTS)
    (tmp_path / "types.vspec").write_text(TYPES)
    tree = ["-s", str(tmp_path / "tree.vspec"), "-t", str(tmp_path / "types.vspec"), "-o", str(tmp_path / "out")]
    assert main(["export", exporter, *tree]) == 1
    told = capsys.readouterr().err
    for line, name in ((3, "Vehicle.Object"), (4, "Vehicle.Objects")):
        expected = f"The export {exporter} must have no struct types; '{name}' has 'Types.Object'. Replace the signal"
        assert any(f"tree.vspec:{line}:" in each and expected in each for each in told.splitlines())
