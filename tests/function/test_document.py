"""Function documents: values, places, and hostile bytes."""

import json
from functools import partial

import pytest

from sigcat.function.document.document import pointer_text
from sigcat.function.document.read_json import read_json
from sigcat.function.document.read_yaml import read_yaml
from sigcat.limits import Limits
from tests.growth import LINEAR, growth

JSON = b'{\n  "a": [1, {"b/c": "x"}],\n  "d~": {}\n}\n'
YAML = b"a:\n  - 1\n  - b/c: x\nd:\n  e: 5\n"


@pytest.mark.parametrize(
    ("pointer", "position"),
    [((), (1, 1)), (("a",), (2, 8)), (("a", 0), (2, 9)), (("a", 1), (2, 12)), (("a", 1, "b/c"), (2, 20)), (("d~",), (3, 9))],
)  # fmt: skip
def test_every_value_of_json_has_a_position(pointer, position):
    assert read_json(JSON, "f").position(pointer) == position


@pytest.mark.parametrize(
    ("pointer", "position"),
    [((), (1, 1)), (("a",), (1, 1)), (("a", 0), (2, 5)), (("a", 1, "b/c"), (3, 10)), (("d", "e"), (5, 6))],
)
def test_every_value_of_yaml_has_a_position(pointer, position):
    assert read_yaml(YAML, "f").position(pointer) == position


def test_a_key_has_a_position_of_its_own_and_an_item_that_of_its_value():
    assert read_json(JSON, "f").position(("a", 1, "b/c"), of_key=True) == (2, 13)
    assert read_yaml(YAML, "f").position(("d", "e"), of_key=True) == (5, 3)
    assert read_json(JSON, "f").position(("a", 0), of_key=True) == (2, 9)
    assert read_yaml(YAML, "f").position(("a", 0), of_key=True) == (2, 5)


@pytest.mark.parametrize("read", [read_json, read_yaml])
def test_what_is_not_there_has_the_position_of_what_is_around_it(read):
    data = JSON if read is read_json else YAML
    document = read(data, "f")
    assert document.position(("a", 1, "missing", 3)) == document.position(("a", 1))
    assert document.position(("nothing",)) == (1, 1)


def test_pointers_are_escaped():
    assert pointer_text(("a", 0, "b/c", "d~")) == "/a/0/b~1c/d~0"
    assert pointer_text(()) == ""


def test_json_that_yaml_would_not_take_is_read():
    text = '\t{"x":\t"\\ud83d\\ude00", "' + "k" * 2000 + '":1}'
    document = read_json(text.encode(), "f")
    assert document.findings == ()
    assert document.value["x"] == "😀"
    assert document.position(("k" * 2000,)) == (1, 2027)


BAD_JSON = [
    (b"", "F001", (1, 1)),
    (b"{", "F001", (1, 2)),
    (b"{'a': 1}", "F001", (1, 2)),
    (b'{"a": 1} // done', "F001", (1, 10)),
    (b'{"a":\n NaN}', "F001", (2, 2)),
    (b'{"a": -Infinity}', "F001", (1, 7)),
    (b'{"a": 1e999}', "F001", (1, 7)),
    (b'{"a": ' + b"9" * 5000 + b"}", "F001", (0, 0)),
    (b'{"a": 1,\n "a": 2}', "R006", (2, 2)),
    (b'{"a": "\xe9"}', "R002", (1, 8)),
    ('{"a": 1}'.encode("utf-16"), "R002", (1, 1)),
    (b"[" * 50_000, "R004", (1, 65)),
    (b'{"a":' * 50_000, "R004", (1, 321)),
]


@pytest.mark.parametrize(("data", "rule", "place"), BAD_JSON, ids=lambda value: str(value)[:20])
def test_bad_json_is_one_finding_with_a_place(data, rule, place):
    document = read_json(data, "f")
    assert [(f.rule, (f.line, f.column)) for f in document.findings] == [(rule, place)]


def test_a_comma_too_many_is_not_json():
    """Its place differs between versions of Python."""
    assert [finding.rule for finding in read_json(b'{"a": 1,}', "f").findings] == ["F001"]


def test_a_file_beyond_the_limit_is_refused_unread():
    assert [f.rule for f in read_json(b"[" * 101, "f", Limits(file_bytes=100)).findings] == ["R003"]


@pytest.mark.parametrize(("start", "part"), [(b'"', b'\\"'), (b"", b'{"a": "'), (b"[" * 60, b'"\\'), (b"", b"a")])
def test_unterminated_texts_are_refused_in_linear_time(start, part):
    assert read_json(start + part * 100_000, "f").findings
    assert growth(lambda count: partial(read_json, start + part * count, "f"), 100_000) < LINEAR


@pytest.mark.parametrize(
    ("data", "rule"),
    [
        (b"", "F002"),
        (b"a: 1\nb: {c: 1, c: 2}", "R006"),
        (b"a: &x [*x]", "R014"),
        (b"a: !!python/object:os.system x", "R014"),
        (b"a: [1", "R001"),
        (b"\xff\xfe", "R002"),
        (b"[" * 50_000, "R004"),
        (b"a: &a [x,x,x,x,x,x,x,x,x]\n" + b"".join(b"%c: &%c [%s]\n" % (c + 1, c + 1, b",".join([b"*%c" % c] * 9)) for c in range(97, 110)), "R014"),
    ],
    ids=range(8),
)  # fmt: skip
def test_bad_yaml_is_one_finding(data, rule):
    assert [finding.rule for finding in read_yaml(data, "f").findings] == [rule]


@pytest.mark.parametrize("half", [r"\ud800", r"\uDFFF", r"\udc00\ud800", r"\ud800\ud800\udc00", r"\\\ud83d"])
def test_json_with_half_a_character_is_refused_at_its_place(half):
    document = read_json(f'{{\n "a": "x{half}"}}'.encode(), "a.json")
    assert document.value is None
    [finding] = document.findings
    assert "is half of a character" in finding.message
    assert finding.line == 2


@pytest.mark.parametrize("text", [r"\ud83d\ude00", r"\\ud800", r"\\\\ud800", "\\u00e9"])
def test_json_with_whole_characters_is_read(text):
    assert read_json(f'{{"a": "{text}"}}'.encode(), "a.json").value == {"a": json.loads(f'"{text}"')}
