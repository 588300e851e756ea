"""The mapping of a signal to one of a network, read from the attributes of its node.

Two are in use. VSS's network serialization profile (`network_serialization`) says by what name, when and how a signal is
serialized. The KUKSA CAN provider's `dbc2vss` (`dbc` is an older name of it) says how a signal comes from CAN, `vss2dbc`
how the target of an actuator goes there.
"""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from sigcat.catalogue.network.mapping_attributes import ATTRIBUTES, KUKSA, KUKSA_ALIAS, KUKSA_TARGET, PROFILE
from sigcat.findings import shown
from sigcat.names import did_you_mean

if TYPE_CHECKING:
    from sigcat.catalogue.network.formula import Formula

_MILLISECOND = 1_000_000
_DEFAULT_INTERVAL = 1000
"""Milliseconds between two updates that the KUKSA CAN provider keeps if nothing is said."""
_LISTS: Mapping[str, tuple[str, str, str]] = {
    PROFILE: ("representation", "value", "text"),
    KUKSA: ("mapping", "from", "to"),
    KUKSA_ALIAS: ("mapping", "from", "to"),
    KUKSA_TARGET: ("mapping", "from", "to"),
}
"""The list of values of each attribute, and the keys of its items."""


class Choice(NamedTuple):
    """A value of the one side, with that of the other."""

    given: Any
    """In the mapping of KUKSA `from`, in the profile `value`: a number of the network."""
    meant: Any
    """`to`, or `text`."""
    steps: tuple[int | str, ...]
    """Path of the place, from the attribute on."""


class SignalMapping(NamedTuple):
    """Content of one mapping attribute of a signal."""

    attribute: str
    signal: str
    message: str | None
    """The message that has the signal, where it is said."""
    interval: int
    """The shortest time between two updates, in ns."""
    on_change: bool
    formula: "Formula | None"
    choices: tuple[Choice, ...]
    markers: frozenset[Any] = frozenset()
    """Transmitted numbers that are not a value, where a database says which ones are."""

    @property
    def is_profile(self) -> bool:
        """Whether VSS's profile decides what is sent when, and not the KUKSA CAN provider."""
        return self.attribute == PROFILE


class Fault(NamedTuple):
    """Yield the problems of a transform, with the steps from the attribute to each."""

    message: str
    steps: tuple[int | str, ...]
    fix: str = ""


def mappings_of(values: Mapping[str, Any], attributes: tuple[str, ...] = ATTRIBUTES) -> Iterator[SignalMapping]:
    """The mappings of a node, from its attributes; what is not as it must be is left out."""
    for attribute in attributes:
        found = mapping_of(attribute, values.get(attribute))
        if found is not None:
            yield found


def mapping_of(attribute: str, given: Any) -> SignalMapping | None:
    """Return the mapping of an attribute; None if it names no signal, or a transform of it cannot be used."""
    if not isinstance(given, dict) or not isinstance(given.get("signal"), str) or not given["signal"]:
        return None
    if next(faults_of_transform(attribute, given), None) is not None:
        return None
    message, transform = given.get("message"), given.get("transform") or {}
    interval, on_change = _timing(attribute, given)
    return SignalMapping(
        attribute, given["signal"], message if isinstance(message, str) else None, interval, on_change,
        _formula(transform.get("math")), tuple(_choices(attribute, transform)),
    )  # fmt: skip


def _formula(text: str | None) -> "Formula | None":
    if text is None:
        return None
    from sigcat.catalogue.network.formula import read_formula  # few trees have one, and every lint loads this module

    return read_formula(text)


def _timing(attribute: str, given: Mapping[str, Any]) -> tuple[int, bool]:
    """The interval in ns, and whether only changes count."""
    interval, on_change = given.get("interval_ms"), given.get("on_change")
    is_interval = isinstance(interval, int) and not isinstance(interval, bool)
    if attribute == PROFILE:
        is_on_change = on_change if isinstance(on_change, bool) else not is_interval
        return _in_ns(interval) if is_interval else 0, is_on_change
    default = 0 if on_change is True or attribute == KUKSA_TARGET else _DEFAULT_INTERVAL
    return _in_ns(interval if is_interval else default), on_change is True


def _in_ns(milliseconds: Any) -> int:
    return max(0, int(milliseconds)) * _MILLISECOND


def _choices(attribute: str, transform: Mapping[str, Any]) -> Iterator[Choice]:
    name, given, meant = _LISTS[attribute]
    for index, item in enumerate(transform.get(name) or ()):
        yield Choice(item[given], item[meant], ("transform", name, index))


# -- faults -------------------------------------------------------------------------------------------------------


def faults_of_transform(attribute: str, given: Mapping[str, Any]) -> Iterator[Fault]:
    """Yield the problems of a mapping's transform, beyond the kinds of its fields."""
    transform = given.get("transform")
    if transform is None:
        return
    name, *_ = _LISTS[attribute]
    if not isinstance(transform, dict):
        yield Fault(f"`transform` must be a mapping, not {shown(transform)}.", ("transform",))
        return
    has_list = transform.get(name) is not None
    if not has_list and transform.get("math") is None:
        other = next((key for key in transform if key not in ("math", name)), "")
        fix = did_you_mean(str(other), ("math", name)) if other else ""
        yield Fault(f"`transform` must have `math` or `{name}`.", ("transform",), fix)
    if has_list and transform.get("math") is not None and attribute != PROFILE:
        yield Fault(f"`transform` must have `math` or `{name}`, not both.", ("transform", name), "Remove one of them.")
    if transform.get("math") is not None:
        yield from _faults_of_formula(transform["math"])
    if has_list:
        yield from _faults_of_list(attribute, transform[name])


def _faults_of_formula(text: Any) -> Iterator[Fault]:
    steps = ("transform", "math")
    if not isinstance(text, str):
        yield Fault(f"`math` must be a formula in quotes, not {shown(text)}.", steps)
        return
    from sigcat.catalogue.network.formula import BadFormula, read_formula

    try:
        read_formula(text)
    except BadFormula as error:
        yield Fault(f"`math` must be a formula of x: {error}, at character {error.at + 1}.", steps, error.fix)


def _faults_of_list(attribute: str, given: Any) -> Iterator[Fault]:
    name, *keys = _LISTS[attribute]
    if not isinstance(given, list) or not given:
        yield Fault(f"`{name}` must be a list of `{keys[0]}` and `{keys[1]}`, not {shown(given)}.", ("transform", name))
        return
    for index, item in enumerate(given):
        steps = ("transform", name, index)
        missing = [key for key in keys if not isinstance(item, dict) or item.get(key) is None]
        if missing:
            yield Fault(f"Each item of `{name}` must have `{keys[0]}` and `{keys[1]}`, not {shown(item)}.", steps)
        elif any(isinstance(item[key], dict | list) for key in keys):
            yield Fault(f"`{keys[0]}` and `{keys[1]}` must be single values.", steps)


def doubts_of_transform(attribute: str, given: Mapping[str, Any]) -> Iterator[Fault]:
    """Yield the unused parts of a valid transform: the second of two items for one value, and unknown fields."""
    name, key, meant = _LISTS[attribute]
    seen: list[Any] = []
    for index, item in enumerate((given.get("transform") or {}).get(name) or ()):
        same = (item[key], item[meant]) if attribute == PROFILE else item[key]
        steps = ("transform", name, index)
        if (isinstance(same, str), same) in seen:  # 1, 1.0 and true are one number of the network
            yield Fault(f"{shown(item[key])} must be in `{name}` only once.", (*steps, key), "The first one counts.")
        seen.append((isinstance(same, str), same))
        for extra in item.keys() - {key, meant}:
            yield Fault(
                f"Unknown field {str(extra)!r} in `{name}`.", (*steps, str(extra)),
                did_you_mean(str(extra), (key, meant)) or "Remove it.",
            )  # fmt: skip
