"""Topics: which signals travel together, in which message, and how their fields meet the variables of the code."""

from collections.abc import Container, Iterable, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.function.document.text import Text
from sigcat.function.exchange import Element, Side
from sigcat.function.function_json.conversion import IDENTITY, Linear, as_text
from sigcat.function.function_json.duration import time_in_a_name
from sigcat.integration.finding_collector import FindingCollector, subject_of
from sigcat.integration.grouping import grouped
from sigcat.integration.ros2 import model
from sigcat.integration.ros2.context import Context
from sigcat.integration.ros2.conversions import conversion, to_catalogue
from sigcat.integration.ros2.messages.common_types import STAMP
from sigcat.integration.ros2.messages.existing_messages import SECTION, ExistingMessages
from sigcat.integration.ros2.messages.field_types import FieldType, c_definition, field_type, number_of, sent
from sigcat.integration.ros2.messages.made_messages import constants, unresolved
from sigcat.integration.ros2.names import Name, field_name, numbered, package_name, report_renamed, topic_name
from sigcat.integration.ros2.quality_of_service import quality
from sigcat.integration.ros2.settings import Ros2Settings
from sigcat.integration.ros2.signal_uses import asil_of_side, cycle_of, timeout_of
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
    uses: tuple[Side, ...]
    stamp: str | None = STAMP.name
    """Field of the time; None if the message has none."""
    values: tuple[model.FixedField, ...] = ()
    """Constant values of further fields."""


class _Group(NamedTuple):
    segments: tuple[str, ...]
    message: str
    title: str = ""
    """Content of the message, if the segments do not tell it."""


def topics_of(context: Context) -> tuple[Topic, ...]:
    """Every topic, in the order of their names. Names and types of topics for single signals depend on paths alone."""
    exchange = context.exchange
    _report_uses(context)
    mapped = tuple(_existing_topics(context))
    own = [use for use in exchange.data if use.identity not in context.existing.fields]
    shared = _shared_cycles(map(exchange.element, own))
    groups = grouped(own, lambda use: _group(use, exchange.element(use), shared, context.settings))
    taken = {topic.name.removeprefix("/"): topic.message for topic in mapped}
    messages = {group: context.book.reserved(group.message, subject_of(groups[group][0])) for group in sorted(groups)}
    made = []
    for group, message in messages.items():
        name = _free(topic_name(*group.segments), taken, groups[group][0], context.findings)
        made.append(_topic(name, message, group, groups[group], context))
    return tuple(sorted((*made, *mapped), key=lambda topic: topic.name))


def _existing_topics(context: Context) -> Iterable[Topic]:
    """Topics whose messages exist. Each is sent by one node, or by others: a message is sent whole."""
    existing, rule = context.existing, codes.FIELD_DOES_NOT_FIT
    for name, topic in existing.topics.items():
        fields = {key: field for key, field in existing.fields.items() if field.topic == name}
        own = tuple(use for use in context.exchange.data if use.identity in fields)
        if not own:
            continue
        senders = {use.part.name for use in own if use.provides}
        if topic.values and not senders:
            message = f"{name} must be sent by a node of the set to have `values`; it is only received."
            context.findings.report_deployment(rule, message, (*SECTION, name, "values"), "Remove `values`.", "")
        foreign = {use.identity for use in own} - {use.identity for use in own if use.provides}
        if len(senders) > 1 or (senders and foreign):
            others = [*sorted(senders), *(f"the sender of {key}" for key in sorted(foreign))]
            message = f"{name} must have one sender, not {' and '.join(others)}: each would send the fields of the others empty."
            context.findings.report_deployment(rule, message, (*SECTION, name), "Map signals of one node.", "")
        members = {use.identity: _existing_member(use, existing) for use in own}
        yield Topic(name, topic.message, members, own, topic.stamp, topic.values)


def _existing_member(use: Side, existing: ExistingMessages) -> Member:
    """The field with its datatype, which has the names of an enumeration."""
    mapped, way = existing.fields[use.identity], existing.ways.get(use.identity, IDENTITY)
    field = mapped.field
    assert field.element is not None
    kind = FieldType(field.element, "", field.array, use.data.vss_symbols or ())
    return Member(mapped.path, f"{field.element.ros2}{field.array}", kind, way=way)


def communications(topics: Sequence[Topic], context: Context) -> tuple[model.Communication, ...]:
    """Return the topics of each call, in the order of the document."""
    by_key = {key: topic for topic in topics for key in topic.members}
    calls = grouped(context.exchange.data, lambda use: (use.part.name, use.runnable.name))
    return tuple(
        model.Communication(runnable=runnable, topics=tuple(_ends(own, by_key, context)))
        for (_, runnable), own in calls.items()
    )


# -- which signals travel together --------------------------------------------------------------------------------


def _shared_cycles(elements: Iterable[Element]) -> frozenset[tuple[str, float | None]]:
    """Functions and cycles in which several calls provide signals: one message has what one call writes."""
    providers = (use for each in elements if (use := each.provider) is not None)
    calls = grouped(providers, lambda use: (use.function, cycle_of(use)))
    return frozenset(
        key for key, uses in calls.items() if len({(use.part.name, use.runnable.name) for use in uses}) > 1
    )


def _report_uses(context: Context) -> None:
    """Report signals without a path, and further publishers of a signal."""
    exchange, findings = context.exchange, context.findings
    for use in exchange.data:
        if not use.path:
            message = (
                f"{use.identity} must have a path in the catalogue; without it only {use.function} can know its topic."
            )
            findings.report(codes.SIGNAL_WITHOUT_PATH, message, use, "Set it under `paths` in the deployment file.")
        first = exchange.element(use).leading.function
        if use.provides and first != use.function:
            message = (
                f"{use.identity} must have one publisher, not {first} and {use.function}: subscribers get a mixture."
            )
            findings.report(codes.SEVERAL_PUBLISHERS, message, use, "Let only one of them provide it.", key="Role")


def _group(use: Side, element: Element, shared: Container[tuple[str, float | None]], settings: Ros2Settings) -> _Group:
    """The topic of a signal. Queued ones have a separate topic, which has the depth of the queue."""
    providing = element.provider
    provider = providing.function if providing else ""
    cycle = cycle_of(providing) if providing else None
    if settings.topics == "cycle" and providing and cycle and not element.is_queued:
        is_shared = (provider, cycle) in shared
        call = (f"{providing.part.name}_{providing.runnable.name}",) if is_shared else ()
        names = (provider, *call, f"Cycle{time_in_a_name(cycle)}")
        title = f"What {' '.join((provider, *call))} provides every {cycle} ms."
        return _Group(names, "".join(map(camel_case, names)), title)
    if settings.topics == "function":
        owner, way = (provider, "out") if provider else (use.function, "in")
        return _Group((owner, way), camel_case(owner) + camel_case(way))
    if not use.path:
        return _Group((use.function, use.data.name), camel_case(use.function) + camel_case(use.data.name))
    path = parent_path(use.path) if settings.topics == "branch" else use.path
    steps = path.split(".")
    source = camel_case(provider) if settings.topics == "branch" else ""
    segments = (provider, *steps) if source else tuple(steps)
    return _Group(segments, "".join(map(camel_case, steps[1:] or steps)) + source)


def _free(name: str, taken: dict[str, str], use: Side, findings: FindingCollector) -> str:
    free = numbered(name, taken)
    if free != name:
        report_renamed(Name(free, f"{name!r} is taken by {taken[name]}"), name, subject_of(use), findings)
    taken[free] = use.identity
    return free


# -- messages -----------------------------------------------------------------------------------------------------


def _topic(name: str, message: str, group: _Group, uses: list[Side], context: Context) -> Topic:
    members: dict[str, Member] = {}
    fields: list[model.MessageField] = [STAMP]
    values: list[model.MessageConstant] = []
    of_key = grouped(uses, lambda use: use.identity)
    for key, own in of_key.items():
        own.sort(key=lambda use: not use.provides)
        member = _member(own, {field.name for field in fields}, context)
        if member is None:
            continue
        members[key] = member
        fields.extend(_fields(member, own[0]))
        kind = number_of(member.kind) if member.number else member.kind
        taken = {value.name for value in values}
        prefix = member.field.upper() if len(of_key) > 1 else ""
        values.extend(constants(kind, prefix, subject_of(own[0]), context.findings, taken))
    together = Text(group.title or f"Signals of {' '.join(group.segments)}.")
    what = uses[0].data.description if len(of_key) == 1 else together
    context.book.add(message, what, fields, values)
    return Topic(name, f"{context.book.package}/msg/{message}", members, tuple(uses))


def _fields(member: Member, first: Side) -> Iterable[model.MessageField]:
    yield model.MessageField(
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
        yield model.MessageField(name=member.number, datatype=kind.element.ros2 + kind.suffix, description=description)


def _member(own: list[Side], taken: set[str], context: Context) -> Member | None:
    """The field of a signal. All who use it have to mean the same."""
    first, enumerations = own[0], context.settings.enumerations
    book, findings = context.book, context.findings
    resolved = [field_type(use.data.datatype, use.data.vss_datatype, book.table) for use in own]
    kind = resolved[0]
    if kind is None:
        unresolved(findings, subject_of(first), first.data.datatype)
        return None
    for use, other in zip(own[1:], resolved[1:], strict=True):
        if _disagree(kind, other) or first.data.vss_unit != use.data.vss_unit:
            message = f"{first.identity} must have one datatype and unit; {first.function} and {use.function} differ."
            findings.report(codes.MEANINGS_DIFFER, message, first, "Build both functions from the same catalogue.")
    kind = sent(kind, first.data.vss_symbols, as_number=enumerations == "number")
    written = book.written(kind, subject_of(first))
    if written is None:
        return None
    source = last_name(first.path) if first.path else first.data.name
    name = field_name(source, taken)
    report_renamed(name, source, subject_of(first), findings)
    if not (kind.is_text and kind.symbols and enumerations == "both"):
        return Member(name.text, written, kind)
    return Member(name.text, written, kind, field_name(f"{name.text}_number", taken | {name.text}).text)


def _disagree(one: FieldType, other: FieldType | None) -> bool:
    """Whether two mean different things. The numbers of an enumeration may differ: each end converts them by name."""
    if other is None or (one.element, one.struct, one.suffix) != (other.element, other.struct, other.suffix):
        return True
    return {symbol.symbol for symbol in one.symbols} != {symbol.symbol for symbol in other.symbols}


# -- ends ---------------------------------------------------------------------------------------------------------


def _ends(own: Sequence[Side], by_key: dict[str, Topic], context: Context) -> Iterable[model.RosTopic]:
    """The publishers and subscriptions of one call."""
    mapped = (use for use in own if use.identity in by_key)
    ends = grouped(mapped, lambda use: (by_key[use.identity].name, use.provides))
    taken: set[str] = set()
    for (_, is_provider), mine in ends.items():
        topic = by_key[mine[0].identity]
        _check_timeouts(mine, topic, context.findings)
        yield model.RosTopic(
            name=topic.name,
            interface=_interface(mine),
            data_maps=(_data_map(mine, topic, taken, context),),
            role=PUBLISHER if is_provider else SUBSCRIPTION,
            message=topic.message,
            stamp=topic.stamp,
            values=topic.values or None,
            node=mine[0].part.name,
            providers=tuple(dict.fromkeys(use.function for use in topic.uses if use.provides)),
            quality=quality(mine, topic.uses, topic.name, context.settings),
        )


def _interface(mine: Sequence[Side]) -> str:
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


def _check_timeouts(mine: Sequence[Side], topic: Topic, findings: FindingCollector) -> None:
    slowest: dict[str, float] = {}
    for use in topic.uses:
        if use.provides and (cycle := cycle_of(use)):
            slowest[use.identity] = max(cycle, slowest.get(use.identity, 0))
    for use in mine:
        cycle, timeout = slowest.get(use.identity), timeout_of(use)
        if timeout and not use.provides and cycle and timeout < 2 * cycle:
            message = f"{use.identity}: the time-out must be at least two cycles of {cycle} ms, not {timeout} ms."
            fix = "Raise it, or one late value triggers it."
            findings.report(codes.TIMEOUT_BELOW_TWO_CYCLES, message, use, fix, key="Timeout")


def _data_map(mine: Sequence[Side], topic: Topic, taken: set[str], context: Context) -> model.DataMap:
    rows = [_row(use, topic.members[use.identity], taken, context) for use in mine]
    mappings = [mapping for mapping, _ in rows]
    conversions = tuple(made for _, made in rows if made is not None)
    return model.DataMap(
        variables=tuple(mapping.variable for mapping in mappings),
        variable_types=tuple(mapping.variable_type for mapping in mappings),
        fields=tuple(mapping.field for mapping in mappings),
        field_types=tuple(mapping.field_type for mapping in mappings),
        conversions=conversions or None,
        mappings=tuple(mappings),
    )


def _row(
    use: Side, member: Member, taken: set[str], context: Context
) -> tuple[model.FieldMapping, model.Conversion | None]:
    data, table, findings = use.data, context.book.table, context.findings
    if not data.variable:
        message = f"{use.identity} must name the variable of the code; its own name, {data.name!r}, is used."
        findings.report(codes.VARIABLE_ASSUMED, message, use, "Set `variable` in the declaration.")
    way = "to_topic" if use.provides else "from_topic"
    name = package_name(f"{use.function}_{data.name}_{way}", taken).text
    made = conversion(
        name, member.field, data.datatype, member.kind, to_catalogue(data, subject_of(use), findings), table,
        member.written, is_outgoing=use.provides, has_number=bool(member.number), is_named=member.way is not None,
    )  # fmt: skip
    if made is not None:
        taken.add(name)
    return _mapping(use, member, c_definition(data.datatype, table), made), made


def _mapping(use: Side, member: Member, variable_type: str, made: model.Conversion | None) -> model.FieldMapping:
    data, way = use.data, member.way or IDENTITY
    return model.FieldMapping(
        signal=data.name,
        field=member.field,
        number_field=member.number or None,
        field_type=member.written,
        catalogue_factor=None if way == IDENTITY else as_text(way.factor),
        catalogue_offset=None if way == IDENTITY else as_text(way.offset),
        field_units=data.vss_unit or (None if use.path else data.units) or None,
        variable=data.variable or data.name,
        variable_type=variable_type,
        variable_units=data.units or None,
        conversion=made.name if made else None,
        min=data.min,
        max=data.max,
        default=data.default,
        init_value=data.init_value,
        range_error_action=data.range_error_action,
        timeout=timeout_of(use),
        timeout_error=data.timeout_error,
        access=data.access,
        queue_length=use.queue_length,
        external_provider=data.external_provider,
        asil_level=asil_of_side(use),
        vss_path=use.path or None,
    )
