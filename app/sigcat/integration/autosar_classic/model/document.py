"""The whole Integration JSON for AUTOSAR Classic."""

from typing import Annotated, Literal

from pydantic import Field

from sigcat.function.document.field_types import DATE, VERSION, Carried, FunctionName, Name, ShortName, Version
from sigcat.function.document.text import Text
from sigcat.function.function_json.code import CodeInterface
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.wire import Integer, Listed, WireModel, always, own
from sigcat.integration.autosar_classic.deployment.releases import DEFAULT_RELEASE, ReleaseName
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
    functions: Listed[FunctionName] = always("Functions", "Names of the functions.")


class Component(WireModel):
    """A software component type: a component of a function."""

    name: ShortName = always("Name", "Name of the component type.")
    kind: Literal["Application"] = always("Kind", "Application.")
    function: FunctionName = always("Function", "Name of the function.")
    version: Version | None = own("Version", "Version of the function.")
    description: Text | None = own("Description", "What the function does.")
    ports: Listed[Port] = always("Ports", "Ports, by name.")
    runnables: Listed[Runnable] = always("Runnables", "Runnables.")
    events: Listed[Event] = always("Events", "What starts them.")
    exclusive_areas: Listed[ExclusiveArea] = always("ExclusiveAreas", "Exclusive areas.")
    memories: Listed[PerInstanceMemory] = always("PerInstanceMemories", "Memories.")
    parameters: Listed[InternalParameter] = always("InternalParameters", "Internal parameters.")
    nv_blocks: Listed[NvBlock] = always("NvBlocks", "Blocks of the NVRAM manager.")
    diagnostic_events: Listed[DiagnosticEvent] = always("DiagnosticEvents", "Events of the DEM.")
    supervised_entities: Listed[SupervisedEntity] = always(
        "SupervisedEntities", "Supervised entities of the watchdog manager."
    )
    inhibitions: Listed[Inhibition] = always("Inhibitions", "Function identifiers that its safety conditions inhibit.")
    sections: Listed[MemorySection] = always("MemorySections", "Memory sections.")
    asil_level: Name = always("AsilLevel", "Highest ASIL of its calls and interfaces.")
    code: CodeInterface | None = own("Code", "How the code of the function is compiled and called.")


class ParameterComponent(WireModel):
    """A component that has nothing but the values of calibration parameters."""

    name: ShortName = always("Name", "Name of the component type.")
    ports: Listed[Port] = always("Ports", "Ports that provide parameters.")


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
    units: Listed[Unit] = always("Units", "Units, by name.")
    compu_methods: Listed[CompuMethod] = always("CompuMethods", "What numbers mean, by name.")
    constraints: Listed[DataConstraint] = always("DataConstraints", "Ranges, by name.")
    implementation_types: Listed[ImplementationType] = always(
        "ImplementationTypes", "Datatypes of the code, each after those that it has in it."
    )
    application_types: Listed[ApplicationType] = always(
        "ApplicationTypes", "What values mean, each after those that it has in it."
    )
    mode_groups: Listed[ModeGroup] = always("ModeGroups", "Mode declaration groups, by name.")
    sender_receiver_interfaces: Listed[SenderReceiverInterface] = always("SenderReceiverInterfaces", "Data, by name.")
    client_server_interfaces: Listed[ClientServerInterface] = always("ClientServerInterfaces", "Operations, by name.")
    mode_switch_interfaces: Listed[ModeSwitchInterface] = always("ModeSwitchInterfaces", "Modes, by name.")
    parameter_interfaces: Listed[ParameterInterface] = always("ParameterInterfaces", "Calibration parameters, by name.")
    components: Listed[Component] = always("Components", "Component types, by name.")
    parameter_components: Listed[ParameterComponent] = always(
        "ParameterComponents", "Component types with parameter values, by name."
    )
    composition: Composition = always("Composition", "How components are connected.")
    ecu: Ecu = always("Ecu", "The ECU, its signals and tasks.")
    provenance: Listed[dict[Name, Carried]] | None = own("Provenance", "What each function was made from.")
    functions: tuple[FunctionJson, ...] | None = source_functions()
