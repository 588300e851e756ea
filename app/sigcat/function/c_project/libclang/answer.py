"""Findings about the code so far, and the place of something in the project."""

from typing import Any, TypeAlias

from clang.cindex import Cursor, CursorKind

ROOT = "/sigcat-project/"
"""A folder that does not exist: an include cannot lead from it to a file of the machine."""

Json: TypeAlias = dict[str, Any]


class Answer:
    """Declarations and errors that were found so far."""

    def __init__(self) -> None:
        self.functions: list[Json] = []
        self.variables: list[Json] = []
        self.classes: list[Json] = []
        self.records: dict[str, Json] = {}
        self.enumerations: dict[str, list[Json]] = {}
        self.errors: list[Json] = []
        self.included: dict[str, list[str]] = {}
        """Files by the file that includes them."""


def inside(path: str) -> str:
    """A path below the project; empty for one elsewhere."""
    path = path.replace("\\", "/")
    return path[len(ROOT) :] if path.startswith(ROOT) else ""


def file_of(cursor: Cursor) -> str:
    file = cursor.location.file
    return inside(file.name) if file else ""


def place_of(cursor: Cursor) -> Json:
    return {"file": file_of(cursor), "line": cursor.location.line}


def qualified(cursor: Cursor) -> str:
    """A name with the classes and namespaces around it."""
    parent = cursor.semantic_parent
    is_within = parent is not None and parent.kind in (
        CursorKind.CLASS_DECL, CursorKind.STRUCT_DECL, CursorKind.NAMESPACE,
    )  # fmt: skip
    return f"{qualified(parent)}::{cursor.spelling}" if is_within and parent.spelling else cursor.spelling
