"""Topics: which signals travel together, in which message, and how their fields meet the variables of the code."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.function.document.text import Text
from sigcat.function.function_json.conversion import IDENTITY, Linear, as_text
from sigcat.function.function_json.duration import time_in_a_name
from sigcat.integration.finding_collector import FindingCollector
from sigcat.integration.ros2.common_types import STAMP
from sigcat.integration.ros2.conversions import conversion, to_catalogue
from sigcat.integration.ros2.existing_messages import SECTION, ExistingMessages, MappedField
from sigcat.integration.ros2.messages import MessageBook, constants, unresolved
from sigcat.integration.ros2.model import (
    Communication,
    Conversion,
    DataMap,
    FieldMapping,
    FixedField,
    MessageConstant,
    MessageField,
    RosTopic,
)
from sigcat.integration.ros2.names import Name, field_name, package_name, report_renamed, topic_name
from sigcat.integration.ros2.quality import quality
from sigcat.integration.ros2.settings import Ros2Settings
from sigcat.integration.ros2.signal_uses import SignalUse
from sigcat.integration.ros2.types import FieldType, c_definition, field_type, number_of, sent
from sigcat.names import camel_case, last_name, parent_path

PUBLISHER = "Publisher"
SUBSCRIPTION = "Subscription"


class Member(NamedTuple):
    """A field of a topic's message."""

    field: str
    written: str
    """Its datatype as the message writes it."""
    kind: FieldType
    number: str = ""
    """The field that has the number of an enumeration, beside its text."""
    way: Linear | None = None
    """From the unit of the field to that of the catalogue, if the message exists."""


class Topic(NamedTuple):
    """A topic of the set: its message, and every use of every signal that it carries."""

    name: str
    message: str
    """With its package: `eco_control_interfaces/msg/Speed`."""
    members: dict[str, Member]
    """By the key of the signal."""
    uses: tuple[SignalUse, ...]
    stamp: str | None = STAMP.name
    """Field of the time; None if the message has none."""
    values: tuple[FixedField, ...] = ()
    """Constant values of further fields."""


class _Group(NamedTuple):
    segments: tuple[str, ...]
    message: str
    title: str = ""
    """Content of the message, if the segments do not tell it."""


def topics_of(
    uses: Sequence[SignalUse], existing: ExistingMessages, settings: Ros2Settings, book: MessageBook,
    findings: FindingCollector,
) -> tuple[Topic, ...]:  # fmt: skip
    """Every topic, in the order of their names. Names and types of topics for single signals depend on paths alone."""
    providers = _providers(uses, findings)
    mapped = tuple(_existing_topics(uses, existing, findings))
    own = [use for use in uses if use.key not in existing.fields]
    together = _Together.of(uses, (use for use in providers.values() if use.key not in existing.fields))
    groups: dict[_Group, list[SignalUse]] = {}
    for use in own:
        groups.setdefault(_group(use, providers.get(use.key), together, settings), []).append(use)
    taken = {topic.name.removeprefix("/"): topic.message for topic in mapped}
    messages = {group: book.reserved(group.message, groups[group][0].interface) for group in sorted(groups)}
    made = []
    for group, message in messages.items():
        name = _free(topic_name(*group.segments), taken, groups[group][0], findings)
        made.append(_topic(name, message, group, groups[group], settings, book, findings))
    return tuple(sorted((*made, *mapped), key=lambda topic: topic.name))


def _existing_topics(
    uses: Sequence[SignalUse], existing: ExistingMessages, findings: FindingCollector
) -> Iterable[Topic]:
    """Topics whose messages exist. Each is sent by one node, or by others: a message is sent whole."""
    for name, topic in existing.topics.items():
        fields = {key: field for key, field in existing.fields.items() if field.topic == name}
        own = tuple(use for use in uses if use.key in fields)
        if not own:
            continue
        senders = {use.part.name for use in own if use.is_provider}
        if topic.values and not senders:
            message = f"{name} must be sent by a node of the set to have `values`; it is only received."
            at = (*SECTION, name, "values")
            findings.report_deployment(codes.FIELD_DOES_NOT_FIT, message, at, "Remove `values`.", "")
        foreign = {use.key for use in own} - {use.key for use in own if use.is_provider}
        if len(senders) > 1 or (senders and foreign):
            others = [*sorted(senders), *(f"the sender of {key}" for key in sorted(foreign))]
            message = f"{name} must have one sender, not {' and '.join(others)}: each would send the fields of the others empty."
            findings.report_deployment(
                codes.FIELD_DOES_NOT_FIT, message, (*SECTION, name), "Map signals of one node.", ""
            )
        members = {
            use.key: Member(
                fields[use.key].path, *_existing_kind(use, fields[use.key]), way=existing.ways.get(use.key, IDENTITY)
            )
            for use in own
        }
        values = tuple(FixedField(field=each.path, field_type=each.datatype, value=each.value) for each in topic.values)
        yield Topic(name, topic.message, members, own, topic.stamp, values)


def _existing_kind(use: SignalUse, mapped: MappedField) -> tuple[str, FieldType]:
    """The datatype of a field, with the names of an enumeration."""
    field = mapped.field
    assert field.element is not None
    kind = FieldType(field.element, "", field.array, use.data.vss_symbols or ())
    return f"{field.element.ros2}{field.array}", kind


def communications(
    topics: Sequence[Topic],
    uses: Sequence[SignalUse],
    settings: Ros2Settings,
    book: MessageBook,
    findings: FindingCollector,
) -> tuple[Communication, ...]:
    """Return the topics of each call, in the order of the document."""
    by_key = {key: topic for topic in topics for key in topic.members}
    calls: dict[tuple[str, str], list[SignalUse]] = {}
    for use in uses:
        calls.setdefault((use.part.name, use.runnable.name), []).append(use)
    return tuple(
        Communication(runnable=runnable, topics=tuple(_ends(own, by_key, settings, book, findings)))
        for (_, runnable), own in calls.items()
    )


# -- which signals travel together --------------------------------------------------------------------------------


class _Together(NamedTuple):
    """Facts that decide whether a signal is sent together with the others of its cycle."""

    queued: frozenset[str]
    """Keys of signals that a side queues: a separate topic has the depth of the queue."""
    shared: frozenset[tuple[str, float | None]]
    """Functions and cycles in which several calls provide signals: one message has what one call writes."""

    @classmethod
    def of(cls, uses: Iterable[SignalUse], providers: Iterable[SignalUse]) -> "_Together":
        """Collect them from every use of the set, and the first provider of each signal."""
        calls: dict[tuple[str, float | None], set[str]] = {}
        for use in providers:
            calls.setdefault((use.part.function_name, use.cycle), set()).add(f"{use.part.name}.{use.runnable.name}")
        return cls(
            frozenset(use.key for use in uses if use.queue_length),
            frozenset(key for key, names in calls.items() if len(names) > 1),
        )


def _providers(uses: Iterable[SignalUse], findings: FindingCollector) -> dict[str, SignalUse]:
    """The first provider of each signal."""
    providers: dict[str, SignalUse] = {}
    for use in uses:
        if not use.path:
            message = f"{use.interface} must have a path in the catalogue; without it only {use.part.function_name} can know its topic."
            findings.report(
                codes.SIGNAL_WITHOUT_PATH, message, use.interface, "Set it under `paths` in the deployment file."
            )
        if use.is_provider:
            first = providers.setdefault(use.key, use).part.function_name
            if first != use.part.function_name:
                message = f"{use.interface} must have one publisher, not {first} and {use.part.function_name}: subscribers get a mixture."
                findings.report(
                    codes.SEVERAL_PUBLISHERS, message, use.interface, "Let only one of them provide it.", key="Role"
                )
    return providers


def _group(use: SignalUse, providing: SignalUse | None, together: _Together, settings: Ros2Settings) -> _Group:
    provider = providing.part.function_name if providing else ""
    if settings.topics == "cycle" and providing and providing.cycle and use.key not in together.queued:
        is_shared = (provider, providing.cycle) in together.shared
        call = (f"{providing.part.name}_{providing.runnable.name}",) if is_shared else ()
        names = (provider, *call, f"Cycle{time_in_a_name(providing.cycle)}")
        title = f"What {' '.join((provider, *call))} provides every {providing.cycle} ms."
        return _Group(names, "".join(map(camel_case, names)), title)
    if settings.topics == "function":
        owner, way = (provider, "out") if provider else (use.part.function_name, "in")
        return _Group((owner, way), camel_case(owner) + camel_case(way))
    if not use.path:
        return _Group(
            (use.part.function_name, use.data.name), camel_case(use.part.function_name) + camel_case(use.data.name)
        )
    path = parent_path(use.path) if settings.topics == "branch" else use.path
    steps = path.split(".")
    source = camel_case(provider) if settings.topics == "branch" else ""
    segments = (provider, *steps) if source else tuple(steps)
    return _Group(segments, "".join(map(camel_case, steps[1:] or steps)) + source)


def _free(name: str, taken: dict[str, str], use: SignalUse, findings: FindingCollector) -> str:
    free, number = name, 1
    while free in taken:
        number += 1
        free = f"{name}_{number}"
    reason = f"{name!r} is taken by {taken[name]}" if free != name else ""
    report_renamed(Name(free, reason), name, use.interface, findings)
    taken[free] = use.interface.name
    return free


# -- messages -----------------------------------------------------------------------------------------------------


def _topic(
    name: str,
    message: str,
    group: _Group,
    uses: list[SignalUse],
    settings: Ros2Settings,
    book: MessageBook,
    findings: FindingCollector,
) -> Topic:
    members: dict[str, Member] = {}
    fields: list[MessageField] = [STAMP]
    values: list[MessageConstant] = []
    of_key: dict[str, list[SignalUse]] = {}
    for use in uses:
        of_key.setdefault(use.key, []).append(use)
    for key, own in of_key.items():
        own.sort(key=lambda use: not use.is_provider)
        member = _member(own, {field.name for field in fields}, settings, book, findings)
        if member is None:
            continue
        members[key] = member
        fields.extend(_fields(member, own[0]))
        kind = number_of(member.kind) if member.number else member.kind
        taken = {value.name for value in values}
        values.extend(constants(kind, _prefix(member, of_key), own[0].interface, findings, taken))
    together = Text(group.title or f"Signals of {' '.join(group.segments)}.")
    what = uses[0].data.description if len(of_key) == 1 else together
    book.add(message, what, fields, values)
    return Topic(name, f"{book.package}/msg/{message}", members, tuple(uses))


def _fields(member: Member, first: SignalUse) -> Iterable[MessageField]:
    yield MessageField(
        name=member.field,
        datatype=member.written,
        description=first.data.description,
        units=first.data.vss_unit or (None if first.path else first.data.units) or None,
        vss_path=first.path or None,
    )
    if member.number:
        kind = number_of(member.kind)
        assert kind.element is not None
        description = Text(f"The same as {member.field}, as one of the constants. Nodes read the number.")
        yield MessageField(name=member.number, datatype=kind.element.ros2 + kind.suffix, description=description)


def _prefix(member: Member, of_key: dict[str, list[SignalUse]]) -> str:
    return member.field.upper() if len(of_key) > 1 else ""


def _member(
    own: list[SignalUse], taken: set[str], settings: Ros2Settings, book: MessageBook, findings: FindingCollector
) -> Member | None:
    """The field of a signal. All who use it have to mean the same."""
    first = own[0]
    resolved = [field_type(use.data.datatype, use.data.vss_datatype, book.table) for use in own]
    kind = resolved[0]
    if kind is None:
        unresolved(findings, first.interface, first.data.datatype)
        return None
    for use, other in zip(own[1:], resolved[1:], strict=True):
        if _disagree(kind, other) or first.data.vss_unit != use.data.vss_unit:
            message = f"{first.interface} must have one datatype and unit; {first.part.function_name} and {use.part.function_name} differ."
            findings.report(
                codes.MEANINGS_DIFFER, message, first.interface, "Build both functions from the same catalogue."
            )
    kind = sent(kind, first.data.vss_symbols, as_number=settings.enumerations == "number")
    written = book.written(kind, first.interface)
    if written is None:
        return None
    source = last_name(first.path) if first.path else first.data.name
    name = field_name(source, taken)
    report_renamed(name, source, first.interface, findings)
    if not (kind.is_text and kind.symbols and settings.enumerations == "both"):
        return Member(name.text, written, kind)
    return Member(name.text, written, kind, field_name(f"{name.text}_number", taken | {name.text}).text)


def _disagree(one: FieldType, other: FieldType | None) -> bool:
    """Whether two mean different things. The numbers of an enumeration may differ: each end converts them by name."""
    if other is None or (one.element, one.struct, one.suffix) != (other.element, other.struct, other.suffix):
        return True
    return {symbol.symbol for symbol in one.symbols} != {symbol.symbol for symbol in other.symbols}


# -- ends ---------------------------------------------------------------------------------------------------------


def _ends(
    own: Sequence[SignalUse],
    by_key: dict[str, Topic],
    settings: Ros2Settings,
    book: MessageBook,
    findings: FindingCollector,
) -> Iterable[RosTopic]:
    """The publishers and subscriptions of one call."""
    ends: dict[tuple[str, bool], list[SignalUse]] = {}
    for use in own:
        topic = by_key.get(use.key)
        if topic is not None:
            ends.setdefault((topic.name, use.is_provider), []).append(use)
    taken: set[str] = set()
    for (_, is_provider), mine in ends.items():
        topic = by_key[mine[0].key]
        _check_timeouts(mine, topic, findings)
        yield RosTopic(
            name=topic.name,
            interface=_interface(mine),
            data_maps=(_data_map(mine, topic, taken, book, findings),),
            role=PUBLISHER if is_provider else SUBSCRIPTION,
            message=topic.message,
            stamp=topic.stamp,
            values=topic.values or None,
            node=mine[0].part.name,
            providers=tuple(dict.fromkeys(use.part.function_name for use in topic.uses if use.is_provider)),
            quality=quality(mine, topic.uses, topic.name, settings, is_existing=topic.name in settings.messages),
        )


def _interface(mine: Sequence[SignalUse]) -> str:
    """The signal's name, or for several the structure of the code that holds their variables."""
    if len(mine) == 1:
        return mine[0].data.name
    parts = [(use.data.variable or use.data.name).split(".")[:-1] for use in mine]
    common = []
    for names in zip(*parts, strict=False):
        if len(set(names)) > 1:
            break
        common.append(names[0])
    return ".".join(common) or mine[0].runnable.name


def _check_timeouts(mine: Sequence[SignalUse], topic: Topic, findings: FindingCollector) -> None:
    slowest: dict[str, float] = {}
    for use in topic.uses:
        if use.is_provider and use.cycle:
            slowest[use.key] = max(use.cycle, slowest.get(use.key, 0))
    for use in mine:
        cycle = slowest.get(use.key)
        if use.timeout and not use.is_provider and cycle and use.timeout < 2 * cycle:
            message = f"{use.interface}: the time-out must be at least two cycles of {cycle} ms, not {use.timeout} ms."
            fix = "Raise it, or one late value triggers it."
            findings.report(codes.TIMEOUT_BELOW_TWO_CYCLES, message, use.interface, fix, key="Timeout")


def _data_map(
    mine: Sequence[SignalUse], topic: Topic, taken: set[str], book: MessageBook, findings: FindingCollector
) -> DataMap:
    rows = [_row(use, topic.members[use.key], taken, book, findings) for use in mine]
    mappings = [mapping for mapping, _ in rows]
    conversions = tuple(made for _, made in rows if made is not None)
    return DataMap(
        variables=tuple(mapping.variable for mapping in mappings),
        variable_types=tuple(mapping.variable_type for mapping in mappings),
        fields=tuple(mapping.field for mapping in mappings),
        field_types=tuple(mapping.field_type for mapping in mappings),
        conversions=conversions or None,
        mappings=tuple(mappings),
    )


def _row(
    use: SignalUse, member: Member, taken: set[str], book: MessageBook, findings: FindingCollector
) -> tuple[FieldMapping, Conversion | None]:
    data = use.data
    if not data.variable:
        message = f"{use.interface} must name the variable of the code; its own name, {data.name!r}, is used."
        findings.report(codes.VARIABLE_ASSUMED, message, use.interface, "Set `variable` in the declaration.")
    way = "to_topic" if use.is_provider else "from_topic"
    name = package_name(f"{use.part.function_name}_{data.name}_{way}", taken).text
    made = conversion(
        name, member.field, data.datatype, member.kind, to_catalogue(data, use.interface, findings), book.table,
        member.written, is_outgoing=use.is_provider, has_number=bool(member.number), is_named=member.way is not None,
    )  # fmt: skip
    if made is not None:
        taken.add(name)
    return _mapping(use, member, book, made), made


def _mapping(use: SignalUse, member: Member, book: MessageBook, made: Conversion | None) -> FieldMapping:
    data, way = use.data, member.way or IDENTITY
    return FieldMapping(
        signal=data.name,
        field=member.field,
        number_field=member.number or None,
        field_type=member.written,
        catalogue_factor=None if way == IDENTITY else as_text(way.factor),
        catalogue_offset=None if way == IDENTITY else as_text(way.offset),
        field_units=data.vss_unit or (None if use.path else data.units) or None,
        variable=data.variable or data.name,
        variable_type=c_definition(data.datatype, book.table),
        variable_units=data.units or None,
        conversion=made.name if made else None,
        min=data.min,
        max=data.max,
        default=data.default,
        init_value=data.init_value,
        range_error_action=data.range_error_action,
        timeout=use.timeout,
        timeout_error=data.timeout_error,
        access=data.access,
        queue_length=use.queue_length,
        external_provider=data.external_provider,
        asil_level=use.asil,
        vss_path=use.path or None,
    )
