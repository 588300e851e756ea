"""Variables of the code, compared with the headers that declare them, where these and libclang are at hand."""

import re
from collections.abc import Iterator, Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.function.c_project.c_types import vss_datatype
from sigcat.function.c_project.declarations import CType, Declarations, Record
from sigcat.function.c_project.files import CodeFiles, headers_of
from sigcat.function.c_project.parsing import lacks_system_header, parse_unit
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.code import CLASS, GLOBALS, POINTERS, CodeInterface, is_inside
from sigcat.function.function_json.datatype import Datatype, innermost
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.role import PROVIDER
from sigcat.function.function_json.variables import CodeVariable, variables
from sigcat.function.function_json.walk import data, declared_data, errors, parameters, safety_reactions
from sigcat.names import did_you_mean

_ADAPTER = "Adapter"
_INDEX = re.compile(r"\[\s*(-?[0-9]+)\s*\]")
_UNIT = "sigcat-variables"
_PROBE = "sigcat_variable_"
_SIZED = re.compile(r"(?P<unsigned>u?)int(?P<bits>8|16|32|64)_t")
_FLOATING = {"float": 32, "double": 64}


class _Number(NamedTuple):
    """Kind and size of a number."""

    sort: str
    bits: int

    def fits(self, other: "_Number") -> bool:
        """Whether every number of this type is one of another type."""
        is_widened = (self.sort, other.sort) == ("unsigned", "signed") and self.bits < other.bits
        return is_widened or (self.sort == other.sort and self.bits <= other.bits)

    def holds(self, number: int) -> bool:
        """Whether a whole number is one of this type."""
        if self.sort == "signed":
            return -(1 << self.bits - 1) <= number < 1 << self.bits - 1
        return self.sort != "unsigned" or 0 <= number < 1 << self.bits


class _Question(NamedTuple):
    """A line of the text that clang is given, and what of the declaration it was made from."""

    text: str
    pointer: Pointer
    variable: CodeVariable | None = None
    is_definition: bool = False
    element: int | None = None
    """Index of an element; the line has the type of its array."""
    is_assigned: bool = False
    """Whether the line assigns to the variable, and has no type."""


def unfit_variables(function: ResolvedFunction) -> Iterator[Finding]:
    """A finding for each variable whose type is not the declared one. Headers that are incomplete are not compared."""
    code = function.function.code
    if code is None or function.origin is None or not code.headers or find_spec("clang") is None:
        return
    if not all(map(is_inside, (*code.headers, *(code.include_folders or ())))):
        return
    folder = Path(function.document.name).parent
    texts = headers_of(folder, code.headers, code.include_folders or ())
    if texts is None:
        return
    questions = tuple(each for each in _questions(function, code) if each.text.isprintable())  # in one line
    answers = _answers(code, texts, questions)
    if answers is not None:
        yield from _compared(function, questions, answers, len(_head(code)))


def _head(code: CodeInterface) -> list[str]:
    return ["#include <stdint.h>", "#include <stdbool.h>", *(f'#include "{each}"' for each in code.headers or ())]


def _answers(code: CodeInterface, texts: Mapping[str, str], questions: tuple[_Question, ...]) -> Declarations | None:
    unit = f"{_UNIT}.{'cpp' if code.signature == CLASS else 'c'}"
    text = "\n".join([*_head(code), *(each.text for each in questions), ""])
    definitions = tuple(each.as_option for each in code.definitions or ())
    try:
        found = parse_unit(CodeFiles({**texts, unit: text}, definitions=definitions), unit)
    except InputRefused:
        return None
    before = len(_head(code))
    is_incomplete = any(
        not lacks_system_header(error) and not (error.place.file == unit and error.place.line > before)
        for error in found.errors
    )
    return None if is_incomplete else found


# -- questions ----------------------------------------------------------------------------------------------------


def _questions(function: ResolvedFunction, code: CodeInterface) -> Iterator[_Question]:
    """A line that has the type of each variable, and one that declares again what the adapter defines."""
    datatypes = {each.reference: each for each in function.function.datatypes}
    written = set(_written(function))
    for index, each in enumerate(code.objects or ()):
        if code.signature == GLOBALS and each.defined_by == _ADAPTER and each.has_valid_length:
            yield _Question(f"extern {each.declaration};", ("Code", "Objects", index, "Type"), is_definition=True)
    for number, variable in enumerate(variables(function.function)):
        if variable.defined_by == _ADAPTER and code.signature == GLOBALS:
            yield from _definition(variable, datatypes)
        word = "decltype" if code.signature == CLASS else "__typeof__"
        seen = _seen(variable.expression, code)
        yield _Question(f"extern {word}({seen}) {_PROBE}{number};", variable.pointer, variable)
        yield _Question(f"extern {word}(((void)0, {seen})) {_PROBE}{number}_value;", variable.pointer)
        target = _target(seen, datatypes.get(variable.datatype or ""), datatypes, variable)
        if target and variable.pointer in written:
            text = f"extern {word}(((void)({target} = {target}), 0)) {_PROBE}{number}_assigned;"
            yield _Question(text, variable.pointer, variable, is_assigned=True)
        for place, match in enumerate(_INDEX.finditer(variable.expression)):
            array = _seen(variable.expression[: match.start()], code)
            text = f"extern {word}({array}) {_PROBE}{number}_array_{place};"
            yield _Question(text, variable.pointer, variable, element=int(match[1]))


def _written(function: ResolvedFunction) -> Iterator[Pointer]:
    """Pointers of the variables that the adapter writes."""
    given = function.function
    yield from ((*pointer, "Variable") for pointer, _, item in declared_data(given) if item.role != PROVIDER)
    yield from ((*pointer, "Variable") for pointer, _, _ in parameters(given))
    yield from ((*pointer, "Variable") for pointer, _, _ in safety_reactions(given))
    yield from ((*pointer, "StatusVariable") for pointer, _, _ in errors(given))
    modes = enumerate(given.mode_interfaces or ())
    yield from (("ModeInterfaceList", index, "Variable") for index, mode in modes if mode.direction == "In")


def _target(
    seen: str, datatype: Datatype | None, datatypes: Mapping[str, Datatype], variable: CodeVariable
) -> str | None:
    """The first number that the adapter writes; None of a struct, whose members may have other names."""
    element = innermost(variable.datatype or "", datatypes)
    if variable.datatype is not None and (datatype is None or element is None or element.kind is not None):
        return None
    is_array = datatype is not None and datatype.kind == "array"
    return f"({seen}){'[0]' * (is_array + bool(variable.elements))}"


def _definition(variable: CodeVariable, datatypes: Mapping[str, Datatype]) -> Iterator[_Question]:
    """As the adapter would write it."""
    datatype = datatypes.get(variable.datatype or "")
    element = innermost(variable.datatype or "", datatypes)
    c_type = variable.c_type or (element.c_definition if element and element.kind is None else "")
    count = datatype.length if datatype and datatype.kind == "array" else variable.elements
    length = f"[{count}]" if count else ""
    if c_type and re.fullmatch(r"[A-Za-z_]\w*", variable.expression, re.ASCII):
        at = (*variable.pointer[:-1], "CType" if variable.c_type else "DefinedBy")
        yield _Question(f"extern {c_type} {variable.expression}{length};", at, variable, is_definition=True)


def _seen(expression: str, code: CodeInterface) -> str:
    """A variable, seen from outside of an instance."""
    if code.signature == CLASS:
        return f"(({code.class_name} *)0)->{expression}"
    if code.signature == POINTERS:
        types = {each.name: each.type for each in code.objects or ()}
        names = "|".join(map(re.escape, types)) or r"(?!)"
        return re.sub(rf"(?<![\w.>])({names})\b", lambda match: f"(*({types[match[1]]} *)0)", expression)
    return expression


# -- answers ------------------------------------------------------------------------------------------------------


class _Seen(NamedTuple):
    """Answers of clang by line, and what they are compared with."""

    wrong: Mapping[int, str]
    types: Mapping[int, CType]
    is_complete: bool
    """Whether all headers of the system are there."""
    records: Mapping[str, Record]
    datatypes: Mapping[str, Datatype]
    provided: frozenset[Pointer]
    """Interfaces whose variables the adapter reads: these may be narrower than declared."""
    is_cpp: bool
    """Whether a reference looks like a pointer."""


def _compared(
    function: ResolvedFunction, questions: tuple[_Question, ...], answers: Declarations, before: int
) -> Iterator[Finding]:
    code = function.function.code
    seen = _Seen(
        wrong={error.place.line: error.message for error in answers.errors},
        types={each.place.line: each.type for each in answers.variables if each.name.startswith(_PROBE)},
        is_complete=not any(map(lacks_system_header, answers.errors)),
        records=answers.records,
        datatypes={each.reference: each for each in function.function.datatypes},
        provided=frozenset(pointer for pointer, _, item in data(function.function) if item.role == PROVIDER),
        is_cpp=code is not None and code.signature == CLASS,
    )
    unfit: set[Pointer] = set()
    for line, question in enumerate(questions, before + 1):
        if question.is_assigned and question.pointer in unfit:
            continue
        for finding in _of_question(function, question, line, seen):
            unfit.add(question.pointer)
            yield finding


def _of_question(function: ResolvedFunction, question: _Question, line: int, seen: _Seen) -> Iterator[Finding]:
    variable = question.variable
    if question.is_definition:
        if line in seen.wrong:
            yield _not_definable(function, question, seen.wrong[line])
    elif variable is None:
        return
    elif question.is_assigned:
        if line in seen.wrong and line - 2 not in seen.wrong:
            yield _not_assignable(function, question, variable, seen.wrong[line])
    elif question.element is not None:
        for message in _outside(variable, question.element, seen.types.get(line)):
            yield function.finding(codes.VARIABLE_TYPE_UNFIT, question.pointer, message, "Correct the index.")
    else:
        yield from _of_variable(function, question, variable, line, seen)


def _of_variable(
    function: ResolvedFunction, question: _Question, variable: CodeVariable, line: int, seen: _Seen
) -> Iterator[Finding]:
    if line in seen.wrong and line + 1 in seen.wrong:
        if seen.is_complete and variable.defined_by != _ADAPTER:
            yield _not_declared(function, question, variable, seen.wrong[line])
    else:
        for message, fix in _misfits(variable, line, seen, is_read=question.pointer[:-1] in seen.provided):
            yield function.finding(codes.VARIABLE_TYPE_UNFIT, question.pointer, message, fix)


def _outside(variable: CodeVariable, index: int, array: CType | None) -> Iterator[str]:
    """Say that an element is outside of its array, if the header says so."""
    if array is not None and array.kind == "array" and array.length and not 0 <= index < array.length:
        yield f"{variable.expression!r} must be within its array; the header has {array.length} elements, and {index} is the index."


def _not_assignable(function: ResolvedFunction, question: _Question, variable: CodeVariable, said: str) -> Finding:
    message = f"{variable.expression!r} must be a variable that the adapter can write; clang says: {said}."
    return function.finding(codes.VARIABLE_TYPE_UNFIT, question.pointer, message, "Correct this line, or the code.")


def _not_declared(function: ResolvedFunction, question: _Question, variable: CodeVariable, said: str) -> Finding:
    message = f"The headers must declare {variable.expression!r}; clang says: {said}."
    return function.finding(codes.CODE_UNFIT, question.pointer, message, "Correct this line, or the code.")


def _not_definable(function: ResolvedFunction, question: _Question, said: str) -> Finding:
    message = f"The adapter must define the variable as the header declares it; clang says: {said}."
    fix = "Give the type of the header as `cType`." if question.variable else "Correct the type."
    return function.finding(codes.VARIABLE_TYPE_UNFIT, question.pointer, message, fix)


class _Types(NamedTuple):
    """Types that both sides refer to, and how values of a variable are compared."""

    datatypes: Mapping[str, Datatype]
    records: Mapping[str, Record]
    members: Mapping[str, str]
    """Names of members in the code, by their names in the catalogue."""
    is_read: bool
    """Whether the adapter reads the variable: it may then be narrower than declared."""


class _Misfit(NamedTuple):
    """A difference between a variable and its declaration, and its fix."""

    message: str
    fix: str = "Correct the code, or the datatype."


def _misfits(variable: CodeVariable, line: int, seen: _Seen, *, is_read: bool) -> Iterator[_Misfit]:
    """Yield the differences of a variable. A queue needs an array with room for its values."""
    datatype = seen.datatypes.get(variable.datatype or "")
    found = None if line in seen.wrong else seen.types.get(line)
    if found is None:
        yield from _of_value(variable, datatype, seen.types.get(line + 1), is_bit_field=line in seen.wrong)
        return
    kind, count = found.target, variable.elements
    if count and kind.kind == "array" and kind.of:
        if kind.length and kind.length < count:
            yield _Misfit(f"{variable.expression!r} must have at least {count} elements; the header has {kind.length}.")
        kind = kind.of
    is_text = datatype is not None and datatype.vss_datatype == "string"
    is_array = datatype is not None and datatype.kind == "array"
    if found.kind == "pointer" and (is_array or not (count or is_text or seen.is_cpp)):
        expected = (
            f"an array{_of_length(datatype)}"
            if datatype and is_array
            else "a struct"
            if kind.kind == "record"
            else "one value"
        )
        yield _Misfit(f"{variable.expression!r} must be {expected}; the header has a pointer.")
        return
    compared = _Types(seen.datatypes, seen.records, dict(variable.members), is_read)
    yield from _differences(variable.expression, (), kind, datatype, compared)


def _of_value(
    variable: CodeVariable, datatype: Datatype | None, value: CType | None, *, is_bit_field: bool
) -> Iterator[_Misfit]:
    """Yield the difference of an expression without a type of a variable: a bit field, or a function."""
    if value is None:
        return
    if is_bit_field:
        if datatype is not None and value.kind == "number" and datatype.c_definition in _FLOATING:
            yield _Misfit(f"{variable.expression!r} must be {datatype.c_definition}; the header has a bit field.")
    elif value.kind == "pointer" and (datatype is None or _is_number(datatype)):
        yield _Misfit(f"{variable.expression!r} must be one value; the header has a function.")


def _is_number(datatype: Datatype) -> bool:
    return datatype.kind is None and datatype.vss_datatype != "string"


def _differences(
    expression: str, path: tuple[str, ...], kind: CType, datatype: Datatype | None, types: _Types
) -> Iterator[_Misfit]:
    if datatype is None or len(path) > _DEEPEST:
        return
    if datatype.kind == "array":
        yield from _of_array(expression, path, kind, datatype, types)
    elif datatype.kind == "struct":
        if kind.kind in ("number", "array"):
            yield _Misfit(f"{expression!r} must be a struct; the header has {_shown(kind)}.")
        elif kind.key in types.records and types.records[kind.key].is_complete:
            yield from _of_members(expression, path, types.records[kind.key], datatype, types)
    elif kind.kind in ("array", "record", "pointer") and datatype.vss_datatype != "string":
        yield _Misfit(f"{expression!r} must be one value; the header has {_shown(kind)}.")
    elif kind.kind == "enumeration":
        yield from _of_enumeration(expression, kind, datatype, is_read=types.is_read)
    elif kind.kind == "number" and "char" not in kind.names[-1:]:
        yield from _of_number(expression, kind, datatype, is_read=types.is_read)


_DEEPEST = 16


def _of_array(
    expression: str, path: tuple[str, ...], kind: CType, datatype: Datatype, types: _Types
) -> Iterator[_Misfit]:
    if kind.kind in ("number", "record"):
        yield _Misfit(f"{expression!r} must be an array{_of_length(datatype)}; the header has {_shown(kind)}.")
    elif kind.kind == "array" and kind.of:
        if datatype.length and kind.length and datatype.length != kind.length:
            yield _Misfit(f"{expression!r} must have {datatype.length} elements; the header has {kind.length}.")
        element = types.datatypes.get(datatype.element or "")
        if element is not None and element.kind != "array":
            yield from _differences(f"{expression}[0]", path, kind.of, element, types)


def _of_length(datatype: Datatype) -> str:
    return f" of {datatype.length}" if datatype.length else ""


def _shown(kind: CType) -> str:
    if kind.kind == "array":
        return f"an array of {kind.length}"
    if kind.kind == "pointer":
        return "a pointer"
    return f"the struct {kind.name}".rstrip() if kind.kind == "record" else kind.name


def _of_members(
    expression: str, path: tuple[str, ...], record: Record, datatype: Datatype, types: _Types
) -> Iterator[_Misfit]:
    known = {member.name: member for member in record.members}
    for field in datatype.fields or ():
        name = types.members.get(".".join((*path, field.name)), field.name)
        member = known.get(name)
        if member is None:
            fix = did_you_mean(name, known)
            fix = f"{fix} " if fix else ""
            yield _Misfit(
                f"{expression!r} must have the member {name!r}; the struct of the header has {', '.join(known) or 'none'}.",
                f"{fix}Name the member of the code with `members`, or correct the code.",
            )
        elif member.width is None:  # a bit field has the size of its bits
            inner = types.datatypes.get(field.datatype)
            yield from _differences(f"{expression}.{name}", (*path, field.name), member.type, inner, types)


_ENUMERATION = 32
"""Bits of an enumeration of the usual size."""


def _of_enumeration(expression: str, kind: CType, datatype: Datatype, *, is_read: bool) -> Iterator[_Misfit]:
    """Yield the difference of an enumeration of C and a number: its size, or that it holds no fractions."""
    declared, bits = _number(datatype), kind.bits or _ENUMERATION
    is_narrow = declared is not None and (bits > declared.bits if is_read else bits < declared.bits)
    if declared is not None and (declared.sort == "floating" or is_narrow):
        message = f"{expression!r} must be {datatype.c_definition}; the header has an enumeration of {bits} bits."
        yield _Misfit(message)


def _of_number(expression: str, kind: CType, datatype: Datatype, *, is_read: bool) -> Iterator[_Misfit]:
    has, declared = _Number(kind.sort, kind.bits), _number(datatype)
    if declared is None:
        if has.sort == "floating" and datatype.vss_datatype != "string":
            yield _Misfit(f"{expression!r} must be an integer; the header has {kind.name}.", "Correct the code.")
        elif unheld := [each for each in datatype.symbols or () if not has.holds(each.value)]:
            number = f"{unheld[0].value}, the number of {unheld[0].symbol}"
            message = f"{expression!r} must hold {number}; the header has {kind.name}."
            yield _Misfit(message, "Correct the number, or the code.")
    elif not (has.fits(declared) if is_read else declared.fits(has)):
        message = f"{expression!r} must be {datatype.c_definition}; the header has {kind.name}."
        yield _Misfit(message, f"Give `datatype: {vss_datatype(kind)}`, or correct the code.")


def _number(datatype: Datatype) -> _Number | None:
    """The number that a datatype is; None for a flag, an enumeration or anything else."""
    if datatype.kind is not None:
        return None
    if datatype.c_definition in _FLOATING:
        return _Number("floating", _FLOATING[datatype.c_definition])
    match = _SIZED.fullmatch(datatype.c_definition)
    return _Number("unsigned" if match["unsigned"] else "signed", int(match["bits"])) if match else None
