"""Strings of a function that the types of their fields refuse: what generators would refuse is found here."""

from typing import NamedTuple

from sigcat import codes
from sigcat.function.document.document import Pointer
from sigcat.function.document.field_types import C_EXPRESSION, VSS_PATH
from sigcat.function.document.problem import Problem, Problems
from sigcat.function.document.unfit_texts import Unfit, titled, unfit_texts
from sigcat.function.function_json.datatypes.datatype import innermost
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import Origin
from sigcat.function.function_json.walk import data, parameters


def check_texts(function: FunctionJson, origin: Origin | None = None) -> Problems:
    """Every string that is not of the type of its field, which is called as it is in the declaration at `origin`."""

    def written(pointer: Pointer) -> Pointer | None:
        return origin and origin.exactly(pointer)

    def name(pointer: Pointer) -> str:
        user = None if written(pointer) else _user_of_symbol(function, pointer)
        return f"An allowed value of {user.name!r}" if user else titled(written(pointer) or pointer)

    own = function.info.function_name
    texts = tuple(unfit_texts(function, accessors_of(function), name))
    made_of_name = [each for each in texts if origin is not None and _is_path_of(own, each, written(each.pointer))]
    if made_of_name:
        message = f"The name of a function must be letters, digits and underscores, a letter first, not {own!r}."
        yield Problem(codes.TEXT_OF_WRONG_TYPE, ("FunctionInfo", "FunctionName"), message)
    for each in texts:
        if each in made_of_name:
            continue
        rule = codes.VARIABLE_NO_EXPRESSION if each.grammar is C_EXPRESSION else codes.TEXT_OF_WRONG_TYPE
        user = None if written(each.pointer) or origin is None else _user_of_symbol(function, each.pointer)
        yield Problem(rule, user.pointer if user else each.pointer, each.message, each.fix)


def _is_path_of(function: str, text: Unfit, written: Pointer | None) -> bool:
    """Whether a text is a path that was made of the name of a function, which no path can have."""
    return text.grammar is VSS_PATH and written is None and not VSS_PATH.accepts(function)


class _User(NamedTuple):
    """A signal or parameter, and its place."""

    pointer: Pointer
    name: str


def _user_of_symbol(function: FunctionJson, pointer: Pointer) -> _User | None:
    """The first signal or parameter of the datatype that has a symbol: the catalogue declares it."""
    if pointer[:1] != ("Datatypes",) or pointer[2:3] != ("Symbols",):
        return None
    types = {each.reference: each for each in function.datatypes}
    datatype = function.datatypes[int(pointer[1])]
    users = (*data(function), *parameters(function))
    return next(
        (
            _User((*at, "VssPath"), item.vss_path or item.name)
            for at, _, item in users
            if innermost(item.datatype, types) == datatype
        ),
        None,
    )


def accessors_of(function: FunctionJson) -> tuple[str, ...]:
    """The functions that expressions of a function may call."""
    return (function.code.accessors or ()) if function.code else ()
