"""The section of the deployment file that concerns FMI."""

from pathlib import Path
from typing import Annotated, Literal, Self

from pydantic import Field, PrivateAttr, model_validator

from sigcat.function.declaration.form import DeclarationModel, Text
from sigcat.function.document.field_types import CIdentifier
from sigcat.function.document.structure import unfit
from sigcat.function.function_json.wire import Number
from sigcat.integration.fmi.network import Network

Fmus = Literal["function", "set"]
FmiVersion = Literal["3.0", "2.0"]
FmiInterface = Literal["coSimulation", "scheduledExecution"]


class BusSettings(DeclarationModel):
    """Settings for the CAN bus of the FMUs."""

    name: CIdentifier = Field(description="Name of the bus, as Powertrain.")
    dbc: tuple[Text, ...] | None = Field(
        None,
        description="CAN databases, relative to the deployment file; those of `dbc` in sigcat.toml if absent.",
        min_length=1,
        strict=False,
    )
    signals: Literal["beside", "replaced"] = Field(
        "beside",
        description="Whether the variables of mapped signals are beside the bus, or replaced by it: then they are on the bus only.",
    )


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
    bus: BusSettings | None = Field(
        None, description="CAN bus of the FMUs, by FMI-LS-BUS 1.0; none if absent. It needs FMI 3.0 and `coSimulation`."
    )
    step_size: Annotated[Number, Field(gt=0)] | None = Field(
        None, alias="stepSize", description="Step that importers propose, in ms; the shortest cycle if absent."
    )
    license: Text = Field("Proprietary", description="License of the FMU, as modelDescription.xml states it.")
    copyright: Text | None = Field(None, description="Copyright notice of the FMU.")
    _network: Network | None = PrivateAttr(default=None)

    @property
    def network(self) -> Network | None:
        """CAN database and mappings of the bus; None before they are read."""
        return self._network

    def in_folder(self, folder: Path) -> Self:
        """The same, with paths of files that begin at a folder."""
        if self.bus is None or self.bus.dbc is None:
            return self
        dbc = tuple(str(folder / each) for each in self.bus.dbc)
        return self.model_copy(update={"bus": self.bus.model_copy(update={"dbc": dbc})})

    def with_network(self, network: Network) -> Self:
        """Take the CAN database and the mappings of the bus."""
        self._network = network
        return self

    @model_validator(mode="after")
    def _fits_together(self) -> Self:
        if self.interface == "scheduledExecution" and self.version != "3.0":
            message = "Scheduled execution needs FMI 3.0. Remove `version`, or use `coSimulation`."
            raise unfit(message, "interface", "version")
        if self.interface == "scheduledExecution" and self.fmus == "set":
            message = "Scheduled execution needs one FMU for each function. Remove `fmus`, or use `coSimulation`."
            raise unfit(message, "interface", "fmus")
        if self.bus is not None and self.version != "3.0":
            raise unfit("A bus needs FMI 3.0. Remove `version` or `bus`.", "bus", "version")
        if self.bus is not None and self.interface == "scheduledExecution":
            raise unfit("A bus needs `coSimulation`. Remove `interface` or `bus`.", "bus", "interface")
        return self


NO_SETTINGS = FmiSettings.model_validate({})
"""Everything by default."""
