"""The C code of a function: its files, its objects, the calls in it, and who defines its variables."""

from collections.abc import Mapping

from sigcat import codes
from sigcat.function.declaration.form import key_of
from sigcat.function.document.document import Pointer
from sigcat.function.document.expression import is_identifier, root_of
from sigcat.function.document.field_types import C_IDENTIFIER, C_MEMBER, C_TYPE, CPP_CLASS
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.function_json.code import (
    CLASS,
    GLOBALS,
    MOST_ELEMENTS,
    POINTERS,
    CodeInterface,
    CodeObject,
    is_inside,
)
from sigcat.function.function_json.datatypes.datatype import Datatype
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.role import PROVIDER
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.variables import CodeVariable, variables
from sigcat.function.function_json.walk import arguments, methods, runnables, subject_of
from sigcat.names import did_you_mean, either

ADAPTER = "Adapter"


def check_code(function: FunctionJson) -> Problems:
    """Every problem of the code."""
    code = function.code
    if code is not None:
        yield from _paths(code)
        yield from _macros(code)
        yield from _class(code)
        yield from _objects(code)
    yield from _arguments(function)
    yield from _symbols(function)
    yield from _methods(function)
    yield from _argument_lengths(function)
    yield from _roots(function)
    yield from _definers(function)


def declared_objects(function: FunctionJson) -> tuple[CodeObject, ...]:
    """The objects of the code."""
    return (function.code.objects or ()) if function.code else ()


# -- files --------------------------------------------------------------------------------------------------------


def _paths(code: CodeInterface) -> Problems:
    """Files move with the declaration: none stands elsewhere."""
    lists = {"Sources": code.sources, "Headers": code.headers, "IncludeFolders": code.include_folders}
    for key, paths in lists.items():
        for index, path in enumerate(paths or ()):
            if not is_inside(path):
                condition = "A path must be relative, with `/`, and lead into the folder of the declaration"
                message = f"{condition}, not {path!r}."
                fix = "Put the file beside the declaration, or below it."
                yield Problem(codes.CODE_FILE_ELSEWHERE, ("Code", key, index), message, fix)


# -- the signature ------------------------------------------------------------------------------------------------


def _class(code: CodeInterface) -> Problems:
    if code.signature not in (GLOBALS, POINTERS, CLASS):
        message = f"`Signature` must be {either((GLOBALS, POINTERS, CLASS))}, not {code.signature!r}."
        yield Problem(codes.SIGNATURE_UNFIT, ("Code", "Signature"), message)
    elif code.signature == CLASS and code.class_name is None:
        message = "The class whose members the calls are must be named."
        yield Problem(codes.SIGNATURE_UNFIT, ("Code", "Signature"), message, "Give `class`, with its namespaces.")
    elif code.signature != CLASS and code.class_name is not None:
        message = f"A class must be named only where the calls are its members, not with {code.signature.lower()}."
        yield Problem(codes.SIGNATURE_UNFIT, ("Code", "ClassName"), message, "Remove it, or write `signature: class`.")
    elif code.signature == POINTERS and not code.objects:
        message = "`signature: pointers` needs `objects`: calls take pointers to them."
        fix = "List the objects, or write `signature: globals`."
        yield Problem(codes.SIGNATURE_UNFIT, ("Code", "Signature"), message, fix)
    if code.class_name is not None and not CPP_CLASS.accepts(code.class_name):
        message = f"The class must have a name of C++, such as control::Acc, not {code.class_name!r}."
        yield Problem(codes.NAME_NO_C_NAME, ("Code", "ClassName"), message)


def _macros(code: CodeInterface) -> Problems:
    for index, each in enumerate(code.definitions or ()):
        if not is_identifier(each.name):
            yield _no_name(each.name, "A definition of the preprocessor", ("Code", "Macros", index, "Name"))


def _objects(code: CodeInterface) -> Problems:
    seen: set[str] = set()
    for index, each in enumerate(code.objects or ()):
        at: Pointer = ("Code", "Objects", index)
        if not is_identifier(each.name):
            yield _no_name(each.name, "An object", (*at, "Name"))
        if each.name in seen:
            message, fix = f"There are two objects {each.name!r}.", "Rename one."
            yield Problem(codes.OBJECT_UNFIT, (*at, "Name"), message, fix)
        seen.add(each.name)
        yield from _object(each, index, code.signature, at)


def _object(each: CodeObject, index: int, signature: str, at: Pointer) -> Problems:
    if not C_TYPE.accepts(each.type):
        message = f"The type of {each.name!r} must be the name of one in C, not {each.type!r}."
        yield Problem(codes.OBJECT_UNFIT, (*at, "Type"), message, "Write it as the header does, such as ExtU_Acc_T.")
    if each.member is not None and not C_MEMBER.accepts(each.member):
        yield _no_name(each.member, "The member that points to an object", (*at, "Member"))
    if each.length is not None and (signature != GLOBALS or each.defined_by != ADAPTER):
        message = f"Only a global variable that the adapter defines has a `length`, not {each.name!r}."
        yield Problem(codes.OBJECT_UNFIT, (*at, "Length"), message, "Remove `length`, or add `definedBy: adapter`.")
    elif not each.has_valid_length:
        message = f"`length` of {each.name!r} must be 1 to {MOST_ELEMENTS}, not {each.length}."
        yield Problem(codes.OBJECT_UNFIT, (*at, "Length"), message)
    if each.member is not None and (index == 0 or signature != POINTERS):
        message = "Only with pointers, an object after the first one is pointed to by a member of the first."
        yield Problem(codes.OBJECT_UNFIT, (*at, "Member"), message, "Remove `member`.")
    if signature == POINTERS and each.defined_by not in (None, ADAPTER):
        message = f"With pointers the adapter holds {each.name!r}, for each instance: the function cannot define it."
        yield Problem(codes.OBJECT_UNFIT, (*at, "DefinedBy"), message, "Remove `definedBy`.")


def _no_name(name: str, what: str, at: Pointer) -> Problem:
    return Problem(codes.NAME_NO_C_NAME, at, f"{what} must have a name of C, not {name!r}.", C_IDENTIFIER.fix)


# -- calls --------------------------------------------------------------------------------------------------------


def _arguments(function: FunctionJson) -> Problems:
    names = [each.name for each in declared_objects(function)]
    signature = function.code.signature if function.code else GLOBALS
    for pointer, _, call in runnables(function):
        subject = Subject("scheduling", call.name)
        if call.arguments and signature != POINTERS:
            message = f"{call.name} must take no arguments, as its code has the signature {signature.lower()}."
            fix = "Remove them, or write `signature: pointers` under `code`."
            yield Problem(codes.ARGUMENT_UNKNOWN, (*pointer, "Arguments"), message, fix, subject)
            continue
        for index, argument in enumerate(call.arguments or ()):
            if argument not in names:
                message = f"The arguments of {call.name} must be objects of the code, not {argument!r}."
                fix = did_you_mean(argument, names) or "List it under `objects` of `code`."
                yield Problem(codes.ARGUMENT_UNKNOWN, (*pointer, "Arguments", index), message, fix, subject)


def _symbols(function: FunctionJson) -> Problems:
    for pointer, _, call in runnables(function):
        named: list[tuple[Pointer, str]] = [(("Symbol",), call.symbol)] if call.symbol is not None else []
        for key, symbols in (("PreProcessing", call.pre_processing), ("PostProcessing", call.post_processing)):
            named += [((key, index), symbol) for index, symbol in enumerate(symbols or ())]
        for below, symbol in named:
            if not is_identifier(symbol):
                yield _no_name(symbol, f"A function that {call.name} calls", (*pointer, *below))
    for pointer, _, method in methods(function):
        if method.symbol is not None and not is_identifier(method.symbol):
            yield _no_name(method.symbol, f"The function of {method.name}", (*pointer, "Symbol"))


def _methods(function: FunctionJson) -> Problems:
    """Fields that only the other side of a method has."""
    for pointer, _, method in methods(function):
        is_provided = method.role == PROVIDER
        role, other = ("provided", "used") if is_provided else ("consumed", "offered")
        for field in ("timeout", "request_variable", "status_variable") if is_provided else ("symbol",):
            if getattr(method, field) is not None:
                message = f"{method.name!r} is {role}: `{key_of(field)}` is that of a method that is {other}."
                at = (*pointer, str(MethodInterface.model_fields[field].alias))
                yield Problem(codes.METHOD_UNFIT, at, message, "Remove it.", subject_of(method))


def _argument_lengths(function: FunctionJson) -> Problems:
    """An argument that is kept in a variable has a length that is known."""
    known = {datatype.reference: datatype for datatype in function.datatypes or ()}
    for pointer, _, method in methods(function):
        for below, argument in arguments(method):
            if argument.variable is not None and _is_open(argument.datatype, known):
                message = (
                    f"The argument {argument.name} of {method.name} must have a length that is known, for no adapter "
                    "can be generated with a text or an array of open length."
                )
                at, fix = (*pointer, *below, "Datatype"), "Give it a struct, or a number for each element."
                yield Problem(codes.ARGUMENT_OF_OPEN_LENGTH, at, message, fix, subject_of(method))


def _is_open(reference: str, known: Mapping[str, Datatype], above: frozenset[str] = frozenset()) -> bool:
    """Whether a datatype is a text or an array of open length, or holds one."""
    datatype = known.get(reference)
    if datatype is None or reference in above:
        return False
    if datatype.vss_datatype == "string" or (datatype.kind == "array" and datatype.length is None):
        return True
    inner = (datatype.element, *(field.datatype for field in datatype.fields or ()))
    return any(each is not None and _is_open(each, known, above | {reference}) for each in inner)


# -- variables ----------------------------------------------------------------------------------------------------


def _roots(function: FunctionJson) -> Problems:
    """With pointers there is nothing but the objects of an instance."""
    if function.code is None or function.code.signature != POINTERS or not function.code.objects:
        return
    names = [each.name for each in function.code.objects]
    for each in variables(function):
        root = root_of(each.expression)
        if root is not None and root not in names and root not in (function.code.accessors or ()):
            message = f"{each.expression!r} must begin with an object of the code, not with {root!r}."
            fix = did_you_mean(root, names) or f"Begin with {either(dict.fromkeys(names))}, or list it under `objects`."
            yield Problem(codes.EXPRESSION_OF_NO_OBJECT, each.pointer, message, fix, each.place.subject)


def _definers(function: FunctionJson) -> Problems:
    """Report variables that the adapter defines without a name and a type that it knows."""
    objects = {each.name for each in declared_objects(function)}
    types = {each.reference: each for each in function.datatypes}
    for each in variables(function):
        if each.defined_by != ADAPTER or each.expression in objects or root_of(each.expression) is None:
            continue
        if not is_identifier(each.expression):
            message = f"The adapter must define a variable by its name, not {each.expression!r}."
            root, keys = root_of(each.expression), "type, `length`" if "[" in each.expression else "type"
            fix = f"List {root!r} under `objects` of `code` with its {keys} and `definedBy: adapter`."
            yield _undefinable(each, message, fix)
        elif each.elements is not None and _is_array(each.datatype, types):
            message = f"The adapter must define a variable of one dimension; {each.expression!r} holds several arrays."
            yield _undefinable(each, message, "Define it in the code of the function.")
        elif each.datatype is not None and not each.c_type and not _is_plain(each.datatype, types):
            message = f"The adapter must know the type of {each.expression!r} in C, and has none for a struct or an open array."
            fix = "Give its `cType`."
            yield _undefinable(each, message, fix)


def _is_array(reference: str | None, types: Mapping[str, Datatype]) -> bool:
    datatype = types.get(reference or "")
    return datatype is not None and datatype.kind == "array"


def _undefinable(each: CodeVariable, message: str, fix: str) -> Problem:
    at = (*each.pointer[:-1], "DefinedBy")
    return Problem(codes.VARIABLE_NOT_DEFINABLE, at, message, fix, each.place.subject)


def _is_plain(reference: str, types: Mapping[str, Datatype]) -> bool:
    """Whether a datatype is a number, an enumeration, or an array of a fixed length of these."""
    datatype = types.get(reference)
    if datatype is not None and datatype.kind == "array":
        return datatype.length is not None and _is_plain(datatype.element or "", types)
    return datatype is not None and datatype.kind != "struct"
