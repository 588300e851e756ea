"""Transport of the messages of a service, in a deployment and in the Integration JSON."""

from typing import Annotated, Literal

from pydantic import Field

from sigcat.function.declaration.form import DeclarationModel
from sigcat.function.document.field_types import MulticastAddress, Name, ShortName
from sigcat.function.function_json.wire import Integer

Protocol = Literal["UDP", "TCP"]


class MulticastSettings(DeclarationModel):
    """When and where the event groups of a service are sent by multicast."""

    threshold: Annotated[Integer, Field(ge=1, le=0xFFFF)] = Field(
        description="Number of subscribers from which an event group is sent by multicast."
    )
    address: MulticastAddress = Field(description="IPv4 address of the multicast group.")
    port: Annotated[Integer, Field(ge=1, le=0xFFFF)] = Field(description="UDP port of the multicast group.")


class TransportSettings(DeclarationModel):
    """Transport of the messages of a service."""

    protocol: Protocol = Field("UDP", description="Protocol of its events, fields and methods.")
    multicast: MulticastSettings | None = Field(None, description="Multicast of its event groups; none if absent.")
    event_groups: Literal["cycle", "one"] | dict[ShortName, list[Name]] = Field(
        "cycle",
        description="One event group for each cycle and one for fields, one for all, or groups by name with their events "
        "and fields; what no group names is grouped by cycle.",
    )


DEFAULT_TRANSPORT = TransportSettings.model_validate({})
"""UDP alone, an event group for each cycle."""
