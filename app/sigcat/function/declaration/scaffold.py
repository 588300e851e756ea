"""A function to start from: a function.yaml that names its JSON Schema and defines an interface of every category, and C code."""

import json
import re
from collections.abc import Mapping
from pathlib import Path

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.errors import UsageError
from sigcat.file_kind import SHIPPED_ROOT
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


def scaffold(name: str, schema: str = SCHEMA_FILE, catalogue: Catalogue | None = None) -> str:
    """The text for a function of this name. Raises UsageError.

    `schema` is the address of its JSON Schema. Without a catalogue it is for the standard's tree. For one that has no speed
    of the vehicle, the function defines a signal.
    """
    root = catalogue.roots[0].path if catalogue is not None and catalogue.roots else SHIPPED_ROOT
    path = f"{root}.Speed"
    is_own = catalogue is not None and not _is_speed(catalogue.get(path))
    if is_own:
        path = f"{root}.{checked_name(name)}.Speed"
    text = _text("function.yaml", checked_name(name)).replace("__SCHEMA__", checked_schema(schema))
    defined = _text("signal.yaml", name) if is_own else ""
    text = text.replace("__SIGNAL__\n", defined).replace("__SPEED__", path).replace("__ROOT__", root)
    return text.replace("__PROVIDER__\n", "            provider: Name of the part that sends it\n" if is_own else "")


def _is_speed(node: Node | None) -> bool:
    return node is not None and node.values.get("datatype") == "float" and not node.children


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
