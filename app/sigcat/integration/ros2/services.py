"""Methods as services: requests and responses in the interface package, servers and clients at the calls."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.function.document.text import Text
from sigcat.function.exchange import Side
from sigcat.function.function_json.interfaces.methods import Argument, MethodInterface
from sigcat.integration.finding_collector import Subject, subject_of
from sigcat.integration.ros2.context import Context
from sigcat.integration.ros2.messages.field_types import c_definition, field_type
from sigcat.integration.ros2.messages.made_messages import unresolved
from sigcat.integration.ros2.model import ArgumentMap, Communication, MessageField, RosService
from sigcat.integration.ros2.names import field_name, report_renamed, topic_name
from sigcat.names import camel_case

SERVER = "Server"
CLIENT = "Client"


class _Side(NamedTuple):
    """A request or a response."""

    fields: tuple[MessageField, ...]
    arguments: tuple[ArgumentMap, ...]


def with_services(exchanged: Sequence[Communication], context: Context) -> tuple[Communication, ...]:
    """The communications with the services of every call. Calls that exchange nothing else are added."""
    services: dict[tuple[str, str], list[RosService]] = {}
    types: dict[str, tuple[str, _Side, _Side]] = {}
    for use in context.exchange.sides:
        service = _service(use, types, context) if use.kind == "method" else None
        if service is not None:
            services.setdefault((use.part.name, use.runnable.name), []).append(service)
    made = []
    for communication in exchanged:
        node = next((topic.node for topic in communication.topics), "") or ""
        own = services.pop((node, communication.runnable), [])
        made.append(communication.model_copy(update={"services": tuple(own)}) if own else communication)
    made.extend(Communication(runnable=name, topics=(), services=tuple(own)) for (_, name), own in services.items())
    return tuple(made)


def _service(use: Side, types: dict[str, tuple[str, _Side, _Side]], context: Context) -> RosService | None:
    """Server or client of a method. Providers and users of one name have one service."""
    method, interface = use.interface, subject_of(use)
    assert isinstance(method, MethodInterface)
    request = _side(method.inputs, interface, context)
    response = _side(method.outputs, interface, context)
    if request is None or response is None:
        return None
    success = _success(response)
    if method.name not in types:
        source, answer = camel_case(method.name), (*response.fields, success)
        made = context.book.add_service(source, interface, method.description, request.fields, answer)
        types[method.name] = made, request, response
    name, asked, answered = types[method.name]
    if _shape(asked) != _shape(request) or _shape(answered) != _shape(response):
        message = f"The method {method.name} must have the same arguments everywhere, in the same units; those of {use.function} differ from another function's."
        fix = "Rename one of them, or use the same datatypes and units."
        context.findings.report(codes.MEANINGS_DIFFER, message, interface, fix)
    return RosService(
        name=topic_name(method.name),
        method=method.name,
        role=SERVER if use.provides else CLIENT,
        service=f"{context.book.package}/srv/{name}",
        node=use.part.name,
        request=request.arguments,
        response=response.arguments,
        success=success.name,
    )


def _success(response: _Side) -> MessageField:
    """The field that tells whether the function has answered: a mode may exclude its call."""
    name = field_name("success", {field.name for field in response.fields}).text
    return MessageField(name=name, datatype="bool", description=Text("Whether the function has answered."))


def _shape(side: _Side) -> list[tuple[str, str, str | None]]:
    return [(field.name, field.datatype, field.units) for field in side.fields]


def _side(arguments: Sequence[Argument], interface: Subject, context: Context) -> _Side | None:
    book, findings = context.book, context.findings
    fields: list[MessageField] = []
    maps: list[ArgumentMap] = []
    for argument in arguments:
        kind = field_type(argument.datatype, None, book.table)
        written = book.written(kind, interface) if kind else None
        if kind is None:
            unresolved(findings, interface, argument.datatype)
        if written is None:
            return None
        name = field_name(argument.name, {field.name for field in fields})
        report_renamed(name, argument.name, interface, findings)
        meaning, units = Text(argument.name), argument.units or None
        fields.append(MessageField(name=name.text, datatype=written, description=meaning, units=units))
        c = c_definition(argument.datatype, book.table)
        maps.append(ArgumentMap(name=argument.name, field=name.text, field_type=written, variable_type=c))
    return _Side(tuple(fields), tuple(maps))
