"""Values that variables have from the start, as far as clang can compute them."""

from typing import Any

from clang import cindex
from clang.cindex import Cursor, CursorKind

from sigcat.function.c_project.libclang.answer import Json


def value_of(cursor: Cursor) -> Any:
    """A constant: a number; a list of values; a mapping where members are named; None where clang cannot tell."""
    if cursor.kind != CursorKind.INIT_LIST_EXPR:
        children = list(cursor.get_children())
        is_list = (
            cursor.kind == CursorKind.UNEXPOSED_EXPR and children and children[-1].kind == CursorKind.INIT_LIST_EXPR
        )
        return value_of(children[-1]) if is_list else _number(cursor)
    named: Json = {}
    listed = []
    for child in cursor.get_children():
        parts = list(child.get_children())
        if child.kind == CursorKind.UNEXPOSED_EXPR and parts and parts[0].kind == CursorKind.MEMBER_REF:
            named[parts[0].spelling] = value_of(parts[-1])
        else:
            listed.append(value_of(child))
    return named or listed


def _number(cursor: Cursor) -> int | float | None:
    library = cindex.conf.lib
    result = library.clang_Cursor_Evaluate(cursor)
    if not result:
        return None
    try:
        kind = library.clang_EvalResult_getKind(result)
        if kind == 1:
            return int(library.clang_EvalResult_getAsLongLong(result))
        return float(library.clang_EvalResult_getAsDouble(result)) if kind == 2 else None
    finally:
        library.clang_EvalResult_dispose(result)
