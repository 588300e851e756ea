"""ARXML of Integration JSON that came from elsewhere, or that wants to get out of its XML."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sigcat.adapter.autosar_adaptive.arxml.adaptive_arxml import generate
from sigcat.errors import InputRefused
from sigcat.function.function_json.wire import written
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.integration.autosar_adaptive.storages import stored_parameters
from tests.adapter.arxml_made import METHOD, document, refused, tags, texts
from tests.adapter.arxml_requirements import (
    dangling,
    doubled_names,
    doubled_numbers,
    loaded,
    misplaced,
    without_number,
)
from tests.integration.autosar_adaptive.sets import at, derive, function, parameter, signal
from tests.needs import published, published_files
from tests.properties import examples
from tests.reference_tools import checked_with

# -- Integration JSON from elsewhere -------------------------------------------------------------------------------------


@published_files
def test_the_published_example_becomes_arxml_with_ids_by_rule():
    files = generate(read_integration(published("integration_model_AA_core_acc.json"), "published.json"))
    model = loaded(files)
    assert dangling(model) == []
    assert misplaced(model) == []
    assert without_number(model) == []
    assert doubled_numbers(model) == []


def test_what_autosar_cannot_name_is_refused_where_it_stands():
    value = document()
    value["ComponentList"][0]["ServiceInterfaceList"][0]["ServiceList"][0]["Events"][0]["Name"] = '"/><script>'
    found = refused(value)
    assert [finding.rule for finding in found] == ["A020"]
    assert found[0].pointer == "/ComponentList/0/ServiceInterfaceList/0/ServiceList/0/Events/0/Name"
    assert found[0].line > 1


@pytest.mark.parametrize(
    ("codes", "words"),
    [
        (({"Key": "gain/x"},), "key name"),
        (({"Storage": "1st"},), "storage name must be"),
        (({"Storage": "Adapter"},), "that of another port"),
        (({"Key": "Gain"}, {"Key": "gain"}), "key names 'Gain' and 'gain'"),
        (({"Storage": "Cal"}, {"Storage": "CAL"}), "storage names 'Cal' and 'CAL'"),
    ],
)
def test_storages_and_keys_that_autosar_cannot_have_are_refused(codes, words):
    listed = [parameter(Name=f"P{index}", Variable=f"g_{index}", **code) for index, code in enumerate(codes)]
    value = json.loads(written(derive([function(contract={"ParameterList": listed})]).model))
    del value["SourceFunctionList"]
    found = refused(value)
    assert {finding.rule for finding in found} == {"A020"}
    assert words in found[0].message
    assert found[0].pointer == f"/ComponentList/0/ParameterList/{len(codes) - 1}"


def test_a_parameter_that_two_calls_describe_differently_is_stored_once():
    listed = [parameter(Key="gain", Variable="g_gain", Description=text) for text in ("A gain.", "Another gain.")]
    model = derive([function(contract={"ParameterList": listed})]).model
    assert [each.key for each in stored_parameters(model.components[0])][:1] == ["gain"]


def test_a_datatype_that_is_not_defined_is_refused():
    value = document()
    value["ComponentList"][0]["ServiceInterfaceList"][0]["ServiceList"][0]["Events"][0]["DataType"] = "DT_Nothing"
    assert "'DT_Nothing' of A_B is not defined" in refused(value)[0].message


@pytest.mark.parametrize(
    "entry",
    [
        {"Name": "uint8_t", "Class": "type_reference", "cDef": "bool"},
        {"Name": "A/B", "Class": "structure", "Field": []},
        {"Name": "E", "Class": "enumeration", "EnumField": [{"Symbol": "</VT>", "Value": 1}]},
        {"Name": "S", "Class": "structure", "Field": [{"Name": "a", "Type": "bool"}, {"Name": "A", "Type": "bool"}]},
        {"Name": "S", "Class": "structure", "Field": [{"Name": "a", "Type": "nothing"}]},
        {"Name": "L", "Class": "array", "Dimension": 3},
    ],
)
def test_datatypes_that_autosar_cannot_have_are_refused(entry):
    assert refused(document(DataTypes=[entry]))[0].rule == "A020"


@pytest.mark.parametrize(("key", "value"), [("Package", "a b"), ("FunctionGroup", "1")])
def test_names_of_the_deployment_are_checked(key, value):
    base = document()
    base["Deployment"][key] = value
    assert refused(base)[0].pointer == f"/Deployment/{key}"


def test_an_array_of_open_length_needs_a_length():
    value = document(DataTypes=[{"Name": "L", "Class": "array", "Type": "float", "Dimension": "dynamic"}])
    value["Deployment"]["Transformation"]["arrayLength"] = 0
    assert [finding.pointer for finding in refused(value)] == ["/Deployment/Transformation/arrayLength"]


def test_an_id_that_two_have_is_refused():
    model = derive([function(signals=[at("Vehicle.A.B"), at("Vehicle.A.C")])]).model
    value = json.loads(written(model))
    for event in value["ComponentList"][0]["ServiceInterfaceList"][0]["ServiceList"][0]["Events"]:
        event["EventID"] = 32770
    assert "must have different ids, not both 32770" in refused(value)[0].message


@pytest.mark.parametrize("data", [b"", b"[]", b"{}", b"\xff\xfe", b"nonsense", b'{"ComponentList": 3}', b"[" * 100_000])
def test_what_is_no_integration_json_is_refused(data):
    with pytest.raises(InputRefused) as caught:
        read_integration(data, "integration.json")
    assert caught.value.findings


# -- texts that want to get out ------------------------------------------------------------------------------------------


HOSTILE = [
    '"><script>alert(1)</script>',
    "*/ #include <x>",
    "]]><!--",
    "&amp;&lt;",
    "\u0000\u0001\u001f",
    "\ufffe",
    "été 🚗",
    "a\nb\tc",
]


@checked_with("autosar-data", "ARXML loads for any text or name of a function")
@pytest.mark.parametrize("text", HOSTILE)
def test_hostile_texts_stay_texts(text):
    method = METHOD | {"Description": text}
    one = function(
        "Demo",
        [signal("S", Description=text, Variable=text, Units=text, VssPath="Vehicle.A.S")],
        contract={"MethodList": [method]},
    )
    files = generate(derive([one]).model)
    model = loaded(files)
    assert dangling(model) == []
    assert not [element for element in tags(files) if element.tag.lower().endswith("script")]
    if text.isprintable():
        assert text in texts(files, "L-2")


@checked_with("autosar-data", "ARXML loads for any text or name of a function")
@pytest.mark.parametrize("name", [*HOSTILE, "x" * 5000, "class", "1st"])
def test_hostile_names_load_and_resolve(name):
    one = function(
        name, [signal(name, "Provider"), signal(f"{name}x")], contract={"MethodList": [METHOD | {"Name": name}]}
    )
    model = loaded(generate(derive([one]).model))
    assert dangling(model) == []
    assert doubled_names(model) == []


@pytest.mark.parametrize("number", ["", "abc", "</V>", "1e999999999", "05", "1_0", "nan", "-0.5", "1e-5", "1/3"])
def test_scalings_and_conversions_that_are_no_numbers_do_no_harm(number):
    scaled = signal("S", Factor=number, Offset=number, VssPath=None)
    largest = 1.7976931348623157e308
    converted = at("Vehicle.A.B", ConversionFactor=number, ConversionOffset=number) | {"Max": largest}
    over = at("Vehicle.A.C", ConversionFactor="3.6", ConversionOffset="0") | {"Max": largest}
    assert dangling(loaded(generate(derive([function(signals=[scaled, converted, over])]).model))) == []


@checked_with("autosar-data", "ARXML loads for any text or name of a function")
@examples(60)
@given(st.text(max_size=200), st.text(max_size=200), st.text(max_size=200))
def test_any_text_is_carried_and_any_name_has_a_place(name, path, text):
    one = function(
        name,
        [signal(text, VssPath=path or None, Description=text, Units=name), signal(name, "Provider", Variable=text)],
    )
    model = loaded(generate(derive([one]).model))
    assert dangling(model) == []
    assert doubled_names(model) == []
    assert misplaced(model) == []
