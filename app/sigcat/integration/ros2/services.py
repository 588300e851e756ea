"""Methods as services: requests and responses in the interface package, servers and clients at the calls."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.function.document.text import Text
from sigcat.function.exchange import Part
from sigcat.function.function_json.methods import Argument, MethodInterface
from sigcat.function.function_json.role import PROVIDER
from sigcat.function.function_json.runnable import Runnable
from sigcat.integration.finding_collector import FindingCollector, Subject
from sigcat.integration.ros2.messages import MessageBook, unresolved
from sigcat.integration.ros2.model import ArgumentMap, Communication, MessageField, RosService
from sigcat.integration.ros2.names import field_name, report_renamed, topic_name
from sigcat.integration.ros2.types import c_definition, field_type
from sigcat.names import camel_case

SERVER = "Server"
CLIENT = "Client"


class _Call(NamedTuple):
    part: Part
    runnable: Runnable
    method: MethodInterface


class _Side(NamedTuple):
    """A request or a response."""

    fields: tuple[MessageField, ...]
    arguments: tuple[ArgumentMap, ...]


def with_services(
    exchanged: Sequence[Communication], parts: Sequence[Part], book: MessageBook,
    findings: FindingCollector,
) -> tuple[Communication, ...]:  # fmt: skip
    """The communications with the services of every call. Calls that exchange nothing else are added."""
    services: dict[tuple[str, str], list[RosService]] = {}
    types: dict[str, tuple[str, _Side, _Side]] = {}
    for call in _calls(parts):
        service = _service(call, types, book, findings)
        if service is not None:
            services.setdefault((call.part.name, call.runnable.name), []).append(service)
    made = []
    for communication in exchanged:
        node = next((topic.node for topic in communication.topics), "") or ""
        own = services.pop((node, communication.runnable), [])
        made.append(communication.model_copy(update={"services": tuple(own)}) if own else communication)
    made.extend(Communication(runnable=name, topics=(), services=tuple(own)) for (_, name), own in services.items())
    return tuple(made)


def _calls(parts: Sequence[Part]) -> Iterator[_Call]:
    for part in parts:
        for runnable in part.component.runnables:
            for contract in runnable.contracts or ():
                yield from (_Call(part, runnable, method) for method in contract.methods or ())


def _service(
    call: _Call,
    types: dict[str, tuple[str, _Side, _Side]],
    book: MessageBook,
    findings: FindingCollector,
) -> RosService | None:
    """Server or client of a method. Providers and users of one name have one service."""
    method = call.method
    interface = Subject(method.name, method)
    request = _side(method.inputs, interface, book, findings)
    response = _side(method.outputs, interface, book, findings)
    if request is None or response is None:
        return None
    success = _success(response)
    if method.name not in types:
        answer = (*response.fields, success)
        types[method.name] = (
            book.add_service(camel_case(method.name), interface, method.description, request.fields, answer),
            request,
            response,
        )
    name, asked, answered = types[method.name]
    if _shape(asked) != _shape(request) or _shape(answered) != _shape(response):
        message = f"The method {method.name} must have the same arguments everywhere, in the same units; those of {call.part.function_name} differ from another function's."
        findings.report(
            codes.MEANINGS_DIFFER, message, interface, "Rename one of them, or use the same datatypes and units."
        )
    return RosService(
        name=topic_name(method.name),
        method=method.name,
        role=SERVER if method.role == PROVIDER else CLIENT,
        service=f"{book.package}/srv/{name}",
        node=call.part.name,
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


def _side(
    arguments: Sequence[Argument], interface: Subject, book: MessageBook, findings: FindingCollector
) -> _Side | None:
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
        fields.append(
            MessageField(
                name=name.text, datatype=written, description=Text(argument.name), units=argument.units or None
            )
        )
        c = c_definition(argument.datatype, book.table)
        maps.append(ArgumentMap(name=argument.name, field=name.text, field_type=written, variable_type=c))
    return _Side(tuple(fields), tuple(maps))
