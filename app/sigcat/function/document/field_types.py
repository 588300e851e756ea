"""Types of the strings of documents: each has a grammar, and nothing that it accepts can become code.

A field that may have any characters is a `Text`, which reaches files through filters alone. Every other string field
has one of these types.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import Field

from sigcat.function.document.expression import is_identifier, may_hold_value
from sigcat.names import either


@dataclass(frozen=True)
class Grammar:
    """The strings of a type."""

    expected: str
    """Noun phrase for messages: `a C identifier`."""
    accepts: Callable[[str], bool]
    fix: str = ""
    longest: int | None = None
    """Characters of the longest string, where there is one."""


@dataclass(frozen=True)
class Refers:
    """The string is the name of something that a function of the document has."""

    to: str
    """Noun for messages: `call`."""


def _matching(expected: str, pattern: str, fix: str = "", longest: int = 500) -> Grammar:
    form = re.compile(pattern)
    return Grammar(expected, lambda text: len(text) <= longest and form.fullmatch(text) is not None, fix, longest)


def _one_of(*words: str) -> Grammar:
    return Grammar(either(words), lambda text: text in words)


_LETTERS = r"[^\W_]"
"""Letters and digits of any script."""
_CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f\xad\u034f\u061c\u115f\u1160\u17b4\u17b5\u180b-\u180f\u200b-\u200f\u2028-\u202e\u2060-\u206f\u3164\ufe00-\ufe0f\ud800-\udfff\ufeff\uffa0\ufff0-\uffff\U000e0000-\U000e0fff]")  # fmt: skip
"""Invisible characters, and those that turn the direction of text."""
_INERT = re.compile(r"""(?!.*(?:/[*/]|\*/|\?\?|\]\]))[^"'\\`$#;<>&{}@]*""", re.DOTALL)


def is_inert(text: str) -> bool:
    """Whether nothing in a text has a meaning to C, C++, CMake, make, a shell, Python, XML or Markdown."""
    return _CONTROL.search(text) is None and _INERT.fullmatch(text) is not None


_LETTERS_FIRST = "Use letters, digits and underscores, and a letter first."
_PATH = r"[A-Za-z_][A-Za-z0-9_]*(?:\.[A-Za-z0-9_]+)*"
_NUMBER = r"[+-]?(?:[0-9]{1,400}(?:\.[0-9]{0,400})?|\.[0-9]{1,400})(?:[eE][+-]?[0-9]{1,3})?"
_ROS_WORD = r"[a-z][a-z0-9_]{0,254}"

# -- names --------------------------------------------------------------------------------------------------------

FREE = Grammar("a text", lambda _: True)
Free = Annotated[str, Field(min_length=1), FREE]
"""Free text of a settings file, which becomes a `Text` of a document."""
Carried = Annotated[Any, FREE]
"""A value that a document keeps, and that nothing is generated from."""
NAME = _matching(
    "a name of letters, digits, spaces and the signs _ - . : , /",
    rf"{_LETTERS}(?:{_LETTERS}|[_ .:,-]|/(?!/))*|_(?:{_LETTERS}|[_ .:,-]|/(?!/))*|",
    "Remove the other signs.",
)
Name = Annotated[str, NAME]
"""A name from which names for languages are made by rule."""
FunctionName = Annotated[str, NAME, Refers("function")]
ComponentName = Annotated[str, NAME, Refers("component")]
CallName = Annotated[str, NAME, Refers("call")]
MethodName = Annotated[str, NAME, Refers("method")]
ParameterName = Annotated[str, NAME, Refers("parameter")]
ErrorName = Annotated[str, NAME, Refers("error")]
InterfaceName = Annotated[str, NAME, Refers("interface")]
"""Names that an Integration JSON takes from the functions that it carries."""
WORDS = Grammar(
    'words without the signs " \\ ` $ # ; < > { } @, comments and invisible characters',
    lambda text: len(text) <= 1_000 and is_inert(re.sub("['&]", "", text)),
    "Remove these signs.",
)
Words = Annotated[str, WORDS]
"""A name of a person, an organization or a thing, in a few words."""
UNIT = _matching(
    "a unit of letters, digits and the signs ^ / * . % ° - ( )",
    rf"(?!.*(?:/[*/]|\*/))(?:{_LETTERS}|[ _^/*.·%°()+-])*",
    "Write it by its key in the catalogue, such as m/s^2.",
    100,
)
UnitKey = Annotated[str, UNIT]
"""A unit by its key; empty if there is none."""

# -- C and C++ ----------------------------------------------------------------------------------------------------

C_IDENTIFIER = Grammar(
    "a C identifier", is_identifier, f"{_LETTERS_FIRST} Words of C, names of its headers and `main` are taken."
)
CIdentifier = Annotated[str, C_IDENTIFIER]
C_EXPRESSION = Grammar(
    "an expression of C that holds a value",
    may_hold_value,
    "Name the variable as the code does, such as in.speed, in->speed or in[3]. Words of C and `main` are taken.",
)
CExpression = Annotated[str, C_EXPRESSION]
C_TYPE = _matching(
    "the name of a type in C",
    r"(?:const +)?(?:(?:struct|union|enum) +)?[A-Za-z_][A-Za-z0-9_]*(?: +[A-Za-z_][A-Za-z0-9_]*){0,3}(?: *\*)?(?: *\[[0-9]{0,9}\])?",
    "Write it as the header does, such as ExtU_Acc_T.",
)
CType = Annotated[str, C_TYPE]
C_VARIABLE_TYPE = (
    r"^(volatile )?((un)?signed|((un)?signed )?(char|short|int|long|long long|short int|long int|long long int)|float|double|_Bool"
    r"|((enum|struct) )?[A-Za-z_][A-Za-z0-9_]{0,127})$"
)
"""Pattern of the types of variables that an adapter defines."""
C_DEFINITION = _matching(
    "a definition of a type in C",
    r"[A-Za-z_][A-Za-z0-9_]*(?: +[A-Za-z_][A-Za-z0-9_]*){0,4}(?: *\*)?(?: *\[[0-9]{0,9}\])?|",
    "Write a type such as float, uint16_t or float[50].",
)
CDefinition = Annotated[str, C_DEFINITION]
C_MEMBER = _matching("a member in C", r"[A-Za-z_][A-Za-z0-9_]*(?:\.[A-Za-z_][A-Za-z0-9_]*)*", _LETTERS_FIRST)
CMember = Annotated[str, C_MEMBER]
CPP_CLASS = _matching(
    "a class of C++ such as control::Acc", r"[A-Za-z_][A-Za-z0-9_]*(?:::[A-Za-z_][A-Za-z0-9_]*)*", _LETTERS_FIRST
)
CppClass = Annotated[str, CPP_CLASS]
MACRO_VALUE = _matching(
    "a number or a word without quotes and brackets",
    r"[+-]?[A-Za-z0-9_.]*(?:[eE][+-][0-9]+)?",
    "Define it in a header.",
)
MacroValue = Annotated[str, MACRO_VALUE]
CPP_NAMESPACE = _matching("C++ namespaces such as eco::control", r"[A-Za-z][A-Za-z0-9_]*(?:::[A-Za-z][A-Za-z0-9_]*)*")

# -- the catalogue ------------------------------------------------------------------------------------------------

VSS_PATH = _matching(
    "a VSS path such as Vehicle.Speed",
    _PATH,
    "Separate names by points, and write them with letters, digits and underscores.",
    2_000,
)
VssPath = Annotated[str, VSS_PATH]
VSS_DATATYPE = _matching("a datatype of VSS such as uint8 or float[]", rf"(?:{_PATH})(?:\[[0-9]{{0,9}}\])?", "", 2_000)
VssDatatype = Annotated[str, VSS_DATATYPE]
TYPE_REFERENCE = _matching("`DT_` with letters and digits", r"DT_[A-Za-z0-9]+")

# -- AUTOSAR and ROS 2 --------------------------------------------------------------------------------------------

SHORT_NAME = _matching("an AUTOSAR short name of at most 128 characters", r"[A-Za-z][A-Za-z0-9_]*", _LETTERS_FIRST, 128)
ShortName = Annotated[str, SHORT_NAME]
ELEMENT_KEY = _matching(
    "a name such as Service, Service:instance or Service.Element", r"[A-Za-z_][A-Za-z0-9_]*(?:[.:/][A-Za-z0-9_]+)*"
)
ElementKey = Annotated[str, ELEMENT_KEY]
SERVICE_EVENT = _matching(
    "a name, or two with a slash between", r"[A-Za-z][A-Za-z0-9_]*(?:/[A-Za-z][A-Za-z0-9_]*)?", ""
)
ServiceEvent = Annotated[str, SERVICE_EVENT]
ROS_NAME = _matching("a ROS 2 name of lower-case letters, digits and underscores", _ROS_WORD)
RosName = Annotated[str, ROS_NAME]
"""A package, a node, a field or a parameter."""
_ROS_STEP = rf"{_ROS_WORD}(?:\[[0-9]{{1,9}}\])?"
ROS_FIELD = _matching("a field of a message such as speed or linear.x", rf"{_ROS_STEP}(?:\.{_ROS_STEP})*", "", 2_000)
RosField = Annotated[str, ROS_FIELD]
"""A field of a message, or of a message in it."""
_FMI_STEP = r"(?:[A-Za-z_][A-Za-z0-9_]*|'[A-Za-z0-9_ .:,/-]+')(?:\[[0-9]{1,9}\])?"
FMI_VARIABLE = _matching("a structured name of FMI such as Vehicle.Speed", rf"{_FMI_STEP}(?:\.{_FMI_STEP})*", "", 2_000)
FmiVariableName = Annotated[str, FMI_VARIABLE]
ROS_TOPIC = _matching("a ROS 2 topic such as vehicle/speed", rf"/?{_ROS_WORD}(?:/{_ROS_WORD})*")
RosTopicName = Annotated[str, ROS_TOPIC]
ROS_NAMESPACE = _matching("a ROS 2 namespace such as /ego", rf"/?|(?:/{_ROS_WORD})+")
RosNamespace = Annotated[str, ROS_NAMESPACE]
ROS_MESSAGE = _matching("a ROS 2 message such as SpeedSet", r"[A-Z][A-Za-z0-9]*")
RosMessage = Annotated[str, ROS_MESSAGE]
ROS_INTERFACE = _matching(
    "a ROS 2 interface such as ego_interfaces/msg/Speed", rf"{_ROS_WORD}/(?:(?:msg|srv)/)?[A-Z][A-Za-z0-9]*"
)
RosInterface = Annotated[str, ROS_INTERFACE]
ROS_DATATYPE = _matching(
    "a datatype of ROS 2 such as float32[50]",
    rf"(?:{_ROS_WORD}|{_ROS_WORD}/(?:msg/)?[A-Z][A-Za-z0-9]*|[A-Z][A-Za-z0-9]*)(?:\[(?:<=)?[0-9]{{0,9}}\])?",
)
RosDatatype = Annotated[str, ROS_DATATYPE]
ROS_CONSTANT = _matching("a ROS 2 constant such as NOT_IN_MAP", r"[A-Z][A-Z0-9_]*")
RosConstant = Annotated[str, ROS_CONSTANT]
ROS_PLUGIN = _matching("a class of a package such as ego::Speed", rf"{_ROS_WORD}::[A-Z][A-Za-z0-9]*")
RosPlugin = Annotated[str, ROS_PLUGIN]

# -- files, numbers, values ---------------------------------------------------------------------------------------

_FILE = r"[^\W_]|[_.+=-]"
SOURCE_FILE = _matching(
    "a relative file name of letters, digits and the signs _ - . + = /",
    rf"(?!(?:.*/)?\.\.(?:/|\Z))(?!-)(?:{_FILE})+(?:/(?:{_FILE})+)*/?",
    "Rename the file.",
    1_000,
)
SourceFile = Annotated[str, SOURCE_FILE]
"""A file or a folder below the declaration, without a sign that CMake, make or a shell interprets."""
VERSION = _matching(
    "a version such as 1.2.3 (SemVer)",
    r"(?:0|[1-9][0-9]*)(?:\.(?:0|[1-9][0-9]*)){1,2}(?:-[0-9A-Za-z.-]+)?(?:\+[0-9A-Za-z.-]+)?",
    "Write three numbers with points between.",
    100,
)
Version = Annotated[str, VERSION]
SERVICE_VERSION = _matching(
    "a version such as 2.1: major up to 254, and minor", r"(?:25[0-4]|2[0-4][0-9]|1?[0-9]?[0-9])\.[0-9]{1,9}", "", 20
)
DATE = _matching("a date such as 2025-09-12", r"[0-9]{2,4}[-./][0-9]{2}[-./][0-9]{2,4}")
Date = Annotated[str, DATE]
DIGEST = _matching("a SHA-256 digest", r"[0-9a-f]{64}")
Digest = Annotated[str, DIGEST]
NUMBER_TEXT = _matching(
    "a number, or a fraction such as 5/18", rf"\s?{_NUMBER}\s?|[+-]?[0-9]{{1,400}}/[0-9]{{1,400}}|", "", 1_000
)
NumberText = Annotated[str, NUMBER_TEXT]
QUANTITY = _matching("a number", rf"\s?{_NUMBER} ?[A-Za-zµ]{{0,10}}\s?|[A-Za-z ]{{0,30}}", "", 1_000)
Quantity = Annotated[str, QUANTITY]
"""A number, with a unit where a document writes one; or a word such as none."""
_BYTE = "(?:25[0-5]|2[0-4][0-9]|1[0-9][0-9]|[1-9]?[0-9])"
MULTICAST_ADDRESS = _matching(
    "an IPv4 address of a multicast group, such as 239.0.0.1", rf"(?:22[4-9]|23[0-9])(?:\.{_BYTE}){{3}}"
)
MulticastAddress = Annotated[str, MULTICAST_ADDRESS]
E_MAIL = _matching("a mail address", r"[A-Za-z0-9.!%*+/=?^_|~-]+@[A-Za-z0-9.-]+", "", 200)
Email = Annotated[str, E_MAIL]

# -- words of adapters --------------------------------------------------------------------------------------------

Definer = Annotated[str, _one_of("Function", "Adapter")]
TimeoutStart = Annotated[str, _one_of("Init", "First")]
TimeoutValue = Annotated[str, _one_of("Last", "Default", "Init")]
Overflow = Annotated[str, _one_of("DropOldest", "DropNewest")]
UnknownAction = Annotated[str, _one_of("Keep", "Initial")]
Signature = Annotated[str, _one_of("Globals", "Pointers", "Class")]
