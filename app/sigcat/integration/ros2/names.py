"""Names that the generators of ROS 2 messages accept, made from names of the catalogue.

One rule for each kind of name, as rosidl checks it (rosidl_adapter, `parser.py`). A text that is not a name there is changed by
rule: words as lower_snake_case; nothing left or a digit first: a word in front; a keyword of C++ or Python, or a
macro of the C library: a word behind; taken already: a number behind.
"""

import re
from collections.abc import Container
from hashlib import sha256
from typing import NamedTuple

from sigcat import codes
from sigcat.integration.finding_collector import FindingCollector, Subject
from sigcat.names import camel_case, screaming_snake_case, snake_case
from sigcat.reserved_words import C_KEYWORDS, CPP_KEYWORDS, IDL_KEYWORDS, PYTHON_KEYWORDS, is_of_headers

FIELD = re.compile(r"(?!.*__)(?!.*_$)[a-z][a-z0-9_]*")
MESSAGE = re.compile(r"[A-Z][A-Za-z0-9]*")
CONSTANT = re.compile(r"[A-Z](?:[A-Z0-9_]?[A-Z0-9]+)*")
LONGEST = 100
"""Longest name in characters: names of generated files and of DDS types are made of several."""

GENERATED = frozenset(("structure_needs_at_least_one_member", "check_fields", "slots", "structure"))
"""Members that the generated code has already."""

PACKAGES_OF_ROS = frozenset((
    "action_msgs", "ament_cmake", "builtin_interfaces", "composition_interfaces", "diagnostic_msgs", "geometry_msgs",
    "launch", "launch_ros", "launch_testing", "lifecycle_msgs", "nav_msgs", "rcl", "rcl_interfaces", "rcl_lifecycle", "rclcpp",
    "rclcpp_components", "rclcpp_lifecycle", "rclpy", "rcutils", "rmw", "rosgraph_msgs", "rosidl_default_generators",
    "rosidl_default_runtime", "sensor_msgs", "service_msgs", "statistics_msgs", "std", "std_msgs", "std_srvs", "unique_identifier_msgs",
))  # fmt: skip
"""Packages that ROS 2 brings, by which the user's own package would be hidden, and the namespace of the standard library."""


class Name(NamedTuple):
    """A name for the target, and why it is not simply the one it was made from."""

    text: str
    reason: str = ""


def report_renamed(name: Name, source: str, interface: Subject, findings: FindingCollector) -> None:
    """Report the name of an interface, or of a part of it, if there is a reason why it is not as in the source."""
    if name.reason:
        findings.report(codes.NAME_CHANGED, f"{source!r} is named {name.text!r} in ROS 2: {name.reason}.", interface)


def field_name(source: str, taken: Container[str] = ()) -> Name:
    """Name of a field, a parameter or an argument: `CylP` → `cyl_p`, `Switch` → `switch_value`."""
    return _permitted_name(snake_case(source), "value", "_", taken)


def package_name(source: str, taken: Container[str] = ()) -> Name:
    """Name of a package or a node: `CoreAcc` → `core_acc`."""
    return _permitted_name(snake_case(source), "function", "_", taken)


def message_name(source: str, taken: Container[str] = ()) -> Name:
    """Name of a message or a service, unique without regard to case: `ADAS.Map` → `ADASMap`.

    `taken` has lower-case names: two messages whose names differ in case alone share the name of a header file.
    """
    text = re.sub(r"[^A-Za-z0-9]", "", camel_case(source))
    return _permitted_name(text, "Message", "", taken, lower=True)


def constant_name(source: str, taken: Container[str] = ()) -> Name:
    """Name of a constant: `NOT_IN_MAP` stays, `kmPerHour` → `KM_PER_HOUR`, `NULL` → `NULL_VALUE`."""
    text = source if CONSTANT.fullmatch(source) else screaming_snake_case(source)
    return _permitted_name(text, "VALUE", "_", taken)


def topic_name(*segments: str) -> str:
    """A relative topic or service name of lower_snake_case segments, `vehicle/speed`: nodes resolve it in their namespace."""
    return "/".join(_permitted_name(snake_case(segment), "value", "_", (), reserved=False).text for segment in segments)


def _permitted_name(
    text: str, word: str, joint: str, taken: Container[str], *, lower: bool = False, reserved: bool = True
) -> Name:
    reason = ""
    if not text or not text[0].isalpha():
        text, reason = f"{word}{joint if text else ''}{text}", "a name begins with a letter"
    if len(text) > LONGEST:
        digest = sha256(text.encode()).hexdigest()[:8]
        text, reason = (
            f"{text[: LONGEST - 9].rstrip('_')}{joint}{digest.upper() if text.isupper() else digest}",
            f"cut to {LONGEST} characters",
        )
    keyword_of = _reserved(text) if reserved else ""
    if keyword_of:
        text, reason = f"{text}{joint}{word}", f"{text!r} is a reserved word of {keyword_of}"
    free = numbered(text, taken, joint, lower=lower)
    return Name(free, f"{text!r} is taken" if free != text else reason)


def numbered(text: str, taken: Container[str], joint: str = "_", *, lower: bool = False) -> str:
    """The text, with the first number behind it that is free if it is taken. With `lower`, taken names are in lower case."""
    free, number = text, 1
    while (free.lower() if lower else free) in taken:
        number += 1
        free = f"{text}{joint}{number}"
    return free


def _reserved(text: str) -> str:
    if text in CPP_KEYWORDS or text in C_KEYWORDS:
        return "C++"
    if text in PYTHON_KEYWORDS:
        return "Python"
    if is_of_headers(text):
        return "the C library"
    if text in GENERATED:
        return "rosidl"
    return "IDL" if text in IDL_KEYWORDS else ""


def shortened(text: str) -> str:
    """A text as messages have it: 60 characters at most."""
    return text if len(text) <= 60 else text[:57] + "..."
