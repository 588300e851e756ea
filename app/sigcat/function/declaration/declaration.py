"""`function.yaml`: what an author says about a function. Everything that the catalogue knows is left to it."""

import datetime as dt
import re
from collections.abc import Mapping
from typing import Annotated, Any, Literal, NamedTuple

from pydantic import BeforeValidator, Field, ValidationError

from sigcat.findings import Finding
from sigcat.function.declaration.code_section import DEFINED_BY, CheckpointItem, CodeSection, DefinedBy
from sigcat.function.declaration.define_section import DefineSection
from sigcat.function.declaration.form import Asil, DeclarationModel, Duration, Natural, Text, possible, required
from sigcat.function.document.document import Document
from sigcat.function.document.read_yaml import read_yaml
from sigcat.function.document.structure import structural_findings
from sigcat.function.function_json.datatypes.c_type import C_TYPE, CTypeName
from sigcat.function.function_json.wire import Count, Integer, Number, document_schema
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import last_name

__all__ = [  # what other files that people write are made from, too
    "Asil", "Declaration", "DeclarationModel", "Declared", "Duration", "Natural", "Text", "declaration_schema",
    "read_declaration",
]  # fmt: skip

RangeErrorAction = Literal["Default", "Init"]
Positive = Annotated[Integer, Field(ge=1)]
_MEMBERS = "Members of the struct in C, by their names in the catalogue, where the two differ."


class DataItem(DeclarationModel):
    """A signal that a call consumes or provides. Datatype, unit, range and description come from the catalogue."""

    path: Text = required("VSS path of the signal.")
    role: Literal["consumed", "provided"] = required("Whether the call reads or writes the signal.")
    name: Text | None = possible("Name inside the function; the last name of the path if absent.")
    variable: Text | None = possible("Expression of the C code that holds the value.")
    defined_by: DefinedBy | None = possible(DEFINED_BY)
    c_type: CTypeName | None = possible(C_TYPE)
    members: dict[str, Text] | None = possible(_MEMBERS)
    asil: Asil | None = possible("ASIL; the one of the catalogue if absent.")
    optional: bool | None = possible(
        "Whether a vehicle may lack the signal: its `variable` has `init` then, else the default, else 0; it is not sent."
    )
    absent_error: Text | None = possible(
        "Error that is set in vehicles without the optional signal: interface name or path."
    )
    access: Literal["Immediate", "Buffered"] | None = possible("Immediate, or buffered for a call.")
    timeout: Duration | None = possible("Longest time between two values, in ms.")
    timeout_error: Text | None = possible("Error that the time-out sets: interface name or path.")
    timeout_start: Literal["Init", "First"] | None = possible(
        "Whether the time-out runs from the end of init, or from the first value; Init if absent."
    )
    timeout_value: Literal["Last", "Default", "Init"] | None = possible(
        "Value after the time-out: the last one, the default or `init`; Last if absent."
    )
    timeout_recovery: Positive | None = possible("Valid values in a row that end the time-out; 1 if absent.")
    range_error_action: RangeErrorAction | None = possible("What replaces a value out of range.")
    range_error: Text | None = possible("Error that a value out of range sets: interface name or path.")
    e2e_error: Text | None = possible(
        "Error that a message sets which end-to-end protection rejects: interface name or path."
    )
    provider: Text | None = possible("Who provides a consumed signal, where no other function does.")
    queue_length: Positive | None = possible("Number of values to queue; absent if only the latest counts.")
    overflow: Literal["DropOldest", "DropNewest"] | None = possible(
        "What is lost when the queue is full; DropOldest if absent."
    )
    overflow_error: Text | None = possible("Error that a lost value sets: interface name or path.")
    values_per_step: Positive | None = possible(
        "Most queued values that a call takes at once, into an array; 1 if absent."
    )
    count_variable: Text | None = possible("Expression of the C code that holds how many values arrived for the call.")
    init: Any = possible(
        "Value before the first one arrives: number, boolean or allowed value; of an array a list, or one value for "
        "all elements; of a struct a mapping."
    )
    min: Number | None = possible("Smallest value that the code takes or gives, in its unit.")
    max: Number | None = possible("Largest value that the code takes or gives, in its unit.")
    datatype: Text | None = possible("VSS name of the code's datatype, where it is another one.")
    unit: Text | None = possible("Key of the code's unit, where it is another one.")
    factor: Number | None = possible("Scaling in the code: physical value = stored × factor + offset.")
    offset: Number | None = possible("Offset of the scaling, in the code's unit.")
    values: dict[str, Integer] | None = possible("Numbers of allowed texts in the code.")


class ParameterItem(DeclarationModel):
    """A parameter. Datatype, unit, range, default and description come from the catalogue."""

    path: Text = required("VSS path of the parameter; its last name if the function defines it.")
    name: Text | None = possible("Name inside the function; the last name of the path if absent.")
    kind: Literal["Calibration", "Measurement", "PersistenceMemory"] = Field(
        "Calibration", description="Where the value is kept."
    )
    attribute: Literal["Normal", "LearningParameter", "NA"] = Field(
        "Normal", description="Whether the function learns the value."
    )
    variable: Text | None = possible("Expression of the C code that holds the value.")
    defined_by: DefinedBy | None = possible(DEFINED_BY)
    c_type: CTypeName | None = possible(C_TYPE)
    members: dict[str, Text] | None = possible(_MEMBERS)
    asil: Asil | None = possible("ASIL; the one of the catalogue if absent.")
    key: Text | None = possible("Key under which the value is stored; the name if absent.")
    storage: Text | None = possible("Key-value storage that holds it; that of `code` if absent.")
    range_error_action: RangeErrorAction = Field("Default", description="What replaces a value out of range.")
    range_error: Text | None = possible("Error that a value out of range sets: interface name or path.")
    init: Any = possible(
        "Value at start-up, of an array a list, of a struct a mapping; the default of the catalogue if absent."
    )
    min: Number | None = possible("Smallest value that the code takes, in its unit.")
    max: Number | None = possible("Largest value that the code takes, in its unit.")
    datatype: Text | None = possible("VSS name of the code's datatype, where it is another one.")
    unit: Text | None = possible("Key of the code's unit, where it is another one.")
    factor: Number | None = possible("Scaling in the code: physical value = stored × factor + offset.")
    offset: Number | None = possible("Offset of the scaling, in the code's unit.")
    values: dict[str, Integer] | None = possible("Numbers of allowed texts in the code.")


def _reference(value: Any) -> Any:
    """An interface may be given by its name alone."""
    return {"interface": value} if isinstance(value, str) else value


def _date(value: Any) -> Any:
    """In quotes, YAML reads a date as a text."""
    is_date = isinstance(value, str) and _DATE.fullmatch(value)
    try:
        return dt.date.fromisoformat(value) if is_date else value
    except ValueError:  # no such day
        return value


_DATE = re.compile(r"\d{4}-\d{2}-\d{2}", re.ASCII)


class ErrorItem(DeclarationModel):
    """An error that the call reports. Its fields are in the catalogue."""

    interface: Text = required("Interface name or path of the error.")
    occurrence_count_limit: Count = Field(0, description="Occurrences that confirm it; 0 if they do not count.")
    ignition_count_limit: Count = Field(0, description="Ignition cycles that confirm it; 0 if they do not count.")
    variable: Text | None = possible(
        "Expression of the C code in which the function says whether the error is present: not 0."
    )
    status_variable: Text | None = possible(
        "Expression of the C code that holds the state of the error, written before a call."
    )
    defined_by: DefinedBy | None = possible(DEFINED_BY)
    c_type: CTypeName | None = possible(C_TYPE)
    reset: Text | None = possible(
        "What the error waits for: `restart`, or a signal that the function consumes, by its path or name, which "
        "is not 0 while the reset condition holds; that it is no longer present, if absent."
    )


class ReactionItem(DeclarationModel):
    """A safety condition that the call reacts to. Its fields are in the catalogue."""

    interface: Text = required("Interface name or path of the safety reaction.")
    variable: Text | None = possible("Expression of the C code that holds the condition, written before a call.")
    defined_by: DefinedBy | None = possible(DEFINED_BY)
    c_type: CTypeName | None = possible(C_TYPE)
    initial: Text | None = possible("Condition before any is known: one of its enumeration; INACTIVE if absent.")
    timeout: Duration | None = possible("Longest time between two values from outside, in ms.")


class ArgumentItem(DeclarationModel):
    """An argument or return value of a method."""

    name: Text = required("Name of the argument.")
    datatype: Text = required("Datatype of VSS, or path of a struct.")
    unit: Text | None = possible("Key of the unit.")
    variable: Text | None = possible("Expression of the C code that holds the value.")


class MethodItem(DeclarationModel):
    """A call that the function offers (provided) or uses (consumed)."""

    name: Text = required("Name of the method.")
    description: Text = required("What the method does.")
    role: Literal["consumed", "provided"] = required("Whether the function uses or offers the method.")
    inputs: list[ArgumentItem] = Field([], description="Arguments, in order.")
    outputs: list[ArgumentItem] = Field([], description="Return values, in order.")
    symbol: Text | None = possible("C function that does what a provided method offers.")
    timeout: Duration | None = possible("Longest time until the answer, in ms.")
    request_variable: Text | None = possible(
        "Expression of the C code that asks for a call of a consumed method: not 0."
    )
    status_variable: Text | None = possible(
        "Expression of the C code that holds what became of it: IDLE 0, PENDING 1, DONE 2, FAILED 3, TIMEOUT 4."
    )


class RunnableItem(DeclarationModel):
    """A call of the function: its scheduling interface, and what it reads and writes."""

    interface: Text = required("Interface name or path of the call: <FunctionName>_Init, _Step, _Terminate.")
    symbol: Text | None = possible("Function or member function in C; the interface name if absent.")
    arguments: list[Text] = Field(
        [], description="Objects that it takes pointers to, by their names in `code`, in order."
    )
    success: Integer | None = possible("Result that means success; absent if the call returns nothing.")
    before: list[Text] = Field([], description="C functions of the project that run before the call, in order.")
    after: list[Text] = Field([], description="C functions of the project that run after the call, in order.")
    checkpoint: CheckpointItem | None = possible("Place of the call in the graph of the logical supervision.")
    overrun_error: Text | None = possible("Error that missed activations set: interface name or path.")
    contract: Text | None = possible("How data is handed over, such as: Global variables.")
    parallel: bool | None = possible(
        "Whether the call may run at the same time as others; yes if absent. AUTOSAR adaptive needs `true` of both calls that share variables, objects or the mode."
    )
    events: list[Text] = Field(
        [],
        description="Events that trigger the call: paths or names of signals that it consumes; all of them if absent.",
    )
    data: list[DataItem] = Field([], description="Signals that the call reads and writes.")
    parameters: list[ParameterItem] = Field([], description="Parameters that the call reads.")
    errors: list[Annotated[ErrorItem, BeforeValidator(_reference, json_schema_input_type=str | ErrorItem)]] = Field(
        [], description="Errors that it reports."
    )
    safety_reactions: list[
        Annotated[ReactionItem, BeforeValidator(_reference, json_schema_input_type=str | ReactionItem)]
    ] = Field([], description="Safety conditions that it reacts to.")
    methods: list[MethodItem] = Field([], description="Methods that it uses or offers.")


class ComponentItem(DeclarationModel):
    """A part of the function that is deployed as a whole."""

    name: Text = required("Name of the component.")
    runnables: list[Annotated[RunnableItem, BeforeValidator(_reference, json_schema_input_type=str | RunnableItem)]] = (
        required("Calls: init, one step or several, terminate.", min_length=1)
    )


class ActiveMode(DeclarationModel):
    """A mode and the calls that run in it."""

    mode: Text = required("Name of the mode, one of those that the mode interface allows.")
    description: Text = required("What the mode means.")
    runnables: list[Text] = required("Interface names of the calls that run in the mode.")


class ModeOutItem(DeclarationModel):
    """The mode that the function reports, in its code."""

    variable: Text | None = possible("Expression of the C code that holds the mode.")
    defined_by: DefinedBy | None = possible(DEFINED_BY)
    c_type: CTypeName | None = possible(C_TYPE)
    values: dict[str, Integer] | None = possible(
        "Numbers of the modes in the code; their positions in the catalogue's list, from 0, if absent."
    )


class ModeInItem(ModeOutItem):
    """The mode that the function is asked to take, in its code."""

    initial: Text | None = possible("Mode before the first one is received; the first allowed if absent.")
    unknown: Literal["keep", "initial"] | None = possible(
        "What a mode that is not allowed leads to: the last one is kept, also if absent, or the initial one."
    )
    unknown_error: Text | None = possible("Error that a mode that is not allowed sets: interface name or path.")


class ModesItem(DeclarationModel):
    """Mode interfaces and what runs in each mode."""

    interfaces: list[Text] = Field([], description="Interface names or paths: <FunctionName>_Mode_In, _Mode_Out.")
    in_: ModeInItem | None = possible("The mode that the function takes, in its code.", alias="in")
    out: ModeOutItem | None = possible("The mode that the function reports, in its code.")
    active: list[ActiveMode] = Field([], description="Modes with the calls that run in them.")


class Declaration(DeclarationModel):
    """The whole file."""

    function: Text = required("Name of the function, CamelCase.")
    description: Text = required("What the function does.")
    responsible: Text = required("Team that answers for the function.")
    version: Annotated[str, Field(pattern=r"^\d+\.\d+\.\d+$")] | None = possible("Version, as 1.2.3.")
    authority: Text | None = possible("Organization that the document belongs to.")
    author: Text | None = possible("Author of the document.")
    date: Annotated[dt.date, BeforeValidator(_date)] | None = possible("Date of the document, as 2025-09-12.")
    code: CodeSection | None = possible("How the code of the function is compiled and called.")
    components: list[ComponentItem] = required("Components of the function.", min_length=1)
    modes: ModesItem | None = possible("Modes of the function.")
    define: DefineSection | None = possible("Interfaces that the catalogue does not have yet.")

    @property
    def consumed_signals(self) -> Mapping[str, str]:
        """Names of the signals that calls consume, by their paths."""
        calls = [call for component in self.components for call in component.runnables]
        consumed = (item for call in calls for item in call.data if item.role == "consumed")
        return {item.path: item.name or last_name(item.path) for item in consumed}


class Declared(NamedTuple):
    """A declaration that was read, and its document. None if the structure is wrong."""

    declaration: Declaration | None
    document: Document
    findings: tuple[Finding, ...]


def read_declaration(data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> Declared:
    """Read `function.yaml`. Everything that is wrong with its structure is a finding."""
    document = read_yaml(data, name, limits)
    if document.value is None:
        return Declared(None, document, document.findings)
    try:
        declaration = Declaration.model_validate(document.value)
    except ValidationError as error:
        return Declared(None, document, (*document.findings, *structural_findings(error, document, Declaration)))
    return Declared(declaration, document, document.findings)


def declaration_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of `function.yaml`, for editors."""
    return document_schema(Declaration)
