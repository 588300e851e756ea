"""Kinds of files, decided by their names and first bytes. Nothing is parsed.

Which of several vspec files is the root of a tree, which an overlay and which a part of a tree depends on the files
beside them: that is `sigcat.rules.linting.discovery`.
"""

import os
import re
from collections.abc import Collection, Iterator
from typing import Literal, NamedTuple

from sigcat.limits import RECOGNITION_BYTES

FileKind = Literal["vspec", "units", "quantities", "function", "function json", "integration json", "rules", "unknown"]
"""`vspec` is a tree, an overlay, struct types, or a part of one; `function` is a function.yaml."""

ROOT_NAME = "VehicleSignalSpecification.vspec"
SHIPPED_ROOT = "Vehicle"
"""The root of the shipped tree, which an overlay without its own tree is made for."""
TYPES_NAME = "VehicleDataTypes.vspec"
"""The file that the Makefile of VSS passes as `--types`: it includes the structs and holds none itself."""
UNIT_NAMES = ("units.yaml", "units.yml")
QUANTITY_NAMES = ("quantities.yaml", "quantities.yml")
OVERLAY_FOLDERS = frozenset(("overlay", "overlays"))

C_HEADERS = (".h", ".hh", ".hpp", ".hxx")
C_SOURCES = (".c", ".cc", ".cpp", ".cxx")
"""Endings of code in C and C++."""
TREE_ENDINGS = (".vspec", ".yaml", ".yml")
"""Endings of the names of trees and overlays; an include without one means the first."""
ENDINGS = (*TREE_ENDINGS, ".json")


RUN_COLUMNS = ("time", "call")
"""First columns of a run, as `sigcat simulate` writes it; a trace does not have the second one."""


class DocumentKind(NamedTuple):
    """One kind of the documents that are made for functions, or of functions."""

    kind: FileKind
    keys: frozenset[str]
    """Keys that each such document has, outermost."""
    title: str
    """In sentences: `a function.yaml`."""
    use: str
    """The command that accepts it, as an instruction."""
    platform: str = ""
    """Name of the platform whose Integration JSON it is; empty for other documents."""


FUNCTION_JSON = DocumentKind(
    "function json",
    frozenset(("FunctionInfo",)),
    "Function JSON",
    "Run `sigcat function validate` or `sigcat integrate` on it.",
)
FUNCTION_YAML = DocumentKind(
    "function",
    frozenset(("function", "components")),
    "a function.yaml",
    "Run `sigcat function build` or `sigcat integrate` on it.",
)
INTEGRATION_JSON = (
    DocumentKind(
        "integration json",
        frozenset(("FunctionInformation",)),
        "Integration JSON for AUTOSAR adaptive",
        "Run `sigcat generate arxml` on it.",
        "autosar-adaptive",
    ),
    DocumentKind(
        "integration json",
        frozenset(("ApplicationInformation",)),
        "Integration JSON for AUTOSAR Classic",
        "Run `sigcat generate autosar-classic` on it.",
        "autosar-classic",
    ),
    DocumentKind(
        "integration json",
        frozenset(("FmiInformation",)),
        "Integration JSON for FMI",
        "Run `sigcat generate fmi` on it.",
        "fmi",
    ),
    DocumentKind(
        "integration json",
        FUNCTION_JSON.keys | {"CommunicationList"},
        "Integration JSON for ROS 2",
        "For ARXML, run `sigcat integrate autosar-adaptive` or `sigcat integrate autosar-classic` on the functions.",
        "ros2",
    ),
)
DOCUMENT_KINDS = (*INTEGRATION_JSON, FUNCTION_JSON, FUNCTION_YAML)
"""The more special first: Integration JSON for ROS 2 has the keys of Function JSON too."""

_FUNCTION_KEYS = (*(f'"{key}"'.encode() for key in FUNCTION_JSON.keys), b'"InterfaceData"', b'"SchedulingInfo"')
_INTEGRATION_KEYS = tuple(f'"{key}"'.encode() for each in INTEGRATION_JSON for key in each.keys - FUNCTION_JSON.keys)
_JSON_TOKEN = rb"""(?s)"(?:[^"\\]++|\\.?)*+"?|[][{}]"""
_FOREIGN_WORDS = (b"openapi", b"swagger", b"asyncapi", b"$schema")
_FOREIGN = (
    rb"""(?:^|\A\s*\{\s*)["']?(?:(?:openapi|swagger|asyncapi)["']?[ \t]*:[ \t]*["']?[0-9]|\$schema["']?[ \t]*:)"""
)
"""Descriptions of APIs, and JSON Schemas: examples in them are not documents."""
_FUNCTION_NAME = rb"""^["']?[Ff]unction["']?:[ \t]+[^\s#{&!]"""
_FUNCTION_PARTS = tuple(f"^{key}:".encode() for key in FUNCTION_YAML.keys)
_RULE_FIELDS = (b"check", b"severity", b"why", b"title", b"source", b"name")
_OWN_RULE_FIELDS = _RULE_FIELDS[:3]
"""Fields of rules that documents of other kinds rarely have."""
_LEAST_RULE_FIELDS, _LEAST_OWN_RULE_FIELDS = 3, 2
"""Fields by which a file is one of rules, whatever its keys are."""
_RULE_CODE = rb"""^["']?[A-Z]+[0-9]{3}["']?:"""
_FIELD = rb"""(?:^[ \t]+|[{,-][ \t]*)["']?%s["']?[ \t]*:[ \t]*\S"""
_DOTTED_NAME = rb"""^["']?[A-Za-z]\w*\."""
_TYPE = rb"""(?:^[ \t]+|[{,][ \t]*)["']?type["']?[ \t]*:[ \t]*["']?"""
_NODE = _TYPE + rb"(branch|sensor|actuator|attribute|struct|property)\b"
_STRUCT = _TYPE + rb"struct\b"
_SIGNAL = _TYPE + rb"(sensor|actuator|attribute)\b"
_BRANCH = _TYPE + rb"branch\b"
_TOP_LEVEL_NODE = rb"""^["']?([A-Za-z]\w*)["']?:[ \t]*(\n|\r|\{|#)"""
_FIRST_NAME = rb"""^["']?([A-Za-z]\w*)(?=["']?:|\.)"""


def file_kind(data: bytes, name: str = "") -> FileKind:
    """The kind of a file; without a name, of a text. JSON and YAML are distinguished by the ending, if there is one."""
    ending = ending_of(name)
    if ending == ".vspec":
        return "vspec"
    data = data[:RECOGNITION_BYTES]
    if ending == ".json" or _is_json_text(data):
        kind = _kind_of_json(data)
        if kind != "unknown" or ending == ".json":
            return kind
    return _kind_of_yaml(data, os.path.basename(name))  # noqa: PTH119 — of every file of a folder


def document_kind(keys: Collection[str]) -> DocumentKind | None:
    """The kind of a document with these keys, if it has to do with functions."""
    return next((each for each in DOCUMENT_KINDS if each.keys.issubset(keys)), None)


def holds_function(data: bytes) -> bool:
    """Whether a text is a function or what was derived from one, whatever it is called: quick for any text."""
    data = data[:RECOGNITION_BYTES]
    return _declares_function(data) or (_is_json_text(data) and _kind_of_json(data) != "unknown")


def is_json(data: bytes, name: str) -> bool:
    """Whether a function file is read as JSON: it is called so, or it is Function JSON under another name."""
    return ending_of(name) == ".json" or file_kind(data, name) in ("function json", "integration json")


def ending_of(name: str) -> str:
    """The ending of a file's name in lower case, dot included."""
    return os.path.splitext(name)[1].lower()  # noqa: PTH122 — of every file of a folder


def holds_only_structs(data: bytes) -> bool:
    """Whether a vspec file has struct types and no signals."""
    return b"struct" in data and _holds(_STRUCT, data) and not holds_signal(data)


def holds_signal(data: bytes) -> bool:
    """Whether a vspec file has a sensor, an actuator or an attribute."""
    return _holds(_SIGNAL, data)


def holds_top_level_node(data: bytes) -> bool:
    """Whether a vspec file has a node without a branch above it, as the root of a tree is."""
    return _holds(_TOP_LEVEL_NODE, data)


def root_name(data: bytes) -> str:
    """The name that the first path of a vspec file begins with: of a tree that of its root, of an overlay that of its tree's."""
    match = re.search(_FIRST_NAME, data, re.MULTILINE)
    return match[1].decode() if match else ""


def first_names(data: bytes) -> frozenset[bytes]:
    """The names that the paths of a vspec file begin with: one in a whole tree, several in a part of one."""
    return frozenset(re.findall(_FIRST_NAME, data, re.MULTILINE))


def root_branch(data: bytes) -> str:
    """The name of the first node of a vspec file, if it is a branch without one above it; empty if it is not."""
    match = re.search(_TOP_LEVEL_NODE, data, re.MULTILINE)
    if match is None or match[1].decode() != root_name(data):
        return ""
    after = re.search(rb"\n[^\s#]", data[match.start() :])
    block = data[match.start() : match.start() + after.start() if after else len(data)]
    return match[1].decode() if _holds(_BRANCH, block) else ""


def _is_json_text(data: bytes) -> bool:
    return data.removeprefix(b"\xef\xbb\xbf").lstrip().startswith(b"{")


def _kind_of_json(data: bytes) -> FileKind:
    wanted = {key for key in (*_INTEGRATION_KEYS, *_FUNCTION_KEYS) if key in data}
    found = wanted.intersection(_outermost_texts(data)) if wanted else set()
    if found.intersection(_INTEGRATION_KEYS):
        return "integration json"
    return "function json" if found else "unknown"


def _outermost_texts(data: bytes) -> Iterator[bytes]:
    """Keys and texts of the outermost mapping of JSON, in quotation marks. Schemas and OpenAPI have names of our keys further in."""
    depth = 0
    for match in re.finditer(_JSON_TOKEN, data):
        token = match[0]
        if token in b"{[":
            depth += 1
        elif token in b"}]":
            depth -= 1
        elif depth == 1:
            yield token


def _kind_of_yaml(data: bytes, base: str) -> FileKind:
    if _holds_rules(data):
        return "rules"
    if base in UNIT_NAMES:
        return "units"
    if base in QUANTITY_NAMES:
        return "quantities"
    if _is_function_name(base):
        return "function"
    return _kind_of_unnamed_yaml(data)


def _holds_rules(data: bytes) -> bool:
    """Whether a file has records of rules: a code with some of their fields, or most of their fields below another key."""
    if not any(field in data for field in _OWN_RULE_FIELDS):
        return False
    own = [field for field in _OWN_RULE_FIELDS if _holds(_FIELD % field, data)]
    fields = [field for field in _RULE_FIELDS if _holds(_FIELD % field, data)]
    if own and len(fields) > 1 and _holds(_RULE_CODE, data):
        return True
    is_alike = len(own) >= _LEAST_OWN_RULE_FIELDS and len(fields) >= _LEAST_RULE_FIELDS
    return is_alike and not _holds(_DOTTED_NAME, data)


def _kind_of_unnamed_yaml(data: bytes) -> FileKind:
    if any(word in data for word in _FOREIGN_WORDS) and _holds(_FOREIGN, data):
        return "unknown"
    if _declares_function(data):
        return "function"
    return "vspec" if b"type" in data and _holds(_NODE, data) else "unknown"


def _is_function_name(base: str) -> bool:
    stem, ending = os.path.splitext(base)  # noqa: PTH122 — see above
    return ending.lower() in TREE_ENDINGS and (stem == "function" or stem.endswith(".function"))


def _declares_function(data: bytes) -> bool:
    """`function:` with a name behind it, which no node of a tree has, or the two keys that every function.yaml has."""
    if b"unction" not in data:
        return False
    return _holds(_FUNCTION_NAME, data) or all(_holds(pattern, data) for pattern in _FUNCTION_PARTS)


def _holds(pattern: bytes, data: bytes) -> bool:
    """Patterns are compiled when they are needed, and kept by `re`: a linter lives by its start-up time.

    They try every line; where a text of any size may come, ask for a word of them first.
    """
    return re.search(pattern, data, re.MULTILINE) is not None
