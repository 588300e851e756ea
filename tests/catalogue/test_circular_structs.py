"""A struct that contains itself is a finding of the tree, and no export or page runs without end."""

import pytest

from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.cli import main

TREE = "Vehicle: {type: branch, description: V.}\nVehicle.A: {type: sensor, datatype: Types.A, description: A.}\n"
TYPES = """\
Types: {{type: branch, description: Types.}}
Types.A: {{type: struct, description: A.}}
Types.A.Size: {{type: property, datatype: float, description: Size.}}
Types.A.Next: {{type: property, {first}, description: Next.}}
Types.B: {{type: struct, description: B.}}
Types.B.Back: {{type: property, {second}, description: Back.}}
"""
LIST = "datatype: 'Types.A[]'"
CASES = {
    "itself": ("datatype: Types.A", "datatype: float", ["error A struct must not contain itself; 'Types.A' does."]),
    "by last names": ("datatype: B", "datatype: A", ["error A struct must not contain itself; 'Types.A' does, through Types.B."]),
    "through another": (
        "datatype: Types.B", "datatype: Types.A", ["error A struct must not contain itself; 'Types.A' does, through Types.B."]
    ),
    "an array of itself": (f"{LIST}, arraysize: 3", "datatype: float", ["error A struct must not contain itself; 'Types.A' does."]),
    "a list of itself": (LIST, "datatype: float", []),
    "another": ("datatype: Types.B", "datatype: float", []),
    "two": (
        LIST, "datatype: Types.B",
        ["error A struct must not contain itself; 'Types.B' does."],
    ),
}  # fmt: skip


@pytest.mark.parametrize(("first", "second", "expected"), CASES.values(), ids=CASES)
def test_each_circle_is_found_once(first, second, expected):
    layers = [
        layer_from_text(text.encode(), "tree", is_overlay=False)
        for text in (TREE, TYPES.format(first=first, second=second))
    ]
    found = [each for each in compose(layers[:1], types=layers[1:]).findings if each.rule == "V031"]
    assert [f"{each.severity} {each.message}" for each in found] == expected
    assert [(each.line, each.path) for each in found] == [
        (4, "Types.A.Next") if "'Types.A'" in each.message else (6, "Types.B.Back") for each in found
    ]


@pytest.mark.parametrize(
    "arguments", [["lint"], ["show", "Vehicle.A"], *(["export", each] for each in ("json", "yaml", "csv"))]
)
@pytest.mark.parametrize("datatype", ["datatype: Types.A", LIST], ids=["itself", "a list"])
def test_no_command_runs_without_end(arguments, datatype, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "tree.vspec").write_text(TREE)
    (tmp_path / "types.vspec").write_text(TYPES.format(first=datatype, second="datatype: float"))
    output = ["-o", "out"] if arguments[0] == "export" else []
    main([*arguments, "-s", "tree.vspec", "-t", "types.vspec", "--isolated", *output])
    shown = "".join(capsys.readouterr())
    assert "internal error" not in shown
    assert "V031" in shown or arguments[0] == "show" or datatype == LIST
