"""Whatever names a tree can be a side: a folder, a file, an export, a git revision, a release; each with overlays."""

import json
import subprocess
from pathlib import Path

import pytest

from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.comparing.exported_json import UNKNOWN, catalogue_from_export
from sigcat.catalogue.comparing.sides import NO_OPTIONS, Options, read_side
from sigcat.catalogue.composing.compose import read_catalogue, unexpanded
from sigcat.catalogue.exporting.export_json import tree_data, tree_json
from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.reading.root_file import root_file, types_beside
from sigcat.data import ROOT_FILE
from sigcat.errors import InputRefused, NotFound, UsageError
from sigcat.limits import Limits
from tests.catalogue.comparing.running import sigcat, signal
from tests.catalogue.trees import ROOT, catalogue_of

TREE = ROOT + "#include part/engine.vspec Vehicle\n" + signal("Vehicle.Speed")
CASES = Path(__file__).parents[1] / "cases"
STRUCTS = (
    "Types:\n  type: branch\n  description: T.\nTypes.Point:\n  type: struct\n  description: P.\n"
    "Types.Point.X:\n  type: property\n  datatype: float\n  description: X.\n"
)
MORE_STRUCTS = (
    "Line:\n  type: struct\n  description: L.\nLine.Y:\n  type: property\n  datatype: float\n  description: Y.\n"
)
ENGINE = "Engine:\n  type: branch\n  description: E.\n" + signal("Engine.Heat")


def no_release(name):
    raise NotFound(f"there is no release {name!r}")


def paths(name, release=no_release, options=NO_OPTIONS):
    return list(read_side(str(name), release, options).catalogue.nodes)


WHOLE = ["Vehicle", "Vehicle.Speed", "Vehicle.Engine", "Vehicle.Engine.Heat"]


def write_tree(folder, name="VehicleSignalSpecification.vspec"):
    (folder / "part").mkdir(parents=True, exist_ok=True)
    (folder / name).write_text(TREE)
    (folder / "part" / "engine.vspec").write_text(ENGINE)
    return folder / name


# -- folders and files --------------------------------------------------------------------------------------------


def test_a_root_file(tmp_path):
    assert paths(write_tree(tmp_path)) == WHOLE


def test_a_folder_that_has_the_usual_root_file_somewhere(tmp_path):
    write_tree(tmp_path / "release" / "spec")
    (tmp_path / "release" / "aside.vspec").write_text(ROOT)
    assert paths(tmp_path) == WHOLE


def test_a_folder_of_which_one_file_is_included_by_no_other(tmp_path):
    write_tree(tmp_path, "car.vspec")
    assert root_file(tmp_path) == tmp_path / "car.vspec"


def test_overlays_of_a_folder_are_not_applied_and_are_no_tree(tmp_path):
    write_tree(tmp_path, "car.vspec")
    (tmp_path / "overlays").mkdir()
    (tmp_path / "overlays" / "sport.vspec").write_text(signal("Vehicle.Boost"))
    assert paths(tmp_path) == WHOLE


def test_a_folder_with_struct_types_beside_the_tree_has_both(tmp_path):
    """Types are not a second tree, and trees that use them find them, also in parts."""
    write_tree(tmp_path, "car.vspec")
    with (tmp_path / "car.vspec").open("a") as tree:
        tree.write("Vehicle.Lane:\n  type: sensor\n  datatype: Types.Point\n  description: L.\n")
    (tmp_path / "types.vspec").write_text(STRUCTS + "#include more.vspec Types\n")
    (tmp_path / "more.vspec").write_text(MORE_STRUCTS)
    assert root_file(tmp_path) == tmp_path / "car.vspec"
    assert types_beside(tmp_path / "car.vspec") == (tmp_path / "types.vspec",)
    assert {*WHOLE, "Vehicle.Lane", "Types.Point.X", "Types.Line.Y"} <= set(paths(tmp_path))


def test_an_overlay_beside_the_tree_is_no_second_tree(tmp_path):
    write_tree(tmp_path, "car.vspec")
    (tmp_path / "sport.vspec").write_text(signal("Vehicle.Boost"))
    assert paths(tmp_path) == WHOLE


def test_a_folder_with_two_trees_asks_for_one(tmp_path):
    for name in ("car.vspec", "truck.vspec"):
        (tmp_path / name).write_text(ROOT)
    with pytest.raises(UsageError, match=r"several trees: car\.vspec, truck\.vspec"):
        paths(tmp_path)


def test_a_folder_without_a_tree_is_refused(tmp_path):
    with pytest.raises(UsageError, match="no tree found"):
        paths(tmp_path)


def test_a_folder_with_too_many_files_is_not_searched_through(tmp_path):
    for number in range(20):
        (tmp_path / f"{number}.txt").touch()
    with pytest.raises(UsageError, match="more than 10 files"):
        root_file(tmp_path, Limits(files=10))


def test_overlays_after_a_plus_apply_in_order(tmp_path):
    tree = write_tree(tmp_path)
    (tmp_path / "one.vspec").write_text("Vehicle.Speed:\n  min: 1\n  max: 5\n")
    (tmp_path / "two.vspec").write_text("Vehicle.Speed:\n  min: 2\n")
    side = read_side(f"{tree}+{tmp_path}/one.vspec+{tmp_path}/two.vspec", no_release)
    values = side.catalogue.nodes["Vehicle.Speed"].values
    assert (values["min"], values["max"]) == (2, 5)


def test_overlays_of_both_sides_come_last(tmp_path):
    tree = write_tree(tmp_path)
    (tmp_path / "one.vspec").write_text("Vehicle.Speed:\n  min: 1\n")
    (tmp_path / "both.vspec").write_text("Vehicle.Speed:\n  min: 2\n")
    options = Options(overlays=(tmp_path / "both.vspec",))
    side = read_side(f"{tree}+{tmp_path}/one.vspec", no_release, options)
    assert side.catalogue.nodes["Vehicle.Speed"].values["min"] == 2


def test_a_file_may_have_a_plus_in_its_name(tmp_path):
    assert paths(write_tree(tmp_path, "c++.vspec")) == WHOLE


def test_folders_and_overlays_may_have_a_plus_too(tmp_path):
    tree = write_tree(tmp_path / "a+b" / "c++")
    overlay = tmp_path / "a+b" / "one+two.vspec"
    overlay.write_text("Vehicle.Speed:\n  min: 1\n")
    assert paths(tree.parent) == WHOLE
    for named in (f"{tree.parent}+{overlay}", f"{tree}+{overlay}+{overlay}"):
        assert read_side(named, no_release).catalogue.nodes["Vehicle.Speed"].values["min"] == 1


@pytest.mark.parametrize("name", ["missing/tree.vspec", "missing.vspec", "missing.json", "", "+"])
def test_what_is_not_there_is_said(name):
    with pytest.raises(UsageError, match="no such file or folder"):
        paths(name)


def test_a_missing_overlay_is_said(tmp_path):
    with pytest.raises(UsageError, match="there is no such overlay"):
        paths(f"{write_tree(tmp_path)}+missing.vspec")


def test_a_tree_with_errors_is_not_compared(tmp_path):
    (tmp_path / "tree.vspec").write_text(ROOT + "Vehicle.X:\n  type: sensr\n")
    with pytest.raises(InputRefused) as refused:
        paths(tmp_path / "tree.vspec")
    assert [finding.rule for finding in refused.value.findings] == ["V001"]


# -- releases -----------------------------------------------------------------------------------------------------


def test_another_name_is_that_of_a_release(tmp_path):
    (tmp_path / "one.vspec").write_text(signal("Vehicle.New"))
    (tmp_path / "tree.vspec").write_text(ROOT)
    releases = {"v1.0": Source("v1.0", "VSS 1.0", tmp_path / "tree.vspec", release="v1.0")}
    assert paths("v1.0", releases.__getitem__) == ["Vehicle"]
    assert paths(f"v1.0+{tmp_path}/one.vspec", releases.__getitem__) == ["Vehicle", "Vehicle.New"]
    with pytest.raises(NotFound):
        paths("v2.0")


def test_shipped_catalogues_are_releases_too(capsys):
    assert sigcat("diff", "vss", str(ROOT_FILE)) == 0
    assert capsys.readouterr().out == "No differences.\n"


# -- exported JSON ------------------------------------------------------------------------------------------------


def shipped():
    return read_catalogue(ROOT_FILE)


@pytest.mark.parametrize("form", ["expanded", "expanded, with its instances", "not expanded"])
def test_an_export_does_not_differ_from_its_tree(form):
    tree = shipped()
    data = tree_data(unexpanded(tree) if form == "not expanded" else tree, keep_instances="with" in form)
    export = catalogue_from_export(tree_json(data).encode(), "export.json")
    assert export.findings == ()
    assert compare(tree, export, UNKNOWN) == compare(export, tree, UNKNOWN) == ()
    assert {path: node.template for path, node in export.nodes.items()} == {
        path: node.template for path, node in tree.nodes.items()
    }


def given_in(file):
    """The overlays that a case is made with, and the other options that name files."""
    words = file.read_text().replace("--no-expand", "").split() if file.is_file() else []
    pairs = [pair for pair in zip(words[::2], words[1::2], strict=True) if pair[0] != "-e"]
    overlays = [value for option, value in pairs if option == "-l"]
    return overlays, [word for pair in pairs if pair[0] != "-l" for word in pair]


@pytest.mark.parametrize("form", ["--pretty", "--extend-all-attributes"])
@pytest.mark.parametrize("case", sorted(case.name for case in CASES.iterdir()))
def test_a_tree_does_not_differ_from_what_sigcat_exports_of_it(case, form, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(CASES / case)
    (tmp_path / "sigcat.toml").write_text('[lint.severity]\nV020 = "warning"\n')
    monkeypatch.setenv("SIGCAT_CONFIG", str(tmp_path / "sigcat.toml"))
    overlays, options = given_in(CASES / case / "options")
    over = [word for overlay in overlays for word in ("-l", overlay)]
    tree, export = "+".join(["tree.vspec", *overlays]), str(tmp_path / "export.json")
    assert sigcat("export", "json", "-s", "tree.vspec", *over, *options, form, "-o", export) == 0
    for sides in ((tree, export), (export, tree)):
        capsys.readouterr()
        assert sigcat("diff", *sides, *options) == 0
        assert capsys.readouterr().out == "No differences.\n"


def test_only_at_the_root_may_an_export_have_left_out_an_extended_attribute(tmp_path, capsys):
    (tmp_path / "old.vspec").write_text(ROOT + "  source: x\n" + signal("Vehicle.A", source="x"))
    (tmp_path / "new.vspec").write_text(ROOT + signal("Vehicle.A"))
    assert sigcat("export", "json", "-s", str(tmp_path / "new.vspec"), "-o", str(tmp_path / "new.json")) == 0
    assert sigcat("diff", str(tmp_path / "old.vspec"), str(tmp_path / "new.json")) == 0
    assert capsys.readouterr().out.count("source: x → (none)") == 1


def test_changes_between_exports_are_grouped_by_instances(tmp_path, capsys):
    old = ROOT + "Vehicle.Axle:\n  type: branch\n  instances: [Front, Rear]\n  description: A.\n"
    for name, maximum in (("old", 10), ("new", 20)):
        data = tree_data(catalogue_of(old + signal("Vehicle.Axle.Load", max=maximum)))
        (tmp_path / f"{name}.json").write_text(tree_json(data))
    assert sigcat("diff", str(tmp_path / "old.json"), str(tmp_path / "new.json")) == 0
    assert "~ Load  2 instances" in capsys.readouterr().out


def test_an_export_cannot_know_the_size_of_arrays(tmp_path, capsys):
    text = ROOT + signal("Vehicle.A", datatype='"uint8[]"', arraysize=3)
    (tmp_path / "tree.vspec").write_text(text)
    (tmp_path / "tree.json").write_text(tree_json(tree_data(catalogue_of(text))))
    assert sigcat("diff", str(tmp_path / "tree.vspec"), str(tmp_path / "tree.json")) == 0
    assert capsys.readouterr().out == "No differences.\n"


def test_values_of_an_export_are_those_of_json():
    node = {"type": "sensor", "datatype": "float", "min": 1e-05, "description": "\U0001f697 \ud800 /", "unit": "x"}
    data = json.dumps({"Vehicle": {"type": "branch", "description": "V.", "children": {"A": node}}})
    export = catalogue_from_export(data.replace("/", r"\/").encode(), "export.json")
    assert dict(export.nodes["Vehicle.A"].values) == node


def test_struct_types_of_an_export_are_read():
    data = {
        "Vehicle": {"type": "branch", "children": {"A": {"type": "sensor", "datatype": "T.Place"}}},
        "ComplexDataTypes": {
            "T": {
                "type": "branch",
                "children": {"Place": {"type": "struct", "children": {"X": {"type": "property", "datatype": "float"}}}},
            }
        },
    }
    export = catalogue_from_export(json.dumps(data).encode(), "export.json")
    assert list(export.nodes) == ["Vehicle", "Vehicle.A", "T", "T.Place", "T.Place.X"]
    assert export.findings == ()


@pytest.mark.parametrize(
    ("text", "rule", "place"),
    [
        ("[1]", "R007", (1, 1)),
        ("", "R001", (1, 1)),
        ("{\n1}", "R001", (2, 1)),
        ('{"Vehicle": 1}', "R007", (1, 13)),
        ('{"Vehicle": {"type": "branch",\n "children": [1]}}', "R007", (2, 14)),
        ('{"Vehicle": {"type": "sensr"}}', "V001", (1, 22)),
        ('{"Vehicle": {}}', "V001", (1, 2)),
        ('{"Vehicle": ' + "[" * 50_000, "R004", None),
        ('{"Vehicle": ' + "9" * 5_000 + "}", "R014", None),
    ],
)
def test_a_broken_export_is_refused_with_its_place(tmp_path, text, rule, place):
    file = tmp_path / "export.json"
    file.write_text(text)
    with pytest.raises(InputRefused) as refused:
        paths(file)
    finding = refused.value.findings[0]
    assert finding.rule == rule
    assert place is None or (finding.line, finding.column) == place


def test_an_export_that_is_too_large_is_not_read(tmp_path):
    file = tmp_path / "export.json"
    file.write_text("{}" + " " * 100)
    with pytest.raises(InputRefused) as refused:
        paths(file, options=Options(limits=Limits(file_bytes=50)))
    assert refused.value.findings[0].rule == "R003"


# -- git ----------------------------------------------------------------------------------------------------------


@pytest.fixture
def repository(tmp_path, monkeypatch):
    """A repository whose first commit has a tree in `spec`, and whose second one has a signal less."""
    folder = tmp_path / "repository"
    folder.mkdir()
    monkeypatch.chdir(folder)
    for name in ("GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE"):
        monkeypatch.delenv(name, raising=False)
    git("init", "--quiet")
    write_tree(folder / "spec")
    (folder / "sport.vspec").write_text(signal("Vehicle.Boost"))
    (folder / "link.vspec").symlink_to("/etc/passwd")
    commit("first")
    (folder / "spec" / "part" / "engine.vspec").write_text("Engine:\n  type: branch\n  description: E.\n")
    commit("second")
    return folder


def git(*arguments):
    identity = ["-c", "user.name=Test", "-c", "user.email=test@example.org", "-c", "commit.gpgsign=false"]
    subprocess.run(["git", *identity, *arguments], check=True, capture_output=True)


def commit(name):
    git("add", "--all")
    git("commit", "--quiet", "--message", name)
    git("tag", name)


@pytest.mark.parametrize(
    "side",
    [
        "git:first:spec",
        "git:HEAD~1:spec",
        "git:first:spec/VehicleSignalSpecification.vspec",
        "git:first",
    ],
)
def test_a_revision_is_a_side(repository, side):
    assert paths(side) == WHOLE
    assert paths("git:second:spec") == WHOLE[:3]


def test_a_path_counts_from_the_top_or_with_a_dot_from_here(repository, monkeypatch):
    monkeypatch.chdir(repository / "spec")
    assert paths("git:first:spec") == paths("git:first:./") == paths("git:first:.") == WHOLE
    with pytest.raises(UsageError, match="the path leaves the repository"):
        paths("git:first:../../x")
    (repository / "new").mkdir()
    monkeypatch.chdir(repository / "new")
    assert paths("git:first:../spec") == WHOLE


def test_overlays_of_a_revision_are_files_of_it(repository):
    Path("sport.vspec").unlink()
    assert paths("git:first:spec+sport.vspec") == [*WHOLE, "Vehicle.Boost"]


def test_what_changed_since_a_revision(repository, capsys):
    assert sigcat("diff", "git:first:spec", "spec", "--fail-on", "breaking") == 1
    assert "- Heat  [breaking]" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("side", "message"),
    [
        ("git:missing:spec", "has no such branch, tag or commit. `git branch --all` and `git tag` list"),
        ("git:frist:spec", "Did you mean 'first'?"),
        ("git:", "name a revision"),
        ("git:--output=x:spec", "name a revision"),
        ("git:first:missing", "the revision has no 'missing'"),
        ("git:first:../x", "the path leaves the repository"),
        ("git:first:spec/../../x", "the path leaves the repository"),
        ("git:first:link.vspec", "the revision has no 'link.vspec'"),
        ("git:first:spec+missing.vspec", "git:first:missing.vspec: there is no such overlay"),
    ],
)
def test_what_git_does_not_have_is_said(repository, side, message):
    with pytest.raises(UsageError) as refused:
        paths(side)
    assert message in str(refused.value)
    assert "/tmp" not in str(refused.value).replace(str(repository), "")


def test_outside_of_a_repository_git_is_quoted(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(tmp_path.parent))
    with pytest.raises(UsageError, match="git:HAED: not a git repository"):
        paths("git:HAED")


def test_without_git_that_is_said(monkeypatch):
    monkeypatch.setenv("PATH", "")
    with pytest.raises(UsageError, match="git is not installed"):
        paths("git:HEAD")


def test_findings_name_the_revision_and_not_the_folder_that_it_was_unpacked_to(repository):
    Path("spec/part/engine.vspec").write_text("Engine:\n  type: brunch\n#include missing.vspec\n")
    commit("broken")
    with pytest.raises(InputRefused) as refused:
        paths("git:broken:spec")
    files = {finding.file for finding in refused.value.findings}
    assert files == {f"git:broken:spec/{name}" for name in ("VehicleSignalSpecification.vspec", "part/engine.vspec")}
    assert not any("/tmp" in finding.message for finding in refused.value.findings)
