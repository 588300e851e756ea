"""Map signals to fields of existing messages such as geometry_msgs/Twist, and report fields that do not fit.

A mapped signal gets the datatype, unit and numbers of its field instead of the catalogue's, so that the core of the
function converts between field and code, with its rounding and limits.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from sigcat.function.document.document import Pointer
from sigcat.function.function_json.conversion import IDENTITY, Linear, as_number, as_text, between, of_text, same_kind
from sigcat.function.function_json.datatypes.datatype import Datatype, EnumerationValue
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.runnable import Contract
from sigcat.integration.datatypes import Spelling
from sigcat.integration.problem import Problem
from sigcat.integration.ros2.messages.field_types import FieldType, field_type, sent
from sigcat.integration.ros2.messages.message_definitions import Definitions, Field, MessageError, holds, short_name
from sigcat.integration.ros2.model import FixedField
from sigcat.integration.ros2.settings import FieldSettings, MessageSettings, Ros2Settings
from sigcat.names import either

SECTION = ("ros2", "messages")


class ExistingTopic(NamedTuple):
    """A topic whose message exists."""

    message: str
    """`geometry_msgs/msg/Twist`."""
    stamp: str | None
    """Path of its time."""
    values: tuple[FixedField, ...]
    """Fields that always have one value."""


class MappedField(NamedTuple):
    """The field that a signal has."""

    topic: str
    path: str
    field: Field
    settings: FieldSettings

    @property
    def at(self) -> Pointer:
        """Its place in the deployment file."""
        return (*SECTION, self.topic, "fields", self.path)


class ExistingMessages(NamedTuple):
    """Existing messages, as the deployment maps them."""

    topics: Mapping[str, ExistingTopic]
    fields: Mapping[str, MappedField]
    """By the key of the signal."""
    problems: tuple[Problem, ...]
    ways: Mapping[str, Linear] = {}
    """From the unit of the field to that of the catalogue, by the key of the signal."""


def existing_messages(settings: Ros2Settings) -> ExistingMessages:
    """Find every field in the definition of its message."""
    definitions = Definitions(settings.message_definitions)
    topics: dict[str, ExistingTopic] = {}
    fields: dict[str, MappedField] = {}
    problems: list[Problem] = []
    for topic, message in settings.messages.items():
        at: Pointer = (*SECTION, topic)
        name = short_name(message.type)
        try:
            stamp = definitions.stamp(name)
        except MessageError as error:
            problems.append(Problem((*at, "type"), f"{error}.", _NOT_FOUND))
            continue
        package, _, plain = name.partition("/")
        topics[topic] = ExistingTopic(
            f"{package}/msg/{plain}", stamp, tuple(_values(message, name, definitions, at, problems))
        )
        for path, entry in message.mapped.items():
            own = (*at, "fields", path)
            try:
                found = MappedField(topic, path, definitions.field(name, path), entry)
            except MessageError as error:
                problems.append(Problem(own, f"{error}."))
                continue
            if entry.signal in fields:
                other = fields[entry.signal]
                text = f"{entry.signal} must have one field, not {other.path} of {other.topic} and {path} of {topic}."
                problems.append(Problem(own, text, "Remove one of them."))
            elif path in (stamp, f"{stamp}.sec", f"{stamp}.nanosec"):
                problems.append(Problem(own, f"{path} must have the time of the call, not a signal."))
            else:
                fields[entry.signal] = found
    return ExistingMessages(topics, fields, tuple(problems))


_NOT_FOUND = (
    "Source ROS 2, so that AMENT_PREFIX_PATH names it, name a folder in `messageFolders`, or give its text in "
    "`messageDefinitions`."
)


def _values(
    message: MessageSettings, name: str, definitions: Definitions, at: Pointer, problems: list[Problem]
) -> Iterator[FixedField]:
    for path, value in message.values.items():
        own = (*at, "values", path)
        try:
            field = definitions.field(name, path)
        except MessageError as error:
            problems.append(Problem(own, f"{error}."))
            continue
        if path in message.fields:
            problems.append(Problem(own, f"{path} must have a signal or a value, not both.", "Remove one."))
        elif field.array or field.element is None or not holds(field.element, value):
            kind = f"{field.type}{field.array}"
            problems.append(Problem(own, f"{path} must have a value of {kind}, not {str(value)[:60]!r}."))
        else:
            yield FixedField(field=path, field_type=field.element.ros2, value=value)


# -- functions ----------------------------------------------------------------------------------------------------


def with_existing_messages(
    functions: Sequence[ResolvedFunction], messages: ExistingMessages, paths: Mapping[str, str]
) -> tuple[tuple[ResolvedFunction, ...], ExistingMessages]:
    """Give mapped signals the datatype, unit and numbers of their fields, and add the problems of those that do not fit."""
    problems: dict[Problem, None] = {}
    ways: dict[str, Linear] = {}

    def changed(function: FunctionJson) -> FunctionJson:
        table = {each.reference: each for each in function.datatypes}

        def mapped(item: Any) -> Any:
            name = f"{function.info.function_name}.{item.name}"
            field = messages.fields.get(item.vss_path or paths.get(name, "") or name)
            if field is None:
                return item
            try:
                made = _mapped(item, field, table)
                ways[field.settings.signal] = _unit(item, field).inverse
            except _DoesNotFit as reason:
                problems[Problem(field.at, str(reason), reason.fix)] = None
                return item
            return made

        return _each_signal(function, mapped)

    made = tuple(replace(each, function=changed(each.function)) if messages.fields else each for each in functions)
    wrong = {problem.pointer for problem in problems}
    fitting = {key: field for key, field in messages.fields.items() if field.at not in wrong}
    return made, messages._replace(fields=fitting, problems=(*messages.problems, *problems), ways=ways)


def _each_signal(function: FunctionJson, change: Callable[[Any], Any]) -> FunctionJson:
    def of_contract(contract: Contract) -> Contract:
        update = {
            name: tuple(change(each) for each in items)
            for name in ("signals", "queues")
            if (items := getattr(contract, name)) is not None
        }
        return contract.model_copy(update=update)

    components = []
    for component in function.components:
        runnables = tuple(
            each.model_copy(update={"contracts": tuple(of_contract(one) for one in each.contracts)})
            if each.contracts is not None else each
            for each in component.runnables
        )  # fmt: skip
        components.append(component.model_copy(update={"runnables": runnables}))
    return function.model_copy(update={"components": tuple(components)})


class _DoesNotFit(Exception):
    """The reason why a signal cannot have its field, and a fix."""

    def __init__(self, message: str, fix: str = "") -> None:
        super().__init__(message)
        self.fix = fix


def _mapped(item: Signal | DataQueue, mapped: MappedField, table: Mapping[str, Datatype]) -> Signal | DataQueue:
    """The signal with what its field has. Raises _DoesNotFit."""
    own = field_type(item.datatype, item.vss_datatype, table)
    if own is None:  # reported elsewhere
        return item
    own = sent(own, item.vss_symbols)
    element = mapped.field.element
    if element is None or own.element is None or own.suffix != mapped.field.array:
        kind = f"{mapped.field.type}{mapped.field.array}"
        name = f"the struct {own.struct}" if own.element is None else own.element.vss
        signal = f"{mapped.settings.signal} is {name}{own.suffix}"
        raise _DoesNotFit(f"{signal}, which {mapped.path}, {kind}, cannot have.")
    symbols, way = _symbols(own, element, mapped), _unit(item, mapped)
    factor, offset = (of_text(text or "") for text in (item.conversion_factor, item.conversion_offset))
    whole = Linear(factor or IDENTITY.factor, offset or IDENTITY.offset).then(way)
    return item.model_copy(update={
        "vss_datatype": f"{element.vss}{'[]' if own.suffix else ''}",
        "vss_unit": mapped.settings.unit or item.vss_unit or item.units or None,
        "vss_symbols": symbols or None,
        "vss_min": _limit(item.vss_min, way),
        "vss_max": _limit(item.vss_max, way),
        "conversion_factor": None if whole == IDENTITY else as_text(whole.factor),
        "conversion_offset": None if whole == IDENTITY else as_text(whole.offset),
    })  # fmt: skip


def _limit(value: float | None, way: Linear) -> float | None:
    number = None if value is None else of_text(repr(value))
    return None if number is None else as_number(way(number))


def _symbols(own: FieldType, element: Spelling, mapped: MappedField) -> tuple[EnumerationValue, ...]:
    """Values of an enumeration with the numbers of the message; empty for other datatypes."""
    signal, given = mapped.settings.signal, mapped.settings.symbols
    if element.vss == "string" and not (own.is_text and own.symbols and given is None):
        raise _DoesNotFit(f"{mapped.path} is a text, which {signal} can have as an enumeration of texts alone.")
    if not own.symbols and (own.is_text or given):
        raise _DoesNotFit(f"{signal} must be an enumeration to have numbers in {mapped.path}.")
    names = [each.symbol for each in own.symbols]
    if given is not None and set(given) != set(names):
        raise _DoesNotFit(f"`symbols` of {mapped.path} must have a number for each of {', '.join(names)}.")
    numbers = given or {each.symbol: each.value for each in own.symbols}
    if element.vss != "string" and not all(holds(element, number) for number in numbers.values()):
        raise _DoesNotFit(f"{mapped.path} must hold the numbers of {signal}; it is {element.ros2}.")
    return tuple(each.model_copy(update={"value": numbers[each.symbol]}) for each in own.symbols)


def _unit(item: Signal | DataQueue, mapped: MappedField) -> Linear:
    unit, own = mapped.settings.unit, item.vss_unit or item.units or ""
    way = IDENTITY if unit is None else between(own, unit)
    if way is None:
        fix = f"Use {either((own, *same_kind(own)))}." if own else "Remove `unit`."
        raise _DoesNotFit(f"{mapped.settings.signal} cannot be converted from {own or 'no unit'} to {unit}.", fix)
    return way
