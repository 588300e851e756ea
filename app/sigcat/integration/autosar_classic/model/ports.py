"""Ports of a component."""

from typing import Annotated, Literal

from pydantic import Field

from sigcat.function.document.field_types import CallName, FunctionName, InterfaceName, Name, ShortName
from sigcat.function.document.text import AnyValue, Text
from sigcat.function.function_json.wire import Integer, Listed, Number, WireModel, always, own
from sigcat.integration.autosar_classic.model.interfaces import Kind


class Use(WireModel):
    """An interface of the function for an element of a port."""

    interface: InterfaceName = always("Interface", "Name of the interface in the function.")
    kind: Literal["signal", "queue", "method", "parameter", "error", "safety reaction", "mode"] = always(
        "Kind", "Which of its lists it is in."
    )
    function: FunctionName = always("Function", "Name of the function that has the port.")
    call: CallName | None = own("Call", "Call that has it; absent for modes.")
    timeout: Number | None = own("Timeout", "Longest age of a value: the core checks it, not COM.", unit="ms")


Messages = Annotated[Integer, Field(ge=0, le=255)]
"""A number of messages: AUTOSAR counts them in 8 bits."""


class E2eWindow(WireModel):
    """Messages that a state of the end-to-end state machine counts."""

    size: Annotated[Integer, Field(ge=1, le=255)] = always("WindowSize", "Last messages that count.")
    min_ok: Messages = always("MinOkState", "Fewest of them that passed.")
    max_error: Messages = always("MaxErrorState", "Most of them with an error.")


class E2eWindows(WireModel):
    """Windows of the states of the end-to-end state machine."""

    init: E2eWindow = always("Init", "Window of INIT.")
    valid: E2eWindow = always("Valid", "Window of VALID.")
    invalid: E2eWindow = always("Invalid", "Window of INVALID.")

    @property
    def sizes(self) -> frozenset[int]:
        """Sizes of the windows. Up to release 4.4.0 all states have one."""
        return frozenset(each.size for each in (self.init, self.valid, self.invalid))


class Element(WireModel):
    """Communication specification of a port for an element of its interface."""

    name: ShortName = always("Name", "Name of the data element, operation, mode or parameter.")
    init: AnyValue = own(
        "InitValue",
        "Value before the first one, in the unit of the interface: a number, a list, an object; of an enumeration its number.",
    )
    queue_length: Integer | None = own("QueueLength", "Values or calls that wait; absent if nothing is queued.")
    never_received: bool | None = own("HandleNeverReceived", "Whether the RTE tells that no value has come yet.")
    update: bool | None = own("EnableUpdate", "Whether Rte_IsUpdated tells the core what is fresh.")
    alive_timeout: Number | None = own("AliveTimeout", "Time-out of COM: 0, since the core has its own.", unit="s")
    transformer_errors: bool | None = own(
        "TransformerErrors", "Whether the RTE reports what end-to-end protection has rejected, for the core."
    )
    windows: E2eWindows | None = own("E2eWindows", "Windows of the state machine that checks the received data.")
    uses: Listed[Use] | None = own("Uses", "Interfaces of the function behind it.")


class Port(WireModel):
    """A port prototype of a component."""

    name: ShortName = always("Name", "Name of the port.")
    direction: Literal["Required", "Provided"] = always("Direction", "Required or Provided.")
    kind: Kind = always("Kind", "Kind of its interface.")
    interface: ShortName = always("Interface", "Name of its interface.")
    elements: Listed[Element] = always("Elements", "Elements that are used, with their attributes.")
    service: Name | None = own(
        "ServiceKind", "Module of the base software that it is connected to, if it is a service port."
    )
    description: Text | None = own("Description", "What goes through it.")

    @property
    def reports_transformer_errors(self) -> bool:
        """Whether its functions have the argument for transformer errors: AUTOSAR has one option for all elements of a port."""
        return any(element.transformer_errors for element in self.elements)
