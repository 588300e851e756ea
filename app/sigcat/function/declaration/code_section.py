"""`code` in function.yaml, and what the calls are in that code: how the function is compiled and called."""

from typing import Literal

from pydantic import Field

from sigcat.function.declaration.form import DeclarationModel, Text, possible, required
from sigcat.function.function_json.wire import Integer

DefinedBy = Literal["function", "adapter"]
DEFINED_BY = "Whose code defines the variable; the function's if absent. An adapter defines imported externs."


class ObjectItem(DeclarationModel):
    """An object that calls take a pointer to, or with which expressions begin."""

    name: Text = required("Name of the object, with which the expressions of its members begin.")
    type: Text = required("Type in C, such as ExtU_EcoControlMpc_T.")
    length: Integer | None = possible(
        "Elements of an array, as in `extern Bus B[4]`; of variables that the adapter defines."
    )
    member: Text | None = possible(
        "Member of the first object that is set to point to it, as Simulink has `model.inputs = &inputs`."
    )
    defined_by: DefinedBy | None = possible(f"{DEFINED_BY} With pointers always the adapter.")


class CodeSection(DeclarationModel):
    """Compilation and calls of the function's code."""

    signature: Literal["globals", "pointers", "class"] = required(
        "How calls take their data: over global variables, over pointers to objects that the adapter holds for "
        "each instance, or as members of a C++ class."
    )
    sources: list[Text] = Field([], description="Files to compile, relative to this file.")
    headers: list[Text] = Field([], description="Files to include, in order: in `includeFolders`, or beside this file.")
    include_folders: list[Text] = Field([], description="Folders in which headers are searched, relative to this file.")
    definitions: dict[str, str | Integer | None] = Field(
        {}, description="Definitions of the preprocessor, with their values; null for one without."
    )
    class_name: Text | None = possible("Name of the C++ class, with its namespaces.", alias="class")
    storage: Text | None = possible("Key-value storage of the parameters that name none; `Parameters` if absent.")
    accessors: list[Text] = Field(
        [],
        description="Functions of C that variables may call, as `read_speed(1)`, with names and numbers as arguments.",
    )
    objects: list[ObjectItem] = Field([], description="Objects of the code; with pointers the first is the instance.")


class CheckpointItem(DeclarationModel):
    """The place of a call in the graph of the logical supervision."""

    initial: bool | None = possible("Whether a sequence begins with the call.")
    final: bool | None = possible("Whether a sequence may end with the call.")
    next: list[Text] = Field([], description="Calls that may follow: interface names, paths or last names.")
