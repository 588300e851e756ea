"""`define` in function.yaml: interfaces that the catalogue does not have yet. They become an overlay.

Keys are the last names of the nodes; branches, types and everything that the section implies are left out. Where an
interface of the same file is meant, its last name is enough: `error: AliveError`.
"""

from typing import Annotated, Any, Literal

from pydantic import Field

from sigcat.function.declaration.form import Asil, DeclarationModel, Duration, Natural, Text, possible, required
from sigcat.function.function_json.wire import Integer, Number

Name = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9_]*$", max_length=200)]
Path = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9_]*(\.[A-Za-z][A-Za-z0-9_]*)+$", max_length=1000)]


class LeafDefinition(DeclarationModel):
    """A value with its datatype."""

    datatype: Text | None = possible("Datatype of VSS, or path of a struct.")
    description: Text = required("What the value means, as a sentence.")
    comment: Text | None = possible("Anything else that readers should know.")
    unit: Text | None = possible("Key of the unit.")
    min: Number | None = possible("Smallest value, in the unit.")
    max: Number | None = possible("Largest value, in the unit.")
    allowed: list[Any] | None = possible("The only values, where they are few.")
    enum: dict[str, Integer] | None = possible("Names of numbers.")
    default: Any = possible("Value where none is given.")
    arraysize: Natural | None = possible("Elements of an array.")
    resolution: Number | None = possible("Smallest step between two values, in the unit.")
    asil: Asil | None = possible("ASIL: QM, A, B, C or D.")


class DataDefinition(LeafDefinition):
    """A signal, or a branch above it."""

    type: Literal["sensor", "actuator", "attribute", "branch"] = Field("sensor", description="Type of the node.")


class ErrorDefinition(DeclarationModel):
    """An error interface of the function."""

    description: Text = required("Condition that the error reports, as a sentence.")
    maturation_time: Duration | None = possible("How long it has to be present to be confirmed, in ms.")
    severity: Text | None = possible("What the error leads to.")
    reset_time: Duration | None = possible("Time from the reset condition to the reset, in ms.")
    reset_condition: Text | None = possible("Condition that resets the error.")
    dependency: list[Text] = Field([], description="Errors that set this one too.")
    asil: Asil | None = possible("ASIL: QM, A, B, C or D.")
    datatype: Text = Field("uint8", description="Datatype of VSS.")
    enum: dict[str, Integer] | None = possible("Names of numbers; PASSED: 0 and FAILED: 1 if absent.")


class ReactionDefinition(DeclarationModel):
    """A safety condition that the function reacts to."""

    description: Text = required("What the condition means for the function, as a sentence.")
    error_list: list[Text] = Field([], description="Errors, any of which sets the condition.")
    asil: Asil | None = possible("ASIL: QM, A, B, C or D.")
    datatype: Text = Field("uint8", description="Datatype of VSS.")
    enum: dict[str, Integer] | None = possible("Names of numbers; INACTIVE: 0 and ACTIVE: 1 if absent.")


class ModeDefinition(DeclarationModel):
    """A mode interface."""

    description: Text = required("What the mode says, as a sentence.")
    allowed: list[Text] = required("Names of the modes.", min_length=1)


class ModesDefinition(DeclarationModel):
    """The mode interfaces of the function."""

    in_: ModeDefinition | None = possible("Mode that the function has to take.", alias="in")
    out: ModeDefinition | None = possible("Mode that the function is in.")


class AliveDefinition(DeclarationModel):
    """Limits of the alive supervision, in indications per period."""

    min_indications: Natural = required("Fewest indications.")
    max_indications: Natural = required("Most indications.")
    reference_indications: Natural = required("Expected indications.")
    error: Text = required("Error that is set when a limit is broken.")
    description: Text | None = possible("Explanation, if needed.")


class DeadlineDefinition(DeclarationModel):
    """Limits of the deadline supervision."""

    min_duration: Duration = required("Shortest duration, in ms.")
    max_duration: Duration = required("Longest duration, in ms.")
    error: Text = required("Error that is set when a limit is broken.")
    description: Text | None = possible("Explanation, if needed.")


class LogicalDefinition(DeclarationModel):
    """The order that the logical supervision checks."""

    description: Text = required("Order relative to other calls, as text.")
    error: Text = required("Error that is set when the order is broken.")


class CallDefinition(DeclarationModel):
    """A scheduling interface: Init, Step, <Name>Step or Terminate."""

    description: Text = required("What the call does, as a sentence.")
    run_type: Literal["Init", "Cyclic", "EventTriggered", "Shutdown"] | None = possible(
        "When the call is made; by its name if absent: Init, Cyclic or Shutdown."
    )
    cycle_time: Duration | None = possible("Time from one call to the next, in ms.")
    execution_offset: Duration | None = possible("Offset of the first call, in ms.")
    priority: Integer | None = possible("Priority; a higher number runs first.")
    scheduling: Literal["Preemptive", "NonPreemptive"] | None = possible("Whether other calls may interrupt it.")
    debounce_time: Duration | None = possible("Shortest time between two calls, in ms.")
    asil: Asil | None = possible("ASIL that the call is implemented to.")
    previous_runnable: Text | None = possible("Step after which this one runs; all steps run after init.")
    alive_supervision: AliveDefinition | None = possible("Limits in indications per period.")
    deadline_supervision: DeadlineDefinition | None = possible("Limits in ms.")
    logical_supervision: LogicalDefinition | None = possible("Order relative to other calls.")
    stack_size: Annotated[Integer, Field(ge=1)] | None = possible("Stack that the call needs, in bytes.")


class StructDefinition(DeclarationModel):
    """A struct type."""

    description: Text = required("What the struct is, as a sentence.")
    fields: dict[Name, LeafDefinition] = required("Members, in order.", min_length=1)


class DefineSection(DeclarationModel):
    """Interfaces that this file adds to the catalogue."""

    data: dict[Path, DataDefinition] = Field({}, description="Signals, and branches above them, by VSS path.")
    parameters: dict[Name, LeafDefinition] = Field({}, description="Parameters of the function.")
    errors: dict[Name, ErrorDefinition] = Field({}, description="Errors of the function.")
    safety_reactions: dict[Name, ReactionDefinition] = Field({}, description="Safety conditions.")
    modes: ModesDefinition | None = possible("Mode interfaces.")
    scheduling: dict[Name, CallDefinition] = Field({}, description="Calls: Init, Step or <Name>Step, Terminate.")
    types: dict[Path, StructDefinition] = Field({}, description="Struct types, by path, such as Types.Point.")
