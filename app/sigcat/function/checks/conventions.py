"""Conventions of Function JSON: where a document that is valid departs from what others expect of it.

Documents come from anywhere. What sigcat writes follows every convention.
"""

import re
from collections.abc import Callable, Iterator
from fractions import Fraction

from sigcat.asil import LEVELS, level_of
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.function.checks.against import check_against
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem
from sigcat.function.function_json.datatypes import BY_REFERENCE, agree, c_type, proposed_reference, reference_type
from sigcat.function.function_json.model import CONSUMER, PROVIDER, Datatype, FunctionJson, Parameter
from sigcat.function.function_json.walk import contracts, data, errors, parameters, references, runnables
from sigcat.names import did_you_mean, either

Problems = Iterator[Problem]

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
        pointer = ("Datatypes", i, "cDef")
        meant, promised = c_type(datatype.c_definition), reference_type(datatype.reference)
        row = BY_REFERENCE.get(datatype.reference)
        if meant is None:
            fix = f"Write {row.c!r}." if row else "Write a type of C, such as 'uint16_t'."
            yield Problem("F081", pointer, f"{datatype.c_definition!r} is no type of C.", fix, datatype.reference)
        elif promised is not None and not agree(promised, meant):
            fix = f"Name it {proposed_reference(meant)!r}, or define it as {row.c!r}." if row else ""
            message = f"{datatype.reference!r} is defined as {datatype.c_definition!r}, which is something else."
            yield Problem("F082", pointer, message, fix, datatype.reference)


def _unused_types(function: FunctionJson) -> Problems:
    used = {reference for _, reference in references(function)}
    for i, datatype in enumerate(function.datatypes):
        if datatype.reference not in used:
            message = f"Nothing refers to the datatype {datatype.reference!r}."
            yield Problem("F083", ("Datatypes", i, "typeRef"), message, "Remove it.", datatype.reference)


# -- levels and spellings -----------------------------------------------------------------------------------------


def _asil_levels(function: FunctionJson) -> Problems:
    for pointer, _, runnable in runnables(function):
        yield from _asil((*pointer, "AsilLevel"), runnable.asil_level, runnable.name)
    for pointer, _, item in data(function):
        key = "AsilInfo" if "DataQList" in pointer else "AsilLevel"
        yield from _asil((*pointer, key), item.asil_level, item.name)
    for pointer, _, parameter in parameters(function):
        yield from _asil((*pointer, "Asillevel"), parameter.asil_level, parameter.name)
    for pointer, _, error in errors(function):
        if error.asil_level is not None:
            yield from _asil((*pointer, "AsilLevel"), error.asil_level, error.name)


def _asil(pointer: Pointer, text: str | None, name: str) -> Problems:
    level = level_of(text)
    if text is None:
        yield Problem("F090", pointer, f"{name} has no ASIL.", "State one; QM where there is no requirement.", name)
    elif level is None:
        message = f"`{pointer[-1]}` must be {either(LEVELS)}, not {text!r}."
        yield Problem("F091", pointer, message, "Write one of these; until then it counts as not stated.", name)
    elif text != level:
        yield Problem(
            "F091", pointer, f"`{pointer[-1]}` must be spelled {level!r}, not {text!r}.", f"Write {level!r}.", name
        )


def _priorities(function: FunctionJson) -> Problems:
    for pointer, _, runnable in runnables(function):
        if runnable.priority and not re.fullmatch(r"-?\d+", runnable.priority.strip()):
            message = f"The priority of {runnable.name} is the text {runnable.priority!r}, which no scheduler can use."
            fix = "Write a number; a higher one runs first."
            yield Problem("F092", (*pointer, "Priority"), message, fix, runnable.name)


def _spellings(function: FunctionJson) -> Problems:
    for pointer, _, item in data(function):
        yield from _spelling((*pointer, "Role"), item.role, (CONSUMER, PROVIDER), "F097", item.name)
    for pointer, _, runnable in runnables(function):
        yield from _spelling((*pointer, "Runtype"), runnable.run_type, RUN_TYPES, "F098", runnable.name)
        yield from _spelling((*pointer, "Scheduling"), runnable.scheduling, SCHEDULING, "F098", runnable.name)


def _spelling(pointer: Pointer, text: str, known: tuple[str, ...], rule: str, name: str) -> Problems:
    if text and text not in known:
        fix = did_you_mean(text, known) or f"Use one of {', '.join(known)}."
        yield Problem(rule, pointer, f"{text!r} is not one of the usual words for `{pointer[-1]}`.", fix, name)


# -- texts --------------------------------------------------------------------------------------------------------


def _responsible(function: FunctionJson) -> Problems:
    text = function.info.function_responsible
    words = {word.strip(",.").lower() for word in text.split()}
    if _PERSON.fullmatch(text) and not words & _GROUPS:
        message = f"{text!r} looks like a person; people change teams, and their names are personal data."
        yield Problem("F099", ("FunctionInfo", "FunctionResponsible"), message, "Name the team that answers for it.")


def _descriptions(function: FunctionJson) -> Problems:
    described: list[tuple[Pointer, str]] = [(("FunctionInfo",), function.info.description)]
    described += [(pointer, runnable.description) for pointer, _, runnable in runnables(function)]
    for pointer, _, contract in contracts(function):
        described += [((*pointer, "SignalList", i), item.description) for i, item in enumerate(contract.signals or ())]
        described += [((*pointer, "ErrorList", i), item.description) for i, item in enumerate(contract.errors or ())]
    for pointer, text in described:
        if not _SENTENCE.fullmatch(text.strip()):
            message = f"The description {_short(text)!r} is no sentence."
            fix = "Start with a capital and end with a period."
            yield Problem("F096", (*pointer, "Description"), message, fix)


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
                message = f"{word!r} is spelled differently from the call {meant!r}."
                yield Problem("F034", (*pointer, "Priority"), message, f"Write {meant!r}.", runnable.name)


# -- units and paths ----------------------------------------------------------------------------------------------


def _paths(function: FunctionJson) -> Problems:
    for pointer, _, item in data(function):
        if item.vss_path is None and not (item.model_extra or {}).get("VssPath"):
            message = f"{item.name!r} names no path of the catalogue (`VssPath`)."
            fix = "With a path, its datatype, unit and range can be checked and need not be typed."
            yield Problem("F095", pointer, message, fix, item.name)


def _units(function: FunctionJson, catalogue: Catalogue | None) -> Problems:
    kinds = {d.reference: c_type(d.c_definition) for d in function.datatypes}
    by_ending = {n.name.lower(): n for n in catalogue.nodes.values() if n.is_leaf} if catalogue else {}
    for pointer, _, item in data(function):
        if item.units:
            yield from _known_unit((*pointer, "Units"), item.name, item.units, catalogue)
            continue
        kind = kinds.get(item.datatype)
        is_known = item.vss_path is not None
        node = catalogue.get(item.vss_path) if catalogue and item.vss_path else _alike(item.name, by_ending)
        unit = node.values.get("unit") if node else None
        if node and unit:
            relation = "is" if is_known else "seems to be"
            message = f"{item.name!r} has no unit; it {relation} {node.path!r}, which is in {unit!r}."
            yield Problem("F093", (*pointer, "Units"), message, f"Write {unit!r}.", item.name)
        elif kind is not None and kind.kind == "floating" and not is_known:
            message = f"{item.name!r} is a physical value without a unit."
            yield Problem("F093", (*pointer, "Units"), message, "Write the key of its unit, such as 'kg'.", item.name)


def _known_unit(pointer: Pointer, name: str, unit: str, catalogue: Catalogue | None) -> Problems:
    if unit.lower() in _NO_UNITS:
        fix = "Leave the unit out, and list the values in the datatype (`Symbols`)."
        yield Problem("F094", pointer, f"{unit!r}, the unit of {name!r}, is a kind of datatype, not a unit.", fix, name)
    elif catalogue is not None and catalogue.vocabulary.unit(unit) is None:
        keys = [known.key for known in catalogue.vocabulary.distinct_units]
        longer = [key for key in keys if key.lower().startswith(unit.lower()) and key.isalpha()]
        fix = f"Did you mean {longer[0]!r}?" if longer and len(unit) > 1 else did_you_mean(unit, keys)
        yield Problem("F094", pointer, f"{unit!r}, the unit of {name!r}, is no unit of the catalogue.", fix, name)


def _alike(name: str, by_ending: dict[str, Node]) -> Node | None:
    """The signal whose last name a local name ends with: `BrkCylP` and `….Brake.CylP`."""
    lowered = name.lower()
    endings = (lowered[start:] for start in range(len(lowered) - 3))
    return next((by_ending[ending] for ending in endings if ending in by_ending), None)


# -- ranges -------------------------------------------------------------------------------------------------------


def _lost_ranges(function: FunctionJson) -> Problems:
    """Ranges that the datatype and the scale of an item cannot hold."""
    held = {t.reference: _integers(t) for t in function.datatypes if t.kind is None}
    for pointer, _, item in (*data(function), *parameters(function)):
        limits = held.get(item.datatype)
        scale = None if isinstance(item, Parameter) else _scale(item.factor, item.offset)
        if (
            limits is None
            or item.min is None
            or item.max is None
            or (scale is None and not isinstance(item, Parameter))
        ):
            continue
        factor, offset = scale or (Fraction(1), Fraction(0))
        low, high = sorted(Fraction(end) * factor + offset for end in limits)
        if item.min < low or item.max > high:
            message = (
                f"Values of {item.name!r} from {item.min:g} to {item.max:g} do not fit {item.datatype}, "
                f"which holds {float(low):g} to {float(high):g}."
            )
            fix = "Choose a larger datatype or another scale, or narrow the range."
            yield Problem("F020", (*pointer, "Datatype"), message, fix, item.name)


def _integers(datatype: Datatype) -> tuple[int, int] | None:
    """Smallest and largest number of an integer of C; None for everything else."""
    meant = c_type(datatype.c_definition)
    if meant is None or not meant.bits or meant.kind not in ("signed", "unsigned"):
        return None
    half = 1 << (meant.bits - 1)
    return (-half, half - 1) if meant.kind == "signed" else (0, 2 * half - 1)


def _scale(factor: str | float | None, offset: str | float | None) -> tuple[Fraction, Fraction] | None:
    """Factor and offset; None if they are no numbers."""
    try:
        return Fraction(str(factor if factor is not None else 1)), Fraction(str(offset if offset is not None else 0))
    except (ValueError, ZeroDivisionError):
        return None


_CHECKS: tuple[Callable[[FunctionJson], Problems], ...] = (
    _c_definitions, _unused_types, _asil_levels, _priorities, _spellings, _responsible, _descriptions, _mentions, _lost_ranges,
    _paths,
)  # fmt: skip
