"""The section of the deployment file that concerns AUTOSAR Classic."""

from typing import Annotated, Literal

from pydantic import Field

from sigcat.function.declaration.form import DeclarationModel, Text
from sigcat.function.function_json.wire import Integer
from sigcat.integration.autosar_classic.releases import DEFAULT_RELEASE, ReleaseName

Identifier = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9_]{0,127}$")]
"""An AUTOSAR short name."""


class SignalSettings(DeclarationModel):
    """A signal of a bus that carries a data element."""

    signal: Text = Field(description="Name of the signal in the CAN database, or of the system signal.")
    message: Text | None = Field(
        None, description="Message that has it; its name is part of that of the system signal."
    )
    database: Text | None = Field(None, description="File name of the CAN database, for those who read the document.")
    length: Annotated[Integer, Field(ge=1, le=512)] | None = Field(None, description="Length of the signal, in bits.")


class AutosarClassicSettings(DeclarationModel):
    """What differs from the defaults for AUTOSAR Classic."""

    release: ReleaseName = Field(DEFAULT_RELEASE, description="Release of AUTOSAR that the ARXML is of.")
    package: Identifier | None = Field(None, description="Outermost ARXML package; the application's name if absent.")
    ecu: Identifier | None = Field(None, description="Name of the ECU; <Application>Ecu if absent.")
    parameters: Literal["ports", "internal"] = Field(
        "ports",
        description="Where calibration parameters are: in a component of their own, over ports, or within each component.",
    )
    signals: dict[str, SignalSettings] = Field(
        {}, description="Signals of buses that carry data elements, by VSS path or by the name of the port."
    )
    tick: Annotated[Integer, Field(ge=1)] = Field(
        1000, description="Period of the counter that starts timing events, in µs."
    )


NO_SETTINGS = AutosarClassicSettings.model_validate({})
"""Everything by default."""
