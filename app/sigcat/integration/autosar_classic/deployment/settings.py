"""The section of the deployment file that concerns AUTOSAR Classic."""

from typing import Annotated, Literal

from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from sigcat.function.declaration.form import DeclarationModel, Text
from sigcat.function.document.field_types import C_IDENTIFIER, SHORT_NAME, Name
from sigcat.function.document.structure import unfit
from sigcat.function.function_json.wire import Integer
from sigcat.integration.autosar_classic.deployment.e2e_settings import DEFAULT_E2E, E2eSettings
from sigcat.integration.autosar_classic.deployment.releases import DEFAULT_RELEASE, ReleaseName
from sigcat.integration.autosar_names import event_name
from sigcat.reserved_words import is_reserved


def _no_keyword(name: str) -> str:
    if is_reserved(name):
        raise PydanticCustomError("keyword", "Input should be no keyword of C or C++")
    return name


Identifier = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9_]{0,127}$"), AfterValidator(_no_keyword), SHORT_NAME]
"""An AUTOSAR short name."""
BusName = Annotated[str, Field(pattern=r"^[A-Za-z_][A-Za-z0-9_]{0,127}$"), C_IDENTIFIER]
"""A name in a CAN database."""


class SignalSettings(DeclarationModel):
    """A signal of a bus that carries a data element."""

    signal: BusName = Field(description="Name of the signal in the CAN database, or of the system signal.")
    message: BusName | None = Field(
        None, description="Message that has it; its name is part of that of the system signal."
    )
    database: Text | None = Field(None, description="File name of the CAN database, for readers of the document.")
    length: Annotated[Integer, Field(ge=1, le=512)] | None = Field(
        None, description="Length of the signal, in bits: room for every value (K013)."
    )


def _each_once(signals: dict[str, SignalSettings]) -> dict[str, SignalSettings]:
    """A signal carries one data element, and a data element, by its path or the name of its port, has one signal."""
    carried: dict[tuple[str | None, str], str] = {}
    named: dict[str, str] = {}
    for key, signal in signals.items():
        other = carried.setdefault((signal.message, signal.signal), key)
        if other != key:
            raise unfit(f"Signal {signal.signal} must carry one data element, not {other} and {key}.", key)
        same = named.setdefault(event_name(key), key)
        if same != key and not ("." in same and "." in key):
            raise unfit(f"{same} and {key} are one data element, which must have one signal.", key)
    return signals


class AutosarClassicSettings(DeclarationModel):
    """Settings for AUTOSAR Classic that differ from the defaults."""

    release: ReleaseName = Field(DEFAULT_RELEASE, description="Release of AUTOSAR that the ARXML is of.")
    package: Identifier | None = Field(None, description="Outermost ARXML package; the application's name if absent.")
    ecu: Identifier | None = Field(None, description="Name of the ECU; <Application>Ecu if absent.")
    parameters: Literal["ports", "internal"] = Field(
        "ports",
        description="Where calibration parameters are: in a separate component, over ports, or within each component.",
    )
    signals: Annotated[dict[Name, SignalSettings], AfterValidator(_each_once)] = Field(
        {}, description="Signals of buses that carry data elements, by VSS path or by the name of the port."
    )
    e2e: E2eSettings = Field(
        DEFAULT_E2E, description="Windows of the end-to-end state machines that check received data with an `e2eError`."
    )
    tick: Annotated[Integer, Field(ge=1)] = Field(
        1000, description="Period of the counter that starts timing events, in µs."
    )


NO_SETTINGS = AutosarClassicSettings.model_validate({})
"""Everything by default."""
