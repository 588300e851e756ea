"""Checks of mappings to a network: whether what they convert to fits the signal, and what they name is in the CAN database."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from sigcat.catalogue.model.datatypes import INTEGER_RANGES, PRIMITIVES, is_array
from sigcat.catalogue.model.definition import Definition
from sigcat.catalogue.model.vocabulary import Unit, Vocabulary
from sigcat.catalogue.network.mapping import SignalMapping, doubts_of_transform, faults_of_transform, mapping_of
from sigcat.catalogue.network.mapping_attributes import ATTRIBUTES, KUKSA_TARGET, RECEIVED
from sigcat.catalogue.network.markers import means_no_value
from sigcat.catalogue.network.network_values import Unfit, in_datatype
from sigcat.findings import shown
from sigcat.names import did_you_mean, nearest
from sigcat.rules.checks.kind import NodeTest, TreeTest, is_bound, is_number, listed
from sigcat.rules.problem import Problem
from sigcat.rules.record import Rule
from sigcat.rules.tree import Tree

if TYPE_CHECKING:
    from sigcat.catalogue.network.can_database import CanSignal

_SAMPLES = 64
"""Numbers between the limits of a network's signal at which a formula is looked at."""


def _mappings(definition: Definition) -> Iterator[SignalMapping]:
    for attribute in ATTRIBUTES:
        found = mapping_of(attribute, definition.values.get(attribute))
        if found is not None:
            yield found


# -- the mapping alone --------------------------------------------------------------------------------------------


def transform(_rule: Rule, _tree: Tree) -> NodeTest:
    """A transform has a formula, or a list of pairs of values."""

    def test(definition: Definition) -> Iterator[Problem]:
        for attribute in ATTRIBUTES:
            given = definition.values.get(attribute)
            for fault in faults_of_transform(attribute, given) if isinstance(given, dict) else ():
                yield Problem(definition, fault.message, attribute, fault.fix, within=fault.steps)

    return test


def listed_once(_rule: Rule, _tree: Tree) -> NodeTest:
    """A transform lists each value once, and knows the fields of its items."""

    def test(definition: Definition) -> Iterator[Problem]:
        for each in _mappings(definition):
            for doubt in doubts_of_transform(each.attribute, definition.values[each.attribute]):
                yield Problem(definition, doubt.message, each.attribute, doubt.fix, within=doubt.steps)

    return test


def values_fit(_rule: Rule, _tree: Tree) -> NodeTest:
    """Require that listed values and a default are values of the signal: of its datatype, allowed, and within its range."""

    def test(definition: Definition) -> Iterator[Problem]:
        values = definition.values
        datatype = str(values.get("datatype", ""))
        for each in _mappings(definition):
            if datatype not in PRIMITIVES:
                kind = "an array" if is_array(datatype) else "a struct"
                message = f"{kind.capitalize()} cannot be mapped: a signal of a network is one value."
                yield Problem(definition, message, each.attribute, "Map single signals.", at_name=True)
                continue
            for value, steps in _own_values(each, datatype, values):
                why = _misfit(value, datatype, values)
                if why:
                    message = f"{shown(value)} is not a value of the signal: {why}."
                    yield Problem(definition, message, each.attribute, within=steps)

    return test


def _own_values(
    mapping: SignalMapping, datatype: str, values: Mapping[str, Any]
) -> Iterator[tuple[Any, tuple[int | str, ...]]]:
    """Values of a mapping that are of the signal, not of the network, and where they stand."""
    default = values[mapping.attribute].get("default")
    if default is not None and not isinstance(default, dict | list):
        yield default, ("default",)
    for choice in mapping.choices:
        if mapping.attribute == KUKSA_TARGET:
            yield choice.given, (*choice.steps, "from")
        elif not mapping.is_profile:
            yield choice.meant, (*choice.steps, "to")
        elif datatype == "string":
            yield choice.meant, (*choice.steps, "text")
        elif mapping.formula is None and not isinstance(choice.given, str):
            yield choice.given, (*choice.steps, "value")


def _misfit(value: Any, datatype: str, values: Mapping[str, Any]) -> str:
    """Why a value is none of a signal; empty if it is one."""
    try:
        fitted = in_datatype(value, datatype)
    except Unfit:
        return f"its datatype is {datatype}"
    if datatype in INTEGER_RANGES and fitted != value:
        return f"its datatype is {datatype}"
    allowed, low, high = values.get("allowed"), values.get("min"), values.get("max")
    if isinstance(allowed, list) and allowed and fitted not in allowed:
        return f"`allowed` has no such value. {did_you_mean(str(fitted), map(str, allowed))}".rstrip(". ")
    if is_number(fitted) and is_bound(low) and fitted < low:  # type: ignore[operator]  # it is a number
        return f"`min` is {low}"
    if is_number(fitted) and is_bound(high) and fitted > high:  # type: ignore[operator]  # it is a number
        return f"`max` is {high}"
    return ""


def sent_once(_rule: Rule, tree: Tree) -> TreeTest:
    """Require that only one of several signals or instances is sent as a signal of the network."""

    def test() -> Iterator[Problem]:
        first: dict[tuple[str, str | None], str] = {}
        instances = Counter(id(definition) for definition in tree.expanded.values())
        for definition in tree.definitions.values():
            sent = mapping_of(KUKSA_TARGET, definition.values.get(KUKSA_TARGET))
            if sent is None:
                continue
            other = first.setdefault((sent.signal, sent.message), definition.path)
            if other != definition.path:
                message = f"{other!r} is sent as {sent.signal} too."
                yield Problem(definition, message, KUKSA_TARGET, "Send one of the two.", within=("signal",))
            if (count := instances[id(definition)]) > 1:
                message = f"{count} instances are sent as {sent.signal}."
                yield Problem(
                    definition, message, KUKSA_TARGET, "Give each instance its own signal.", within=("signal",)
                )

    return test


# -- the mapping and the database ---------------------------------------------------------------------------------


def in_database(_rule: Rule, tree: Tree) -> NodeTest:
    """The signal that a mapping names is in the CAN database, and in the message that it names."""
    database = tree.can

    def test(definition: Definition) -> Iterator[Problem]:
        for each in _mappings(definition) if database is not None else ():
            assert database is not None
            known = database.signals.get(each.signal, ())
            if not known:
                message = f"The CAN database has no signal {shown(each.signal)}."
                fix = did_you_mean(each.signal, database.signals)
                yield Problem(definition, message, each.attribute, fix, within=("signal",))
            elif each.message is not None and each.message not in {signal.message for signal in known}:
                messages = [signal.message for signal in known]
                is_near = bool(nearest(each.message, messages, limit=1))
                fix = did_you_mean(each.message, messages) if is_near else f"It is in {listed(messages)}."
                message = f"The message {shown(each.message)} has no signal {shown(each.signal)}."
                yield Problem(definition, message, each.attribute, fix, within=("message",))

    return test


def unambiguous(_rule: Rule, tree: Tree) -> NodeTest:
    """A mapping without a message names a signal that one message has."""

    def test(definition: Definition) -> Iterator[Problem]:
        for each in _mappings(definition):
            known = _in_database(each, tree)
            if len(known) > 1:
                names = listed([signal.message for signal in known])
                what = (
                    "Values of all of them are received" if each.attribute in RECEIVED else "It is sent in all of them"
                )
                message = f"{len(known)} messages have a signal {each.signal}: {names}. {what}."
                yield Problem(definition, message, each.attribute, "Name the `message`.", within=("signal",))

    return test


def names_in_database(_rule: Rule, tree: Tree) -> NodeTest:
    """A list names values of the network as the CAN database names them."""

    def test(definition: Definition) -> Iterator[Problem]:
        for each in _mappings(definition):
            known = {name for signal in _in_database(each, tree) for name in signal.names.values()}
            if not known and not _in_database(each, tree):
                continue
            for name, steps in _network_names(each):
                if name not in known:
                    message = f"{each.signal} has no value {shown(name)} in the CAN database."
                    fix = did_you_mean(name, known) if known else "It names none: write numbers."
                    yield Problem(definition, message, each.attribute, fix, within=steps)

    return test


def _network_names(mapping: SignalMapping) -> Iterator[tuple[str, tuple[int | str, ...]]]:
    """Names of values of the network in a list. A text of the profile may be one of the signal, too: it is not checked."""
    for choice in mapping.choices:
        name, key = (choice.meant, "to") if mapping.attribute == KUKSA_TARGET else (choice.given, "from")
        if isinstance(name, str) and not mapping.is_profile:
            yield name, (*choice.steps, key)


def no_value_handled(_rule: Rule, tree: Tree) -> NodeTest:
    """A name of the database for «no value», such as `SNA`, does not become a number of the signal."""

    def test(definition: Definition) -> Iterator[Problem]:
        datatype = str(definition.values.get("datatype", ""))
        for each in _mappings(definition):
            if each.attribute not in RECEIVED or datatype == "string" or each.choices or each.formula is not None:
                continue  # a list has all values that are received, and a formula gets no number with a name
            for signal in _in_database(each, tree):
                for number, name in signal.names.items():
                    if number not in signal.excluded and means_no_value(name):
                        message = f"{signal.name} is {number} for {shown(name)}, which is received as a number."
                        fix = "Add a list of values, or state limits in the CAN database that exclude it."
                        yield Problem(definition, message, each.attribute, fix, within=("signal",))

    return test


def unit_converted(_rule: Rule, tree: Tree) -> NodeTest:
    """Require a transform where the unit of the CAN database is known, and not that of the signal."""

    def test(definition: Definition) -> Iterator[Problem]:
        unit = _unit(definition.values.get("unit"), tree.vocabulary)
        for each in _mappings(definition) if unit is not None else ():
            units = {_unit(signal.unit, tree.vocabulary) for signal in _in_database(each, tree)}
            if each.formula is None and not each.choices and units.isdisjoint((unit, None)) and units:
                said = listed(sorted(other.key for other in units if other is not None))
                assert unit is not None
                message = f"{each.signal} is in {said} in the CAN database, and the signal in {unit.key}."
                yield Problem(definition, message, each.attribute, "Convert it with `transform`.", within=("signal",))

    return test


def _unit(text: Any, vocabulary: Vocabulary) -> Unit | None:
    """The unit of a text, if the catalogue knows it."""
    if not isinstance(text, str) or not text:
        return None
    from sigcat.catalogue.model.near_units import near_unit  # its tables take time at start-up

    return vocabulary.unit(text) or near_unit(text, vocabulary)


def range_fits(_rule: Rule, tree: Tree) -> NodeTest:
    """Require that every value of the network signal, converted, fits the datatype and the range of the signal."""

    def test(definition: Definition) -> Iterator[Problem]:
        datatype = str(definition.values.get("datatype", ""))
        for each in _mappings(definition):
            signals = _in_database(each, tree)
            if not signals or datatype not in PRIMITIVES:
                continue
            misfit = _range_misfit if each.attribute in RECEIVED else _sent_misfit
            why = misfit(each, signals, definition.values, datatype)
            if why:
                yield Problem(definition, why, each.attribute, within=("signal",))
            yield from _other_layout(definition, each, signals)
            yield from _impossible_numbers(definition, each, signals)

    return test


def _other_layout(definition: Definition, mapping: SignalMapping, signals: "Sequence[CanSignal]") -> Iterator[Problem]:
    """A length or an order of bytes that the database says otherwise: that counts."""
    given = definition.values[mapping.attribute]
    known: Mapping[str, set[int] | set[str]] = {
        "length_bits": {each.length for each in signals},
        "endianness": {each.byte_order for each in signals},
    }
    for field, values in known.items():
        if mapping.is_profile and given.get(field) is not None and given[field] not in values:
            said = listed(sorted(str(each) for each in values))
            message = f"`{field}` is {given[field]}, and {said} in the CAN database, which counts."
            yield Problem(definition, message, mapping.attribute, "Write what the database says.", within=(field,))


def _impossible_numbers(
    definition: Definition, mapping: SignalMapping, signals: "Sequence[CanSignal]"
) -> Iterator[Problem]:
    """Numbers of a list that no signal of the network can be."""
    key = "to" if mapping.attribute == KUKSA_TARGET else "from"
    least, greatest = min(each.raw_minimum for each in signals), max(each.raw_maximum for each in signals)
    for choice in mapping.choices if not mapping.is_profile else ():
        number = choice.meant if key == "to" else choice.given
        if is_number(number) and not least <= number <= greatest:
            message = f"{mapping.signal} cannot be {number}: its bits hold {_short(least)} to {_short(greatest)}."
            yield Problem(definition, message, mapping.attribute, within=(*choice.steps, key))


def _sent_misfit(
    mapping: SignalMapping, signals: "Sequence[CanSignal]", values: Mapping[str, Any], datatype: str
) -> str:
    """Return the part of a signal's range that the network cannot hold; empty if it holds all, or without a range."""
    limits = [values.get("min"), values.get("max")]
    if mapping.choices or datatype == "string" or not all(map(is_number, limits)):
        return ""
    found = [
        number if mapping.formula is None else mapping.formula.value(number) for number in limits if number is not None
    ]
    numbers = [number for number in found if number is not None]
    least, greatest = min(each.least for each in signals), max(each.greatest for each in signals)
    if not numbers or (least <= min(numbers) and max(numbers) <= greatest):
        return ""
    span = (
        f"The signal is from {_short(min(numbers))} to {_short(max(numbers))}{' converted' if mapping.formula else ''}"
    )
    return f"{span}, and {mapping.signal} holds {_short(least)} to {_short(greatest)}: values beyond are not sent."


def _range_misfit(
    mapping: SignalMapping, signals: "Sequence[CanSignal]", values: Mapping[str, Any], datatype: str
) -> str:
    """Return the values that do not fit; empty if all do."""
    if mapping.choices:
        return ""
    if mapping.formula is not None and (
        named := [signal for signal in signals if len(signal.names) == 2**signal.length]
    ):
        return f"The database names every value of {named[0].name}: `math` gets none of them. Add a list of values."
    if datatype == "string":
        allowed = values.get("allowed")
        names = {name for signal in signals for name in signal.names.values()}
        other = sorted(names - set(allowed)) if isinstance(allowed, list) and allowed else []
        if other:
            return f"{mapping.signal} may be {listed(other)}, which is not `allowed`: such values are left out."
        has_names = bool(names)
        found = f"{mapping.signal} is a number without names, and the signal is a text. Add a list of values."
        return "" if has_names else found
    numbers = [number for signal in signals for number in _numbers(mapping, signal)]
    if numbers:
        has_limits = all(signal.has_limits for signal in signals)
        span = min(numbers), max(numbers)
        return _span_misfit(mapping, signals, *span, values if has_limits else {}, datatype)
    return f"`math` gives no number for any value of {mapping.signal}." if mapping.formula is not None else ""


def _span_misfit(
    mapping: SignalMapping,
    signals: "Sequence[CanSignal]",
    least: float,
    greatest: float,
    values: Mapping[str, Any],
    datatype: str,
) -> str:
    """Return the numbers from the least to the greatest that do not fit. Bits beyond a range that are never sent do not matter."""
    span = f"{mapping.signal} is from {_short(least)} to {_short(greatest)}{' converted' if mapping.formula else ''}"
    if datatype == "boolean" and not {least, greatest} <= {0, 1}:
        return f"{span}, and the signal is true or false: all but 0 is true. Add a list of values."
    if datatype in INTEGER_RANGES and mapping.formula is None and any(each.step % 1 for each in signals):
        steps = _short(min(each.step for each in signals if each.step % 1))
        return f"{mapping.signal} comes in steps of {steps}, and {datatype} is whole: values are rounded."
    first, last = INTEGER_RANGES.get(datatype, (least, greatest))
    if round(least) < round(first) or round(greatest) > round(last):
        return f"{span}, and {datatype} holds {first} to {last}: values beyond are left out."
    limits = {name: values[name] for name in ("min", "max") if is_number(values.get(name))}
    if least < limits.get("min", least) or greatest > limits.get("max", greatest):
        stated = " and ".join(f"`{name}` {limit}" for name, limit in limits.items())
        return f"{span}, beyond {stated} of the signal."
    return ""


def _numbers(mapping: SignalMapping, signal: "CanSignal") -> Iterator[float]:
    """Return the converted limits of a signal; with a formula, of numbers between them too. Only stated limits count."""
    if not signal.has_limits and mapping.formula is None and abs(signal.least) > _MOST_UNSTATED:
        return  # a float without limits
    if mapping.formula is None:
        yield from (signal.least, signal.greatest)
        return
    for number in range(_SAMPLES + 1):
        share = number / _SAMPLES
        given = signal.least * (1 - share) + signal.greatest * share
        found = mapping.formula.value(given if not signal.step or signal.step % 1 else round(given))
        if found is not None and found == found and abs(found) < _MOST_UNSTATED:  # noqa: PLR0124 — not NaN
            yield found


_MOST_UNSTATED = 1e30


def _short(number: float) -> str:
    return f"{number:.10g}"


def _in_database(mapping: SignalMapping, tree: Tree) -> "Sequence[CanSignal]":
    """The signals of the database that a mapping means."""
    known = () if tree.can is None else tree.can.signals.get(mapping.signal, ())
    return [signal for signal in known if mapping.message in (None, signal.message)]
