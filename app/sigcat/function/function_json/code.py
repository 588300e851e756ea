"""The C or C++ code of a function: its files, how it is called, and what its calls and variables are there."""

from sigcat.function.document.field_types import (
    CIdentifier,
    CMember,
    CppClass,
    CType,
    Definer,
    MacroValue,
    Name,
    Signature,
    SourceFile,
)
from sigcat.function.function_json.wire import Integer, Listed, WireModel, always, own

GLOBALS = "Globals"
POINTERS = "Pointers"
CLASS = "Class"
"""Access of calls to their data: global variables, pointers to objects, or members of a C++ class."""

DEFAULT_STORAGE = "Parameters"
"""Key-value storage of the parameters where nothing names one."""
DEFINED_BY = (
    "Function or Adapter: whose code defines the variable; Function if absent. An adapter defines imported externs."
)
MOST_ELEMENTS = 2**16
"""Largest array of objects."""
MEMBERS = "Members of the struct in C, where their names are not those of the catalogue."


class Macro(WireModel):
    """A macro of the preprocessor that the sources are compiled with."""

    name: CIdentifier = always("Name", "Name of the macro.")
    value: MacroValue | None = own("Replacement", "Its value; absent if it has none.")

    @property
    def as_option(self) -> str:
        """As compilers and CMake take it: `NAME` or `NAME=VALUE`."""
        return self.name if self.value is None else f"{self.name}={self.value}"


class CodeObject(WireModel):
    """An object that calls take a pointer to, or a global variable that is neither a signal nor a parameter."""

    name: CIdentifier = always("Name", "Name of the object; the expressions of its members begin with it.")
    type: CType = always("Type", "Type in C, such as ExtU_EcoControlMpc_T.")
    length: Integer | None = own("Length", "Elements of an array; absent if the object is not an array.")
    member: CMember | None = own("Member", "Member of the first object that is set to point to this one.")
    defined_by: Definer | None = own("DefinedBy", f"{DEFINED_BY} With pointers always the adapter.")

    @property
    def declaration(self) -> str:
        """As C declares it: `Bus channels[4]`."""
        return f"{self.type} {self.name}" + ("" if self.length is None else f"[{self.length}]")

    @property
    def has_valid_length(self) -> bool:
        """Whether it is a single object, or an array with an allowed number of elements."""
        return self.length is None or 1 <= self.length <= MOST_ELEMENTS


class CodeInterface(WireModel):
    """Compilation and calls of the code."""

    signature: Signature = always(
        "Signature",
        "Globals: calls take nothing and read and write global variables. Pointers: calls take pointers to objects that the "
        "adapter holds for each instance. Class: calls are members of a C++ class.",
    )
    sources: Listed[SourceFile] | None = own("Sources", "Files to compile, relative to the declaration.")
    headers: Listed[SourceFile] | None = own("Headers", "Files to include, in order.")
    include_folders: Listed[SourceFile] | None = own(
        "IncludeFolders", "Folders in which headers are searched, relative to the declaration."
    )
    definitions: Listed[Macro] | None = own("Macros", "Macros of the preprocessor.")
    class_name: CppClass | None = own("ClassName", "Name of the C++ class, with its namespaces.")
    storage: Name | None = own(
        "Storage", f"Key-value storage of the parameters that name none; {DEFAULT_STORAGE} if absent."
    )
    objects: Listed[CodeObject] | None = own("Objects", "Objects of the code, in order.")
    accessors: Listed[CIdentifier] | None = own(
        "Accessors", "Functions of C that expressions may call, with names and numbers as arguments."
    )


class Member(WireModel):
    """A member of a struct."""

    name: Name = always("Name", "Name in the catalogue; of a struct within the struct, with points between.")
    member: CIdentifier = always("Member", "Name in C.")


class Checkpoint(WireModel):
    """A call in the graph of the logical supervision."""

    initial: bool | None = own("BeginsSequence", "Whether a sequence begins with the call.")
    final: bool | None = own("EndsSequence", "Whether a sequence may end with the call.")
    next: Listed[Name] | None = own("Next", "Names of the calls that may follow.")


def is_inside(path: str) -> bool:
    """Whether a path leads from a folder into it, on every system."""
    is_plain = path.isprintable() and not any(character in path for character in '\\"<>|?*:')
    return is_plain and not path.startswith("/") and ".." not in path.split("/") and bool(path.strip())
