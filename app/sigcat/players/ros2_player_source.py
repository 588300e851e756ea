"""The player of ROS 2: a program in C++ whose topics are those of an Integration JSON, seen from the other end."""

import json
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

from sigcat.adapter.autosar_adaptive.application.player_source import CPP as CELLS
from sigcat.adapter.files import GeneratedFile, shipped
from sigcat.adapter.ros2.cpp.names import header_of
from sigcat.adapter.ros2.plan import InterfaceType
from sigcat.function.document.text_filters import c_header, c_string

_OWN = Path(__file__).with_name("ros2_player")
_SHARED = ("cell.cpp", "cell.h", "times.h", "trace.cpp", "trace.h")
"""Files that the player of AUTOSAR has, too: they know of no platform."""


class _Field(NamedTuple):
    """A field of a message, and what it is called in a recording."""

    name: str
    field: str
    datatype: str
    number_field: str | None = None
    symbols: tuple[tuple[str, int], ...] = ()
    """Texts of a recording, and the numbers that the message has for them."""
    factor: str = ""
    """In a recording is value of the field × factor + offset; empty if both are the same."""
    offset: str = ""

    @property
    def is_text(self) -> bool:
        """Whether it is a text, or an array of them."""
        return self.datatype.startswith("string")

    @property
    def is_array(self) -> bool:
        """Whether it has elements."""
        return self.datatype.endswith("]")


class _Topic(NamedTuple):
    """One end of a topic, of a node."""

    name: str
    message: str
    node: int
    role: str
    fields: tuple[_Field, ...]
    is_reliable: bool
    keeps: bool
    depth: int


def player_files(document: Mapping[str, Any]) -> tuple[GeneratedFile, ...]:
    """A CMake project `player`."""
    interfaces = document["InterfacePackageList"][0]["Name"]
    shared = (GeneratedFile(f"player/{name}", (CELLS / name).read_bytes()) for name in _SHARED)
    own = [file._replace(name=f"{'' if '/' in file.name else 'player/'}{file.name}") for file in shipped(_OWN)]
    return (
        *shared,
        *own,
        _file(
            "player/step_service.h",
            _STEP_SERVICE.format(interfaces=interfaces, header=c_string(f"{interfaces}/srv/step.hpp")),
        ),
        _file("player/topics.cpp", _topics_source(document)),
        _file("CMakeLists.txt", _cmake(document, interfaces)),
    )


def _cmake(document: Mapping[str, Any], interfaces: str) -> str:
    others = sorted({topic.message.partition("/")[0] for topic in _topics(document)} - {interfaces})
    return _CMAKE.format(
        interfaces=interfaces,
        found="".join(f"find_package({each} REQUIRED)\n" for each in others),
        targets="".join(f" ${{{each}_TARGETS}}" for each in others),
    )


def _file(name: str, text: str) -> GeneratedFile:
    return GeneratedFile(name, text.encode())


# -- what the document says ---------------------------------------------------------------------------------------


def _nodes(document: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    return [node for package in document["NodePackageList"] for node in package["Nodes"]]


def _topics(document: Mapping[str, Any]) -> Iterator[_Topic]:
    numbers = {node["NodeName"]: number for number, node in enumerate(_nodes(document))}
    for communication in document["CommunicationList"]:
        for topic in communication["ROSTopicList"]:
            fields = tuple(each for data in topic["DataMappingList"] for each in _fields(data))
            yield _topic(topic, numbers[topic["NodeName"]], fields)
    messages = _messages(document)
    for node in _nodes(document):
        for topic in [*node["ErrorTopics"], *node["SafetyReactionTopics"], *node["ModeTopics"]]:
            constants = tuple(
                (each["Name"], int(each["Value"])) for each in messages[topic["MessageType"]]["Constants"]
            )
            field = _Field(topic["InterfaceName"], topic["Field"], "uint8", symbols=constants)
            yield _topic(topic, numbers[node["NodeName"]], (field,))


def _fields(data: Mapping[str, Any]) -> Iterator[_Field]:
    conversions = {each["Name"]: each for each in data["ConversionAPI"] or ()}
    for each in data["FieldList"]:
        symbols = conversions.get(each.get("Conversion"), {}).get("Symbols") or ()
        numbers = tuple((symbol["Text"], symbol["Number"]) for symbol in symbols if "Number" in symbol)
        factor, offset = (_cpp(each.get(f"Catalogue{key}")) for key in ("Factor", "Offset"))
        yield _Field(
            each["VssPath"],
            each["Field"],
            each["FieldDataType"],
            each.get("NumberField"),
            numbers,
            factor,
            offset or "0.0",
        )


def _cpp(number: str | None) -> str:
    """A number of the document, `5/18`, as C++ writes it."""
    return repr(float(Fraction(number))) if number else ""


def _topic(topic: Mapping[str, Any], node: int, fields: tuple[_Field, ...]) -> _Topic:
    quality = topic["QualityOfService"]
    return _Topic(
        topic["TopicName"], topic["MessageType"], node, topic["Role"], fields,
        quality["Reliability"] == "reliable", quality["Durability"] == "transient_local", quality["Depth"],
    )  # fmt: skip


# -- what is written ----------------------------------------------------------------------------------------------


def _topics_source(document: Mapping[str, Any]) -> str:
    topics = list(_topics(document))
    takers: defaultdict[str, set[int]] = defaultdict(set)
    for topic in topics:
        if topic.role == "Subscription":
            takers[topic.name].add(topic.node)
    heard = _joined(topic for topic in topics if topic.role == "Publisher")
    given = _joined(topic for topic in topics if topic.role == "Subscription" and topic.name not in heard)
    parts = [
        *(_offered(topic, takers[topic.name]) for topic in given.values()),
        *(_heard(topic, takers[topic.name]) for topic in heard.values()),
    ]
    types = sorted({topic.message for topic in (*heard.values(), *given.values())})
    return _TOPICS.format(
        includes="\n".join(f"#include {c_header(header_of(InterfaceType(*each.split('/'))))}" for each in types),
        structs="".join(_structs(document)),
        nodes=", ".join(c_string(node["NodeName"]) for node in _nodes(document)),
        functions=", ".join(f"{{{c_string(node['FunctionName'])}, {n}}}" for n, node in enumerate(_nodes(document))),
        cycles=", ".join(f"{{{period}U, {offset}U}}" for period, offset in _cycles(document)),
        events="true" if any(each.get("Topics") for each in _schedules(document)) else "false",
        connections="\n".join(parts),
    )


def _joined(topics: Iterable[_Topic]) -> Mapping[str, _Topic]:
    """A topic once, with the fields of all its ends."""
    found: dict[str, _Topic] = {}
    for topic in topics:
        known = found.get(topic.name)
        fields = tuple(dict.fromkeys((*(known.fields if known else ()), *topic.fields)))
        found[topic.name] = topic._replace(fields=fields)
    return found


def _messages(document: Mapping[str, Any]) -> Mapping[str, Mapping[str, Any]]:
    return {
        f"{package['Name']}/msg/{message['Name']}": message
        for package in document["InterfacePackageList"]
        for message in package["Messages"]
    }


def _schedules(document: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    return [each for node in _nodes(document) for each in node["Schedules"]]


def _cycles(document: Mapping[str, Any]) -> list[tuple[int, int]]:
    return [
        (round(each["Period"] * 1e6), round((each.get("Offset") or 0) * 1e6))
        for each in _schedules(document) if each.get("Period")
    ]  # fmt: skip


def _offered(topic: _Topic, takers: Iterable[int]) -> str:
    nodes = ", ".join(map(str, sorted(takers)))
    quality = f"Quality(true, {_bool(topic.keeps)}, {topic.depth})"
    offer = f"auto& out = ports.Offer<{_type(topic.message)}>({c_string(topic.name)}, {quality}, {{{nodes}}});"
    columns = [
        f"        ports.Column({c_string(each.name)}, out, [](auto& message, const Item& item) {{ {_filled(each)} }});"
        for each in topic.fields
    ]
    return "\n".join(["    {", f"        {offer}", *columns, "    }"])


def _filled(field: _Field) -> str:
    place = f"message.{field.field}"
    if field.factor:
        number = f"(Read<double>(item) - {field.offset}) / {field.factor}"
        return f"{place} = static_cast<std::decay_t<decltype({place})>>({number});"
    if not field.symbols or field.is_array:
        return f"{place} = Read<std::decay_t<decltype({place})>>(item);"
    if not field.is_text:
        return _numbered(place, field)
    number = f" {_numbered(f'message.{field.number_field}', field)}" if field.number_field else ""
    return f"{place} = item.text;{number}"


def _numbered(place: str, field: _Field) -> str:
    return f"{place} = static_cast<std::decay_t<decltype({place})>>(NumberOf(item.text, {_symbols(field)}));"


def _heard(topic: _Topic, takers: Iterable[int]) -> str:
    nodes = ", ".join(map(str, sorted(takers)))
    values = ", ".join(f"{{{c_string(each.name)}, {_told(each)}}}" for each in topic.fields)
    quality = f"Quality({_bool(topic.is_reliable)}, {_bool(topic.keeps)}, {topic.depth})"
    return (
        f"    ports.Hear<{_type(topic.message)}>({c_string(topic.name)}, {quality}, {topic.node}, {{{nodes}}}, "
        f"[](const auto& message) {{\n        return Values{{{values}}};\n    }});"
    )


def _told(field: _Field) -> str:
    place = f"message.{field.field}"
    if field.factor:
        return f"Text(static_cast<double>({place}) * {field.factor} + {field.offset})"
    if field.symbols and not field.is_text and not field.is_array:
        return f"SymbolOf({place}, {_symbols(field)})"
    return f"Text({place})"


def _symbols(field: _Field) -> str:
    names = ", ".join(f"{{{c_string(text)}, {number}}}" for text, number in field.symbols)
    return f"{{{names}}}"


def _structs(document: Mapping[str, Any]) -> Iterator[str]:
    """Cells of messages that are members of others, inner ones first."""
    messages = _messages(document)
    members = _members(document, messages)
    for name in _nested(document, messages):
        fields = [each["Name"] for each in messages[name]["Fields"]]
        both = list(zip(members.get(name, fields), fields, strict=True))
        texts = " + ".join(
            c_string(f"{', ' if number else ''}{json.dumps(member)}: ") + f" + player::Text(value.{field})"
            for number, (member, field) in enumerate(both)
        )
        reads = "".join(
            f"        value.{field} = player::Read<std::decay_t<decltype(value.{field})>>(item.At({c_string(member)}));\n"
            for member, field in both
        )
        yield _STRUCT.format(type=_type(name), reads=reads, texts=texts)


def _members(document: Mapping[str, Any], messages: Mapping[str, Mapping[str, Any]]) -> Mapping[str, Sequence[str]]:
    """Return the names of members in a recording: those of the catalogue, not those of ROS 2."""
    types = {each["typeRef"]: each["cDef"] for each in document["Datatypes"]}
    structs = {each["cDef"]: each["Fields"] for each in document["Datatypes"] if each.get("Fields")}
    found: dict[str, Sequence[str]] = {}

    def visit(message: str, c_type: str) -> None:
        members = structs.get(_element(c_type))
        if message not in messages or members is None or message in found:
            return
        found[message] = [each["Name"] for each in members]
        for field, member in zip(messages[message]["Fields"], members, strict=True):
            visit(_message_of(field["DataType"], document), types[member["Datatype"]])

    for communication in document["CommunicationList"]:
        for topic in communication["ROSTopicList"]:
            for field in (each for data in topic["DataMappingList"] for each in data["FieldList"]):
                visit(_message_of(field["FieldDataType"], document), field["VariableDataType"])
    return found


def _element(datatype: str) -> str:
    """`Point[4]` → `Point`."""
    return re.sub(r"\[.*\]$", "", datatype)


def _nested(document: Mapping[str, Any], messages: Mapping[str, Mapping[str, Any]]) -> list[str]:
    found: dict[str, None] = {}

    def visit(name: str) -> None:
        for each in messages[name]["Fields"]:
            inner = _message_of(each["DataType"], document)
            if inner in messages and inner not in found:
                visit(inner)
                found[inner] = None

    for name in messages:
        visit(name)
    return list(found)


def _message_of(datatype: str, document: Mapping[str, Any]) -> str:
    package, _, name = _element(datatype).rpartition("/")
    return f"{package.removesuffix('/msg') or document['InterfacePackageList'][0]['Name']}/msg/{name}"


def _type(message: str) -> str:
    return message.replace("/", "::")


def _bool(value: bool) -> str:
    return "true" if value else "false"


_TOPICS = """// Topics of the player. Generated by sigcat.

#include "player/ports.h"

{includes}

namespace player {{

using Values = std::vector<std::pair<const char*, std::string>>;

{structs}const std::vector<std::string>& Nodes() {{
    static const std::vector<std::string> names{{{nodes}}};
    return names;
}}

const std::map<std::string, std::size_t>& Functions() {{
    static const std::map<std::string, std::size_t> numbers{{{functions}}};
    return numbers;
}}

const std::vector<std::pair<std::uint64_t, std::uint64_t>>& Cycles() {{
    static const std::vector<std::pair<std::uint64_t, std::uint64_t>> cycles{{{cycles}}};
    return cycles;
}}

bool HasEvents() {{ return {events}; }}

void Connect(Ports& ports) {{
{connections}
}}

}}  // namespace player
"""
_STRUCT = """template <>
struct Cell<{type}, void> final {{
    static {type} Read(const Item& item) {{
        {type} value;
{reads}        return value;
    }}
    static std::string Text(const {type}& value) {{ return std::string("{{") + {texts} + "}}"; }}
}};

"""
_STEP_SERVICE = """#ifndef PLAYER_STEP_SERVICE_H
#define PLAYER_STEP_SERVICE_H

#include {header}

namespace player {{

using StepService = {interfaces}::srv::Step;

}}  // namespace player

#endif  // PLAYER_STEP_SERVICE_H
"""
_CMAKE = """cmake_minimum_required(VERSION 3.16)
project(player LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
find_package(ament_cmake REQUIRED)
{found}find_package(lifecycle_msgs REQUIRED)
find_package(rclcpp REQUIRED)
find_package({interfaces} REQUIRED)
find_package(Threads REQUIRED)
add_executable(player player/cell.cpp player/main.cpp player/ports.cpp player/steps.cpp player/topics.cpp player/trace.cpp)
set_target_properties(player PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 20)
target_compile_options(player PRIVATE -O1)
target_include_directories(player PRIVATE "${{CMAKE_CURRENT_SOURCE_DIR}}")
target_link_libraries(player PRIVATE ${{{interfaces}_TARGETS}}{targets} ${{lifecycle_msgs_TARGETS}} rclcpp::rclcpp Threads::Threads)
install(TARGETS player DESTINATION lib/player)
"""
