"""Bad input: each gives clear findings, all at once, quickly, and the process lives."""

import threading

import pytest

from scripts.cases import BAD_INPUT
from sigcat.catalogue.composing.compose import compose, read_catalogue
from sigcat.catalogue.model.vocabulary import read_vocabulary
from sigcat.catalogue.reading.layers import layer_from_text, read_layer
from sigcat.cli import main
from sigcat.limits import Limits
from tests.catalogue.trees import ROOT, findings_of


@pytest.mark.parametrize("name", BAD_INPUT.names)
def test_the_findings_are_as_expected(name):
    found = BAD_INPUT.made(name)
    assert found
    assert found == BAD_INPUT.text(name), "If that is meant, run `make generate`."


def _merges(deep, wide):
    """The attributes of one node, merged through so many mappings, each so many times."""
    chain = (f"&m{n} {{k{n}: {{}}, <<: [{', '.join([f'*m{n - 1}'] * wide)}]}}" for n in range(1, deep))
    return "\n".join(("A:", "  comment: &m0 {a: b}", *(f"  x{n}: {each}" for n, each in enumerate(chain, 1)))).encode()


@pytest.mark.parametrize(
    ("text", "rule"),
    [
        (b"[" * 50_000, "R004"),
        (b"- " * 50_000, "R004"),
        (b"? " * 50_000, "R004"),
        (b"{a: " * 50_000, "R004"),
        ("\n".join(" " * depth + "a:" for depth in range(2_000)).encode(), "R004"),
        (b"A:\n  x: " + b"[" * 1_000 + b"]" * 1_000, "R014"),
        (b"\xff\xfe" + "Vehicle:".encode("utf-16-le"), "R002"),
        (b"A:\n  type: 9" + b"9" * 5_000, "R014"),
        (b"%TAG ! tag:yaml.org,2002:\n---\nA: !!map {type: !!python/name:os branch}", "R014"),
        (b"A: &a {<<: *a}", "R014"),
        (b"A: &a {x: {<<: [*a]}}", "R005"),
        (b"a: &a {<<: x}", "R014"),
        (_merges(70, 1), "R005"),
        (_merges(60, 2), "R005"),
    ],
)
def test_hostile_text_is_one_finding(text, rule):
    findings = layer_from_text(text, "text").findings
    assert [finding.rule for finding in findings] == [rule]


@pytest.mark.parametrize("ending", ["\n", "\r\n", "\r", "\x85", "\u2028", "\u2029"])
def test_directives_are_bounded_however_their_lines_end(ending):
    directives = [f"%TAG !a{n}! b:" for n in range(200)]
    findings = layer_from_text(ending.join([*directives, "---", "A: {type: branch}"]).encode(), "text").findings
    assert [finding.rule for finding in findings] == ["R001"]


def test_aliases_that_multiply_are_refused():
    lines = ["a0: &a0 [x, x, x, x, x, x, x, x, x]"]
    lines += [f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 9)}]" for n in range(1, 20)]
    text = "Vehicle:\n  type: branch\n  Bomb:\n" + "\n".join(f"    {line}" for line in lines)
    findings = layer_from_text(text.encode(), "bomb", limits=Limits(values=100_000)).findings
    assert [finding.rule for finding in findings] == ["R005"]


def test_a_file_of_100_megabytes_is_refused_unread(tmp_path):
    huge = tmp_path / "huge.vspec"
    with huge.open("wb") as file:
        file.truncate(100_000_000)
    assert [finding.rule for finding in read_layer(huge).findings] == ["R003"]


def test_a_missing_file_is_a_finding(tmp_path):
    catalogue = read_catalogue(tmp_path / "missing.vspec")
    assert [finding.rule for finding in catalogue.findings] == ["R012"]


def test_includes_that_multiply_are_refused(tmp_path):
    names = [f"level{n}.vspec" for n in range(8)]
    for name, below in zip(names, [*names[1:], ""], strict=True):
        includes = "".join(f"#include {below} P{n}\n" for n in range(20)) if below else ""
        (tmp_path / name).write_text(f"{ROOT}{includes}")
    layer = read_layer(tmp_path / names[0], limits=Limits(nodes=10_000))
    assert [finding.rule for finding in layer.findings] == ["R015"]


def test_a_link_out_of_the_folder_is_not_followed(tmp_path):
    outside = tmp_path / "outside.vspec"
    outside.write_text("Secret:\n  type: branch\n")
    inside = tmp_path / "tree"
    inside.mkdir()
    (inside / "link.vspec").symlink_to(outside)
    (inside / "tree.vspec").write_text(f"{ROOT}#include link.vspec Vehicle\n")
    catalogue = read_catalogue(inside / "tree.vspec")
    assert [finding.rule for finding in catalogue.findings] == ["R010"]
    assert catalogue.get("Vehicle.Secret") is None


def test_text_cannot_include_files():
    layer = layer_from_text(b"#include /etc/passwd\n", "posted")
    assert [finding.rule for finding in layer.findings] == ["R010"]


def test_a_path_of_300_names_is_refused():
    path = ".".join(["Vehicle"] + ["A"] * 300)
    assert findings_of(f"{ROOT}{path}:\n  type: branch\n") == ["R004"]


def test_two_catalogues_with_different_units_live_in_one_process_on_two_threads(tmp_path):
    results = {}

    def read(unit: str) -> None:
        folder = tmp_path / unit
        folder.mkdir()
        (folder / "quantities.yaml").write_text("speed:\n  definition: Speed.\n")
        (folder / "units.yaml").write_text(
            f"{unit}:\n  definition: D.\n  unit: name of {unit}\n  quantity: speed\n  allowed-datatypes: [numeric]\n"
        )
        signals = "".join(
            f"Vehicle.{name}:\n  type: sensor\n  datatype: float\n  unit: {name}\n" for name in ("knot", "warp")
        )
        (folder / "tree.vspec").write_text(ROOT + signals)
        for _ in range(20):
            results[unit] = read_catalogue(folder / "tree.vspec")

    threads = [threading.Thread(target=read, args=(unit,)) for unit in ("knot", "warp")]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [f.path for f in results["knot"].findings] == ["Vehicle.warp"]
    assert [f.path for f in results["warp"].findings] == ["Vehicle.knot"]


def test_everything_wrong_is_told_at_once():
    signals = "".join(f"Vehicle.S{number}:\n  type: sensor\n  datatype: flaot\n" for number in range(50))
    assert findings_of(ROOT + signals) == ["V003"] * 50


def test_unreadable_units_are_a_finding(tmp_path):
    vocabulary = read_vocabulary([tmp_path / "none.yaml"], [])
    assert [finding.rule for finding in vocabulary.findings] == ["R012"]
    assert compose([layer_from_text(ROOT.encode(), "tree", is_overlay=False)], vocabulary).get("Vehicle") is not None


@pytest.mark.parametrize(
    ("attributes", "told"),
    [
        ("datatype: int16, max: 0.0", [("warning", "V027")]),
        ("datatype: 'int8[]', default: [1.0, 2]", [("warning", "V027")]),
        ("datatype: int8, max: 0.5", [("error", "V008")]),
        ("datatype: int8, min: '0'", [("warning", "V027")]),
        ("datatype: int8, min: 1e1", [("warning", "V027")]),
        ("datatype: int8, default: true", [("warning", "V027")]),
        ("datatype: string, delete: 'yes'", [("warning", "V027")]),
        ("datatype: float, default: .nan", [("error", "V030")]),
        ("datatype: float, acme: {least: -.inf}", [("error", "V030")]),
        ("datatype: float, arraysize: .nan", [("error", "V004")]),
        ("datatype: .nan", [("error", "V004")]),
        ("datatype: uint8, max: 0100", [("warning", "R018")]),
        ("datatype: uint8, max: 1:30", [("warning", "R018")]),
        ("datatype: uint8, max: 0x1F", []),
        ("datatype: string, pattern: '[a'", [("warning", "V028")]),
        ("datatype: string, pattern: '[a', default: a", [("error", "V016")]),
        ("datatype: float, unit: km/h", [("error", "U007")]),
    ],
)
def test_a_value_that_is_clear_is_taken_with_a_warning_and_one_that_is_not_is_an_error(attributes, told):
    text = f"{ROOT}Vehicle.A: {{type: sensor, description: A., {attributes}}}\n"
    findings = compose([layer_from_text(text.encode(), "tree", is_overlay=False)]).findings
    assert [(finding.severity, finding.rule) for finding in findings] == told


def test_a_whole_number_with_a_point_is_exported_as_the_number_that_it_is():
    text = f"{ROOT}Vehicle.A: {{type: sensor, datatype: int16, max: 10.0, description: A.}}\n"
    node = compose([layer_from_text(text.encode(), "tree", is_overlay=False)]).get("Vehicle.A")
    assert node is not None
    assert repr(node.values["max"]) == "10"


@pytest.mark.parametrize("line", ["#inlcude A.vspec", "# include A.vspec Vehicle", "#Include A.vspec"])
def test_a_misspelled_include_is_told(line):
    text = f"{ROOT}{line}\n# Includes are explained elsewhere; see the include of Body.vspec.\n##include B.vspec\n"
    findings = compose([layer_from_text(text.encode(), "tree", is_overlay=False)]).findings
    assert [(f.rule, f.line) for f in findings] == [("R017", text.splitlines().index(line) + 1)]


@pytest.mark.parametrize(
    ("attributes", "message", "fix"),
    [
        ("datatype: string, default: 2020-01-01", "Default 2020-01-01 does not fit string (text).", "Quote it: YAML reads it as a date."),
        ("datatype: string, default: 5", "Default 5 does not fit string (text).", "Quote it: YAML reads it as a number."),
        ("datatype: string, allowed: [2020-01-01]", "`allowed` must be a list of values, not [2020-01-01].", "Quote it: YAML reads it as a date."),
        ("datatype: string, comment: 2020-01-01", "`comment` must be text, not 2020-01-01.", "Quote it: YAML reads it as a date."),
        ("2020-01-01: 5", "The name of an attribute must be text, not 2020-01-01.", "Quote it: YAML reads it as a date."),
        ("datatype: float, default: 1e3", "Default '1e3' does not fit float (numbers up to ±3.4028235e+38).", "Write 1000.0: YAML reads 1e3 as a text, as it has no point or no sign in its exponent."),
        ("datatype: uint16, min: 1e3", "`min` must be a number, not the text '1e3'.", "Write 1000: YAML reads 1e3 as a text, as it has no point or no sign in its exponent."),
        ("datatype: uint16, min: '1000'", "`min` must be a number, not the text '1000'.", "Write `min: 1000`, without quotes."),
        ("Off: 5", "The name of an attribute must be text, not False.", "Quote it: YAML reads words such as ON, OFF, YES and NO as true and false."),
        ("datatype: uint16, min: 1.0", "`min` must be a whole number, not 1.0.", "Write 1: vss-tools refuses fractions."),
    ],
)  # fmt: skip
def test_a_value_that_yaml_reads_as_another_is_shown_as_it_is_written(attributes, message, fix):
    text = f"{ROOT}Vehicle.A: {{type: sensor, description: A., {attributes}}}\n"
    found = compose([layer_from_text(text.encode(), "tree", is_overlay=False)]).findings
    assert [(finding.message, finding.fix) for finding in found] == [(message, fix)]


def test_an_instance_that_yaml_reads_as_a_truth_value_is_found(tmp_path, capsys):
    (tmp_path / "tree.vspec").write_text(
        "Vehicle: {type: branch, description: A vehicle.}\n"
        "Vehicle.Door: {type: branch, instances: [On, 'Off'], description: A door.}\n"
        "Vehicle.Door.IsOpen: {type: sensor, datatype: boolean, description: Whether it is open.}\n"
    )
    main(["lint", str(tmp_path / "tree.vspec")])
    out = capsys.readouterr().out
    assert out.count("V027") == 1
    assert "An instance must be text, not true: its path would end with 'True'. Quote it: YAML reads words" in out
