"""A signal of a bus carries values from or to outside the set, and every value of them; else the deployment has a finding at its line."""

import pytest

from sigcat.platforms.deployment_file import read_deployment
from tests.integration.autosar_adaptive.sets import at, function
from tests.integration.autosar_classic.classic import derive

PATH = "Vehicle.Demo.Level"
C_OF = {"boolean": "bool", "float": "float", "double": "double"}


def found(signals, *functions):
    """Findings about the signals of a deployment file: rule, line, message, fix. Each signal has a separate line, from 3 on."""
    lines = "".join(f"    {key}: {value}\n" for key, value in signals.items())
    text = f"autosarClassic:\n  signals:\n{lines}"
    derived = derive(functions, read_deployment(text.encode(), "deployment.yaml"))
    own = [each for each in derived.findings if each.rule in ("K007", "K013")]
    assert {each.file for each in own} <= {"deployment.yaml"}
    return [(each.rule, each.line, each.message, each.fix) for each in own]


def level(datatype, role="Consumer", **more):
    """A signal of a datatype of the catalogue, which the code has too."""
    return {
        **at(PATH, role), "Datatype": f"DT_{datatype}", "VssDatatype": datatype, "Units": "", "VssUnit": "",
        "Min": None, "Max": None, "InitValue": None, **more,
    }  # fmt: skip


def of_level(datatype, name="Demo", role="Consumer", **more):
    """A function with that signal."""
    primitive = {"typeRef": f"DT_{datatype}", "category": "primitive", "cDef": C_OF.get(datatype, f"{datatype}_t")}
    return function(name, [level(datatype, role, **more)], [primitive])


NEEDED = {
    "a boolean": ("boolean", {}, 1),
    "all of a datatype": ("uint16", {}, 16),
    "the values of a range": ("uint16", {"VssMin": 0, "VssMax": 1000}, 10),
    "the number beyond a power of two": ("uint8", {"VssMin": 0, "VssMax": 128}, 8),
    "a sign": ("int16", {"VssMin": -128, "VssMax": 127}, 8),
    "a sign of one value more": ("int16", {"VssMin": -129, "VssMax": 127}, 9),
    "a float": ("float", {"VssMin": 0, "VssMax": 1}, 32),
    "a double": ("double", {}, 64),
}


@pytest.mark.parametrize(("datatype", "limits", "bits"), NEEDED.values(), ids=NEEDED)
def test_a_signal_has_room_for(datatype, limits, bits):
    told = of_level(datatype, **limits)
    assert found({PATH: f"{{signal: Level, length: {bits}}}"}, told) == []
    if bits > 1:
        ((rule, line, message, _),) = found({PATH: f"{{signal: Level, length: {bits - 1}}}"}, told)
        assert (rule, line) == ("K013", 3)
        assert f"at least {bits} bits" in message


def test_a_float_is_shorter_where_a_database_scales_it():
    ((*_, fix),) = found({PATH: "{signal: Level, length: 16}"}, of_level("double"))
    assert "`database`" in fix
    assert found({PATH: "{signal: Level, length: 16, database: can.dbc}"}, of_level("double")) == []
    assert found({PATH: "{signal: Level, length: 8, database: can.dbc}"}, of_level("uint16")) != []


def test_what_is_proposed_is_accepted():
    misspelled = {"Vehicle.Demo.Levle": "{signal: Level}"}
    ((rule, line, _, fix),) = found(misspelled, of_level("uint8"))
    assert (rule, line) == ("K007", 3)
    assert PATH in fix
    assert found({PATH: "{signal: Level}"}, of_level("uint8")) == []


def test_what_stays_within_the_set_is_not_proposed():
    functions = of_level("uint8", "Giver", "Provider"), of_level("uint8", "Taker")
    for key in ("Vehicle.Demo.Levle", PATH):
        ((rule, line, _, fix),) = found({key: "{signal: Level}"}, *functions)
        assert (rule, line, fix) == ("K007", 3, "Take it away.")
