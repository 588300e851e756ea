"""`define` in function.yaml: interfaces that the catalogue does not have yet. They become an overlay.

Keys are the last names of the nodes; branches, types and everything that the section implies are left out. Where an
interface of the same file is meant, its last name is enough: `error: AliveError`.
"""

from typing import Annotated, Any, Literal

from pydantic import Field

from sigcat.function.declaration.form import Asil, DeclarationModel, Duration, Natural, Text
from sigcat.function.function_json.wire import Integer, Number

Name = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9_]*$", max_length=200)]
Path = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9_]*(\.[A-Za-z][A-Za-z0-9_]*)+$", max_length=1000)]


class LeafDefinition(DeclarationModel):
    """A value with its datatype."""

    datatype: Text | None = Field(None, description="Datatype of VSS, or path of a struct.")
    description: Text = Field(description="What the value means, as a sentence.")
    comment: Text | None = Field(None, description="Anything else that readers should know.")
    unit: Text | None = Field(None, description="Key of the unit.")
    min: Number | None = Field(None, description="Smallest value, in the unit.")
    max: Number | None = Field(None, description="Largest value, in the unit.")
    allowed: list[Any] | None = Field(None, description="The only values, where they are few.")
    enum: dict[str, Integer] | None = Field(None, description="Names of numbers.")
    default: Any = Field(None, description="Value where none is given.")
    arraysize: Natural | None = Field(None, description="Elements of an array.")
    resolution: Number | None = Field(None, description="Smallest step between two values, in the unit.")
    asil: Asil | None = Field(None, description="ASIL: QM, A, B, C or D.")


class DataDefinition(LeafDefinition):
    """A signal, or a branch above it."""

    type: Literal["sensor", "actuator", "attribute", "branch"] = Field("sensor", description="Type of the node.")


class ErrorDefinition(DeclarationModel):
    """An error interface of the function."""

    description: Text = Field(description="Condition that the error reports, as a sentence.")
    maturation_time: Duration | None = Field(None, description="How long it has to be present to be confirmed, in ms.")
    severity: Text | None = Field(None, description="What the error leads to.")
    reset_time: Duration | None = Field(None, description="Time from the reset condition to the reset, in ms.")
    reset_condition: Text | None = Field(None, description="Condition that resets the error.")
    dependency: list[Text] = Field([], description="Errors that set this one too.")
    asil: Asil | None = Field(None, description="ASIL: QM, A, B, C or D.")
    datatype: Text = Field("uint8", description="Datatype of VSS.")
    enum: dict[str, Integer] | None = Field(None, description="Names of numbers; PASSED: 0 and FAILED: 1 if absent.")


class ReactionDefinition(DeclarationModel):
    """A safety condition that the function reacts to."""

    description: Text = Field(description="What the condition means for the function, as a sentence.")
    error_list: list[Text] = Field([], description="Errors, any of which sets the condition.")
    asil: Asil | None = Field(None, description="ASIL: QM, A, B, C or D.")
    datatype: Text = Field("uint8", description="Datatype of VSS.")
    enum: dict[str, Integer] | None = Field(None, description="Names of numbers; INACTIVE: 0 and ACTIVE: 1 if absent.")


class ModeDefinition(DeclarationModel):
    """A mode interface."""

    description: Text = Field(description="What the mode says, as a sentence.")
    allowed: list[Text] = Field(min_length=1, description="Names of the modes.")


class ModesDefinition(DeclarationModel):
    """The mode interfaces of the function."""

    in_: ModeDefinition | None = Field(None, alias="in", description="Mode that the function has to take.")
    out: ModeDefinition | None = Field(None, description="Mode that the function is in.")


class AliveDefinition(DeclarationModel):
    """Limits of the alive supervision, in indications per period."""

    min_indications: Natural = Field(description="Fewest indications.")
    max_indications: Natural = Field(description="Most indications.")
    reference_indications: Natural = Field(description="Expected indications.")
    error: Text = Field(description="Error that is set when a limit is broken.")
    description: Text | None = Field(None, description="Explanation, if needed.")


class DeadlineDefinition(DeclarationModel):
    """Limits of the deadline supervision."""

    min_duration: Duration = Field(description="Shortest duration, in ms.")
    max_duration: Duration = Field(description="Longest duration, in ms.")
    error: Text = Field(description="Error that is set when a limit is broken.")
    description: Text | None = Field(None, description="Explanation, if needed.")


class LogicalDefinition(DeclarationModel):
    """The order that the logical supervision checks."""

    description: Text = Field(description="Order relative to other calls, as text.")
    error: Text = Field(description="Error that is set when the order is broken.")


class CallDefinition(DeclarationModel):
    """A scheduling interface: Init, Step, <Name>Step or Terminate."""

    description: Text = Field(description="What the call does, as a sentence.")
    run_type: Literal["Init", "Cyclic", "EventTriggered", "Shutdown"] | None = Field(
        None, description="When the call is made; by its name if absent: Init, Cyclic or Shutdown."
    )
    cycle_time: Duration | None = Field(None, description="Time from one call to the next, in ms.")
    execution_offset: Duration | None = Field(None, description="Offset of the first call, in ms.")
    priority: Integer | None = Field(None, description="Priority; a higher number runs first.")
    scheduling: Literal["Preemptive", "NonPreemptive"] | None = Field(
        None, description="Whether other calls may interrupt it."
    )
    debounce_time: Duration | None = Field(None, description="Shortest time between two calls, in ms.")
    asil: Asil | None = Field(None, description="ASIL that the call is implemented to.")
    previous_runnable: Text | None = Field(
        None, description="Step after which this one runs; all steps run after init."
    )
    alive_supervision: AliveDefinition | None = Field(None, description="Limits in indications per period.")
    deadline_supervision: DeadlineDefinition | None = Field(None, description="Limits in ms.")
    logical_supervision: LogicalDefinition | None = Field(None, description="Order relative to other calls.")
    stack_size: Annotated[Integer, Field(ge=1)] | None = Field(None, description="Stack that the call needs, in bytes.")


class StructDefinition(DeclarationModel):
    """A struct type."""

    description: Text = Field(description="What the struct is, as a sentence.")
    fields: dict[Name, LeafDefinition] = Field(min_length=1, description="Members, in order.")


class DefineSection(DeclarationModel):
    """Interfaces that this file adds to the catalogue."""

    data: dict[Path, DataDefinition] = Field({}, description="Signals, and branches above them, by VSS path.")
    parameters: dict[Name, LeafDefinition] = Field({}, description="Parameters of the function.")
    errors: dict[Name, ErrorDefinition] = Field({}, description="Errors of the function.")
    safety_reactions: dict[Name, ReactionDefinition] = Field({}, description="Safety conditions.")
    modes: ModesDefinition | None = Field(None, description="Mode interfaces.")
    scheduling: dict[Name, CallDefinition] = Field({}, description="Calls: Init, Step or <Name>Step, Terminate.")
    types: dict[Path, StructDefinition] = Field({}, description="Struct types, by path, such as Types.Point.")
