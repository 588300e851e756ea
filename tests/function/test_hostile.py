"""Nothing that a document contains ends in a traceback, and ten times as much of it takes about ten times as long."""

import json
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.data import ROOT_FILE
from sigcat.function.document.document import Pointer
from sigcat.function.function_file import build_function, check_function, check_function_json
from sigcat.function.function_json.model import to_json
from sigcat.limits import DEFAULT_LIMITS, Limits
from tests.function.shipped import FUNCTIONS, interfaces
from tests.growth import LINEAR, growth, ratio
from tests.overlays.test_overlays import UNITS
from tests.properties import examples

LEAVES = st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=8)
ANYTHING = st.recursive(
    LEAVES, lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=4), inner, max_size=3)
)
QUICKLY = examples(60)
DECLARATION = FUNCTIONS[0].read_bytes()
FUNCTION = json.loads(to_json(build_function(DECLARATION, "f.yaml", interfaces())[0]))


def pointers(value: Any, at: Pointer = ()) -> Iterator[Pointer]:
    yield at
    items: Any = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        yield from pointers(item, (*at, key))


PLACES = [pointer for pointer in pointers(FUNCTION) if pointer]


@QUICKLY
@given(st.binary(max_size=300))
def test_any_bytes_are_answered_with_findings(data):
    assert check_function_json(data, "f.json").findings
    assert check_function(data, "f.yaml", interfaces())


@QUICKLY
@given(st.sampled_from(PLACES), ANYTHING)
def test_any_value_anywhere_is_answered_with_findings_that_have_a_place(pointer, value):
    document = json.loads(json.dumps(FUNCTION))
    around = document
    for part in pointer[:-1]:
        around = around[part]
    around[pointer[-1]] = value
    try:
        data = json.dumps(document, allow_nan=False).encode()
    except ValueError:
        data = json.dumps(document).encode()
    validated = check_function_json(data, "f.json", interfaces())
    assert all(finding.line for finding in validated.findings)
    if validated.function is not None:
        to_json(validated.function)


@QUICKLY
@given(
    st.integers(0, len(DECLARATION) - 1),
    st.integers(1, 12),
    st.sampled_from([b"", b"x", b"- ", b": ", b"[", b"\t", b"0"]),
)
def test_any_damage_to_a_declaration_is_answered_with_findings(start, length, replacement):
    damaged = DECLARATION[:start] + replacement + DECLARATION[start + length :]
    for finding in check_function(damaged, "f.yaml", interfaces()):
        assert finding.message


def large(count: int, path: str = "Vehicle.Speed") -> bytes:
    items = "".join(
        f"\n          - {{path: {path}{i if path == 'X.Y' else ''}, role: consumed, name: s{i}}}" for i in range(count)
    )
    return (
        "function: CoreAcc\ndescription: Cruise control.\nresponsible: Cruise control team\n"
        f"components:\n  - name: CoreAcc\n    runnables:\n      - CoreAcc_Init\n      - interface: CoreAcc_Step\n        data:{items}\n"
        "        errors: [CoreAcc_AliveError_ErrorSts]\n      - CoreAcc_Terminate\n"
    ).encode()


def test_ten_times_the_signals_are_built_in_about_ten_times_the_time():
    interfaces()
    assert growth(lambda count: partial(build_function, large(count), "f.yaml", interfaces()), 200) < LINEAR


def test_ten_times_the_signals_are_validated_in_about_ten_times_the_time():
    def written(count):
        return to_json(build_function(large(count), "f.yaml", interfaces())[0])

    found = check_function_json(written(1_000), "f.json", interfaces()).findings
    assert sum(finding.rule == "F038" for finding in found) == 999
    assert growth(lambda count: partial(check_function_json, written(count), "f.json", interfaces()), 100) < LINEAR


def test_ten_times_the_wrong_signals_are_told_in_about_ten_times_the_time():
    found = check_function(large(1_000, "X.Y"), "f.yaml", interfaces())
    assert sum(finding.rule == "F010" for finding in found) == 1_000
    assert growth(lambda count: partial(check_function, large(count, "X.Y"), "f.yaml", interfaces()), 200) < LINEAR


def calls_after(previous: str, count: int) -> bytes:
    """Function JSON of many calls, each with a previous one."""
    document = json.loads(json.dumps(FUNCTION))
    call = {**document["ComponentList"][0]["functionList"][1], "funcContractList": None, "Watchdog": None}
    document["FunctionInfo"]["FunctionName"] = "CoreAcc"
    document["ComponentList"][0]["functionList"] = [
        {**call, "Name": f"CoreAcc_Step{i}", "PrevRunnable": previous.format(i + 1)} for i in range(count)
    ]
    return json.dumps(document).encode()


@pytest.mark.parametrize(
    ("previous", "rule", "count"),
    [("CoreAcc_Sep{}", "F052", 1_000), ("CoreAcc_Step{}", "F053", 0), ("CoreAcc_Step0", "F053", 1)],
    ids=["unknown", "chain", "circle"],
)
def test_ten_times_the_calls_are_put_in_order_in_about_ten_times_the_time(previous, rule, count):
    found = check_function_json(calls_after(previous, 1_000), "f.json").findings
    assert sum(finding.rule == rule for finding in found) == count
    assert growth(lambda calls: partial(check_function_json, calls_after(previous, calls), "f.json"), 100) < LINEAR


@pytest.mark.parametrize("text", ["*/ #include <x>", '"><script>', "\\u0000", "a" * 100_000])
def test_texts_are_carried_as_data(text):
    declared = large(1).decode().replace("Cruise control.", json.dumps(text)).encode()
    function, _ = build_function(declared, "f.yaml", interfaces())
    assert json.loads(to_json(function))["FunctionInfo"]["Description"] == text


# -- hostile files ------------------------------------------------------------------------------------------------

BOMB = b"a: &a [x,x,x,x,x,x,x,x,x]\n" + b"".join(
    b"%c: &%c [%s]\n" % (c + 1, c + 1, b",".join([b"*%c" % c] * 9)) for c in range(97, 118)
)
FILES: Mapping[str, Callable[[int], bytes]] = {
    "text": lambda size: b"function: " + b"A" * size,
    "items": lambda size: b"function: A\ncomponents: [" + b"{}," * (size // 3) + b"]",
    "json-text": lambda size: b'{"FunctionInfo": "' + b"A" * size + b'"}',
    "json-items": lambda size: b'{"FunctionInfo": [' + b"1," * (size // 2) + b"1]}",
    "braces": lambda size: b"{" * size,
    "dashes": lambda size: b"- " * (size // 2),
    "beyond the limit": lambda size: b"a" * size,
    "bytes": lambda size: b"\xff" * size,
}


@pytest.mark.parametrize("kind", FILES)
def test_ten_times_the_bytes_of_anything_take_about_ten_times_as_long(kind):
    name = "f.json" if kind.startswith("json") else "f.yaml"
    interfaces()
    limits = Limits(file_bytes=1_000_000) if kind == "beyond the limit" else DEFAULT_LIMITS
    assert check_function(FILES[kind](1_100_000), name, interfaces(), limits)
    assert growth(lambda size: partial(check_function, FILES[kind](size), name, interfaces(), limits), 30_000) < LINEAR


def test_aliases_that_multiply_cost_no_more_than_a_megabyte_of_text():
    text = FILES["text"](1_000_000)
    interfaces()
    assert check_function(BOMB, "f.yaml", interfaces())
    assert (
        ratio(
            partial(check_function, BOMB, "f.yaml", interfaces()), partial(check_function, text, "f.yaml", interfaces())
        )
        < 10
    )


@pytest.mark.parametrize("encoding", ["utf-16", "utf-32", "latin-1", "cp037"])
@pytest.mark.parametrize("name", ["f.yaml", "f.json"])
def test_another_encoding_is_one_clear_finding(encoding, name):
    text = DECLARATION.decode().replace("EcoControl", "ÖkoControl")
    found = check_function(text.encode(encoding), name, interfaces())
    assert [finding.rule for finding in found] == ["R002"]


def test_a_mark_of_byte_order_is_taken():
    assert check_function(b"\xef\xbb\xbf" + DECLARATION, "f.yaml", interfaces()) == ()


@pytest.mark.parametrize(
    ("version", "rules", "fix"),
    [
        ("2.1.0", ["F005"], "Use a newer sigcat"),
        ("v2.0", ["F005"], "Use a newer sigcat"),
        ("2", ["F005"], "Use a newer sigcat"),
        (2, ["F005"], "Use a newer sigcat"),
        ("0.9.0", ["F005"], "Write the document as version 1."),
        ("10.0.0", ["F005"], "Use a newer sigcat"),
        ("1.9.0", [], ""),
        (None, [], ""),
        (1.0, ["F004"], ""),
        (["1.0.0"], ["F004"], ""),
        ("first", ["F004"], ""),
        ("1.0", ["F004"], ""),
    ],
)
def test_another_version_of_the_format_is_one_clear_finding(version, rules, fix):
    document = json.loads(json.dumps(FUNCTION))
    document["MetaInfo"]["SchemaVersion"] = version
    found = check_function_json(json.dumps(document, indent=1).encode(), "f.json", interfaces()).findings
    assert [finding.rule for finding in found] == rules
    assert {(finding.pointer, finding.line > 1) for finding in found} <= {("/MetaInfo/SchemaVersion", True)}
    assert all(finding.fix.startswith(fix) for finding in found)


@pytest.mark.parametrize("name", ["*/ #include <x>", '"><script>alert(1)</script>', "a\nb", "../../x", "A" * 5000])
def test_a_name_that_is_none_is_a_finding(name):
    text = DECLARATION.decode().replace("name: BrkCylP", f"name: {json.dumps(name)}")
    assert {finding.rule for finding in check_function(text.encode(), "f.yaml", interfaces())} == {"F113"}
    text = DECLARATION.decode().replace("function: CoreAcc", f"function: {json.dumps(name)}")
    assert check_function(text.encode(), "f.yaml", interfaces())


DEMO = """\
function: Demo
description: A demonstration.
responsible: Demo team
define:
  scheduling:
    Init: {asil: QM, description: Prepares.}
    Step: {cycleTime: 20, asil: QM, description: Works.}
components:
  - name: Demo
    runnables: [Init, {interface: Step, data: [{path: PATH, role: consumed, asil: QM}]}]
"""


def test_a_faulty_allowed_value_of_the_catalogue_is_reported_at_the_signal(tmp_path):
    overlay = tmp_path / "o.vspec"
    overlay.write_text(
        "Vehicle.Gear:\n  type: sensor\n  datatype: string\n  description: A gear.\n  allowed: [P, '*/']\n"
    )
    catalogue = read_catalogue(ROOT_FILE, [overlay], units=UNITS)
    text = DEMO.replace("PATH", "Vehicle.Gear")
    found = [each for each in check_function(text.encode(), "f.yaml", catalogue) if each.rule == "F113"]
    assert [each.message for each in found] == [
        "An allowed value of 'Vehicle.Gear' must be a name of letters, digits, spaces and the signs _ - . : , /, not '*/'."
    ]
    assert "Vehicle.Gear" in text.splitlines()[found[0].line - 1]
