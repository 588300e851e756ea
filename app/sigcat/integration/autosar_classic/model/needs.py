"""Service needs of a component: memory, diagnosis, supervision, inhibition."""

from typing import Literal

from sigcat.function.document.field_types import CallName, ErrorName, Name, ParameterName, ShortName
from sigcat.function.document.text import Text
from sigcat.function.function_json.wire import Integer, Listed, Number, WireModel, always, own


class NvBlock(WireModel):
    """A block of the NVRAM manager."""

    name: ShortName = always("Name", "Name of the need.")
    memory: ShortName = always("PerInstanceMemory", "Memory of the component that is its RAM block.")
    port: ShortName = always("Port", "Service port through which its state is asked and set.")
    parameters: Listed[ParameterName] = always("Parameters", "Parameters whose values are kept in it.")
    errors: Listed[ErrorName] = always("Errors", "Errors whose counts are kept in it.")
    reliability: Literal["NO-PROTECTION", "ERROR-DETECTION", "ERROR-CORRECTION"] = always(
        "Reliability", "How it is protected: a checksum, and a second copy above QM."
    )
    restore_at_start: bool = always("RestoreAtStart", "Whether it is read before the component starts.")
    store_at_shutdown: bool = always("StoreAtShutdown", "Whether it is written when the ECU shuts down.")
    asil_level: Name = always("AsilLevel", "Highest ASIL of its content.")


class DiagnosticEvent(WireModel):
    """An event of the diagnostic event manager: an error of the function."""

    name: ShortName = always("Name", "Name of the need.")
    error: ErrorName = always("Error", "Name of the error interface.")
    port: ShortName = always("Port", "Service port through which its status is set.")
    debouncing: Literal["MonitorInternal"] = always("Debouncing", "MonitorInternal: the core has matured it.")
    description: Text | None = own("Description", "Meaning of the error.")
    severity: Text | None = own("Severity", "What the error leads to.")
    occurrence_limit: Integer | None = own("OccurrenceCountLimit", "How often it has to occur to be confirmed.")
    ignition_limit: Integer | None = own("IgnitionCountLimit", "Ignition cycles after which it is confirmed.")
    asil_level: Name | None = own("AsilLevel", "ASIL of the error.")


class Inhibition(WireModel):
    """A function identifier of the function inhibition manager: others ask whether it may run."""

    name: ShortName = always("Name", "Name of the function identifier.")
    condition: Name = always("Condition", "Safety condition that it represents.")
    events: Listed[ErrorName] = always("Events", "Errors, each of which takes the permission away while it is failed.")
    mask: Literal["LAST_FAILED"] = always("Mask", "LAST_FAILED: while the last test has failed.")


class AliveSupervision(WireModel):
    """Alive supervision of an entity, as the watchdog manager takes it."""

    checkpoint: ShortName = always("Checkpoint", "Checkpoint that is counted.")
    expected: Integer = always("ExpectedIndications", "Indications in a reference cycle.")
    min_margin: Integer = always("MinMargin", "Indications that may be missing.")
    max_margin: Integer = always("MaxMargin", "Indications that may be too many.")
    reference_cycle: Number = always("ReferenceCycle", "Time in which indications are counted.", unit="s")
    error: ErrorName = always("Error", "Error that the core sets when a limit is broken.")


class DeadlineSupervision(WireModel):
    """Deadline supervision between two checkpoints."""

    start: ShortName = always("Start", "Checkpoint at which the time begins.")
    end: ShortName = always("End", "Checkpoint at which it ends.")
    min: Number = always("Min", "Shortest time.", unit="s")
    max: Number = always("Max", "Longest time.", unit="s")
    error: ErrorName = always("Error", "Error that the core sets when a limit is broken.")


class LogicalTransition(WireModel):
    """Two checkpoints, one of which may follow the other."""

    source: ShortName = always("Source", "Checkpoint before.")
    target: ShortName = always("Target", "Checkpoint after.")


class Checkpoint(WireModel):
    """A place in the flow of a supervised entity."""

    name: ShortName = always("Name", "Name of the checkpoint.")
    number: Integer = always("Number", "Its number.")
    port: ShortName = always("Port", "Service port through which it is reported.")
    call: CallName = always("Call", "Call that reports it.")
    moment: Literal["Begin", "End"] = always("Moment", "When: before the call, or after it.")
    initial: bool | None = own("Initial", "Whether a sequence begins with it.")
    final: bool | None = own("Final", "Whether a sequence may end with it.")


class SupervisedEntity(WireModel):
    """A supervised entity of the watchdog manager."""

    name: ShortName = always("Name", "Name of the entity.")
    checkpoints: Listed[Checkpoint] = always("Checkpoints", "Checkpoints.")
    alive: Listed[AliveSupervision] = always("Alive", "Alive supervisions.")
    deadlines: Listed[DeadlineSupervision] = always("Deadline", "Deadline supervisions.")
    transitions: Listed[LogicalTransition] = always("Logical", "Transitions of the logical supervision.")
