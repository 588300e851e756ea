"""vss-tools runs in a separate process: it cannot change anything here, and its errors are reported to users."""

import io
import subprocess
import sys
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
import yaml

from sigcat.catalogue.composing.compose import compose, read_catalogue
from sigcat.catalogue.exporting.export import export, exported
from sigcat.catalogue.exporting.files import ExportedFile, zipped
from sigcat.catalogue.hosting.source import Source, load
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.vocabulary import EMPTY
from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.errors import InputRefused, UsageError
from sigcat.file_kind import ROOT_NAME
from tests.catalogue.exporting.test_same_bytes import TREE
from tests.catalogue.trees import ROOT, catalogue_of
from tests.needs import IS_SLOW_RUN, OFFICIAL, official_releases, slow

SPEED = "Vehicle.Speed:\n  type: sensor\n  datatype: float\n  description: Speed.\n"
DOORS = (
    "Vehicle.Door:\n  type: branch\n  instances: [Left, Right]\n  description: D.\n"
    "Vehicle.Door.IsOpen:\n  type: actuator\n  datatype: boolean\n  description: O.\n"
)


OLDER = Path(__file__).parents[1] / "hosting" / "older"
LEFT_OUT = {
    "loose_checks": {
        ("Vehicle.Speed", "max"),
        ("Vehicle.State", "allowed"),
        ("Vehicle.Level", "allowed"),
        ("Vehicle.Level", "default"),
        ("Vehicle.Level", "aggregate"),
    },
    "values_of_other_kinds": {
        ("Vehicle.Old", "deprecation"),
        ("Vehicle.Rows", "default"),
        ("Vehicle.Mode", "allowed"),
        ("Vehicle.Lowest", "min"),
        ("Vehicle.Distance", "unit"),
        ("Vehicle.Distance", "max"),
    },
}
"""Trees from before today's checks that vss-tools would refuse."""


def text_of(catalogue: Catalogue, name: str, options: Mapping[str, Any] | None = None) -> str:
    return export(catalogue, name, options)[0].data.decode()


def test_nothing_of_vss_tools_is_imported_here():
    program = f"""
import sys
from pathlib import Path
from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.exporting.export import export
assert export(read_catalogue(Path({str(TREE / "tree.vspec")!r}), types=[Path({str(TREE / "types.vspec")!r})]), "csv")
sys.exit("vss_tools" in sys.modules)
"""
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0


def test_catalogues_with_different_units_do_not_mix(tmp_path):
    tree = ROOT + SPEED + "  unit: furlong\n"
    with_unit = read_catalogue(written(tmp_path / "a", tree, furlong=True))
    without = read_catalogue(written(tmp_path / "b", tree))
    assert "furlong" in text_of(with_unit, "csv")
    with pytest.raises(InputRefused, match="The tree has errors"):
        export(without, "csv")


def written(folder: Path, tree: str, *, furlong: bool = False) -> Path:
    folder.mkdir()
    (folder / "tree.vspec").write_text(tree)
    if furlong:
        (folder / "quantities.yaml").write_text("length:\n  definition: Length.\n")
        unit = (
            "furlong:\n  definition: 220 yards.\n  unit: furlong\n  quantity: length\n  allowed-datatypes: [numeric]\n"
        )
        (folder / "units.yaml").write_text(unit)
    return folder / "tree.vspec"


def test_what_vss_tools_refuses_is_told_at_the_node_that_it_speaks_of():
    catalogue = catalogue_of(f"{ROOT}{SPEED}  ASILlevel: B\n")
    with pytest.raises(InputRefused, match=r"vss-tools could not export csv\.") as refusal:
        export(catalogue, "csv", {"strict": True})
    assert ("X002", "tree", 4, "Vehicle.Speed") in [(f.rule, f.file, f.line, f.path) for f in refusal.value.findings]
    assert any(f.rule == "X001" and "ASILlevel" in f.message for f in refusal.value.findings)


def test_extended_attributes_alone_are_no_reason_to_warn():
    assert exported(catalogue_of(f"{ROOT}{SPEED}  ASILlevel: B\n"), "csv").findings == ()


def test_what_vss_tools_warns_of_again_and_again_is_told_once_with_a_count(tmp_path):
    speed = SPEED + "  unit: furlong\n"
    tree = ROOT + speed + speed.replace("Speed", "AverageSpeed")
    result = exported(read_catalogue(written(tmp_path / "a", tree, furlong=True)), "samm")
    (warning,) = [finding for finding in result.findings if "No DataUnit found" in finding.message]
    assert warning.message.endswith("(2 times)")


def test_what_is_told_of_a_failure_is_its_cause():
    text = ROOT + SPEED + "  max: 1.5\n  custom: 1\n"
    with pytest.raises(InputRefused) as refusal:
        export(catalogue_of(text), "vhal")
    assert ["integer" in finding.message for finding in refusal.value.findings] == [True]


def test_an_exporter_that_raises_is_told_too(as_a_command):
    with pytest.raises(InputRefused) as refusal:
        export(catalogue_of(ROOT + SPEED.replace("Speed:", "1:")), "csv", {"stats-piechart": "chart.csv"})
    assert "stats-old-piechart is required" in refusal.value.findings[-1].message


@pytest.mark.parametrize("process", ["_as_in_a_service", "as_a_command"])
def test_an_export_that_takes_too_long_is_stopped(process, request):
    request.getfixturevalue(process)
    many = "".join(SPEED.replace("Speed:", f"Speed{number}:") for number in range(3000))
    with pytest.raises(InputRefused, match=r"longer than 0\.01 s"):
        export(catalogue_of(ROOT + many), "csv", timeout=0.01)


def test_modules_in_the_current_folder_are_not_run(as_a_command, tmp_path, monkeypatch):
    for name in ("yaml", "json", "logging", "vss_tools"):
        (tmp_path / f"{name}.py").write_text("raise SystemExit('run')")
    monkeypatch.chdir(tmp_path)
    assert "Speed" in text_of(catalogue_of(ROOT + SPEED), "csv")


@pytest.mark.parametrize("line_end", [r"\n", r"\u2028", r"\x0c", r"\r"])
def test_a_text_is_never_taken_for_an_include(line_end):
    tree = (
        ROOT + f'Vehicle.Note:\n  type: sensor\n  datatype: string\n  description: "N.{line_end}#include /etc/passwd"\n'
    )
    data = yaml.safe_load(text_of(catalogue_of(tree), "yaml"))
    assert "#include /etc/passwd" in data["Vehicle.Note"]["description"]


def test_an_attribute_of_an_overlay_is_never_taken_for_an_include():
    catalogue = catalogue_of(ROOT, "Vehicle:\n  includes: [/etc/passwd]\n")
    data = yaml.safe_load(text_of(catalogue, "yaml", {"extended_attributes": ["includes"]}))
    assert data["Vehicle"]["includes"] == ["/etc/passwd"]


@pytest.mark.parametrize(
    "node",
    ["Vehicle./tmp/sigcat:\n  type: branch\n", "Vehicle.A:\n  type: branch\n  instances: ['/tmp/sigcat']\n", 'Vehicle."\\\\x":\n  type: branch\n'],
)  # fmt: skip
def test_a_name_that_could_leave_the_folder_is_refused(node):
    with pytest.raises(InputRefused) as refusal:
        export(catalogue_of(f"{ROOT}{node}  description: B.\n"), "ros2interface")
    assert [(f.rule, f.line) for f in refusal.value.findings] == [("X003", 4)]


@pytest.mark.parametrize(
    ("format_name", "options", "message"),
    [
        ("ros2interface", {"package-name": "../evil"}, "must be a plain file name"),
        ("samm", {"target-namespace": ".."}, "must be a plain file name"),
        ("go", {"package": '";\nevil'}, "must be letters, digits and underscores"),
        ("csv", {"types-output": "/tmp/t.csv"}, "must be a plain file name"),
        ("samm", {"signals-file": "/etc/passwd"}, "must be a file"),
        ("samm", {"split-depth": "2"}, "must be a whole number"),
        ("samm", {"split-depth": True}, "must be a whole number"),
        ("ros2interface", {"mode": "leaves"}, "must be one of aggregate, leaf"),
        ("csv", {"aborts": ["style"]}, "must be one of name-style, unknown-attribute"),
        ("csv", {"expand": "no"}, "must be true or false"),
        ("csv", {"expandd": True}, "Did you mean 'expand'"),
        ("tree", {"attr": "unit"}, "must be a list of texts"),
        ("json", {"extended_attributes": ["min"]}, "must name one attribute that VSS does not define"),
        ("avro", {}, "give a types file"),
    ],
)
def test_unfit_options_are_refused_before_anything_runs(format_name, options, message):
    with pytest.raises(UsageError, match=message):
        export(catalogue_of(ROOT + SPEED), format_name, options, timeout=0)


def test_a_value_may_begin_with_a_dash():
    assert text_of(catalogue_of(ROOT + SPEED), "franca", {"franca_vss_version": "-o"}).count('"-o"') == 1


def test_units_that_share_a_name_get_names_of_their_own(tmp_path):
    (tmp_path / "tree.vspec").write_text(ROOT + SPEED + "  unit: b\n")
    (tmp_path / "quantities.yaml").write_text("length:\n  definition: Length.\n")
    unit = "{}:\n  definition: D.\n  unit: mile\n  quantity: length\n  allowed-datatypes: [numeric]\n{}"
    deprecated = "  deprecation: V1\n"
    (tmp_path / "units.yaml").write_text(unit.format("a", "") + unit.format("b", "") + unit.format("c", deprecated))
    catalogue = read_catalogue(tmp_path / "tree.vspec")
    assert ",b," in text_of(catalogue, "csv")
    files = {file.name: file.data for file in export(catalogue, "s2dm")}
    units = yaml.safe_load(files["vspec_reference/vspec_units.yaml"])
    assert {key: entry["unit"] for key, entry in units.items()} == {
        "a": "mile (a)",
        "b": "mile",
        "c": "mile (deprecated)",
    }


@official_releases
@pytest.mark.parametrize("name", ["csv", pytest.param("id", marks=slow), pytest.param("vhal", marks=slow)])
def test_the_release_that_vss_tools_refuses_is_exported(name):
    catalogue = read_catalogue(OFFICIAL / "v6.0/spec/VehicleSignalSpecification.vspec")
    assert len(export(catalogue, name)[0].data) > 100_000


@pytest.mark.parametrize("case", sorted(folder.name for folder in OLDER.iterdir()) if IS_SLOW_RUN else LEFT_OUT)
def test_trees_of_older_releases_are_exported(case):
    catalogue = load(Source("old", "Old", OLDER / case / ROOT_NAME))
    export_ = exported(catalogue, "csv")
    paths = {line.partition(",")[0] for line in export_.files[0].data.decode().splitlines()}
    assert paths == {"Signal", *catalogue.nodes}
    left_out = {(f.path, f.message.split("`")[1]) for f in export_.findings if f.rule == "X004"}
    assert left_out == LEFT_OUT.get(case, set())


@pytest.mark.parametrize("name", ["json", "yaml"])
def test_instances_are_kept_beside_what_they_expand_to(name):
    data = yaml.safe_load(text_of(catalogue_of(ROOT + DOORS), name, {"keep_instances": True}))
    doors = data["Vehicle"]["children"]["Door"] if name == "json" else data["Vehicle.Door"]
    assert doors["instances"] == ["Left", "Right"]
    left = doors["children"]["Left"] if name == "json" else data["Vehicle.Door.Left"]
    assert "instances" not in left
    assert "IsOpen" in left["children"] if name == "json" else "Vehicle.Door.Left.IsOpen" in data


def test_an_expanded_catalogue_can_be_exported_without_its_expansion():
    expanded, unexpanded = catalogue_of(ROOT + DOORS), catalogue_of(ROOT + DOORS, expanded=False)
    options = {"expand": False}
    assert text_of(expanded, "json", options) == text_of(unexpanded, "json", options)
    assert text_of(expanded, "yaml", options) == text_of(unexpanded, "yaml", options)


def test_a_map_of_android_properties_is_continued(tmp_path):
    before = catalogue_of(ROOT + SPEED)
    map_file = tmp_path / "map.json"
    files = {file.option: file for file in export(before, "vhal", {"vhal_map": map_file})}
    map_file.write_bytes(files["vhal-map"].data)
    slow = SPEED.replace("Speed:", "A:")
    after = {f.option: f for f in export(catalogue_of(ROOT + slow + SPEED), "vhal", {"vhal_map": map_file})}
    numbers = [{e["source"]: e["propertyId"] for e in yaml.safe_load(f["vhal-map"].data)} for f in (files, after)]
    assert numbers[1]["Vehicle.Speed"] == numbers[0]["Vehicle.Speed"]
    assert set(numbers[1]) - set(numbers[0]) == {"Vehicle.A"}


def test_a_zip_archive_of_equal_files_has_equal_bytes():
    files = (ExportedFile("b/c.txt", b"1"), ExportedFile("a.txt", b"2"))
    assert zipped(files) == zipped(reversed(files))
    assert zipfile.ZipFile(io.BytesIO(zipped(files))).namelist() == ["a.txt", "b/c.txt"]


def test_a_posted_overlay_is_exported_with_the_tree():
    base = read_catalogue(TREE / "tree.vspec", types=[TREE / "types.vspec"])
    overlay = layer_from_text(b"Vehicle.Posted:\n  type: sensor\n  datatype: float\n  description: P.\n", "posted")
    catalogue = compose([layer_from_text((ROOT + SPEED).encode(), "tree", is_overlay=False), overlay], EMPTY)
    assert "Vehicle.Posted" not in text_of(base, "csv")
    assert "Vehicle.Posted" in text_of(catalogue, "csv")
