"""Names that functions use, and those that they write: variables, members, and other functions."""

from typing import Any

from clang import cindex
from clang.cindex import Cursor, CursorKind

from sigcat.function.c_project.libclang.answer import Json, qualified

_ASSIGN, _FIRST_STEP, _LAST_STEP, _ADDRESS = 22, 1, 4, 5
"""Numbers of libclang: `=`; `++` and `--` behind and before; `&`."""


def uses_of(cursor: Cursor) -> Json:
    """Return the functions, variables and members that a body or a value names, and those that it writes."""
    used: set[str] = set()
    written: set[str] = set()

    def visit(each: Cursor, _parent: Cursor, _data: Any) -> int:
        each._tu = cursor._tu  # noqa: SLF001 - as libclang's own loop does, which makes lists of all that it visits
        kind = each._kind_id  # noqa: SLF001
        if kind in _REFERENCES:
            used.update(_name_referred_to(each))
        elif kind in _OPERATORS and _writes(each):
            written.update(_base(next(each.get_children())))
        elif kind == CursorKind.CALL_EXPR.value:
            written.update(_handed_over(each))
        return _RECURSE

    cindex.conf.lib.clang_visitChildren(cursor, cindex.callbacks["cursor_visit"](visit), None)
    return {"uses": sorted(used), "writes": sorted(written)}


_RECURSE = 2
_REFERENCES = frozenset((CursorKind.DECL_REF_EXPR.value, CursorKind.MEMBER_REF_EXPR.value))
_OPERATORS = frozenset((
    CursorKind.BINARY_OPERATOR.value, CursorKind.UNARY_OPERATOR.value, CursorKind.COMPOUND_ASSIGNMENT_OPERATOR.value,
))  # fmt: skip
_OUTER = (CursorKind.FUNCTION_DECL, CursorKind.VAR_DECL, CursorKind.CXX_METHOD)


def _name_referred_to(cursor: Cursor) -> set[str]:
    """Meaning of a reference: a name, or the key of a member."""
    target = cursor.referenced
    if target is not None and target.kind == CursorKind.FIELD_DECL:
        return {target.get_usr()}
    if target is None or target.kind not in _OUTER:
        return set()
    parent = target.semantic_parent
    is_local = parent is not None and parent.kind in (CursorKind.FUNCTION_DECL, CursorKind.CXX_METHOD)
    return set() if is_local else {qualified(target)}


def _writes(cursor: Cursor) -> bool:
    library = cindex.conf.lib
    if cursor.kind == CursorKind.BINARY_OPERATOR:
        return bool(library.clang_getCursorBinaryOperatorKind(cursor) == _ASSIGN)
    if cursor.kind == CursorKind.UNARY_OPERATOR:
        return _FIRST_STEP <= int(library.clang_getCursorUnaryOperatorKind(cursor)) <= _LAST_STEP
    return bool(cursor.kind == CursorKind.COMPOUND_ASSIGNMENT_OPERATOR)


def _handed_over(call: Cursor) -> set[str]:
    """Variables whose address a call takes: it may write them. What it copies from, it does not."""
    arguments = list(call.get_arguments())
    read_only = arguments[1:] if call.spelling in ("memcpy", "memmove") else []
    library = cindex.conf.lib
    found: set[str] = set()
    for argument in arguments:
        is_address = argument.kind == CursorKind.UNARY_OPERATOR and (
            library.clang_getCursorUnaryOperatorKind(argument) == _ADDRESS
        )
        if is_address and argument not in read_only:
            found |= _base(next(argument.get_children()))
    return found


def _base(cursor: Cursor) -> set[str]:
    """The variable in which a place lies, and the members on the way: `rtY`, `bus` and `speed` of `rtY.bus.speed[2]`."""
    found: set[str] = set()
    while cursor.kind != CursorKind.DECL_REF_EXPR:
        if cursor.kind == CursorKind.MEMBER_REF_EXPR:
            found |= _name_referred_to(cursor)
        inner = next(cursor.get_children(), None)
        if inner is None:
            return found
        cursor = inner
    return found | _name_referred_to(cursor)
