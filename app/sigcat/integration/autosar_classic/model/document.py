"""The whole Integration JSON for AUTOSAR Classic."""

from typing import Annotated, Any, Literal

from pydantic import Field

from sigcat.function.document.field_types import DATE, VERSION, Carried, FunctionName, Name, ShortName, Version
from sigcat.function.document.text import Text
from sigcat.function.function_json.code import CodeInterface
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.wire import Integer, WireModel, always, own, written
from sigcat.integration.autosar_classic.model.behaviour import (
    Event,
    ExclusiveArea,
    InternalParameter,
    MemorySection,
    PerInstanceMemory,
    Runnable,
)
from sigcat.integration.autosar_classic.model.interfaces import (
    ClientServerInterface,
    ModeSwitchInterface,
    ParameterInterface,
    SenderReceiverInterface,
)
from sigcat.integration.autosar_classic.model.needs import DiagnosticEvent, Inhibition, NvBlock, SupervisedEntity
from sigcat.integration.autosar_classic.model.ports import Port
from sigcat.integration.autosar_classic.model.system import Composition, Ecu
from sigcat.integration.autosar_classic.model.types import (
    ApplicationType,
    CompuMethod,
    DataConstraint,
    ImplementationType,
    ModeGroup,
    Unit,
)
from sigcat.integration.autosar_classic.releases import DEFAULT_RELEASE, ReleaseName
from sigcat.integration.source_functions import source_functions


class MetaInformation(WireModel):
    """Responsible team of the document, and its version."""

    authority: Text = always("Authority", "Organization that the document belongs to.")
    author: Text = always("Author", "Author of the document.")
    date: Annotated[str, Field(pattern=r"^\d{4}-\d{2}-\d{2}$"), DATE] = always("Date", "Date of the document.")
    version: Annotated[str, Field(pattern=r"^\d+\.\d+\.\d+$"), VERSION] = always("Version", "Version of the document.")


class ApplicationInformation(WireModel):
    """Identity of the application: a function, or a set of them."""

    name: Name = always("Name", "Name of the application.")
    responsible: Text = always("Responsible", "Who answers for it.")
    description: Text = always("Description", "What it does.")
    functions: tuple[FunctionName, ...] = always("Functions", "Names of the functions.", strict=False)


class Component(WireModel):
    """A software component type: a component of a function."""

    name: ShortName = always("Name", "Name of the component type.")
    kind: Literal["Application"] = always("Kind", "Application.")
    function: FunctionName = always("Function", "Name of the function.")
    version: Version | None = own("Version", "Version of the function.")
    description: Text | None = own("Description", "What the function does.")
    ports: tuple[Port, ...] = always("Ports", "Ports, by name.", strict=False)
    runnables: tuple[Runnable, ...] = always("Runnables", "Runnables.", strict=False)
    events: tuple[Event, ...] = always("Events", "What starts them.", strict=False)
    exclusive_areas: tuple[ExclusiveArea, ...] = always("ExclusiveAreas", "Exclusive areas.", strict=False)
    memories: tuple[PerInstanceMemory, ...] = always("PerInstanceMemories", "Memories.", strict=False)
    parameters: tuple[InternalParameter, ...] = always("InternalParameters", "Internal parameters.", strict=False)
    nv_blocks: tuple[NvBlock, ...] = always("NvBlocks", "Blocks of the NVRAM manager.", strict=False)
    diagnostic_events: tuple[DiagnosticEvent, ...] = always("DiagnosticEvents", "Events of the DEM.", strict=False)
    supervised_entities: tuple[SupervisedEntity, ...] = always(
        "SupervisedEntities", "Supervised entities of the watchdog manager.", strict=False
    )
    inhibitions: tuple[Inhibition, ...] = always(
        "Inhibitions", "Function identifiers that its safety conditions inhibit.", strict=False
    )
    sections: tuple[MemorySection, ...] = always("MemorySections", "Memory sections.", strict=False)
    asil_level: Name = always("AsilLevel", "Highest ASIL of its calls and interfaces.")
    code: CodeInterface | None = own("Code", "How the code of the function is compiled and called.")


class ParameterComponent(WireModel):
    """A component that has nothing but the values of calibration parameters."""

    name: ShortName = always("Name", "Name of the component type.")
    ports: tuple[Port, ...] = always("Ports", "Ports that provide parameters.", strict=False)


class ClassicDeployment(WireModel):
    """Settings of ARXML and code besides the elements, as the deployment file has them."""

    package: ShortName = always("Package", "Outermost package of the ARXML.")
    release: ReleaseName = always("Release", "Release of AUTOSAR that the ARXML is of.", default=DEFAULT_RELEASE)
    tick: Integer = always("Tick", "Period of the counter that starts timing events.", unit="µs")


class ClassicIntegration(WireModel):
    """The whole document."""

    meta: MetaInformation = always("MetaInformation", "Who is responsible, and the version.")
    info: ApplicationInformation = always("ApplicationInformation", "Identity of the application.")
    deployment: ClassicDeployment = always("ClassicDeployment", "What ARXML and code take beside the elements.")
    units: tuple[Unit, ...] = always("Units", "Units, by name.", strict=False)
    compu_methods: tuple[CompuMethod, ...] = always("CompuMethods", "What numbers mean, by name.", strict=False)
    constraints: tuple[DataConstraint, ...] = always("DataConstraints", "Ranges, by name.", strict=False)
    implementation_types: tuple[ImplementationType, ...] = always(
        "ImplementationTypes", "Datatypes of the code, each after those that it has in it.", strict=False
    )
    application_types: tuple[ApplicationType, ...] = always(
        "ApplicationTypes", "What values mean, each after those that it has in it.", strict=False
    )
    mode_groups: tuple[ModeGroup, ...] = always("ModeGroups", "Mode declaration groups, by name.", strict=False)
    sender_receiver_interfaces: tuple[SenderReceiverInterface, ...] = always(
        "SenderReceiverInterfaces", "Data, by name.", strict=False
    )
    client_server_interfaces: tuple[ClientServerInterface, ...] = always(
        "ClientServerInterfaces", "Operations, by name.", strict=False
    )
    mode_switch_interfaces: tuple[ModeSwitchInterface, ...] = always(
        "ModeSwitchInterfaces", "Modes, by name.", strict=False
    )
    parameter_interfaces: tuple[ParameterInterface, ...] = always(
        "ParameterInterfaces", "Calibration parameters, by name.", strict=False
    )
    components: tuple[Component, ...] = always("Components", "Component types, by name.", strict=False)
    parameter_components: tuple[ParameterComponent, ...] = always(
        "ParameterComponents", "Component types with parameter values, by name.", strict=False
    )
    composition: Composition = always("Composition", "How components are connected.")
    ecu: Ecu = always("Ecu", "The ECU, its signals and tasks.")
    provenance: tuple[dict[Name, Carried], ...] | None = own(
        "Provenance", "What each function was made from.", strict=False
    )
    functions: tuple[FunctionJson, ...] | None = source_functions()


def to_json(model: ClassicIntegration) -> bytes:
    """The document as UTF-8 text with a stable layout: the same model gives the same bytes."""
    return written(model)


def integration_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of the document."""
    schema = ClassicIntegration.model_json_schema(by_alias=True)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}
