"""Providers and consumers in a set of functions."""

from typing import Any

import pytest

from sigcat.function.function_json.model import FunctionJson
from sigcat.function.sets.wiring import connect


def function(name: str, *signals: dict[str, Any], cycle: int = 10, reactions: tuple[str, ...] = ()) -> FunctionJson:
    """A function of one call with these signals."""
    listed = [
        {"Name": "S", "Description": "A signal.", "Datatype": "DT_Float32", "VssDatatype": "float", **signal}
        for signal in signals
    ]
    told = [
        {"Name": "R_SftyCondSts", "Description": "A condition.", "Datatype": "DT_Bool", "ErrorList": list(reactions)}
    ]
    contract = {
        "SignalList": listed, "DataQList": None, "MethodList": None, "ParameterList": None, "ErrorList": None,
        "SafetyReactionList": told if reactions else None,
    }  # fmt: skip
    call = {
        "Name": f"{name}_Step", "Description": "Step.", "Runtype": "Cyclic", "Cycletime": cycle, "Watchdog": None,
        "Scheduling": "Preemptive", "Priority": "1", "funcContractList": [contract],
    }  # fmt: skip
    info = {"FunctionName": name, "FunctionResponsible": "Team", "Description": "A function."}
    component = {"Name": name, "functionList": [call]}
    return FunctionJson.model_validate(
        {"MetaInfo": {}, "FunctionInfo": info, "ComponentList": [component], "ModesList": None, "Datatypes": []}
    )


def gives(path: str = "Vehicle.A", **more: Any) -> dict[str, Any]:
    return {"VssPath": path, "Role": "Provider", **more}


def takes(path: str = "Vehicle.A", **more: Any) -> dict[str, Any]:
    return {"VssPath": path, "Role": "Consumer", **more}


def messages(given: dict[str, Any], taken: dict[str, Any], cycle: int = 10) -> tuple[str, ...]:
    (link,) = connect([function("One", given, cycle=cycle), function("Two", taken)]).links
    return tuple(mismatch.message for mismatch in link.mismatches)


def test_what_one_provides_and_another_consumes_is_a_link() -> None:
    wiring = connect([function("One", gives(), takes("Vehicle.In")), function("Two", takes(), gives("Vehicle.Out"))])
    assert [(link.path, link.provider.function, link.consumer.function) for link in wiring.links] == [
        ("Vehicle.A", "One", "Two")
    ]
    assert [end.path for end in wiring.from_outside] == ["Vehicle.In"]
    assert [end.path for end in wiring.to_outside] == ["Vehicle.Out"]


def test_a_signal_that_a_function_gives_itself_is_no_link() -> None:
    wiring = connect([function("One", gives(), takes())])
    assert (wiring.links, wiring.from_outside, wiring.to_outside) == ((), (), ())


def test_two_providers_of_one_signal_are_rivals() -> None:
    (rivals,) = connect([function("One", gives()), function("Two", gives())]).rivals
    assert (rivals.path, rivals.functions) == ("Vehicle.A", ("One", "Two"))


def test_each_of_several_providers_has_a_link_and_each_consumer_one_provider() -> None:
    wiring = connect([function("A", gives()), function("B", gives()), function("C", takes()), function("D", takes())])
    assert [(link.provider.function, link.consumer.function) for link in wiring.links] == [
        ("A", "C"), ("A", "D"), ("B", "C"),
    ]  # fmt: skip


def test_links_do_not_multiply() -> None:
    both = [gives(), takes()] * 50
    assert len(connect([function(f"F{i}", *both) for i in range(100)]).links) < 100 * 100


def test_an_error_that_nobody_in_the_set_reports_is_told() -> None:
    wiring = connect([function("One", gives(), reactions=("Other_X_ErrorSts",))])
    assert wiring.unreported == (("One", "R_SftyCondSts", "Other_X_ErrorSts"),)


@pytest.mark.parametrize(
    ("given", "taken", "expected"),
    [
        ({"AsilLevel": "QM"}, {"AsilLevel": "B"}, "at ASIL B, as Two needs it, not at QM"),
        ({"VssUnit": "km/h"}, {"VssUnit": "m/s"}, "must be km/h, as One provides it, not m/s"),
        ({"VssDatatype": "uint8"}, {}, "must be uint8, as One provides it, not float"),
        ({"Min": -5, "Max": 5}, {"Min": 0, "Max": 5}, "down to -5, as One provides it, not only to 0"),
        ({"Min": 0, "Max": 100}, {"Min": 0, "Max": 50}, "up to 100, as One provides it, not only to 50"),
    ],
)
def test_what_does_not_fit_is_a_mismatch(given: dict[str, Any], taken: dict[str, Any], expected: str) -> None:
    (message,) = messages(gives(**given), takes(**taken))
    assert expected in message


def test_ranges_are_compared_in_the_unit_of_the_catalogue() -> None:
    assert messages(gives(Max=100), takes(Max=27.7777778, ConversionFactor="3.6", ConversionOffset="0")) == ()


def test_a_signal_that_comes_later_than_its_consumer_waits_does_not_fit() -> None:
    (message,) = messages(gives(), takes(Timeout="200"), cycle=500)
    assert "at least 500 ms" in message
    assert messages(gives(), takes(Timeout="1500"), cycle=500) == ()
