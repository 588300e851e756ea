"""End-to-end protection of events and fields: what a deployment says of it, and what the Integration JSON has of each event."""

from typing import Annotated, Literal

from pydantic import Field

from sigcat.function.declaration.form import DeclarationModel
from sigcat.function.document.field_types import ElementKey
from sigcat.function.function_json.wire import Integer, WireModel, always

Profile = Literal[4, 5, 6, 7]
"""Number of a profile of AUTOSAR's E2E protocol."""
Step = Annotated[Integer, Field(ge=1, le=127)]
"""Fewer than half of the smallest counter counts: more would look like going back."""


class EventE2eSettings(DeclarationModel):
    """Settings of an event or a field, or of all of a service."""

    profile: Literal[4, 5, 6, 7, "none"] | None = Field(
        None, description="Profile that protects them whatever their ASIL, or none; as for all if absent."
    )
    max_delta_counter: Step | None = Field(
        None, description="Largest step from one counter to the next that passes; as for all if absent."
    )


class E2eSettings(DeclarationModel):
    """Protection of events and fields."""

    profile: Profile | None = Field(
        None, description="Profile that protects events and fields with an ASIL; none if absent."
    )
    max_delta_counter: Step = Field(
        1, description="Largest step from one counter to the next that passes: 1 passes no lost message, 3 passes two."
    )
    events: dict[ElementKey, EventE2eSettings] = Field(
        {}, description="What differs, by `Service` for all of its events and fields, or by `Service.Element`."
    )


NO_E2E = E2eSettings.model_validate({})
"""Nothing is protected."""


class E2eProtection(WireModel):
    """Protection of an event, or of the notifier of a field."""

    profile: Profile = always("Profile", "Number of the profile: 4, 5, 6 or 7.")
    data_id: Annotated[Integer, Field(ge=0, le=0xFFFFFFFF)] = always(
        "DataID", "What tells the event from every other one."
    )
    max_delta_counter: Step = always("MaxDeltaCounter", "Largest step from one counter to the next that passes.")
