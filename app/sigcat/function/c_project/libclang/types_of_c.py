"""Types: numbers, arrays, pointers, structs and enumerations, each with the names that it goes by."""

from collections.abc import Iterator, Sequence
from typing import Any

from clang.cindex import Cursor, CursorKind, TypeKind

from sigcat.file_kind import C_SOURCES
from sigcat.function.c_project.libclang.answer import Answer, Json, file_of, place_of, qualified

_DEEPEST = 12
_INT = 4
"""Bytes of an enumeration of C, whatever its numbers."""
_FLOATING = (TypeKind.FLOAT, TypeKind.DOUBLE, TypeKind.LONGDOUBLE)
_UNSIGNED = (
    TypeKind.CHAR_U, TypeKind.UCHAR, TypeKind.CHAR16, TypeKind.CHAR32, TypeKind.USHORT, TypeKind.UINT, TypeKind.ULONG,
    TypeKind.ULONGLONG,
)  # fmt: skip
_SIGNED = (
    TypeKind.CHAR_S, TypeKind.SCHAR, TypeKind.WCHAR, TypeKind.SHORT, TypeKind.INT, TypeKind.LONG, TypeKind.LONGLONG,
)  # fmt: skip
_SORTS = {
    **dict.fromkeys(_FLOATING, "floating"),
    **dict.fromkeys(_UNSIGNED, "unsigned"),
    **dict.fromkeys(_SIGNED, "signed"),
    TypeKind.BOOL: "boolean",
}


def type_of(kind: Any, answer: Answer, depth: int = 0) -> Json:
    """A type with the names that it goes by, the one that is written first."""
    canonical = kind.get_canonical()
    names = _names(kind)
    if depth > _DEEPEST:
        return {"kind": "other", "names": names}
    if canonical.kind in (TypeKind.CONSTANTARRAY, TypeKind.INCOMPLETEARRAY):
        return _array(kind, canonical, answer, depth)
    if canonical.kind in (TypeKind.POINTER, TypeKind.LVALUEREFERENCE):
        to = _inner(kind.get_pointee(), canonical.get_pointee())
        return {"kind": "pointer", "const": to.is_const_qualified(), "of": type_of(to, answer, depth + 1)}
    if canonical.kind == TypeKind.RECORD:
        return _struct(canonical, names, answer, depth)
    if canonical.kind == TypeKind.ENUM:
        declaration = canonical.get_declaration()
        number = _number(declaration.enum_type.get_canonical(), ()) if canonical.get_size() != _INT else {}
        return {**number, "kind": "enumeration", "names": names, "key": _enumeration(declaration, answer)}
    return _number(canonical, names)


def _struct(canonical: Any, names: list[str], answer: Answer, depth: int) -> Json:
    if canonical.spelling.startswith("std::array<"):
        elements = next(iter(canonical.get_fields())).type
        return _array(elements, elements.get_canonical(), answer, depth)
    return {"kind": "record", "names": names, "key": _record(canonical.get_declaration(), answer, depth)}


def _number(canonical: Any, names: Sequence[str]) -> Json:
    if canonical.kind in _SORTS:
        return {"kind": "number", "names": names, "sort": _SORTS[canonical.kind], "bits": canonical.get_size() * 8}
    return {"kind": "void" if canonical.kind == TypeKind.VOID else "other", "names": names}


def _array(kind: Any, canonical: Any, answer: Answer, depth: int) -> Json:
    """An array; one without a length is a pointer to its elements."""
    element = _inner(kind.get_array_element_type(), canonical.get_array_element_type())
    of = type_of(element, answer, depth + 1)
    if canonical.kind == TypeKind.CONSTANTARRAY:
        return {"kind": "array", "length": canonical.get_array_size(), "of": of}
    return {"kind": "pointer", "const": element.is_const_qualified(), "of": of}


def _inner(written: Any, canonical: Any) -> Any:
    """A type within another one, by the name that is written where there is one."""
    return written if written.kind != TypeKind.INVALID else canonical


def _names(kind: Any) -> list[str]:
    """The written name, and those of the types behind it."""
    names: list[str] = []
    while len(names) < _DEEPEST:
        declaration = kind.get_declaration()
        if declaration.kind not in (CursorKind.TYPEDEF_DECL, CursorKind.TYPE_ALIAS_DECL):
            break
        names.append(qualified(declaration))
        kind = declaration.underlying_typedef_type
    spellings = (kind.spelling, kind.get_canonical().spelling)
    spelled = next((each for each in spellings if "(" not in each.removeprefix("_Atomic(")), "")
    return [*names, _unqualified(spelled)] if spelled else names


def written_type(kind: Any) -> str:
    """The name by which other files declare a variable of this type, of an array that of its elements.

    A name that only a source knows is replaced by the type that it names.
    """
    while kind.get_canonical().kind == TypeKind.CONSTANTARRAY:
        kind = _inner(kind.get_array_element_type(), kind.get_canonical().get_array_element_type())
    volatile = "volatile " if kind.get_canonical().is_volatile_qualified() and "volatile" not in kind.spelling else ""
    declaration = kind.get_declaration()
    if declaration.kind == CursorKind.NO_DECL_FOUND or not file_of(declaration).endswith(C_SOURCES):
        return volatile + _plain_bool(kind.spelling)
    canonical = kind.get_canonical()
    if canonical.kind == TypeKind.ENUM:
        return volatile + str(canonical.get_declaration().enum_type.spelling)
    return volatile + _plain_bool(canonical.spelling)


def _plain_bool(name: str) -> str:
    """Without a name that only <stdbool.h> has."""
    return " ".join("_Bool" if word == "bool" else word for word in name.split())


def _unqualified(name: str) -> str:
    words = [word for word in name.split() if word not in ("const", "volatile", "enum")]
    return " ".join(words)


def _record(cursor: Cursor, answer: Answer, depth: int) -> str:
    key = str(cursor.get_usr())
    if key not in answer.records:
        answer.records[key] = {}  # a struct that points to itself finds it
        definition = cursor.get_definition()
        members = list(definition.get_children()) if definition is not None else []
        answer.records[key] = {
            "name": "" if cursor.is_anonymous() or "(" in cursor.spelling else qualified(cursor),
            "is_union": cursor.kind == CursorKind.UNION_DECL,
            "is_complete": definition is not None,
            "members": list(_members(members, answer, depth)),
            "place": place_of(definition or cursor),
        }
    return key


def _members(children: Sequence[Cursor], answer: Answer, depth: int) -> Iterator[Json]:
    """Members, with those of structs without a name, which are named as if they were members of the outer one."""
    named = {each.type.get_declaration().get_usr() for each in children if each.kind == CursorKind.FIELD_DECL}
    for each in children:
        if each.kind == CursorKind.FIELD_DECL:
            yield member_of(each, answer, depth)
        elif each.kind == CursorKind.STRUCT_DECL and each.is_anonymous() and each.get_usr() not in named:
            yield from _members(list(each.get_children()), answer, depth + 1)


def member_of(cursor: Cursor, answer: Answer, depth: int = 0) -> Json:
    width = cursor.get_bitfield_width() if cursor.is_bitfield() else None
    kind = type_of(cursor.type, answer, depth + 1)
    return {
        "name": cursor.spelling,
        "key": cursor.get_usr(),
        "type": kind,
        "width": width,
        "is_const": cursor.type.is_const_qualified(),
        "place": place_of(cursor),
    }


def _enumeration(cursor: Cursor, answer: Answer) -> str:
    key = str(cursor.get_usr())
    if key not in answer.enumerations:
        constants = [each for each in cursor.get_children() if each.kind == CursorKind.ENUM_CONSTANT_DECL]
        answer.enumerations[key] = [{"name": each.spelling, "value": each.enum_value} for each in constants]
    return key
