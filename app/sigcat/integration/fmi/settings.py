"""The section of the deployment file that concerns FMI."""

from typing import Annotated, Literal

from pydantic import Field

from sigcat.function.declaration.form import DeclarationModel, Text
from sigcat.function.function_json.wire import Number

Fmus = Literal["function", "set"]
FmiVersion = Literal["3.0", "2.0"]


class FmiSettings(DeclarationModel):
    """Settings for FMI."""

    fmus: Fmus = Field(
        "function",
        description="One FMU for each function, or one for the whole set. Within one FMU, functions exchange values at once; "
        "between FMUs, the importer hands them over after each step.",
    )
    version: FmiVersion = Field(
        "3.0", description="Version of FMI. 2.0 is for older importers: each element of an array is a variable."
    )
    step_size: Annotated[Number, Field(gt=0)] | None = Field(
        None, alias="stepSize", description="Step that importers propose, in ms; the shortest cycle if absent."
    )
    license: Text = Field("Proprietary", description="License of the FMU, as modelDescription.xml states it.")
    copyright: Text | None = Field(None, description="Copyright notice of the FMU.")


NO_SETTINGS = FmiSettings.model_validate({})
"""Everything by default."""
