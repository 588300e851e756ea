"""Strings of a function that the types of their fields refuse: what generators would refuse is found here."""

from collections.abc import Iterator
from typing import NamedTuple

from sigcat import codes
from sigcat.function.document.document import Pointer
from sigcat.function.document.field_types import C_EXPRESSION, VSS_PATH
from sigcat.function.document.problem import Problem
from sigcat.function.document.unfit_texts import titled, unfit_texts
from sigcat.function.function_json.datatypes.datatype import innermost
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import Origin
from sigcat.function.function_json.walk import data, parameters


def check_texts(function: FunctionJson, origin: Origin | None = None) -> Iterator[Problem]:
    """Every string that is not of the type of its field, which is called as it is in the declaration at `origin`."""

    def written(pointer: Pointer) -> Pointer | None:
        return origin and origin.exactly(pointer)

    def name(pointer: Pointer) -> str:
        user = None if written(pointer) else _user_of_symbol(function, pointer)
        return f"An allowed value of {user.name!r}" if user else titled(written(pointer) or pointer)

    own = function.info.function_name
    is_in_paths = VSS_PATH.accepts(own)
    if not is_in_paths:
        message = f"The name of a function must be letters, digits and underscores, a letter first, not {own!r}."
        yield Problem(codes.TEXT_OF_WRONG_TYPE, ("FunctionInfo", "FunctionName"), message)
    for each in unfit_texts(function, accessors_of(function), name):
        if each.grammar is VSS_PATH and not is_in_paths and not written(each.pointer):
            continue  # the path is made of the name
        rule = codes.VARIABLE_NO_EXPRESSION if each.grammar is C_EXPRESSION else codes.TEXT_OF_WRONG_TYPE
        user = None if written(each.pointer) or origin is None else _user_of_symbol(function, each.pointer)
        yield Problem(rule, user.pointer if user else each.pointer, each.message, each.fix)


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
