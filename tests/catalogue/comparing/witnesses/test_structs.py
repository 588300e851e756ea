"""Structs: what is sent as a whole breaks with any member; what names or numbers members does not."""

import pytest

from sigcat.catalogue.comparing.bindings import form_of
from sigcat.catalogue.comparing.changes import worst
from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.layers import layer_from_text
from tests.catalogue.comparing.witnesses.tools import EACH_BINDING, VERDICTS, exported
from tests.catalogue.trees import ROOT

SIGNAL = ROOT + "Vehicle.Place:\n  type: sensor\n  datatype: Types.Place\n  description: Where it is.\n"
STRUCT = "Types:\n  type: branch\n  description: D.\nTypes.Place:\n  type: struct\n  description: D.\n"
CHANGES = {
    "a property at the end": {"X": "float", "Y": "float", "Z": "float"},
    "a property in the middle": {"X": "float", "Z": "float", "Y": "float"},
    "a removed property": {"X": "float"},
    "another order": {"Y": "float", "X": "float"},
    "another datatype": {"X": "float", "Y": "double"},
}

OPTIONS = {"json": {"types-output": "types"}}
"""Without it, the JSON has no structs."""


def catalogue(**properties: str) -> Catalogue:
    fields = "".join(
        f"Types.Place.{name}:\n  type: property\n  datatype: {datatype}\n  description: D.\n"
        for name, datatype in properties.items()
    )
    layers = [layer_from_text(text.encode(), "text", is_overlay=False) for text in (SIGNAL, STRUCT + fields)]
    return compose(layers[:1], types=layers[1:])


@pytest.mark.parametrize("name", CHANGES)
@pytest.mark.parametrize("binding", EACH_BINDING)
def test_a_struct_breaks_as_the_table_says(binding, name, tmp_path):
    format_name, breaks = VERDICTS[binding]
    old, new = catalogue(X="float", Y="float"), catalogue(**CHANGES[name])
    predicted = worst(form_of(change, binding) for change in compare(old, new))
    before, after = (exported(each, format_name, **OPTIONS.get(format_name, {})) for each in (old, new))
    assert predicted == "risky" or (predicted == "breaking") is breaks(before, after, tmp_path)
