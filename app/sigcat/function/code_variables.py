"""Variables and functions of the code, compared with the headers that declare them, where these and libclang are at hand."""

import re
from collections.abc import Iterable, Iterator, Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.findings import Finding, RuleCode
from sigcat.function.c_project.declarations import CFunction, CompilerError, CType, Declarations, Member, Record
from sigcat.function.c_project.files import CodeFiles, headers_of
from sigcat.function.c_project.parsing import lacks_system_header, parse_unit, syntax_error
from sigcat.function.code_calls import called_functions, lines_of, unfit_calls
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.code import CLASS, GLOBALS, POINTERS, CodeInterface, is_inside
from sigcat.function.function_json.datatypes.datatype import Datatype, innermost
from sigcat.function.function_json.interfaces.role import PROVIDER
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.variables import CodeVariable, variables
from sigcat.function.function_json.walk import data, declared_data, errors, parameters, safety_reactions
from sigcat.function.variable_types import Seen, Types, misfits

_ADAPTER = "Adapter"
_INDEX = re.compile(r"\[\s*(-?[0-9]+)\s*\]")
_ROOT = re.compile(r"[(*&\s]*([A-Za-z_]\w*)")
"""The variable at the begin of an expression."""
_MEMBER = re.compile(r"(?P<owner>.*\w.*?) *(?:\.|->) *(?P<name>[A-Za-z_]\w*) *")
"""A member of a struct, such as `in.flags` or `list[1]->flags`."""
_UNIT = "sigcat-variables"
_PROBE = "sigcat_variable_"


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
    member: str = ""
    """Name of the variable in its struct; the line has the type of the struct."""


def unfit_code(function: ResolvedFunction) -> Iterator[Finding]:
    """A finding for each variable and function that is not as declared. Headers that are incomplete are not compared."""
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
    called = tuple(called_functions(function, code))
    lines = [line for number, each in enumerate(called) for line in lines_of(each, number, code)]
    answers = _answers(code, texts, (*(each.text for each in questions), *lines))
    if isinstance(answers, CompilerError):
        message = f"The headers must compile to be compared with the declaration; clang says: {answers.message[:200]}."
        at = (str(folder / answers.place.file), answers.place.line, answers.column)
        yield codes.CODE_UNFIT.finding(message, *at, fix="Correct the header.")
        return
    if answers is None:
        return
    before = len(_head(code))
    yield from _compared(function, questions, answers, before)
    yield from unfit_calls(function, called, answers, before + len(questions) + 1)
    if code.signature != CLASS:  # constants and inline variables of C++ are defined in headers
        yield from _defined_in_headers(folder, answers)


def _defined_in_headers(folder: Path, answers: Declarations) -> Iterator[Finding]:
    """A finding for each variable and function that every file including a header defines again."""
    for each in answers.named:
        is_own = isinstance(each, CFunction) and each.is_inline
        if not each.is_defined or each.is_static or is_own or each.place.file.startswith(_UNIT):
            continue
        what, way = ("function", "") if isinstance(each, CFunction) else ("variable", " as extern")
        message = f"The header must declare the {what} {each.name!r}, not define it: each file that includes the header defines it again."
        fix = f"Declare it{way} in the header, and define it in one source."
        file = str(folder / each.place.file)
        yield codes.DEFINED_IN_HEADER.finding(message, file, each.place.line, fix=fix)


def _head(code: CodeInterface) -> list[str]:
    return ["#include <stdint.h>", "#include <stdbool.h>", *(f'#include "{each}"' for each in code.headers or ())]


def _answers(
    code: CodeInterface, texts: Mapping[str, str], lines: Iterable[str]
) -> Declarations | CompilerError | None:
    """The answers of the compiler; an error of a header, or None if headers are not found."""
    unit = f"{_UNIT}.{'cpp' if code.signature == CLASS else 'c'}"
    text = "\n".join([*_head(code), *lines, ""])
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
    return syntax_error(found.errors, texts) if is_incomplete else found


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
        if member := _MEMBER.fullmatch(seen):
            text = f"extern {word}({member['owner']}) {_PROBE}{number}_owner;"
            yield _Question(text, variable.pointer, member=member["name"])
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


class _Answers(NamedTuple):
    """Answers of clang by line, and what they are compared with."""

    function: ResolvedFunction
    wrong: Mapping[int, str]
    types: Mapping[int, CType]
    static_names: frozenset[str]
    """Names of variables that each file has for itself."""
    is_complete: bool
    """Whether all headers of the system are there."""
    compared: Types
    provided: frozenset[Pointer]
    """Interfaces whose variables the adapter reads."""
    members: Mapping[Pointer, Member]
    """Variables that are members of a struct."""

    def finding(
        self, question: _Question, message: str, fix: str, rule: RuleCode = codes.VARIABLE_TYPE_UNFIT
    ) -> Finding:
        """A finding at what a question was made from."""
        return self.function.finding(rule, question.pointer, message, fix)


def _compared(
    function: ResolvedFunction, questions: tuple[_Question, ...], answers: Declarations, before: int
) -> Iterator[Finding]:
    code = function.function.code
    types = {each.place.line: each.type for each in answers.variables if each.name.startswith(_PROBE)}
    seen = _Answers(
        function=function,
        wrong={error.place.line: error.message for error in answers.errors},
        types=types,
        static_names=frozenset(each.name for each in answers.variables if each.is_static),
        is_complete=not any(map(lacks_system_header, answers.errors)),
        compared=Types(
            datatypes={each.reference: each for each in function.function.datatypes},
            records=answers.records,
            constants=answers.enumerations,
            members={},
            is_read=False,
            is_replaced=False,
            is_cpp=code is not None and code.signature == CLASS,
        ),
        provided=frozenset(pointer for pointer, _, item in data(function.function) if item.role == PROVIDER),
        members=dict(_members(questions, types, answers.records, before)),
    )
    unfit: set[Pointer] = set()
    for line, question in enumerate(questions, before + 1):
        if question.is_assigned and question.pointer in unfit:
            continue
        for finding in _of_question(question, line, seen):
            unfit.add(question.pointer)
            yield finding


def _members(
    questions: tuple[_Question, ...], types: Mapping[int, CType], records: Mapping[str, Record], before: int
) -> Iterator[tuple[Pointer, Member]]:
    """Variables that are members of a struct, as the headers declare these."""
    for line, question in enumerate(questions, before + 1):
        if question.member and line in types:
            record = records.get(types[line].target.key)
            for each in record.members if record else ():
                if each.name == question.member:
                    yield question.pointer, each


def _of_question(question: _Question, line: int, seen: _Answers) -> Iterator[Finding]:
    variable, said = question.variable, seen.wrong.get(line)
    if question.is_definition:
        if said is not None:
            message = f"The adapter must define the variable as the header declares it; clang says: {said}."
            fix = "Give the type of the header as `cType`." if variable else "Correct the type."
            yield seen.finding(question, message, fix)
    elif variable is None:
        return
    elif question.is_assigned:
        if said is not None and line - 2 not in seen.wrong:
            message = f"{variable.expression!r} must be a variable that the adapter can write; clang says: {said}."
            yield seen.finding(question, message, "Correct this line, or the code.")
    elif question.element is not None:
        array, index = seen.types.get(line), question.element
        if array is not None and array.kind == "array" and array.length and not 0 <= index < array.length:
            has = f"the header has {array.length} elements, and {index} is the index"
            message = f"{variable.expression!r} must be within its array; {has}."
            yield seen.finding(question, message, "Correct the index.")
    else:
        yield from _of_variable(question, variable, line, seen)


def _of_variable(question: _Question, variable: CodeVariable, line: int, seen: _Answers) -> Iterator[Finding]:
    root = _ROOT.match(variable.expression)
    if root is not None and root[1] in seen.static_names:
        message = f"{variable.expression!r} must not be static: each file that includes the header has its own."
        fix = "Declare it as extern in the header, and define it in one source."
        yield seen.finding(question, message, fix)
    elif line in seen.wrong and line + 1 in seen.wrong:
        if seen.is_complete and variable.defined_by != _ADAPTER:
            message = f"The headers must declare {variable.expression!r}; clang says: {seen.wrong[line]}."
            yield seen.finding(question, message, "Correct this line, or the code.", codes.CODE_UNFIT)
    else:
        members, is_read = dict(variable.members), question.pointer[:-1] in seen.provided
        types = seen.compared._replace(members=members, is_read=is_read, is_replaced=variable.is_replaced)
        is_bit_field = line in seen.wrong
        member = seen.members.get(question.pointer)
        known = Seen(
            type=None if is_bit_field else seen.types.get(line),
            value=member.type if is_bit_field and member else seen.types.get(line + 1),
            is_bit_field=is_bit_field,
            width=member.width if member else None,
        )
        for message, fix in misfits(variable, known, types):
            yield seen.finding(question, message, fix)
