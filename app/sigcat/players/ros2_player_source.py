"""The player of ROS 2: a program in C++ whose topics are those of an Integration JSON, seen from the other end."""

import json
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

from sigcat.adapter.autosar_adaptive.application.player.player_source import CPP as CELLS
from sigcat.adapter.files import GeneratedFile, shipped
from sigcat.adapter.ros2.cpp.names import header_of
from sigcat.adapter.ros2.plan import InterfaceType
from sigcat.adapter.templates import rendered

_OWN = Path(__file__).with_name("ros2_player")
_SHARED = ("cell.h", "times.h", "trace.cpp", "trace.h")
"""Files that the player of AUTOSAR has, too: they know of no platform."""

_Symbols = Sequence[tuple[str, int]]
"""Names of an enumeration, and the numbers that the message has for them."""


class _Field(NamedTuple):
    """A field of a message, and what it is called in a recording."""

    name: str
    field: str
    datatype: str
    number_field: str | None = None
    symbols: _Symbols = ()
    factor: str = ""
    """In a recording is value of the field × factor + offset; empty if both are the same."""
    offset: str = ""

    @property
    def is_enumeration(self) -> bool:
        """Whether its values have names."""
        return bool(self.symbols) or self.datatype.startswith("string")


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
    takers: Sequence[int] = ()
    """Numbers of all nodes that subscribe to it."""

    @property
    def type(self) -> str:
        """Its message in C++."""
        return _type(self.message)


class _Member(NamedTuple):
    """A member of a message, with its name in a recording, and the text before its value there."""

    field: str
    name: str
    key: str
    symbols: _Symbols


class _Struct(NamedTuple):
    """A message that is a member of others."""

    type: str
    members: Sequence[_Member]


class _Topics(NamedTuple):
    """Plan of `topics.cpp`; a cycle is its period and offset, in ns."""

    headers: Sequence[str]
    structs: Sequence[_Struct]
    nodes: Sequence[str]
    functions: Sequence[str]
    """Each of the node with its number."""
    cycles: Sequence[tuple[int, int]]
    has_events: bool
    offered: Sequence[_Topic]
    heard: Sequence[_Topic]


def player_files(document: Mapping[str, Any]) -> tuple[GeneratedFile, ...]:
    """A CMake project `player`."""
    interfaces = document["InterfacePackageList"][0]["Name"]
    shared = (GeneratedFile(f"player/{name}", (CELLS / name).read_bytes()) for name in _SHARED)
    own = [file._replace(name=f"{'' if '/' in file.name else 'player/'}{file.name}") for file in shipped(_OWN)]
    others = {topic.message.partition("/")[0] for topic in _topics(document)} - {interfaces}
    project = {"interfaces": interfaces, "others": sorted(others)}
    return (
        *shared,
        *own,
        _file("player/step_service.h", rendered("players/step_service.h.j2", **project)),
        _file("player/topics.cpp", rendered("players/topics.cpp.j2", **_plan(document)._asdict())),
        _file("CMakeLists.txt", rendered("players/CMakeLists.txt.j2", **project)),
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


def _plan(document: Mapping[str, Any]) -> _Topics:
    topics = list(_topics(document))
    takers: defaultdict[str, set[int]] = defaultdict(set)
    for topic in topics:
        if topic.role == "Subscription":
            takers[topic.name].add(topic.node)
    heard = _joined((topic for topic in topics if topic.role == "Publisher"), takers)
    given = _joined((topic for topic in topics if topic.role == "Subscription" and topic.name not in heard), takers)
    types = sorted({topic.message for topic in (*heard.values(), *given.values())})
    return _Topics(
        [header_of(InterfaceType(*each.split("/"))) for each in types],
        list(_structs(document)),
        [node["NodeName"] for node in _nodes(document)],
        [node["FunctionName"] for node in _nodes(document)],
        _cycles(document),
        any(each.get("Topics") for each in _schedules(document)),
        list(given.values()),
        list(heard.values()),
    )


def _joined(topics: Iterable[_Topic], takers: Mapping[str, set[int]]) -> Mapping[str, _Topic]:
    """A topic once, with the fields of those of its ends, and the nodes that subscribe to it."""
    found: dict[str, _Topic] = {}
    for topic in topics:
        known = found.get(topic.name)
        fields = tuple(dict.fromkeys((*(known.fields if known else ()), *topic.fields)))
        found[topic.name] = topic._replace(fields=fields, takers=sorted(takers.get(topic.name, ())))
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


def _structs(document: Mapping[str, Any]) -> Iterator[_Struct]:
    """Messages that are members of others, inner ones first."""
    messages = _messages(document)
    members = _members(document, messages)
    for message in _nested(document, messages):
        fields = [each["Name"] for each in messages[message]["Fields"]]
        named = members.get(message) or [(field, ()) for field in fields]
        keyed = [
            _Member(field, name, f"{',' if number else ''}{json.dumps(name)}:", symbols)
            for number, (field, (name, symbols)) in enumerate(zip(fields, named, strict=True))
        ]
        yield _Struct(_type(message), keyed)


def _members(
    document: Mapping[str, Any], messages: Mapping[str, Mapping[str, Any]]
) -> Mapping[str, Sequence[tuple[str, _Symbols]]]:
    """Return the names of members in a recording, with those of their values: of the catalogue, not of ROS 2."""
    types = {each["typeRef"]: each for each in document["Datatypes"]}
    structs = {each["cDef"]: each["Fields"] for each in document["Datatypes"] if each.get("Fields")}
    found: dict[str, Sequence[tuple[str, _Symbols]]] = {}

    def visit(message: str, c_type: str) -> None:
        members = structs.get(_element(c_type))
        if message not in messages or members is None or message in found:
            return
        found[message] = [(each["Name"], _symbols(types[each["Datatype"]], types)) for each in members]
        for field, member in zip(messages[message]["Fields"], members, strict=True):
            visit(_message_of(field["DataType"], document), types[member["Datatype"]]["cDef"])

    for communication in document["CommunicationList"]:
        for topic in communication["ROSTopicList"]:
            for field in (each for data in topic["DataMappingList"] for each in data["FieldList"]):
                visit(_message_of(field["FieldDataType"], document), field["VariableDataType"])
    return found


def _symbols(datatype: Mapping[str, Any], types: Mapping[str, Mapping[str, Any]]) -> _Symbols:
    """Names and numbers of an enumeration, or of the elements of an array."""
    element = types.get(datatype.get("ElementType", ""), datatype)
    return [(each["Symbol"], each["Value"]) for each in element.get("Symbols") or ()]


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
