"""Start values that are not numbers: carried, or reported."""

import json

import pytest

from sigcat.function.document.text import Text
from sigcat.function.function_file import build_function
from sigcat.function.function_json.interfaces.data_interfaces import ParameterInterface, Signal
from sigcat.function.function_json.model import FunctionJson
from sigcat.platforms.integrate import integrate
from sigcat.platforms.table import PLATFORMS
from tests.function.shipped import interfaces, resolved

ARRAY = "Vehicle.ADAS.EcoControl.Gains"


def built(uses: str, define: str = "") -> tuple[FunctionJson, list[tuple[str, str]]]:
    text = (
        "function: CoreAcc\ndescription: Cruise control.\nresponsible: Cruise control team\n"
        f"define: {{data: {{{define}}}}}\n"
        f"components: [{{name: CoreAcc, runnables: [CoreAcc_Init, {{interface: CoreAcc_Step, errors: [CoreAcc_AliveError_ErrorSts], {uses}}}, CoreAcc_Terminate]}}]\n"
    )
    function, findings = build_function(text.encode(), "f.yaml", interfaces())
    return function, [(finding.rule, finding.pointer) for finding in findings if finding.rule == "F017"]


ARTIST = "Vehicle.Cabin.Infotainment.Media.Played.Artist"
AT = "/components/0/runnables/1/data/0"


@pytest.mark.parametrize(
    ("data", "define", "told"),
    [
        (f"{{path: {ARTIST}, role: consumed, init: nobody}}", "", [("F017", f"{AT}/init")]),
        (f"{{path: {ARTIST}, role: consumed}}", "", []),
        ("{path: Vehicle.Speed, role: consumed, init: 3}", "", []),
        (
            f"{{path: {ARRAY}, role: consumed, provider: Car}}",
            f"{ARRAY}: {{type: sensor, datatype: 'float[]', arraysize: 2, default: [1.0, 2.5], description: Gains.}}",
            [],
        ),
    ],
)
def test_what_a_signal_cannot_start_from_is_told(data: str, define: str, told: list[tuple[str, str]]) -> None:
    assert built(f"data: [{data}]", define)[1] == told


def test_the_elements_of_a_parameter_go_all_the_way() -> None:
    define = f"{ARRAY}: {{type: attribute, datatype: 'float[]', arraysize: 2, unit: km/h, default: [36, 72], description: Gains.}}"
    function, told = built(f"parameters: [{{path: {ARRAY}, unit: m/s, variable: par.gains}}]", define)
    assert told == []
    contracts = [contract for call in function.components[0].runnables for contract in call.contracts or ()]
    (parameter,) = [parameter for contract in contracts for parameter in contract.parameters or ()]
    assert parameter.default_text == Text("[10, 20]")
    adaptive = json.loads(integrate(PLATFORMS["autosar-adaptive"], [resolved(function)]).document)
    assert '"Default": "[10, 20]"' in json.dumps(adaptive)
    ros = integrate(PLATFORMS["ros2"], [resolved(function)]).document.decode()
    assert "36.0" in ros
    assert "72.0" in ros


@pytest.mark.parametrize(
    "item",
    [
        f"parameters: [{{path: {ARRAY}, init: 5, variable: gains}}]",
        f"data: [{{path: {ARRAY}, role: consumed, init: 5, variable: gains, provider: Car}}]",
    ],
)
def test_one_start_value_for_all_elements_is_seen_beside_a_default(item: str) -> None:
    define = f"{ARRAY}: {{type: attribute, datatype: 'float[]', arraysize: 2, default: [36, 72], description: Gains.}}"
    function, told = built(item, define)
    assert told == []
    contracts = [contract for call in function.components[0].runnables for contract in call.contracts or ()]
    items: list[ParameterInterface | Signal] = []
    for contract in contracts:
        items += [*(contract.parameters or ()), *(contract.signals or ())]
    assert [each.init_elements for each in items] == [Text("[5, 5]")]
