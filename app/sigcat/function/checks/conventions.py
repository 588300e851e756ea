"""Conventions of Function JSON: where a document that is valid departs from what others expect of it.

Documents come from anywhere. What sigcat writes follows every convention.
"""

import re
from collections.abc import Callable
from fractions import Fraction

from sigcat import codes
from sigcat.asil import LEVELS, level_of
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.datatypes import LARGEST_ROUNDED_TO_FLOAT
from sigcat.findings import RuleCode
from sigcat.function.checks.against_catalogue import check_against
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.document.text import Text
from sigcat.function.function_json.datatypes.datatype import Datatype
from sigcat.function.function_json.datatypes.primitive_types import (
    BY_REFERENCE,
    CType,
    agree,
    c_type,
    proposed_reference,
    reference_type,
)
from sigcat.function.function_json.interfaces.data_interfaces import Signal
from sigcat.function.function_json.interfaces.role import CONSUMER, PROVIDER
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import (
    data,
    errors,
    methods,
    parameters,
    references,
    runnables,
    safety_reactions,
    subject_of,
)
from sigcat.names import did_you_mean, either

RUN_TYPES = ("Init", "Cyclic", "EventTriggered", "Shutdown")
SCHEDULING = ("Preemptive", "Non-Preemptive")

_SENTENCE = re.compile(r"[^a-z].*[.!?)]", re.DOTALL)
_NO_UNITS = frozenset(("enum", "enumeration", "bool", "boolean", "string", "text"))
_PERSON = re.compile(r"[A-Z][A-Za-z'-]+,? [A-Z][A-Za-z'-]+(,? [A-Z][A-Za-z'-]+)?")
_GROUPS = frozenset(
    ("team", "teams", "group", "department", "office", "division", "lab", "ag", "gmbh", "inc", "ltd", "control",
     "systems", "engineering", "software", "development", "platform", "project", "unit", "center", "centre")
)  # fmt: skip
_MENTION = re.compile(r"[A-Za-z][A-Za-z0-9]*(?:_[A-Za-z0-9]+)+")


def check_conventions(function: FunctionJson, catalogue: Catalogue | None = None) -> Problems:
    """Every departure. With a catalogue, also from what it says about the signals."""
    for one in _CHECKS:
        yield from one(function)
    yield from _units(function, catalogue)
    if catalogue is not None:
        yield from check_against(function, catalogue)


# -- datatypes ----------------------------------------------------------------------------------------------------


def _c_definitions(function: FunctionJson) -> Problems:
    for i, datatype in enumerate(function.datatypes):
        if datatype.category != "primitive":
            continue
        pointer, subject = ("Datatypes", i, "cDef"), Subject("datatype", datatype.reference)
        meant, promised = c_type(datatype.c_definition), reference_type(datatype.reference)
        row = BY_REFERENCE.get(datatype.reference)
        if meant is None:
            message = f"`cDef` must be a type of C, not {datatype.c_definition!r}."
            fix = f"Write {row.c!r}." if row else "Write a type of C, such as 'uint16_t'."
            yield Problem(codes.NOT_A_TYPE_OF_C, pointer, message, fix, subject)
        elif promised is not None and not agree(promised, meant):
            fix = f"Name it {proposed_reference(meant)!r}, or define it as {row.c!r}." if row else ""
            message = f"{datatype.reference!r} must be defined as its name says, not as {datatype.c_definition!r}."
            yield Problem(codes.TYPE_NAME_CONTRADICTS_DEFINITION, pointer, message, fix, subject)


def _unused_types(function: FunctionJson) -> Problems:
    used = {reference for _, reference in references(function)}
    for i, datatype in enumerate(function.datatypes):
        if datatype.reference not in used:
            message = f"Nothing refers to the datatype {datatype.reference!r}."
            at, subject = ("Datatypes", i, "typeRef"), Subject("datatype", datatype.reference)
            yield Problem(codes.TYPE_UNUSED, at, message, "Remove it.", subject)


# -- levels and spellings -----------------------------------------------------------------------------------------


def _asil_levels(function: FunctionJson) -> Problems:
    """Steps without a level, and levels that are misspelled. `check_inputs` finds inputs without one."""
    for pointer, _, runnable in runnables(function):
        subject = Subject("scheduling", runnable.name)
        if runnable.asil_level is None and runnable.run_type not in ("Init", "Shutdown"):
            message, fix = f"{runnable.name} has no ASIL.", "State one; QM without a requirement."
            yield Problem(codes.ASIL_OF_ELEMENT_MISSING, (*pointer, "AsilLevel"), message, fix, subject)
        yield from _asil((*pointer, "AsilLevel"), runnable.asil_level, subject)
    for pointer, _, item in (*data(function), *parameters(function), *errors(function), *safety_reactions(function)):
        key = str(type(item).model_fields["asil_level"].alias)
        yield from _asil((*pointer, key), item.asil_level, subject_of(item))


def _asil(pointer: Pointer, text: str | None, subject: Subject) -> Problems:
    if text is None:
        return
    level = level_of(text)
    if level is None:
        message = f"`{pointer[-1]}` must be {either(LEVELS)}, not {text!r}."
        fix = "Write one of these; until then it counts as not stated."
        yield Problem(codes.ASIL_MISSPELLED, pointer, message, fix, subject)
    elif text != level:
        message = f"`{pointer[-1]}` must be spelled {level!r}, not {text!r}."
        yield Problem(codes.ASIL_MISSPELLED, pointer, message, f"Write {level!r}.", subject)


def _priorities(function: FunctionJson) -> Problems:
    for pointer, _, runnable in runnables(function):
        if runnable.priority and runnable.priority_number is None:
            message = f"The priority of {runnable.name} must be a number, not {runnable.priority!r}."
            fix, subject = "Write a number; a higher one runs first.", Subject("scheduling", runnable.name)
            yield Problem(codes.PRIORITY_NO_NUMBER, (*pointer, "Priority"), message, fix, subject)


def _spellings(function: FunctionJson) -> Problems:
    roles, rule = (CONSUMER, PROVIDER), codes.ROLE_MISSPELLED
    for pointer, _, item in (*data(function), *methods(function)):
        yield from _spelling(rule, (*pointer, "Role"), item.role, roles, subject_of(item))
    rule = codes.RUN_TYPE_OR_SCHEDULING_MISSPELLED
    for pointer, _, runnable in runnables(function):
        subject = Subject("scheduling", runnable.name)
        yield from _spelling(rule, (*pointer, "Runtype"), runnable.run_type, RUN_TYPES, subject)
        yield from _spelling(rule, (*pointer, "Scheduling"), runnable.scheduling, SCHEDULING, subject)


def _spelling(rule: RuleCode, pointer: Pointer, text: str, known: tuple[str, ...], subject: Subject) -> Problems:
    if text not in known and (text or rule is codes.ROLE_MISSPELLED):
        message = f"`{pointer[-1]}` must be {either(known)}, not {text!r}."
        yield Problem(rule, pointer, message, did_you_mean(text, known), subject)


# -- texts --------------------------------------------------------------------------------------------------------


def _responsible(function: FunctionJson) -> Problems:
    text = function.info.function_responsible.raw
    words = {word.strip(",.").lower() for word in text.split()}
    if _PERSON.fullmatch(text) and not words & _GROUPS:
        message = f"The responsible must be a team, not a person as {text!r} seems to be."
        at, fix = ("FunctionInfo", "FunctionResponsible"), "Name the team that answers for it."
        yield Problem(codes.RESPONSIBLE_IS_A_PERSON, at, message, fix)


def _descriptions(function: FunctionJson) -> Problems:
    described: list[tuple[Pointer, Text]] = [(("FunctionInfo",), function.info.description)]
    described += [(pointer, runnable.description) for pointer, _, runnable in runnables(function)]
    described += [(pointer, item.description) for pointer, _, item in data(function) if isinstance(item, Signal)]
    described += [(pointer, error.description) for pointer, _, error in errors(function)]
    for pointer, text in described:
        if not _SENTENCE.fullmatch(text.raw.strip()):
            message = f"The description must be a sentence, not {_short(text.raw)!r}."
            fix = "Start with a capital and end with a period."
            yield Problem(codes.DESCRIPTION_NO_SENTENCE, (*pointer, "Description"), message, fix)


def _short(text: str) -> str:
    return text if len(text) <= 60 else f"{text[:57]}..."


def _mentions(function: FunctionJson) -> Problems:
    """Names in texts that are almost, but not quite, names of calls."""
    names = {runnable.name for _, _, runnable in runnables(function)}
    lowered = {name.lower(): name for name in names}
    for pointer, _, runnable in runnables(function):
        for word in _MENTION.findall(runnable.priority):
            meant = lowered.get(word.lower())
            if meant and word not in names:
                message, fix = f"The call must be spelled {meant!r}, not {word!r}.", f"Write {meant!r}."
                subject = Subject("scheduling", runnable.name)
                yield Problem(codes.CALL_MISSPELLED_IN_TEXT, (*pointer, "Priority"), message, fix, subject)


# -- units and paths ----------------------------------------------------------------------------------------------


def _paths(function: FunctionJson) -> Problems:
    for pointer, _, item in data(function):
        if item.vss_path is None and not (item.model_extra or {}).get("VssPath"):
            message = f"{item.name!r} names no path of the catalogue (`VssPath`)."
            fix = "With a path, its datatype, unit and range can be checked and need not be typed."
            yield Problem(codes.DATA_WITHOUT_PATH, pointer, message, fix, subject_of(item))


def _units(function: FunctionJson, catalogue: Catalogue | None) -> Problems:
    kinds = {d.reference: c_type(d.c_definition) for d in function.datatypes}
    by_ending = {n.name.lower(): n for n in catalogue.nodes.values() if n.is_leaf} if catalogue else {}
    for pointer, _, item in data(function):
        at, subject = (*pointer, "Units"), subject_of(item)
        if item.units:
            yield from _known_unit(at, subject, item.units, catalogue)
            continue
        kind = kinds.get(item.datatype)
        is_known = item.vss_path is not None
        node = catalogue.get(item.vss_path) if catalogue and item.vss_path else _alike(item.name, by_ending)
        unit = node.values.get("unit") if node else None
        if node and unit:
            relation = "is" if is_known else "seems to be"
            message = f"{item.name!r} has no unit; it {relation} {node.path!r}, which is in {unit!r}."
            yield Problem(codes.UNIT_MISSING, at, message, f"Write {unit!r}.", subject)
        elif kind is not None and kind.kind == "floating" and not is_known:
            message = f"{item.name!r} is a physical value without a unit."
            yield Problem(codes.UNIT_MISSING, at, message, "Write the key of its unit, such as 'kg'.", subject)


def _known_unit(pointer: Pointer, subject: Subject, unit: str, catalogue: Catalogue | None) -> Problems:
    if unit.lower() in _NO_UNITS:
        message = f"The unit of {subject.name!r} must be a unit, not {unit!r}, which is a kind of datatype."
        fix = "Leave the unit out, and list the values in the datatype (`Symbols`)."
        yield Problem(codes.UNIT_NOT_IN_CATALOGUE, pointer, message, fix, subject)
    elif catalogue is not None and catalogue.vocabulary.is_unknown(unit):
        keys = [known.key for known in catalogue.vocabulary.distinct_units]
        longer = [key for key in keys if key.lower().startswith(unit.lower()) and key.isalpha()]
        message = f"The unit of {subject.name!r} must be one of the catalogue, not {unit!r}."
        fix = f"Did you mean {longer[0]!r}?" if longer and len(unit) > 1 else did_you_mean(unit, keys)
        yield Problem(codes.UNIT_NOT_IN_CATALOGUE, pointer, message, fix, subject)


def _alike(name: str, by_ending: dict[str, Node]) -> Node | None:
    """The signal whose last name a local name ends with: `BrkCylP` and `….Brake.CylP`."""
    lowered = name.lower()
    endings = (lowered[start:] for start in range(len(lowered) - 3))
    return next((by_ending[ending] for ending in endings if ending in by_ending), None)


# -- ranges -------------------------------------------------------------------------------------------------------


def _lost_ranges(function: FunctionJson) -> Problems:
    """Ranges that the datatype and the scale of an item cannot hold."""
    held = {t.reference: _numbers(t) for t in function.datatypes if t.kind is None}
    for pointer, _, item in (*data(function), *parameters(function)):
        limits = held.get(item.datatype)
        scale = _scale(item.factor, item.offset)
        if limits is None or item.min is None or item.max is None or scale is None:
            continue
        factor, offset = scale
        low, high = sorted(Fraction(end) * factor + offset for end in limits)
        if item.min < low or item.max > high:
            message = (
                f"Values of {item.name!r} from {item.min:g} to {item.max:g} do not fit {item.datatype}, "
                f"which holds {float(low):g} to {float(high):g}."
            )
            fix = "Choose a larger datatype or another scale, or narrow the range."
            yield Problem(codes.CONVERSION_LOSES_RANGE, (*pointer, "Datatype"), message, fix, subject_of(item))


def _numbers(datatype: Datatype) -> tuple[float, float] | None:
    """Smallest and largest number of a float or an integer of C; None for everything else."""
    meant = c_type(datatype.c_definition)
    if meant == CType("floating", 32):
        return -LARGEST_ROUNDED_TO_FLOAT, LARGEST_ROUNDED_TO_FLOAT
    if meant is None or not meant.bits or meant.kind not in ("signed", "unsigned"):
        return None
    half = 1 << (meant.bits - 1)
    return (-half, half - 1) if meant.kind == "signed" else (0, 2 * half - 1)


def _scale(factor: str | float | None, offset: str | float | None) -> tuple[Fraction, Fraction] | None:
    """Factor and offset; None if they are not numbers."""
    try:
        return Fraction(str(factor if factor is not None else 1)), Fraction(str(offset if offset is not None else 0))
    except (ValueError, ZeroDivisionError):
        return None


_CHECKS: tuple[Callable[[FunctionJson], Problems], ...] = (
    _c_definitions, _unused_types, _asil_levels, _priorities, _spellings, _responsible, _descriptions, _mentions, _lost_ranges,
    _paths,
)  # fmt: skip
