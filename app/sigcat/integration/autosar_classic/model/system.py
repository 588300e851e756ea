"""The components together: composition, ECU, system signals and tasks."""

from typing import Literal

from sigcat.function.document.field_types import ShortName
from sigcat.function.document.text import AnyValue, Text
from sigcat.function.function_json.wire import Integer, Listed, Number, WireModel, always, own
from sigcat.integration.autosar_classic.model.interfaces import Kind


class Prototype(WireModel):
    """A component of the composition."""

    name: ShortName = always("Name", "Name of the component prototype.")
    type: ShortName = always("Type", "Name of the component type.")


class OuterPort(WireModel):
    """A port of the composition: data from outside of the set, or to it."""

    name: ShortName = always("Name", "Name of the port.")
    direction: Literal["Required", "Provided"] = always("Direction", "Required or Provided.")
    kind: Kind = always("Kind", "Kind of its interface.")
    interface: ShortName = always("Interface", "Name of its interface.")
    init: AnyValue = own("InitValue", "Value before the first one, of the data element that the interface has.")
    provider: Text | None = own("ExternalProvider", "Who provides it, as the functions or the deployment say.")


class PortReference(WireModel):
    """A port of a component of the composition."""

    component: ShortName = always("Component", "Name of the component prototype.")
    port: ShortName = always("Port", "Name of its port.")


class Assembly(WireModel):
    """A connection between two components."""

    name: ShortName = always("Name", "Name of the connector.")
    provider: PortReference = always("Provider", "The port that provides.")
    requester: PortReference = always("Requester", "The port that requires.")


class Delegation(WireModel):
    """A connection between a component and a port of the composition."""

    name: ShortName = always("Name", "Name of the connector.")
    inner: PortReference = always("Inner", "The port of the component.")
    outer: ShortName = always("Outer", "Name of the port of the composition.")


class Composition(WireModel):
    """The components and how they are connected."""

    name: ShortName = always("Name", "Name of the composition.")
    prototypes: Listed[Prototype] = always("Components", "Components.")
    ports: Listed[OuterPort] = always("Ports", "Ports to the outside.")
    assemblies: Listed[Assembly] = always("Assemblies", "Connections between components.")
    delegations: Listed[Delegation] = always("Delegations", "Connections to the outside.")


class SystemSignal(WireModel):
    """A data element of the composition that travels over a bus."""

    port: ShortName = always("Port", "Port of the composition.")
    element: ShortName = always("Element", "Data element.")
    signal: ShortName = always("SystemSignal", "Name of the system signal.")
    message: ShortName | None = own("Message", "Message of the CAN database that has it.")
    database: Text | None = own("Database", "File name of the database.")
    length: Integer | None = own("Length", "Length of the signal.", unit="bits")


class TaskEvent(WireModel):
    """An event that is mapped to a task."""

    component: ShortName = always("Component", "Name of the component prototype.")
    event: ShortName = always("Event", "Name of the event.")
    position: Integer = always("Position", "Place of the event in the task, from 1: no two have one.")


class Task(WireModel):
    """A task of the operating system: a proposal from cycles and priorities."""

    name: ShortName = always("Name", "Name of the task.")
    priority: Integer = always("Priority", "Priority; a higher number runs first.")
    preemptable: bool = always("Preemptable", "Whether others may interrupt it.")
    period: Number | None = own("Period", "Period, if it is cyclic.", unit="s")
    offset: Number | None = own("Offset", "Offset of the first activation.", unit="s")
    stack_size: Integer | None = own("StackSize", "Largest stack that one of its runnables needs.", unit="bytes")
    events: Listed[TaskEvent] = always("Events", "Events, in the order in which their runnables run.")
    reason: Text = always("Reason", "What led to it.")


class InitBatch(WireModel):
    """Runnables that run one after the other before anything else does: `Rte_Init_<Name>`, which the ECU's state manager calls."""

    name: ShortName = always("Name", "Name of the batch.")
    events: Listed[TaskEvent] = always("Events", "Init events, in the order in which their runnables run.")
    reason: Text = always("Reason", "What led to it.")


class Ecu(WireModel):
    """The ECU that runs the components."""

    name: ShortName = always("Name", "Name of the ECU.")
    signals: Listed[SystemSignal] = always("Signals", "Data elements that travel over a bus.")
    init_batches: Listed[InitBatch] = always("InitBatches", "What runs before the tasks do.", default=())
    tasks: Listed[Task] = always("Tasks", "Tasks, the highest priority first.")
