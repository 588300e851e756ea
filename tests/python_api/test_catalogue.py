"""Catalogues and nodes of the Python API: what is returned, what is raised, and how notebooks show them."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

import sigcat

TREE = """\
Vehicle:
  type: branch
  description: A vehicle.
Vehicle.Speed:
  type: sensor
  datatype: float
  unit: km/h
  description: "<script>alert('1')</script> & more"
"""


@pytest.fixture
def tree(tmp_path):
    file = tmp_path / "tree.vspec"
    file.write_text(TREE)
    return file


@pytest.fixture(scope="module")
def shipped():
    return sigcat.open_catalogue()


@pytest.fixture
def units():
    from sigcat.data import VSPEC

    return {"units": [VSPEC / "units.yaml"], "quantities": [VSPEC / "quantities.yaml"]}


def test_importing_the_package_loads_nothing_else():
    code = "import sys, sigcat; print([name for name in sys.modules if name.startswith('sigcat.')])"
    printed = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert printed == "[]\n"


def test_opening_a_catalogue_loads_neither_service_nor_functions():
    code = (
        "import sys, sigcat; sigcat.open_catalogue()\n"
        "print([name for name in ('fastapi', 'pydantic', 'vss_tools', 'pyarrow', 'sigcat.function') if name in sys.modules])"
    )
    printed = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert printed == "[]\n"


def test_every_public_name_is_there_and_is_listed():
    names = [name for names in sigcat._NAMES.values() for name in names]
    assert set(names) <= set(dir(sigcat))
    assert all(getattr(sigcat, name).__name__ == name for name in names)
    with pytest.raises(AttributeError, match="no attribute 'Catalog'"):
        _ = sigcat.Catalog


def test_the_stub_of_the_wheel_has_the_types_of_every_public_name():
    stub = (Path(__file__).parents[2] / "app/public/__init__.pyi").read_text("utf-8")
    imports = re.findall(r"^from sigcat\.(\S+) import (\w+) as \2$", stub, re.MULTILINE)
    assert sorted(imports) == sorted((module, name) for module, names in sigcat._NAMES.items() for name in names)


def test_a_later_value_of_an_overlay_has_its_origin_and_the_one_before(tree, units, tmp_path):
    overlay = tmp_path / "acme.vspec"
    overlay.write_text("Vehicle.Speed:\n  type: sensor\n  datatype: float\n  unit: m/s\n")
    attribute = sigcat.open_catalogue(tree, overlays=[overlay], **units)["Vehicle.Speed"].attributes["unit"]
    assert (attribute.value, attribute.origin.line, attribute.origin.file) == ("m/s", 4, str(overlay))
    assert [value for value, _ in attribute.history] == ["km/h", "m/s"]


def test_nodes_of_one_catalogue_are_equal_by_path(shipped):
    assert shipped["Vehicle.Speed"] == shipped.get("Vehicle.Speed") == shipped["Vehicle/Speed"]
    assert len({shipped["Vehicle.Speed"], shipped["Vehicle.Speed"]}) == 1
    assert shipped["Vehicle.Speed"] != sigcat.open_catalogue()["Vehicle.Speed"]
    assert shipped.get("Vehicle.Sped") is None


def test_walking_a_node_yields_it_and_what_is_below_it(shipped):
    below = [node.path for node in shipped["Vehicle.Cabin.Door"].walk()]
    assert below[0] == "Vehicle.Cabin.Door"
    assert all(path.startswith("Vehicle.Cabin.Door") for path in below)
    assert [root.parent for root in shipped.roots] == [None] * len(shipped.roots)


def test_errors_of_a_tree_are_raised_with_all_findings(tree, units):
    tree.write_text(TREE + "Vehicle.A:\n  type: sensr\nVehicle.B:\n  type: brnch\n")
    with pytest.raises(sigcat.InputRefused, match=r"'tree' has 2 errors\.") as refused:
        sigcat.open_catalogue(tree, **units)
    assert any("tree.vspec:10" in note for note in refused.value.__notes__)
    assert len(refused.value.findings) > 1


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda shipped: shipped["Vehicle.Sped"], sigcat.NotFound, "Did you mean Vehicle.Speed"),
        (lambda shipped: shipped.instances("Vehicle.Sped"), sigcat.NotFound, "Did you mean Vehicle.Speed"),
        (lambda shipped: shipped.search("speed", type="sensr"), sigcat.UsageError, "Did you mean 'sensor'"),
        (lambda _: sigcat.open_catalogue("no/such.vspec"), sigcat.UsageError, "there is no such file"),
        (lambda _: sigcat.open_catalogue(overlays=["no.vspec"]), sigcat.UsageError, "there is no such file"),
        (lambda _: sigcat.open_project("no/such/folder"), sigcat.UsageError, "there is no such folder"),
        (lambda shipped: shipped.resolve("no.yaml"), sigcat.UsageError, "there is no such file"),
        (lambda _: sigcat.diff("no/such", "vss"), sigcat.UsageError, "there is no such file"),
    ],
)
def test_what_does_not_exist_is_an_exception_that_says_so(call, error, message, shipped):
    with pytest.raises(error, match=message):
        call(shipped)


@pytest.mark.parametrize(
    ("text", "rules"),
    [
        ("Vehicle.Speed:\n  unit: kmh\n", {"O103", "V006"}),
        ("Train:\n  type: branch\n  description: A train.\nTrain.Speed:\n  type: sensr\n", {"V001"}),
        ("function: Watch\n", {"F002"}),
        ("", {"Q003"}),
        ("a: [\ud800", {"R002"}),
    ],
    ids=["overlay", "tree", "function", "empty", "no UTF-8"],
)
def test_a_text_of_any_kind_is_linted(text, rules, shipped):
    found = shipped.lint(text, "posted")
    assert rules <= {finding.rule for finding in found}
    assert {finding.file for finding in found} == {"posted"}


def test_a_notebook_shows_texts_and_no_markup_of_a_tree(tree, units):
    catalogue = sigcat.open_catalogue(tree, **units)
    for shown in (catalogue._repr_html_(), catalogue["Vehicle.Speed"]._repr_html_()):
        assert "<script" not in shown
        assert "&lt;script&gt;alert(&#x27;1&#x27;)&lt;/script&gt; &amp; more" in shown
    assert "tree.vspec:7" in catalogue["Vehicle.Speed"]._repr_html_()


def test_a_notebook_shows_a_bounded_part_of_a_large_branch(tmp_path, units):
    file = tmp_path / "large.vspec"
    signals = "".join(f"Vehicle.S{n}:\n  type: sensor\n  datatype: float\n  description: A.\n" for n in range(200))
    file.write_text("Vehicle:\n  type: branch\n  description: A vehicle.\n" + signals)
    shown = sigcat.open_catalogue(file, **units)["Vehicle"]._repr_html_()
    assert shown.count("<tr>") < 70
    assert "150 more" in shown


def test_nothing_is_printed(shipped, capfd):
    shipped.lint("Vehicle.Speed:\n  unit: kmh\n")
    shipped.try_overlay("Vehicle.Speed: {typ: x}\n")
    sigcat.diff("vss", "interfaces")
    repr((shipped, shipped["Vehicle.Speed"]))
    assert capfd.readouterr() == ("", "")
