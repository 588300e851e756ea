"""Functions, variables and classes of the files that are not known yet."""

from clang import cindex
from clang.cindex import AccessSpecifier, Cursor, CursorKind, StorageClass, TypeKind

from sigcat.function.c_project.libclang.answer import Answer, Json, file_of, place_of, qualified
from sigcat.function.c_project.libclang.types_of_c import member_of, type_of, written_type
from sigcat.function.c_project.libclang.uses import uses_of
from sigcat.function.c_project.libclang.values_of_c import value_of

_MOST_BYTES = 64 * 1024
"""Largest variable whose value is read: pictures and tables are larger."""


def read_declarations(outer: Cursor, seen: set[str], answer: Answer) -> set[str]:
    """Read the declarations of files that are not known yet; the files."""
    files = set()
    for cursor in outer.get_children():
        file = file_of(cursor)
        if not file or file in seen:
            continue
        files.add(file)
        if cursor.kind in (CursorKind.LINKAGE_SPEC, CursorKind.UNEXPOSED_DECL, CursorKind.NAMESPACE):
            files |= read_declarations(cursor, seen, answer)
        else:
            _declaration(cursor, answer)
    return files


def _declaration(cursor: Cursor, answer: Answer) -> None:
    is_method = cursor.kind == CursorKind.CXX_METHOD and cursor.is_definition()
    if cursor.kind == CursorKind.FUNCTION_DECL or is_method:
        answer.functions.append(_function(cursor, answer))
    elif cursor.kind == CursorKind.VAR_DECL:
        answer.variables.append(_variable(cursor, answer))
    elif cursor.kind in (CursorKind.CLASS_DECL, CursorKind.STRUCT_DECL) and _has_methods(cursor):
        answer.classes.append(_class(cursor, answer))


def _has_methods(cursor: Cursor) -> bool:
    return cursor.is_definition() and any(child.kind == CursorKind.CXX_METHOD for child in cursor.get_children())


def _function(cursor: Cursor, answer: Answer) -> Json:
    is_static = cursor.kind == CursorKind.FUNCTION_DECL and cursor.storage_class == StorageClass.STATIC
    return {
        "name": qualified(cursor),
        "result": type_of(cursor.result_type, answer),
        "parameters": [{"name": each.spelling, "type": type_of(each.type, answer)} for each in cursor.get_arguments()],
        "is_defined": cursor.is_definition(),
        "is_static": is_static,
        "is_inline": bool(cindex.conf.lib.clang_Cursor_isFunctionInlined(cursor)),
        "place": place_of(cursor),
        **(uses_of(cursor) if cursor.is_definition() else {}),
    }


def _variable(cursor: Cursor, answer: Answer) -> Json:
    value = next((child for child in cursor.get_children() if child.kind.is_expression()), None)
    is_const = (
        cursor.type.is_const_qualified() or cursor.type.get_canonical().get_array_element_type().is_const_qualified()
    )
    is_array = cursor.type.get_canonical().kind == TypeKind.CONSTANTARRAY
    has_value = value is not None and not (is_array and value.kind == CursorKind.INTEGER_LITERAL)
    is_small = cursor.type.get_size() <= _MOST_BYTES
    return {
        "name": qualified(cursor),
        "type": type_of(cursor.type, answer),
        "written": written_type(cursor.type),
        "is_const": is_const,
        "is_static": cursor.storage_class == StorageClass.STATIC,
        "is_defined": cursor.storage_class != StorageClass.EXTERN or has_value,
        "value": value_of(value) if value is not None and has_value and is_small else None,
        "place": place_of(cursor),
        "uses": uses_of(cursor)["uses"] if is_small else [],
    }


def _class(cursor: Cursor, answer: Answer) -> Json:
    children = list(cursor.get_children())
    fields = (CursorKind.FIELD_DECL, CursorKind.VAR_DECL)
    return {
        "name": qualified(cursor),
        "members": [
            {**member_of(each, answer), "public": _is_public(each)} for each in children if each.kind in fields
        ],
        "methods": [
            {**_function(each, answer), "name": each.spelling, "public": _is_public(each)}
            for each in children
            if each.kind == CursorKind.CXX_METHOD
        ],
        "place": place_of(cursor),
    }


def _is_public(cursor: Cursor) -> bool:
    return bool(cursor.access_specifier == AccessSpecifier.PUBLIC)
