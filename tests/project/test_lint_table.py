"""The table `[lint]`: where it is found, and its faults by line."""

import json
from pathlib import Path

import pytest

from sigcat.cli import main
from sigcat.errors import InputRefused
from sigcat.project.find_project import find_project
from sigcat.project.read_project import read_project
from sigcat.rules.linting.lint import lint_paths
from tests.project.company import UNITS, write_company


def test_the_configuration_is_found_upwards_and_its_paths_are_relative_to_it(tree):
    (tree / "pyproject.toml").write_text('[tool.sigcat.lint]\nbase = "vspec/VehicleSignalSpecification.vspec"\n'
                                         'ignore = ["V105"]\n[tool.sigcat.lint.severity]\nV106 = "error"\n')  # fmt: skip
    options = read_project(find_project(tree / "vspec") or Path()).lint
    assert options.base is not None
    assert options.base.resolve() == (tree / "vspec" / "VehicleSignalSpecification.vspec").resolve()
    assert [(f.rule, f.severity) for f in lint_paths([tree / "vspec"], options).findings] == [("V106", "error")]


def test_every_severity_that_is_wrong_is_told(tmp_path):
    path = tmp_path / "sigcat.toml"
    path.write_text(
        '[lint.severity]\nV101 = "bad"\nV102 = "eror"\nV103 = "off"\n[lint.per-file]\na.V1 = "x"\nb.V2 = 1\nc = 5\n'
    )
    with pytest.raises(InputRefused) as refused:
        read_project(path)
    assert [(finding.line, finding.message.partition(". ")[0]) for finding in refused.value.findings] == [
        (2, "`severity.V101` must be error, warning, info or off, not 'bad'."),
        (3, "`severity.V102` must be error, warning, info or off, not 'eror'"),
        (6, "`per-file.a.V1` must be error, warning, info or off, not 'x'."),
        (7, "`per-file.b.V2` must be error, warning, info or off, not 1."),
        (8, "`per-file.c` must be a table of codes with severities."),
    ]


@pytest.mark.parametrize(
    ("name", "text", "lines"),
    [
        ("sigcat.toml", '[lint]\nseverity.V101 = "bad"\n"severity"."V102" = "bad"\n', [2, 3]),
        ("sigcat.toml", '[lint]\nselect = []\nseverity = {V101 = "bad", V102 = "bad"}\n', [3, 3]),
        ("sigcat.toml", '[lint.per-file."a/*.vspec"]\n\nV101 = "bad"\n', [3]),
        ("sigcat.toml", '[lint.per-file]\n"a/*.vspec" = {V101 = "bad"}\n', [2]),
        ("pyproject.toml", '[project]\nname = "x"\n[tool.sigcat.lint.severity]\nV101 = "bad"\n', [4]),
        ("sigcat.toml", '[lint]\n\noverlays = ["a.vspec", "b.vspec"]\n[lint.options]\nV101 = 5\n', [3, 3, 5]),
    ],
)
def test_each_fault_has_the_line_of_its_key_however_the_tables_are_written(tmp_path, name, text, lines):
    path = tmp_path / name
    path.write_text(text)
    with pytest.raises(InputRefused) as refused:
        read_project(path)
    assert [finding.line for finding in refused.value.findings] == lines


def test_everything_wrong_with_a_configuration_is_told_at_once(tmp_path):
    path = tmp_path / "sigcat.toml"
    path.write_text('[lint]\nignroe = []\nbase = "no.vspec"\nselect = 5\n[lint.severity]\nV1 = "fatal"\n')
    with pytest.raises(InputRefused) as refused:
        read_project(path)
    assert len(refused.value.findings) == 4
    assert [finding.line for finding in refused.value.findings] == [2, 3, 4, 6]
    assert "Did you mean 'ignore'?" in refused.value.findings[0].message


@pytest.mark.parametrize("key", ["base", "overlays", "units", "quantities", "types", "include-dirs", "include_dirs"])
def test_a_tree_of_the_linter_beside_a_catalogue_is_refused_with_the_place_for_it(tmp_path, key):
    value = '"some.vspec"' if key == "base" else '["folder"]' if key.startswith("include") else '["some.vspec"]'
    (tmp_path / "some.vspec").touch()
    (tmp_path / "folder").mkdir()
    file = tmp_path / "sigcat.toml"
    text = f"[lint]\n{key} = {value}\n"
    file.write_text(text)
    read_project(file)
    file.write_text(f'{text}[[catalogue]]\nid = "acme"\nrelease = "shipped"\n')
    with pytest.raises(InputRefused) as refused:
        read_project(file)
    (finding,) = refused.value.findings
    assert (finding.line, finding.message) == (2, f"`{key}` in [lint] cannot be used beside [[catalogue]].")
    assert "[[catalogue]]" in finding.fix


@pytest.mark.parametrize("paths", [(), (".",), ("units.yaml", "overlays")])
@pytest.mark.parametrize("has_other_tree", [False, True])
def test_a_unit_of_the_project_with_the_name_of_a_standard_one_is_reported(
    tmp_path, monkeypatch, capsys, paths, has_other_tree
):
    monkeypatch.chdir(write_company(tmp_path))
    named = (
        UNITS.replace("ppm:", "degC:", 1)
        .replace("parts per million", "degree Celsius")
        .replace("relation", "temperature")
    )
    (tmp_path / "units.yaml").write_text(UNITS + named)
    if has_other_tree:
        (tmp_path / "own.vspec").write_text("Vehicle: {type: branch, description: A vehicle.}\n")
    main(["lint", *paths])
    assert "units.yaml:7:1: warning U001 Units 'Celsius' and 'degC' share the name" in capsys.readouterr().out


UNITS_OF_ANOTHER_NAME = (
    "km: {definition: A knot mile., unit: knot mile, quantity: length, allowed-datatypes: [numeric]}\n"
)


@pytest.mark.parametrize("paths", [[], ["common"], ["common/acme_units.yaml"]])
def test_a_listed_file_of_units_is_one_whatever_its_name(tmp_path, monkeypatch, capsys, paths):
    write_company(tmp_path)
    monkeypatch.chdir(tmp_path)
    config = Path("sigcat.toml")
    config.write_text(config.read_text().replace('["units.yaml"]', '["units.yaml", "common/acme_units.yaml"]'))
    Path("common").mkdir()
    Path("common/acme_units.yaml").write_text(UNITS_OF_ANOTHER_NAME)
    main(["lint", *paths, "--format", "json"])
    found = [each for each in json.loads(capsys.readouterr().out)["findings"] if "acme_units" in each["file"]]
    assert [each["rule"] for each in found] == ["U004"]


def test_a_setting_of_the_project_within_a_catalogue_is_placed(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    Path("sigcat.toml").write_text('[[catalogue]]\nid = "own"\nrelease = "shipped"\nfunctions = ["functions"]\n')
    assert main(["lint"]) == 2
    assert "Write `functions` before the first table." in capsys.readouterr().err
