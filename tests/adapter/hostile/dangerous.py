"""Documents in which every field with a type has the most dangerous value that its type accepts, all at once.

The product says which of them it refuses, such as a word that must be one of a few: there the next value of the type is
tried, or the field stays as it was. So the documents are as dangerous as they can be, and are read without a finding.
"""

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from typing import Any, NamedTuple
from zlib import crc32

from pydantic import BaseModel

from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.function.document import field_types as types
from sigcat.function.document.document import Pointer, pointer_text
from sigcat.function.document.field_types import Grammar
from sigcat.function.document.unfit_texts import typed_strings
from sigcat.function.function_json.model import FunctionJson
from sigcat.integration.autosar_adaptive import document as adaptive
from sigcat.integration.autosar_adaptive.model import IntegrationModel
from sigcat.integration.autosar_classic import document as classic
from sigcat.integration.autosar_classic.model import ClassicIntegration
from sigcat.integration.fmi import document as fmi
from sigcat.integration.fmi.model import FmiIntegration
from sigcat.integration.reading import read_functions
from sigcat.integration.ros2 import document as ros2
from sigcat.integration.ros2.model import Ros2Integration
from sigcat.limits import DEFAULT_LIMITS
from tests.adapter.hostile.everything import FUNCTION_JSON, catalogue, document

NAMES = ("{} EVIL x", "{}/EVIL.x", "{}: EVIL, é", "{}-EVIL_", "{}EVIL")
"""`EVIL` becomes a word by itself where such a value is written into code as it is; made into a name, it is a part of one.

What is an expression or a type of C by itself has `KNOWN` instead.
"""
VALUES: Mapping[Grammar, Sequence[str]] = {
    types.NAME: NAMES,
    types.WORDS: ("{} (EVIL's & x): /x", "{}"),
    types.UNIT: ("{}*EVIL/x^2.% (°-)",),
    types.C_IDENTIFIER: ("{}KNOWN",),
    types.C_EXPRESSION: ("(*(struct KNOWN *)&(({})[KNOWN + 1u])).KNOWN", "{}.KNOWN[KNOWN - 1].x", "KNOWN_{}"),
    types.C_TYPE: ("const struct {}_KNOWN", "{}_KNOWN"),
    types.C_DEFINITION: ("{}_KNOWN",),
    types.C_MEMBER: ("{}.KNOWN", "{}KNOWN"),
    types.MACRO_VALUE: ("-KNOWN.xe+5",),
    types.CPP_NAMESPACE: ("{}::KNOWN",),
    types.VSS_PATH: ("{}.xEVIL",),
    types.VSS_DATATYPE: ("{}.xEVIL",),
    types.SOURCE_FILE: ("EVIL=+é-x./{}",),
    types.VERSION: ("{}-EVIL.x+EVIL-y",),
    types.NUMBER_TEXT: ("\n{}e-0\n", "\n{}\n"),
    types.QUANTITY: ("\n{}\n",),
    types.TYPE_REFERENCE: ("{}EVIL",),
    types.SHORT_NAME: ("{}_EVIL",),
    types.ELEMENT_KEY: ("{}:EVIL/x", "{}/EVIL"),
    types.SERVICE_EVENT: ("{}/EVIL", "{}EVIL"),
    types.FMI_VARIABLE: ("{}.'EVIL x: /x'[1]", "{}.xEVIL"),
    types.ROS_NAME: ("{}_evil",),
    types.ROS_TOPIC: ("{}/evil_x",),
    types.ROS_NAMESPACE: ("/evil/x",),
    types.ROS_MESSAGE: ("{}EVIL",),
    types.ROS_INTERFACE: ("{}EVIL",),
    types.ROS_DATATYPE: ("{}EVIL",),
    types.ROS_CONSTANT: ("{}_EVIL",),
    types.ROS_PLUGIN: ("{}EVIL",),
    types.E_MAIL: ("EVIL!%*+/=?^_|~-{}",),
    types.DATE: ("2025.09/12",),
}  # fmt: skip
"""Values of each type around what the document has, the most dangerous first."""
DECISIVE = ("Attribute", "Direction", "Kind")
"""Fields on which others depend."""

Changes = Mapping[str, str]
"""New strings by old ones: what a document says twice stays the same twice."""


class Dangerous(NamedTuple):
    """A document with dangerous values."""

    data: bytes
    changes: Changes
    strings: Mapping[Pointer, tuple[str, Grammar]]
    """Strings with a type of the document as it was."""


def refusals(kind: str, data: bytes) -> Sequence[Finding]:
    """Return the findings of every generator that takes a document, when it reads the document."""
    try:
        READERS[kind](data, "a.json", DEFAULT_LIMITS)
    except InputRefused as refused:
        return refused.findings
    return ()


MODELS: Mapping[str, type[BaseModel]] = {
    FUNCTION_JSON: FunctionJson,
    "autosar-adaptive": IntegrationModel,
    "autosar-classic": ClassicIntegration,
    "ros2": Ros2Integration,
    "fmi": FmiIntegration,
}
READERS: Mapping[str, Callable[..., Any]] = {
    FUNCTION_JSON: lambda data, name, limits: read_functions([(data, name)], catalogue(), limits),
    "autosar-adaptive": adaptive.read_integration,
    "autosar-classic": classic.read_integration,
    "ros2": ros2.read_integration,
    "fmi": fmi.read_integration,
}


@cache
def dangerous(kind: str) -> Dangerous:
    """The document of a kind with every dangerous value that the product accepts beside all others."""
    whole = json.loads(document(kind))
    strings = {at: known for at, known in strings_of(kind, whole).items() if at_pointer(whole, at) == known[0]}
    left = candidates(strings)
    accepted: dict[str, str] = {}
    while left:
        wanted = dict(
            _without_blamed(kind, whole, strings, accepted, {text: values[0] for text, values in left.items()})
        )
        accepted |= _largest(kind, whole, strings, accepted, wanted)
        left = {text: values[1:] for text, values in left.items() if text not in accepted and values[1:]}
    return Dangerous(changed(whole, strings, accepted), accepted, strings)


def strings_of(kind: str, whole: Any) -> dict[Pointer, tuple[str, Grammar]]:
    """The strings with a type."""
    model = MODELS[kind].model_validate(whole, by_name=False)
    return {each.pointer: (each.text, each.grammar) for each in typed_strings(model)}


def at_pointer(whole: Any, at: Pointer) -> Any:
    for part in at:
        whole = whole[part]
    return whole


def candidates(strings: Mapping[Pointer, tuple[str, Grammar]]) -> dict[str, list[str]]:
    """Values for each string that are of every type that it has somewhere."""
    types_of: dict[str, dict[Grammar, None]] = {}
    needed = {"", *(text for at, (text, _) in strings.items() if at[-1] in DECISIVE)}
    for text, grammar in strings.values():
        types_of.setdefault(text, {})[grammar] = None
    found = {text: list(_values(text, known)) for text, known in types_of.items() if text not in needed}
    return {text: values for text, values in found.items() if values}


def _values(text: str, known: Mapping[Grammar, None]) -> Iterator[str]:
    if types.C_DEFINITION in known and not text.startswith("struct "):
        return  # a type that the product has to know
    for grammar in known:
        forms = VALUES.get(grammar, ())
        start = crc32(text.encode()) % len(forms) if grammar is types.NAME else 0  # not each name has the same signs
        for form in (*forms[start:], *forms[:start]):
            value = form.format(text)
            if all(each.accepts(value) for each in known):
                yield value


def changed(whole: Any, strings: Mapping[Pointer, tuple[str, Grammar]], changes: Changes) -> bytes:
    """The document with changes."""
    copied = json.loads(json.dumps(whole))
    for at, (text, _) in strings.items():
        if text in changes:
            at_pointer(copied, at[:-1])[at[-1]] = changes[text]
    return json.dumps(copied).encode()


def _without_blamed(
    kind: str, whole: Any, strings: Mapping[Pointer, tuple[str, Grammar]], accepted: Changes, wanted: Changes
) -> Changes:
    """Without what findings blame at its place."""
    places = {pointer_text(at): text for at, (text, _) in strings.items()}
    while True:
        found = refusals(kind, changed(whole, strings, {**accepted, **wanted}))
        blamed = {places.get(each.pointer) for each in found} & wanted.keys()
        if not blamed:
            return wanted
        wanted = {text: value for text, value in wanted.items() if text not in blamed}


def _largest(
    kind: str, whole: Any, strings: Mapping[Pointer, tuple[str, Grammar]], accepted: Changes, wanted: Changes
) -> Changes:
    """Return those of the requested changes that are accepted together, half by half."""
    if not wanted or not refusals(kind, changed(whole, strings, {**accepted, **wanted})):
        return wanted
    if len(wanted) == 1:
        return {}
    middle = len(wanted) // 2
    halves = list(wanted.items())[:middle], list(wanted.items())[middle:]
    first = _largest(kind, whole, strings, accepted, dict(halves[0]))
    return {**first, **_largest(kind, whole, strings, {**accepted, **first}, dict(halves[1]))}
