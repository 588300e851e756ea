"""Values of -s: a pulled release is read with its errors as warnings, and an export is not a tree."""

import pytest

from sigcat.catalogue.hosting.releases import pull
from sigcat.cli import main
from tests.catalogue.hosting.archives import FILES, tar_bytes

LOOSE = {**FILES, "spec/Cabin/Cabin.vspec": FILES["spec/Cabin/Cabin.vspec"].replace("float", "uint8\n  max: 300")}


@pytest.fixture
def release(data, tmp_path):
    archive = tmp_path / "loose.tar.gz"
    archive.write_bytes(tar_bytes(files=LOOSE))
    return pull("v5.0", str(archive))


def test_an_error_of_a_release_is_a_warning_on_the_command_line_too(release, capsys):
    assert main(["show", "-s", "v5.0", "Vehicle.Speed"]) == 0
    output = capsys.readouterr()
    assert "max            300" in output.out
    assert "warning V008" in output.err


def test_the_same_tree_named_by_its_folder_is_one_of_ones_own(release, capsys):
    assert main(["show", "-s", str(release.spec.parent), "Vehicle.Speed"]) == 1
    assert "error V008" in capsys.readouterr().err


def test_an_error_of_an_overlay_stays_one(release, tmp_path, capsys):
    (tmp_path / "overlay.vspec").write_text("Vehicle.Height:\n  type: sensor\n  datatype: flaot\n  description: H.\n")
    assert main(["show", "-s", "v5.0", "-l", str(tmp_path / "overlay.vspec"), "Vehicle.Speed"]) == 1
    assert "error V003" in capsys.readouterr().err


def test_an_exported_tree_is_read_with_its_mappings_and_lines(tmp_path, capsys):
    speed = '"type": "sensor", "datatype": "float", "unit": "km/h", "description": "S.", "dbc2vss": {"signal": "S"}'
    text = '{"Vehicle": {"type": "branch", "description": "V.", "children": {\n"Speed": {%s}}}}'
    (tmp_path / "tree.json").write_text(text % speed)
    assert main(["show", "-s", str(tmp_path / "tree.json"), "Vehicle.Speed", "--format", "json"]) == 0
    assert '"S"' in capsys.readouterr().out
    (tmp_path / "tree.json").write_text(text % speed.replace("float", "flaot"))
    assert main(["show", "-s", str(tmp_path / "tree.json"), "Vehicle.Speed"]) == 1
    assert "tree.json:2:" in capsys.readouterr().err


def test_a_shipped_catalogue_has_the_name_that_diff_knows(capsys):
    assert main(["show", "-s", "vss", "Vehicle.Function"]) == 2
    assert main(["show", "-s", "interfaces", "Vehicle.Function"]) == 0
    capsys.readouterr()


def test_a_name_that_nothing_has_is_not_taken_for_a_release_to_pull(capsys):
    for command in (["show", "-s", "vs", "Vehicle"], ["diff", "vs", "interfaces"]):
        assert main(command) == 2
        message = capsys.readouterr().err
        assert message.startswith("sigcat: no file, folder or release is named 'vs'. Did you mean vss?")
        assert "pull" not in message


@pytest.mark.parametrize("options", [["show", "Vehicle", "-s"], ["serve", "--catalogue"]])
def test_a_path_that_leads_nowhere_is_not_taken_for_a_name(options, capsys):
    *command, option = options
    assert main([*command, option, f"{'x=' if option == '--catalogue' else ''}missing/tree.vspec"]) == 2
    assert capsys.readouterr().err == "sigcat: missing/tree.vspec: there is no such file\n"
