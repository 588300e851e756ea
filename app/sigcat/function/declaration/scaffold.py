"""A function to start from: a function.yaml that names its JSON Schema and defines an interface of every category, and C code."""

import json
import re
from collections.abc import Mapping
from pathlib import Path

from sigcat.errors import UsageError
from sigcat.function.declaration.declaration import declaration_schema
from sigcat.names import camel_case

SCHEMA_FILE = "function.schema.json"
"""Name of the schema beside the scaffold."""

_NAME = re.compile(r"[A-Z][A-Za-z0-9]{0,99}")
_ADDRESS = re.compile(r"[!-~]+")

_FILES = Path(__file__).with_name("scaffold_files")


def code_scaffold(name: str) -> Mapping[str, str]:
    """Return the C code for the same function, by the name of its file. Raises UsageError."""
    return {f"{checked_name(name)}{ending}": _text(f"NAME{ending}", name) for ending in (".h", ".c")}


def scaffold(name: str, schema: str = SCHEMA_FILE) -> str:
    """The text for a function of this name; `schema` is the address of its JSON Schema. Raises UsageError."""
    return _text("function.yaml", checked_name(name)).replace("__SCHEMA__", checked_schema(schema))


def _text(file: str, name: str) -> str:
    return (_FILES / file).read_text("utf-8").replace("__NAME__", name)


def checked_name(name: str) -> str:
    """A name that a function may have. Raises UsageError."""
    if not _NAME.fullmatch(name):
        better = camel_case(name)
        hint = f": {better!r}, for example" if _NAME.fullmatch(better) else ""
        raise UsageError(f"The name of a function must be CamelCase, not {name!r}{hint}")
    return name


def checked_schema(schema: str) -> str:
    """An address that the first line of the file may have. Raises UsageError."""
    if not _ADDRESS.fullmatch(schema):
        raise UsageError(f"The address of a schema must be printable ASCII without spaces, not {schema!r}")
    return schema


def schema_text() -> str:
    """The JSON Schema of function.yaml."""
    return json.dumps(declaration_schema(), indent=2, ensure_ascii=False) + "\n"
