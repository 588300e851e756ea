"""Settings of the end-to-end state machine in a deployment file."""

from typing import Annotated, Self

from pydantic import Field, model_validator

from sigcat.function.declaration.form import DeclarationModel
from sigcat.function.document.field_types import Name
from sigcat.function.document.structure import unfit
from sigcat.function.function_json.wire import Integer

Count = Annotated[Integer, Field(ge=0, le=255)]
"""A number of messages: AUTOSAR counts them in 8 bits."""


class WindowSettings(DeclarationModel):
    """Limits at which the state machine leaves or keeps a state."""

    window_size: Annotated[Integer, Field(ge=1, le=255)] = Field(1, description="Last messages that count.")
    min_ok_state: Count = Field(
        1, description="Fewest messages of the window that passed: with fewer, VALID ends or does not begin."
    )
    max_error_state: Count = Field(
        0, description="Most messages of the window with an error: with more, VALID ends or does not begin."
    )

    @model_validator(mode="after")
    def _within_window(self) -> Self:
        for key, number in (("minOkState", self.min_ok_state), ("maxErrorState", self.max_error_state)):
            if number > self.window_size:
                raise unfit(f"`{key}` must be at most `windowSize`, {self.window_size}, not {number}.", key)
        return self


class ElementE2eSettings(DeclarationModel):
    """Windows that differ for a data element."""

    init: WindowSettings | None = Field(None, description="Window of the state INIT; as for all if absent.")
    valid: WindowSettings | None = Field(None, description="Window of the state VALID; as for all if absent.")
    invalid: WindowSettings | None = Field(None, description="Window of the state INVALID; as for all if absent.")


_ONE = WindowSettings.model_validate({})


class E2eSettings(DeclarationModel):
    """Windows of the state machines that check received data."""

    init: WindowSettings = Field(_ONE, description="Window of the state INIT.")
    valid: WindowSettings = Field(_ONE, description="Window of the state VALID.")
    invalid: WindowSettings = Field(_ONE, description="Window of the state INVALID.")
    elements: dict[Name, ElementE2eSettings] = Field(
        {}, description="Windows that differ, by VSS path or by the name of the port."
    )


DEFAULT_E2E = E2eSettings.model_validate({})
"""Windows of one message: the core decides by each message, as on every platform."""
