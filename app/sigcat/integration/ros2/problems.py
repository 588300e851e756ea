"""Parts of an Integration JSON that ROS 2 refuses: names, types and texts for rosidl or package.xml."""

import re
from collections.abc import Iterable, Iterator, Mapping
from math import isfinite
from typing import Any

from sigcat.function.document.document import Pointer
from sigcat.function.document.text import Text
from sigcat.integration.agreement import argument_counts
from sigcat.integration.datatypes import BY_VSS
from sigcat.integration.problem import Problem
from sigcat.integration.references import places
from sigcat.integration.ros2 import model
from sigcat.integration.ros2.messages.common_types import ERROR_STATUS, SAFETY_REACTION, STEP
from sigcat.integration.ros2.messages.message_definitions import PRIMITIVES, holds
from sigcat.integration.ros2.names import CONSTANT, FIELD, LONGEST, MESSAGE
from sigcat.integration.ros2.settings import EMAIL, NAMESPACE

_PRIMITIVES = {spelling.ros2 for spelling in BY_VSS.values()}
_TYPE = re.compile(r"(\w+(?:/\w+)?)(\[[0-9]{0,9}\])?", re.ASCII)
_VERSION = re.compile(r"[0-9]{1,9}\.[0-9]{1,9}\.[0-9]{1,9}")
_EXECUTABLE = re.compile(r"[a-z][a-z0-9_]*")
_PLUGIN = re.compile(r"[a-z][a-z0-9_]*::[A-Z][A-Za-z0-9]*")
_TOPIC = re.compile(r"/?[a-z][a-z0-9_]*(?:/[a-z][a-z0-9_]*)*")
_INTERFACE = re.compile(r"[a-z][a-z0-9_]*/(?:msg|srv)/[A-Z][A-Za-z0-9]*")
_PARAMETER_TYPES = {f"{name}{ending}" for name in ("bool", "integer", "double", "string") for ending in ("", "_array")}
_AGAIN = "Integrate the functions again."
_INTEGER = re.compile(r"-?[0-9]{1,20}")


def problems_of(document: model.Ros2Integration) -> Iterator[Problem]:
    """Everything in a document that packages cannot have."""
    for key in ("InterfacePackageList", "NodePackageList"):
        for at, packages in places(document, key):
            if len(packages) != 1:
                yield Problem(at, f"`{key}` must have one package, not {len(packages)}.")
    for at, interfaces in places(document, "InterfacePackageList/*"):
        yield from _package(interfaces, at)
        yield from _interfaces(interfaces, at)
    for at, nodes in places(document, "NodePackageList/*"):
        yield from _package(nodes, at)
        yield from _nodes(nodes, at)
    counts = argument_counts(document.functions or ())
    for at, communication in places(document, "CommunicationList/*"):
        yield from _communication(communication, at, counts)


def _communication(
    communication: model.Communication, at: Pointer, counts: Mapping[str, frozenset[tuple[int, int]]]
) -> Iterator[Problem]:
    for below, topic in places(communication, "ROSTopicList/*", at):
        yield from _is(topic.name, _TOPIC, (*below, "TopicName"), "name of a topic")
        yield from _is(topic.message or "", _INTERFACE, (*below, "MessageType"), "type of a topic")
        yield from _fixed_fields(topic, below)
        if topic.quality is None:
            yield Problem(below, f"The topic {topic.name} must have a `QualityOfService`.")
    for below, service in places(communication, "ROSServiceList/*", at):
        yield from _is(service.name, _TOPIC, (*below, "ServiceName"), "name of a service")
        yield from _is(service.service, _INTERFACE, (*below, "ServiceType"), "type of a service")
        own, known = (len(service.request), len(service.response)), counts.get(service.method)
        if known is not None and own not in known:  # a method that no function has is reported elsewhere
            message = f"{service.name} must have the arguments and results of {service.method}."
            yield Problem(below, message, _AGAIN)


def _fixed_fields(topic: model.RosTopic, at: Pointer) -> Iterator[Problem]:
    for here, fixed in places(topic, "FixedFields/*", at):
        element = PRIMITIVES.get(fixed.field_type)
        value = fixed.value.raw if isinstance(fixed.value, Text) else fixed.value
        if element is None or not holds(element, value):
            message = f"The value of {fixed.field} must be a {fixed.field_type}, not {str(value)[:60]!r}."
            yield Problem((*here, "Value"), message)


def _is(text: str, form: re.Pattern[str], at: Pointer, what: str) -> Iterator[Problem]:
    if not form.fullmatch(text) or len(text) > 3 * LONGEST:
        yield Problem(at, f"The {what} must be one that ROS 2 accepts, not {text[:60]!r}.")


def _names(given: Iterable[tuple[Pointer, str]], form: re.Pattern[str], what: str) -> Iterator[Problem]:
    """Names of a kind, each valid and none twice; names of files do not differ in case alone."""
    seen: set[str] = set()
    for at, name in given:
        yield from _is(name, form, at, f"name of a {what}")
        if name.lower() in seen:
            yield Problem(at, f"The name of a {what} must be given once, not twice: {name[:60]!r}.")
        seen.add(name.lower())


def _package(package: model.Package, at: Pointer) -> Iterator[Problem]:
    yield from _is(package.name, FIELD, (*at, "Name"), "name of a package")
    yield from _is(package.version, _VERSION, (*at, "Version"), "version of a package")
    yield from _is(package.email, EMAIL, (*at, "MaintainerEmail"), "mail address of a maintainer")
    for here, name in places(package, "Dependencies/*", at):
        yield from _is(name, FIELD, here, "name of a package")
    for key, text in (("Maintainer", package.maintainer), ("License", package.license)):
        if not text.raw.strip() or not text.raw.isprintable():
            yield Problem((*at, key), f"{key} of {package.name} must be one line of text: package.xml requires it.")


# -- messages and services ----------------------------------------------------------------------------------------


def _interfaces(package: model.InterfacePackage, at: Pointer) -> Iterator[Problem]:
    names = (*places(package, "Messages/*/Name", at), *places(package, "Services/*/Name", at))
    yield from _names(names, MESSAGE, "message")
    known = {message.name for message in package.messages} | {"builtin_interfaces/Time"} | _PRIMITIVES
    for here, message in places(package, "Messages/*", at):
        yield from _message(message, here, known)
    for here, service in places(package, "Services/*", at):
        for key in ("Request", "Response"):
            yield from _fields(service, key, here, known)
    yield from _common(package, at)


def _common(package: model.InterfacePackage, at: Pointer) -> Iterator[Problem]:
    """Interfaces that the nodes use by the names of their fields."""
    if STEP.name not in {each.name for each in package.services}:
        yield Problem((*at, "Services"), f"{package.name} must have the service {STEP.name}.", _AGAIN)
    known = {each.name: _signature(each) for each in (ERROR_STATUS, SAFETY_REACTION, STEP)}
    for here, each in (*places(package, "Messages/*", at), *places(package, "Services/*", at)):
        found = _signature(each)
        expected = known.get(each.name, found)
        if found != expected:
            message = f"{each.name} must have the fields that every node uses: {', '.join(map(' '.join, expected))}."
            yield Problem(here, message, _AGAIN)


def _signature(interface: model.Message | model.Service) -> tuple[tuple[str, str], ...]:
    """Types and names of all fields and constants."""
    if isinstance(interface, model.Service):
        parts: Iterable[model.MessageField | model.MessageConstant] = (*interface.request, *interface.response)
    else:
        parts = (*interface.constants, *interface.fields)
    return tuple((each.datatype, each.name) for each in parts)


def _message(message: model.Message, at: Pointer, known: set[str]) -> Iterator[Problem]:
    yield from _fields(message, "Fields", at, known)
    yield from _names(places(message, "Constants/*/Name", at), CONSTANT, "constant")
    for here, constant in places(message, "Constants/*", at):
        if not _has_value(constant.datatype, constant.value.raw):
            text = f"The value of {constant.name} must be one of {constant.datatype}, not {constant.value.raw[:60]!r}."
            yield Problem((*here, "Value"), text)


def _has_value(datatype: str, value: str) -> bool:
    if datatype == "string":
        return value.isprintable() and "#" not in value
    return datatype in _PRIMITIVES and bool(_INTEGER.fullmatch(value))


def _fields(interface: model.Message | model.Service, key: str, at: Pointer, known: set[str]) -> Iterator[Problem]:
    yield from _names(places(interface, f"{key}/*/Name", at), FIELD, "field")
    for here, field in places(interface, f"{key}/*", at):
        match = _TYPE.fullmatch(field.datatype)
        if match is None or match[1] not in known:
            message = f"The datatype of {field.name} must be a primitive or a message of the package, not {field.datatype[:60]!r}."
            yield Problem((*here, "DataType"), message)


# -- nodes --------------------------------------------------------------------------------------------------------


def _nodes(package: model.NodePackage, at: Pointer) -> Iterator[Problem]:
    for key, form in (("NodeName", FIELD), ("Executable", _EXECUTABLE), ("Plugin", _PLUGIN)):
        yield from _names(places(package, f"Nodes/*/{key}", at), form, "node")
    if not package.nodes:
        yield Problem((*at, "Nodes"), f"`Nodes` of {package.name} must have a node.")
    for here, node in places(package, "Nodes/*", at):
        yield from _node(node, here)


def _node(node: model.RosNode, at: Pointer) -> Iterator[Problem]:
    if node.namespace != "/":
        yield from _is(node.namespace, NAMESPACE, (*at, "Namespace"), "namespace of a node")
    for key in ("ModeTopics", "ErrorTopics", "SafetyReactionTopics"):
        for here, end in places(node, f"{key}/*", at):
            yield from _is(end.topic, _TOPIC, (*here, "TopicName"), "name of a topic")
            yield from _is(end.message, _INTERFACE, (*here, "MessageType"), "type of a topic")
            yield from _is(end.field, FIELD, (*here, "Field"), "name of a field")
    if node.scheduling_policy in ("fifo", "rr") and all(each.thread_priority is None for each in node.schedules):
        message = f"{node.name} must have a `ThreadPriority` in one of its `Schedules` to run under"
        yield Problem((*at, "SchedulingPolicy"), f"{message} {node.scheduling_policy}.")
    yield from _names(places(node, "Parameters/*/Name", at), FIELD, "parameter")
    for here, parameter in places(node, "Parameters/*", at):
        if parameter.type not in _PARAMETER_TYPES:
            message = f"The type of {parameter.name} must be one of a node parameter, not {parameter.type[:60]!r}."
            yield Problem((*here, "Type"), message)
        elif not _is_default(parameter):
            message = f"The default of {parameter.name} must be of the type {parameter.type}."
            yield Problem((*here, "Default"), message)


def _is_default(parameter: model.RosParameter) -> bool:
    element = parameter.type.removesuffix("_array")
    if element == parameter.type:
        return _is_value(parameter.default, element)
    listed = parameter.default
    return isinstance(listed, list | tuple) and all(_is_value(each, element) for each in listed)


def _is_value(value: Any, element: str) -> bool:
    is_number = isinstance(value, int | float) and not isinstance(value, bool) and isfinite(value)
    if element == "integer":
        return is_number and value == int(value) and -(2**63) <= value < 2**63
    if element == "double":
        return is_number
    return isinstance(value, bool if element == "bool" else Text)
