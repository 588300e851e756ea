"""`sigcat.toml` and the catalogues of the command line: values, and faults by line."""

import argparse
from collections.abc import Mapping
from pathlib import Path

import pytest

from sigcat.catalogue.hosting.releases import pull
from sigcat.catalogue.hosting.source import load
from sigcat.catalogue.hosting.sources import shipped_sources, source_from_option
from sigcat.cli.catalogue_options import add_catalogue_options, hosted_sources
from sigcat.cli.project_options import add_project_options, project_of
from sigcat.data import ROOT_FILE
from sigcat.errors import InputRefused, NotFound, UsageError
from sigcat.project.project import Project
from sigcat.project.project_file import TableReader
from sigcat.project.read_project import read_project

TREE = "Vehicle:\n  type: branch\n  description: A vehicle.\n"


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "overlays").mkdir()
    for name in ("tree.vspec", "overlays/first.vspec", "overlays/second.vspec", "units.yaml"):
        (tmp_path / name).write_text(TREE if name == "tree.vspec" else "")
    return tmp_path


def configuration(folder: Path, text: str, tables: Mapping[str, TableReader] | None = None) -> Project:
    file = folder / "sigcat.toml"
    file.write_text(text)
    return read_project(file, tables)


def findings(folder: Path, text: str) -> list[tuple[str, int, str, str]]:
    with pytest.raises(InputRefused) as refused:
        configuration(folder, text)
    return [(f.rule, f.line, f.message.replace(f"{folder}/", ""), f.fix) for f in refused.value.findings]


def test_catalogues_are_declared_in_order_with_their_overlays_in_order(folder, server, data):
    pull("v5.0", f"{server}/good", allows_private=True)
    found = configuration(
        folder,
        """
        watch = true
        shipped = false
        functions = ["overlays"]
        [[catalogue]]
        id = "own"
        title = "Our own"
        spec = "tree.vspec"
        overlays = ["overlays/second.vspec", "overlays/first.vspec"]
        units = ["units.yaml"]
        include-dirs = ["overlays"]
        [[catalogue]]
        id = "official"
        release = "5.0"
        [[catalogue]]
        id = "base"
        release = "shipped"
        """,
    )
    own, official, base = found.catalogues
    assert (own.id, own.title, own.spec) == ("own", "Our own", folder / "tree.vspec")
    assert own.overlays == (folder / "overlays/second.vspec", folder / "overlays/first.vspec")
    assert (own.units, own.include_dirs) == ((folder / "units.yaml",), (folder / "overlays",))
    assert (official.id, official.title, official.release) == ("official", "VSS 5.0", "v5.0")
    assert len(load(official).nodes) == 2
    assert base.spec == ROOT_FILE
    assert (found.is_watching, found.shipped) == (True, False)
    assert found.functions == (folder / "overlays",)


def test_an_empty_file_says_nothing(folder):
    found = configuration(folder, "")
    assert (found.catalogues, found.is_watching, found.shipped, found.functions) == ((), False, None, ())


def test_unknown_settings_are_refused_with_the_line_and_the_nearest_name(folder):
    text = '# Catalogues\nwach = true\n\n[[catalogue]]\nid = "a"\nspec = "tree.vspec"\noverlay = []\n'
    assert findings(folder, text) == [
        ("C002", 2, "Unknown setting 'wach'.", "Did you mean 'watch'?"),
        ("C002", 7, "Unknown setting 'overlay'.", "Did you mean 'overlays'?"),
    ]


def test_the_line_is_that_of_the_catalogue_meant(folder):
    text = '[[catalogue]]\nid = "a"\nspec = "tree.vspec"\n\n[[catalogue]]\nid = "b"\nspec = "none.vspec"\n'
    assert findings(folder, text) == [("C005", 7, "There is no file 'none.vspec'.", "")]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('[[catalogue]]\nspec = "tree.vspec"\n', ("C004", 1, "The catalogue has no `id`.")),
        (
            '[[catalogue]]\nid = "a"\n',
            ("C004", 1, "The catalogue has neither `spec` nor `release`; one of them is needed."),
        ),
        (
            '[[catalogue]]\nid = "a"\nspec = "tree.vspec"\nrelease = "shipped"\n',
            ("C004", 1, "The catalogue has both `spec` and `release`; one of them is needed."),
        ),
        ('[[catalogue]]\nid = 5\nspec = "tree.vspec"\n', ("C003", 2, "`id` must be text, not 5.")),
        (
            '[[catalogue]]\nid = "../a"\nspec = "tree.vspec"\n',
            ("C003", 2, "`id` must be letters, digits, '.', '_' and '-', not '../a'."),
        ),
        ('watch = "yes"\n', ("C003", 1, "`watch` must be true or false, not 'yes'.")),
        ('[catalogue]\nid = "a"\n', ("C003", 1, "`catalogue` must be a list, not {'id': 'a'}.")),
        ("catalogue = [1]\n", ("C003", 1, "`catalogue` must be tables: [[catalogue]].")),
        (
            '[[catalogue]]\nid = "a"\nspec = "tree.vspec"\noverlays = "x"\n',
            ("C003", 4, "`overlays` must be a list, not 'x'."),
        ),
        (
            '[[catalogue]]\nid = "a"\nspec = "tree.vspec"\noverlays = [\n  1,\n]\n',
            ("C003", 4, "`overlays` must be a list of texts."),
        ),
        (
            '[[catalogue]]\nid = "a"\nspec = "tree.vspec"\ninclude_dirs = ["tree.vspec"]\n',
            ("C005", 4, "'tree.vspec' must be a folder, not a file."),
        ),
        (
            "watch = true\nwatch = false\n",
            ("C001", 2, "Not valid TOML: `watch` is given twice, first at sigcat.toml:1."),
        ),
        ("watch = \n", ("C001", 1, "Not valid TOML: Invalid value.")),
        ("[[catalogue", ("C001", 1, "Not valid TOML: Expected ']]' at the end of an array declaration.")),
    ],
)
def test_each_fault_has_its_line(folder, text, expected):
    assert [finding[:3] for finding in findings(folder, text)] == [expected]


def test_two_catalogues_cannot_have_one_id(folder):
    one = '[[catalogue]]\nid = "a"\nspec = "tree.vspec"\n'
    assert findings(folder, one + one) == [("C006", 5, "Two catalogues have the id 'a', first at sigcat.toml:2.", "")]


def test_a_release_that_was_not_pulled_is_told_with_how_to_pull_it(folder, data):
    text = '[[catalogue]]\nid = "a"\nrelease = "v4.0"\n'
    assert findings(folder, text) == [("C005", 3, "Release v4.0 is not pulled. Run `sigcat pull v4.0`.", "")]


def test_a_table_of_others_is_checked_by_its_reader(folder):
    text = "[service]\nport = 80\n"
    assert configuration(folder, text, {"service": lambda table, _file: table["port"]}).tables == {"service": 80}
    assert configuration(folder, text).tables == {}


def test_what_is_no_text_is_refused(folder):
    (folder / "sigcat.toml").write_bytes(b"# one\n\xff\n")
    with pytest.raises(InputRefused) as refused:
        read_project(folder / "sigcat.toml")
    assert [(f.rule, f.line) for f in refused.value.findings] == [("C001", 2)]


def test_a_missing_file_is_an_error_of_usage(folder):
    with pytest.raises(UsageError, match="No such file"):
        read_project(folder / "none.toml")


def test_an_option_names_a_file_a_folder_or_a_release_with_overlays(folder, server, data):
    release = pull("v5.0", f"{server}/good", allows_private=True)
    overlay = folder / "overlays/first.vspec"
    file = source_from_option(f"a={folder}/tree.vspec,{overlay}")
    assert (file.id, file.spec, file.overlays) == ("a", folder / "tree.vspec", (overlay,))
    assert source_from_option(f"b={release.folder}").spec == release.spec
    assert source_from_option("c=5.0").release == "v5.0"
    assert source_from_option("d=shipped").spec == ROOT_FILE


def test_a_path_may_have_a_comma(tmp_path):
    folder = tmp_path / "a,b"
    folder.mkdir()
    for name in ("tree.vspec", "one,two.vspec"):
        (folder / name).write_text(TREE)
    source = source_from_option(f"a={folder}/tree.vspec,{folder}/one,two.vspec")
    assert (source.spec, source.overlays) == (folder / "tree.vspec", (folder / "one,two.vspec",))


@pytest.mark.parametrize("text", ["", "a", "a=", "=b", "a=5.0,missing.vspec", "a=overlays"])
def test_an_option_that_names_no_catalogue_is_refused(folder, monkeypatch, data, text):
    monkeypatch.chdir(folder)
    with pytest.raises((UsageError, NotFound)):
        source_from_option(text)


def hosted(*argv: str) -> list[str]:
    """The ids of the catalogues that a service hosts."""
    parser = argparse.ArgumentParser()
    add_catalogue_options(parser)
    add_project_options(parser)
    arguments = parser.parse_args(argv)
    return [source.id for source in hosted_sources(arguments, project_of(arguments))]


def test_the_command_line_comes_before_the_file_and_the_shipped_ones_last(folder, monkeypatch):
    monkeypatch.chdir(folder)
    assert hosted() == [source.id for source in shipped_sources()]
    Path("sigcat.toml").write_text('[[catalogue]]\nid = "vss"\nspec = "tree.vspec"\n')
    assert hosted("--catalogue", "mine=tree.vspec") == ["mine", "vss", "interfaces"]


def test_the_configuration_is_named_by_option_or_environment(folder, monkeypatch, tmp_path):
    other = tmp_path / "other.toml"
    other.write_text('shipped = false\n[[catalogue]]\nid = "only"\nspec = "tree.vspec"\n')
    assert hosted("--config", str(other)) == ["only"]
    monkeypatch.setenv("SIGCAT_CONFIG", str(other))
    assert hosted() == ["only"]
    assert hosted("--isolated") == [source.id for source in shipped_sources()]


def test_nothing_to_host_is_an_error_of_usage(folder, monkeypatch):
    monkeypatch.chdir(folder)
    Path("sigcat.toml").write_text("shipped = false\n")
    with pytest.raises(UsageError, match="no catalogue is left"):
        hosted()


def test_a_folder_is_answered_as_one_and_a_misspelled_key_has_one_finding(folder):
    assert findings(folder, '[[catalogue]]\nid = "a"\nspec = "overlays"\n') == [
        ("C005", 3, "'overlays' must be a file, not a folder.", "Name the root .vspec file in it."),
    ]
    assert [finding[:2] for finding in findings(folder, '[[catalogue]]\nid = "a"\ntree = "tree.vspec"\n')] == [
        ("C002", 3)
    ]


def test_one_file_configures_the_service_and_the_linter(folder, monkeypatch):
    (folder / "sigcat.toml").write_text('[lint]\nignore = ["V110"]\n[[catalogue]]\nid = "own"\nspec = "tree.vspec"\n')
    monkeypatch.chdir(folder)
    assert hosted()[0] == "own"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('functions = ["none"]', "There is no folder 'none'."),
        ('functions = ["tree.vspec"]', "'tree.vspec' must be a folder, not a file."),
        ("functions = [1]", "`functions` must be a list of texts."),
        ('functions = "overlays"', "`functions` must be a list, not 'overlays'."),
    ],
)
def test_folders_of_functions_must_be_there(folder, text, message):
    assert [(line, found) for _, line, found, _ in findings(folder, f"\n{text}\n")] == [(2, message)]


@pytest.mark.parametrize(
    ("line", "fix"),
    [
        ("overlay = []", "Write `overlays` in [[catalogue]]."),
        ('spec = "tree.vspec"', "Write `spec` in [[catalogue]]."),
        ("ignore = []", "Write `ignore` in [lint]."),
        ('extended_attributes = ["owner"]', "Write `extended-attributes` in [lint]."),
        ("zzz = 1", "Known are watch, shipped, "),
    ],
)
def test_a_setting_in_the_wrong_table_is_told_with_the_right_one(folder, line, fix):
    ((_, _, _, advice),) = findings(folder, f"{line}\n")
    assert advice.startswith(fix)


def test_units_and_quantities_beside_the_file_need_no_entry(tmp_path):
    file = tmp_path / "sigcat.toml"
    file.write_text('[[catalogue]]\nid = "own"\nrelease = "shipped"\n')
    for name in ("units.yaml", "quantities.yaml"):
        (tmp_path / name).write_text("")
    read = read_project(file)
    assert (read.units, read.quantities) == ((tmp_path / "units.yaml",), (tmp_path / "quantities.yaml",))
    assert read.catalogues[0].units == read.units


def test_units_beside_a_tree_are_those_of_the_tree(tmp_path):
    file = tmp_path / "sigcat.toml"
    file.write_text('[[catalogue]]\nid = "own"\nspec = "Own.vspec"\n')
    for name in ("units.yaml", "Own.vspec"):
        (tmp_path / name).write_text("")
    assert read_project(file).units == ()
