"""Tables of moves: the shipped ones fit the official trees, and one with an error is refused at its line."""

import pytest

from sigcat.catalogue.hosting.source import load
from sigcat.catalogue.hosting.sources import source_of_tree
from sigcat.cli import main
from sigcat.migration.labelled_path import labelled, parsed, plain, template
from sigcat.migration.migration import Migration
from sigcat.migration.table import read_table, shipped_tables, tables_between
from tests.needs import OFFICIAL

FOLDERS = {"3.1": "v3.1.1", "4.2": "v4.2.1", "7.0": "master"}
"""Folders of releases that are not named like them."""


def test_the_shipped_tables_are_one_chain():
    tables = shipped_tables()
    assert [table.old for table in tables[1:]] == [table.new for table in tables[:-1]]
    assert (tables[0].old, tables[-1].new) == ("3.0", "7.0")


def test_tables_lead_both_ways():
    assert [(table.old, table.new) for table in tables_between("5.0", "6.0")] == [("5.0", "5.1"), ("5.1", "6.0")]
    assert [(table.old, table.new) for table in tables_between("6.0", "5.0")] == [("6.0", "5.1"), ("5.1", "5.0")]
    assert tables_between("6.0", "6.0") == ()
    assert tables_between("6.0", "99.0") == ()


def _tree(release):
    folder = OFFICIAL / FOLDERS.get(release, f"v{release}") / "spec"
    if not folder.is_dir():
        pytest.skip(f"the official release {release} of VSS: `sigcat pull v{release}`")
    return load(source_of_tree(str(folder)))


@pytest.mark.parametrize("table", shipped_tables(), ids=lambda table: f"{table.old}-{table.new}")
def test_a_table_names_nodes_of_both_trees_and_explains_every_removed_one(table):
    old, new = _tree(table.old), _tree(table.new)
    for source, entry in table.moves.items():
        path = parsed(source)
        assert path is not None
        assert template(path) in old.definitions, source
        assert template(path) not in new.definitions or source == "Vehicle.Cabin.Seat.Massage", source
        for target in entry.targets:
            known = parsed(target)
            assert known is not None
            assert template(known) in new.definitions or plain(known) in new.nodes, target
    migration = Migration(old, new, (table,))
    removed = [path for path in old.definitions if path not in new.definitions]
    leaves = [path for path in removed if "datatype" in old.definitions[path].values]
    unexplained = [p for p in leaves if (fate := migration.fate(p)).status == "gone" and not fate.why]
    assert unexplained == []


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        ("", 1, "empty"),
        ("[]", 1, "must be a mapping"),
        ("from: '1'\nto: 2\n", 2, "`to` must be the name of a release"),
        ("from: '1'\nto: '2'\nmove: {}\n", 3, "Unknown key 'move'"),
        ("from: '1'\nto: '2'\nmoves:\n  A.B: 3\n", 4, "must have a target"),
        ("from: '1'\nto: '2'\nmoves:\n  A.B: {to: [C D]}\n", 4, "must have a target"),
        ("from: '1'\nto: '2'\nmoves:\n  A.B: {to: [C], confidence: 2}\n", 4, "from 0 to 1"),
        ("from: '1'\nto: '2'\nmoves: [A]\n", 3, "`moves` must be a mapping"),
        ("from: '1'\nto: '2'\nlabels: {A: [B]}\n", 1, "`A` must be a mapping"),
        ("from: '1\n", 1, "YAML"),
    ],
)
def test_a_table_with_an_error_is_refused(sides, text, line, message):
    sides.write("table.yaml", text)
    result = sides.run("--table", "table.yaml")
    assert result.status == 1
    assert message in result.messages or message == "YAML"
    assert f"table.yaml:{line}" in result.messages


def test_the_moves_between_two_trees_are_written_as_a_table(sides, tmp_path):
    result = sides.run("--write-table", "moves.yaml")
    assert result.status == 0
    table = read_table(tmp_path / "project/moves.yaml")
    assert table.moves["Vehicle.Coolant"].targets == ("Vehicle.Engine.Coolant",)
    assert table.moves["Vehicle.Same"].confidence == 0.5
    assert table.moves["Vehicle.Gone"].targets == ()


def test_labels_are_told_from_names(sides, tmp_path):
    tree = load(source_of_tree(str(tmp_path / "trees/old.vspec")))
    path, rest = labelled("Vehicle.Door.Row1.Left.IsOpen.Own", tree)
    assert (template(path), plain(path), rest) == ("Vehicle.Door.IsOpen", "Vehicle.Door.Row1.Left.IsOpen", "Own")


def test_sides_that_are_no_trees_are_refused(capsys):
    assert main(["migrate", "no", "none"]) == 2
    assert "no" in capsys.readouterr().err
