"""The section of the deployment file that concerns FMI."""

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from sigcat.function.declaration.form import DeclarationModel, Text
from sigcat.function.document.structure import unfit
from sigcat.function.function_json.wire import Number

Fmus = Literal["function", "set"]
FmiVersion = Literal["3.0", "2.0"]
FmiInterface = Literal["coSimulation", "scheduledExecution"]


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
    interface: FmiInterface = Field(
        "coSimulation",
        description="Whether an FMU runs its schedule itself, or the importer activates each call by its clock. Scheduled execution "
        "needs FMI 3.0 and one FMU for each function.",
    )
    step_size: Annotated[Number, Field(gt=0)] | None = Field(
        None, alias="stepSize", description="Step that importers propose, in ms; the shortest cycle if absent."
    )
    license: Text = Field("Proprietary", description="License of the FMU, as modelDescription.xml states it.")
    copyright: Text | None = Field(None, description="Copyright notice of the FMU.")

    @model_validator(mode="after")
    def _fits_together(self) -> Self:
        if self.interface == "scheduledExecution" and self.version != "3.0":
            message = "Scheduled execution needs FMI 3.0. Remove `version`, or use `coSimulation`."
            raise unfit(message, "interface", "version")
        if self.interface == "scheduledExecution" and self.fmus == "set":
            message = "Scheduled execution needs one FMU for each function. Remove `fmus`, or use `coSimulation`."
            raise unfit(message, "interface", "fmus")
        return self


NO_SETTINGS = FmiSettings.model_validate({})
"""Everything by default."""
