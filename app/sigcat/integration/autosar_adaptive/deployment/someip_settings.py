"""Serialization of SOME/IP and service discovery: the part of a deployment that both sides share."""

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from sigcat.function.declaration.form import DeclarationModel, Duration, Natural
from sigcat.function.document.structure import unfit

Seconds = Annotated[Natural, Field(ge=1, le=0xFFFFFF)]
"""A time to live: 24 bits in a message of service discovery; the largest is for ever."""


class TransformationSettings(DeclarationModel):
    """Serialization of values. Provider and consumers of a service have to agree on it."""

    byte_order: Literal["big-endian", "little-endian"] = Field(
        "big-endian", description="Order of the bytes of a number."
    )
    alignment: Literal[8, 16, 32, 64, 128, 256] = Field(
        8, description="Bits to which what follows a text or an array of open length is aligned."
    )
    array_length: Literal[0, 1, 2, 4] = Field(
        4, description="Bytes of the length before an array; 0 where all arrays have a fixed length."
    )
    string_length: Literal[1, 2, 4] = Field(4, description="Bytes of the length before a text.")
    struct_length: Literal[0, 1, 2, 4] = Field(0, description="Bytes of the length before a struct.")
    string_encoding: Literal["UTF-8", "UTF-16"] = Field("UTF-8", description="Encoding of texts.")
    session_handling: bool = Field(True, description="Whether messages are counted, so that a lost one is noticed.")


class ServiceDiscoverySettings(DeclarationModel):
    """When services are offered, looked for and subscribed to."""

    initial_delay_min: Duration = Field(10, description="Shortest wait before the first offer or search, in ms.")
    initial_delay_max: Duration = Field(100, description="Longest wait before the first offer or search, in ms.")
    repetitions_max: Natural = Field(3, description="How often the first offer or search is repeated.")
    repetitions_base_delay: Duration = Field(
        200, description="Wait before the first repetition, in ms; it doubles each time."
    )
    offer_cyclic_delay: Duration = Field(1000, description="Time from one offer to the next afterwards, in ms.")
    offer_time_to_live: Seconds = Field(3, description="How long an offer holds, in s; 16777215 is for ever.")
    find_time_to_live: Seconds = Field(3, description="How long a search holds, in s.")
    subscribe_time_to_live: Seconds = Field(3, description="How long a subscription holds, in s.")
    response_delay_min: Duration = Field(
        10, description="Shortest wait before a message by multicast is answered, in ms."
    )
    response_delay_max: Duration = Field(
        100, description="Longest wait before a message by multicast is answered, in ms."
    )

    @model_validator(mode="after")
    def _fits_together(self) -> Self:
        for which, low, high in (
            ("initialDelay", self.initial_delay_min, self.initial_delay_max),
            ("responseDelay", self.response_delay_min, self.response_delay_max),
        ):
            if low > high:
                message = f"`{which}Max` must be at least `{which}Min`, {low} ms, not {high} ms."
                raise unfit(message, f"{which}Max", f"{which}Min")
        if self.repetitions_max and not self.repetitions_base_delay:
            message = "`repetitionsBaseDelay` must be more than 0 where `repetitionsMax` is."
            raise unfit(message, "repetitionsBaseDelay")
        if self.offer_time_to_live * 1000 <= self.offer_cyclic_delay:
            ends = f"`offerTimeToLive` must be longer than `offerCyclicDelay`, {self.offer_cyclic_delay} ms, not"
            message = f"{ends} {self.offer_time_to_live} s: the service would come and go."
            raise unfit(message, "offerTimeToLive", "offerCyclicDelay")
        return self


DEFAULT_TRANSFORMATION = TransformationSettings.model_validate({})
DEFAULT_SERVICE_DISCOVERY = ServiceDiscoverySettings.model_validate({})
