"""Problems of datatypes: references to nothing, or to a later datatype."""

from collections.abc import Iterator

from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_classic.datatypes.platform_types import FLOATS, WHOLE_NUMBERS
from sigcat.integration.autosar_classic.model import ApplicationType, ClassicIntegration, ImplementationType
from sigcat.integration.problem import Problem
from sigcat.integration.references import unknown

PLATFORM_TYPES = (*WHOLE_NUMBERS, *FLOATS)
"""Types that every platform has (AUTOSAR_SWS_PlatformTypes)."""


def type_problems(model: ClassicIntegration) -> Iterator[Problem]:
    """Datatypes that refer to others: these stand before them, so that nothing contains itself."""
    yield from _implementation(model)
    yield from _application(model)


def _implementation(model: ClassicIntegration) -> Iterator[Problem]:
    seen: set[str] = set()
    for index, each in enumerate(model.implementation_types):
        at = ("ImplementationTypes", index)
        yield from _missing_parts(each, at)
        if each.category == "VALUE" and each.base not in PLATFORM_TYPES:
            yield unknown((*at, "Base"), "platform type", str(each.base))
        base = each.base if each.category == "TYPE_REFERENCE" else None
        for used in filter(None, [base, each.element, *(member.type for member in each.members or ())]):
            if used not in seen:
                yield unknown(("ImplementationTypes", index), "implementation type before it", used)
        seen.add(each.name)


def _application(model: ClassicIntegration) -> Iterator[Problem]:
    seen: set[str] = set()
    codes = {each.name: each for each in model.implementation_types}
    for index, each in enumerate(model.application_types):
        at = ("ApplicationTypes", index)
        code = codes.get(each.implementation)
        if code is not None and _form(each) != _form(code):
            message = f"{each.name} must be {_words(code)}, as {code.name} is in the code, not {_words(each)}."
            yield Problem(at, message, "Give both the same form.")
        yield from _missing_parts(each, at)
        for used in filter(None, [each.element, *(member.type for member in each.members or ())]):
            if used not in seen:
                yield unknown(at, "application type before it", used)
        seen.add(each.name)


def _form(entry: ImplementationType | ApplicationType) -> tuple[int | None, tuple[str, ...]]:
    """Return the length of an array and the members of a structure: a type of meaning has the form of its code."""
    length = entry.length if entry.category == "ARRAY" else None
    members = entry.members or () if entry.category == "STRUCTURE" else ()
    return length, tuple(member.name for member in members)


def _words(entry: ImplementationType | ApplicationType) -> str:
    length, members = _form(entry)
    return f"a structure of {', '.join(members)}" if members else "one value" if length is None else f"{length} values"


def _missing_parts(entry: ImplementationType | ApplicationType, at: Pointer) -> Iterator[Problem]:
    """An array has elements and a length, a structure has members, a reference a datatype that it is one for."""
    if entry.category == "ARRAY" and (not entry.element or (entry.length or 0) < 1):
        yield Problem(at, f"Array {entry.name} must have a type of its elements, and a length of at least 1.", "Add them.")  # fmt: skip
    if entry.category == "STRUCTURE" and not entry.members:
        yield Problem(at, f"Structure {entry.name} must have a member.", "Add one.")
    if isinstance(entry, ImplementationType) and entry.category == "TYPE_REFERENCE" and not entry.base:
        yield Problem(at, f"{entry.name} must say which datatype it is another name for.", "Add `Base`.")
