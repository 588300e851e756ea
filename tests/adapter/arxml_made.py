"""ARXML of examples and of every kind of interface, and how it is looked into."""

import html
import json
import xml.etree.ElementTree as ET
from functools import cache

import pytest

from sigcat.adapter.autosar_adaptive.arxml.adaptive_arxml import generate
from sigcat.errors import InputRefused
from sigcat.function.function_json.wire import written
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT
from tests.integration.autosar_adaptive.sets import at, deployed, derive, examples, function, signal

POINT = {
    "typeRef": "DT_Point", "category": "userdefined", "cDef": "struct Point", "Kind": "struct",
    "Description": "A place.",
    "Fields": [{"Name": "X", "Datatype": "DT_Float32", "Units": "m", "Description": "Ahead.", "Min": -2, "Max": 7.5},
               {"Name": "Label", "Datatype": "DT_String"}],
}  # fmt: skip


POINTS = {
    "typeRef": "DT_Points", "category": "userdefined", "cDef": "struct Point *", "Kind": "array", "ElementType": "DT_Point",
}  # fmt: skip


COLOURS = {
    "typeRef": "DT_Colour", "category": "userdefined", "cDef": "uint8_t", "Kind": "enumeration",
    "Symbols": [{"Symbol": "RED", "Value": 0}, {"Symbol": "GREEN", "Value": 7}],
}  # fmt: skip


METHOD = {
    "Name": "SetSpeed", "Description": "Sets <it> & more.", "Role": "Provider",
    "InDataTypeList": [{"Name": "v", "Datatype": "DT_Float32", "Units": "km/h"}],
    "OutDataTypeList": [{"Name": "done", "Datatype": "DT_Bool", "Units": ""}],
}  # fmt: skip


def every_kind():
    """A function with every kind of datatype and element."""
    return function(
        "Demo",
        [
            signal("Points", "Provider", Datatype="DT_Points", VssPath="Vehicle.A.Points", VssDatatype="Types.Point[]"),
            signal("Colour", Datatype="DT_Colour", VssPath="Vehicle.A.Colour", VssDatatype="string"),
            signal("Text", Datatype="DT_String", VssPath="Vehicle.A.Text", VssDatatype="string"),
            signal("Scaled", Factor="0.01", Offset="-40", Units="celsius"),
            at("Vehicle.B.Speed"),
        ],
        [POINT, POINTS, COLOURS],
        contract={"MethodList": [METHOD]},
    )


@cache
def made(name, release="R23-11"):
    functions = examples() if name == "examples" else (every_kind(),)
    protected = {"profile": 4, "events": {"DemoService": {"profile": 5, "maxDeltaCounter": 3}}}
    deployment = DEFAULT_DEPLOYMENT if name == "examples" else deployed(autosarAdaptive={"e2e": protected})
    return generate(derive(functions, deployment).model, release)


def tags(files):
    return [element for file in files for element in ET.fromstring(file.data).iter()]


def texts(files, tag):
    return [element.text for element in tags(files) if element.tag.endswith(f"}}{tag}")]


def lost(written, files, elsewhere):
    """Values of a document that its files do not have, but for fields whose values are other words there."""
    texts = html.unescape(b"".join(file.data for file in files).decode())
    return [text for text in _leaves(json.loads(written), elsewhere) if text not in texts]


def _leaves(value, elsewhere):
    if isinstance(value, dict):
        return [text for key, inner in value.items() if key not in elsewhere for text in _leaves(inner, elsewhere)]
    if isinstance(value, list):
        return [text for inner in value for text in _leaves(inner, elsewhere)]
    return [str(value).lower() if isinstance(value, bool) else str(value)] if value not in (None, "") else []


def document(**changes):
    base = json.loads(written(derive([function(signals=[at("Vehicle.A.B")])]).model))
    return {**base, **changes}


def refused(value):
    with pytest.raises(InputRefused) as caught:
        read_integration(json.dumps(value, indent=1).encode(), "integration.json")
    return caught.value.findings
