"""Classes by binding: what breaks depends on how a consumer finds and decodes the signals."""

import json

import pytest

from sigcat.catalogue.comparing.bindings import BINDINGS, BY_RULE, EFFECTS, TITLES, classes_of, for_bindings
from sigcat.catalogue.comparing.changes import CLASSES
from sigcat.catalogue.comparing.compatibility import ROWS
from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.comparing.diff_report import binding_names, binding_table
from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.cli import diff
from tests.catalogue.comparing.running import changes, sigcat, signal
from tests.catalogue.comparing.test_classes import DOCUMENT
from tests.catalogue.trees import ROOT


def classes(old: str, new: str) -> dict[str, str]:
    """The class of the only change for each binding."""
    (change,) = changes(old, new)
    return {each.binding: each.compatibility for each in classes_of(change)}


def breaking(old: str, new: str) -> set[str]:
    """Bindings that the only change breaks."""
    return {binding for binding, compatibility in classes(old, new).items() if compatibility == "breaking"}


def branch(name: str) -> str:
    return f"{name}:\n  type: branch\n  description: A branch.\n"


def test_the_documented_tables_are_those_of_the_code():
    assert binding_table() in DOCUMENT.read_text()
    assert binding_names() in DOCUMENT.read_text()


def test_the_command_knows_every_binding():
    assert diff._BINDINGS == BINDINGS == tuple(TITLES)
    assert diff._CLASSES == CLASSES


def test_a_rule_of_the_first_table_that_is_no_row_here_has_its_class_in_every_binding():
    assert len(BY_RULE) == len(EFFECTS)
    for effect in EFFECTS:
        assert (effect.rule in ROWS) is (not effect.what)
        assert effect.rule in ROWS or effect.cells.keys() == set(BINDINGS)


def test_a_signal_that_is_gone_breaks_every_binding():
    assert breaking(signal("Vehicle.A") + signal("Vehicle.B"), signal("Vehicle.A")) == set(BINDINGS)


def test_another_unit_breaks_every_binding_since_it_is_the_meaning():
    assert breaking(signal("Vehicle.A", unit="km"), signal("Vehicle.A", unit="m")) == set(BINDINGS)


def test_a_signal_at_the_end_of_a_branch_breaks_only_the_message_of_ros2():
    assert breaking(signal("Vehicle.A"), signal("Vehicle.A") + signal("Vehicle.B")) == {"ros2"}


def test_a_signal_in_the_middle_renumbers_the_fields_after_it():
    assert breaking(signal("Vehicle.B"), signal("Vehicle.A") + signal("Vehicle.B")) == {"ros2", "protobuf"}


def test_the_first_signal_of_a_branch_makes_a_message_and_changes_none():
    assert breaking(branch("Vehicle.Cabin"), branch("Vehicle.Cabin") + signal("Vehicle.Cabin.A")) == set()


def test_a_branch_in_the_middle_renumbers_fields_and_changes_no_message():
    old = signal("Vehicle.B")
    assert breaking(old, branch("Vehicle.Cabin") + signal("Vehicle.Cabin.A") + old) == {"protobuf"}


def test_another_order_breaks_what_is_numbered_by_position():
    assert breaking(signal("Vehicle.A") + signal("Vehicle.B"), signal("Vehicle.B") + signal("Vehicle.A")) == {
        "protobuf"
    }


def test_integers_that_read_each_other_in_protobuf_are_risky_there():
    found = classes(signal("Vehicle.A", datatype="uint8"), signal("Vehicle.A", datatype="uint16"))
    assert found["protobuf"] == "risky"
    assert found["path"] == found["ros2"] == found["c"] == found["graphql"] == found["ids"] == "breaking"


def test_float_and_double_are_one_type_in_graphql_alone():
    found = classes(signal("Vehicle.A"), signal("Vehicle.A", datatype="double"))
    assert [binding for binding, each in found.items() if each == "risky"] == ["graphql"]


def test_texts_become_an_enumeration_where_the_binding_has_one():
    old, new = signal("Vehicle.A", datatype="string"), signal("Vehicle.A", datatype="string", allowed="[X, Y]")
    assert breaking(old, new) == {"protobuf", "someip", "c", "graphql", "dds", "ids"}


def test_a_text_at_the_end_renumbers_none_and_one_before_does():
    def allowed(*texts):
        return signal("Vehicle.A", datatype="string", allowed=f"[{', '.join(texts)}]")

    assert breaking(allowed("X", "Y"), allowed("X", "Y", "Z")) == {"ids"}
    assert breaking(allowed("X", "Y"), allowed("Z", "X", "Y")) == {"protobuf", "someip", "c", "dds", "ids"}
    assert breaking(allowed("X", "Y"), allowed("X")) == {"protobuf", "graphql", "dds", "ids"}


def test_a_node_that_names_its_former_path_keeps_its_id():
    old = signal("Vehicle.A")
    assert "ids" not in breaking(old, signal("Vehicle.B", fka="[Vehicle.A]"))
    moved = branch("Vehicle.D") + "  fka: [Vehicle.C]\n" + signal("Vehicle.D.A", description="Value.")
    assert "ids" in breaking(branch("Vehicle.C") + signal("Vehicle.C.A", description="Value."), moved)


def test_a_dropped_unit_drops_the_argument_of_the_field():
    assert breaking(signal("Vehicle.A", unit="km"), signal("Vehicle.A")) == {"graphql", "ids"}


def test_a_unit_of_another_quantity_is_another_argument_in_graphql(sides, tmp_path, capsys):
    for name, unit in (("old", "km/h"), ("new", "km")):
        (tmp_path / f"{name}.vspec").write_text(ROOT + signal("Vehicle.B", unit=unit))
    assert sigcat("diff", *sides, "--format", "json") == 0
    (change,) = json.loads(capsys.readouterr().out)["changes"]
    assert change["effects"] == ["id-changed", "unit-quantity"]


def test_text_breaks_no_binding():
    assert set(classes(signal("Vehicle.A"), signal("Vehicle.A", comment="New.")).values()) == {"text"}


def test_the_class_for_several_bindings_is_the_worst_and_the_row_says_why():
    (change,) = for_bindings(
        changes(signal("Vehicle.B"), signal("Vehicle.A") + signal("Vehicle.B")), ["path", "protobuf"]
    )
    assert (change.compatibility, change.rule) == ("breaking", "added-before")


def test_properties_in_another_order_break_a_struct_that_is_sent_as_a_whole():
    def struct(*names):
        fields = "".join(f"T.P.{name}:\n  type: property\n  datatype: float\n  description: D.\n" for name in names)
        return f"T:\n  type: branch\n  description: D.\nT.P:\n  type: struct\n  description: D.\n{fields}"

    old, new = (
        compose(
            [layer_from_text(ROOT.encode(), "t", is_overlay=False)],
            types=[layer_from_text(text.encode(), "s", is_overlay=False)],
        )
        for text in (struct("X", "Y"), struct("Y", "X"))
    )
    (change,) = compare(old, new)
    found = {each.binding for each in classes_of(change) if each.compatibility == "breaking"}
    assert found == {"protobuf", "ros2", "someip", "c", "dds"}


@pytest.fixture
def sides(tmp_path):
    for name, text in (("old", signal("Vehicle.B")), ("new", signal("Vehicle.A") + signal("Vehicle.B"))):
        (tmp_path / f"{name}.vspec").write_text(ROOT + text)
    return str(tmp_path / "old.vspec"), str(tmp_path / "new.vspec")


def test_the_command_fails_for_the_bindings_that_are_named(sides, capsys):
    assert sigcat("diff", *sides, "--fail-on", "breaking") == 0
    assert sigcat("diff", *sides, "--fail-on", "breaking", "--binding", "path,json") == 0
    assert sigcat("diff", *sides, "--fail-on", "breaking", "--binding", "path", "--binding", "protobuf") == 1
    assert "added-before: The numbers of the fields after it change." in capsys.readouterr().out


@pytest.mark.parametrize("form", ["text", "markdown", "github", "gitlab"])
def test_every_format_says_why(form, sides, capsys):
    assert sigcat("diff", *sides, "--binding", "protobuf", "--format", form) == 0
    assert "The numbers of the fields after it change" in capsys.readouterr().out


def test_an_unknown_binding_is_refused_with_the_nearest_one(sides, capsys):
    with pytest.raises(SystemExit):
        sigcat("diff", *sides, "--binding", "protobf,x")
    assert "unknown binding 'protobf': Did you mean 'protobuf'?" in capsys.readouterr().err


def test_an_export_has_no_order_so_the_number_of_a_new_field_is_not_known(sides, tmp_path, capsys):
    export = str(tmp_path / "old.json")
    assert sigcat("export", "json", "-s", sides[0], "-o", export) == 0
    capsys.readouterr()
    assert sigcat("diff", export, sides[1], "--format", "json") == 0
    (change,) = json.loads(capsys.readouterr().out)["changes"]
    assert change["effects"] == ["position-unknown", "added-beside"]
    assert change["bindings"]["protobuf"] == "risky"
