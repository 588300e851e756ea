"""Exchange of a set of functions."""

from sigcat.function.exchange import Element, Exchange, exchange_of, parts_of
from tests.integration.autosar_adaptive.sets import at, function, signal

SPEED = "Vehicle.Speed"


def error(name, *causes):
    """An error interface, set by others."""
    return {
        "Name": name, "Description": "An error.", "Datatype": "DT_Bool", "Dependancy": list(causes),
        "OccurenceCountLimit": 0, "IgnitionCountLimit": 0, "MaturationTime": 0, "Severity": "Warning",
    }  # fmt: skip


def exchange(*functions, **options) -> Exchange:
    return exchange_of(parts_of(functions), **options)


def data(found: Exchange, identity: str) -> Element:
    return found.elements["data", identity]


def providers(element: Element) -> list[str]:
    return [side.part.name for side in element.providers]


def test_an_element_has_every_side_of_a_signal() -> None:
    found = exchange(function("Taker", [at(SPEED)]), function("Giver", [at(SPEED, "Provider")]))
    element = data(found, SPEED)
    assert [side.function for side in element.sides] == ["Taker", "Giver"]
    assert element.leading.function == "Giver"


def test_a_signal_from_outside_has_no_provider_and_is_led_by_its_first_consumer() -> None:
    element = data(exchange(function("One", [at(SPEED)]), function("Two", [at(SPEED)])), SPEED)
    assert (element.provider, element.leading.function) == (None, "One")


def test_a_component_that_provides_at_two_calls_is_one_provider() -> None:
    twice = function("One", [at(SPEED, "Provider"), at(SPEED, "Provider")])
    assert providers(data(exchange(twice, function("Two", [at(SPEED, "Provider")])), SPEED)) == ["One", "Two"]


def test_the_first_provider_is_that_of_the_first_function_whichever_repeats() -> None:
    one, two = function("One", [at(SPEED, "Provider")]), function("Two", [at(SPEED, "Provider")])
    again = function("Three", [at(SPEED, "Provider")])
    assert providers(data(exchange(one, two, again), SPEED)) == ["One", "Two", "Three"]


def test_a_path_of_the_deployment_joins_a_signal_that_names_none() -> None:
    found = exchange(function("One", [signal("S")]), function("Two", [at(SPEED)]), paths={"One.S": SPEED})
    assert [side.function for side in data(found, SPEED).sides] == ["One", "Two"]


def test_signals_without_a_path_are_joined_by_name_or_belong_to_their_functions() -> None:
    one, two = function("One", [signal("S")]), function("Two", [signal("S")])
    assert [key for _, key in exchange(one, two).elements] == ["S"]
    assert [key for _, key in exchange(one, two, joins_names=False).elements] == ["One.S", "Two.S"]


def test_a_component_consumes_the_errors_of_others_that_set_its_own() -> None:
    one = function("One", contract={"ErrorList": [error("One_E_ErrorSts")]})
    two = function("Two", contract={"ErrorList": [error("Two_E_ErrorSts", "One_E_ErrorSts", "Hmi_E_ErrorSts")]})
    found = exchange(one, two)
    known, unknown = found.elements["error", "One_E_ErrorSts"], found.elements["error", "Hmi_E_ErrorSts"]
    assert [(side.function, side.provides) for side in known.sides] == [("One", True), ("Two", False)]
    assert (known.is_reported, unknown.is_reported) == (True, False)


def test_the_pointer_of_a_side_leads_to_its_interface() -> None:
    (side,) = exchange(function("One", [at(SPEED)])).sides
    assert side.pointer == ("ComponentList", 0, "functionList", 0, "funcContractList", 0, "SignalList", 0)
