"""Documents from anywhere: large, wrong, hostile. Each is clear, quick, and stays inside its format."""

import json
from functools import partial

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sigcat.errors import InputRefused
from sigcat.function.function_json.model import to_json as function_to_json
from sigcat.function.function_json.wire import written
from sigcat.integration.reading import read_functions
from sigcat.integration.report import to_markdown
from sigcat.integration.ros2.document import read_integration
from sigcat.integration.ros2.names import FIELD, MESSAGE
from tests.function.shipped import interfaces
from tests.growth import LINEAR, growth
from tests.integration.ros2.functions import derived, document, function, signal
from tests.properties import examples

HOSTILE = [
    "*/ #include <x>",
    '"><script>alert(1)</script>',
    "a\nb: c",
    "\u202eevil",
    "x" * 5000,
    "",
    "é",
    "a.b..c",
    "../../x",
]


@pytest.mark.parametrize("text", HOSTILE)
def test_hostile_texts_become_names_that_are_none(text):
    made = document([function(signal(text, f"Vehicle.{text}", Description=text, Variable=text), name=text or "X")])
    assert made["InterfacePackageList"][0]["Messages"]
    assert [topic for call in made["CommunicationList"] for topic in call["ROSTopicList"]]
    for package in (*made["InterfacePackageList"], *made["NodePackageList"]):
        assert FIELD.fullmatch(package["Name"])
    for message in made["InterfacePackageList"][0]["Messages"]:
        assert MESSAGE.fullmatch(message["Name"])
        assert all(FIELD.fullmatch(field["Name"]) for field in message["Fields"])
    for call in made["CommunicationList"]:
        for topic in call["ROSTopicList"]:
            assert all(FIELD.fullmatch(part) for part in topic["TopicName"].split("/"))


def test_nothing_of_a_document_reaches_the_report_unescaped():
    hostile = function(signal('"><script>', "Vehicle.<b>|x|"), name="<img src=x>")
    table = to_markdown(derived([hostile]).report)
    assert "<" not in table
    assert all(line.replace("\\|", "").count("|") == 7 for line in table.splitlines())


@examples(40)
@given(st.text(max_size=40), st.text(max_size=40), st.text(max_size=20), st.text(max_size=20))
def test_any_text_anywhere_is_derived_or_refused(name, path, factor, unit):
    made = function(signal(name, path, Factor=factor, VssUnit=unit, Timeout=factor, AsilLevel=unit), name=name)
    json.loads(written(derived([made]).model))


def test_ten_times_the_signals_take_about_ten_times_as_long():
    def deriving(count):
        many = function(*(signal(f"S{i}", f"Vehicle.Branch{i % 50}.S{i}") for i in range(count)))
        return partial(derived, [many])

    assert len(deriving(1_000)().model.communications[0].topics) == 1_000
    assert growth(deriving, 100) < LINEAR


@pytest.mark.parametrize(
    ("data", "rule"),
    [
        (b"", None),
        (b"{", "F001"),
        (b'{"FunctionInfo": {"FunctionName": NaN}}', "F001"),
        ('{"FunctionInfo": "\u00e9"}'.encode("utf-16"), None),
        (b'{"FunctionInfo": ' + b"[" * 60_000, None),
        (b'{"FunctionInfo": {}}', "F002"),
    ],
)
def test_what_is_no_function_json_is_refused(data, rule):
    with pytest.raises(InputRefused) as refused:
        read_functions([(data, "function.json")], interfaces())
    assert refused.value.findings
    assert rule is None or rule in {finding.rule for finding in refused.value.findings}


def test_ten_times_the_text_takes_about_ten_times_as_long():
    def reading(count):
        data = b'{"FunctionInfo": "' + b"x" * count + b'"}'

        def read():
            with pytest.raises(InputRefused):
                read_functions([(data, "function.json")], interfaces())

        return read

    assert growth(reading, 200_000) < LINEAR


def test_another_schema_version_is_refused():
    data = json.loads(function_to_json(function(signal())))
    data["MetaInfo"] = {"SchemaVersion": "2.0.0"}
    with pytest.raises(InputRefused) as refused:
        read_functions([(json.dumps(data).encode(), "function.json")], interfaces())
    assert any("2.0.0" in finding.message for finding in refused.value.findings)


def test_integration_json_is_no_function():
    data = written(derived([function(signal())]).model)
    with pytest.raises(InputRefused, match="cannot be used") as refused:
        read_functions([(data, "ros2.json")], interfaces())
    assert any("not Integration JSON" in finding.message for finding in refused.value.findings)


def test_a_document_is_read_back_and_a_defect_has_its_place():
    data = written(derived([function(signal())]).model)
    assert written(read_integration(data, "ros2.json")) == data
    with pytest.raises(InputRefused) as refused:
        read_integration(data.replace(b'"TopicName"', b'"Topic"'), "ros2.json")
    (finding,) = refused.value.findings
    assert (finding.rule, finding.pointer) == ("F002", "/CommunicationList/0/ROSTopicList/0")
