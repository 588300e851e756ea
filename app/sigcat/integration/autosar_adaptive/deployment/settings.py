"""The section of the deployment file that concerns AUTOSAR adaptive."""

from typing import Annotated

from pydantic import Field

from sigcat.function.declaration.form import DeclarationModel, Text
from sigcat.function.document.field_types import (
    SERVICE_VERSION,
    SHORT_NAME,
    ElementKey,
    Name,
    ShortName,
    SourceFile,
    UnitKey,
    VssPath,
)
from sigcat.function.function_json.wire import Integer
from sigcat.integration.autosar_adaptive.deployment.identifiers import LARGEST_ID
from sigcat.integration.autosar_adaptive.deployment.namespaces import DEFAULT_HEADER_FOLDERS, HeaderFolders, Namespace
from sigcat.integration.autosar_adaptive.deployment.releases import DEFAULT_RELEASE, ReleaseName
from sigcat.integration.autosar_adaptive.deployment.someip_settings import (
    DEFAULT_SERVICE_DISCOVERY,
    DEFAULT_TRANSFORMATION,
    ServiceDiscoverySettings,
    TransformationSettings,
)
from sigcat.integration.autosar_adaptive.deployment.transport import TransportSettings
from sigcat.integration.autosar_adaptive.e2e import NO_E2E, E2eSettings
from sigcat.integration.autosar_adaptive.startup import NO_STARTUP, StartupSettings
from sigcat.integration.autosar_si_units import UnitSettings

Identifier = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9_]{0,127}$"), SHORT_NAME]
"""An AUTOSAR short name."""


class ComponentSettings(DeclarationModel):
    """Settings of one component."""

    executable: Identifier | None = Field(None, description="Name of the executable; <Component>Executable if absent.")
    header_files: list[SourceFile] | None = Field(
        None, description="Header files of the code; <Component>.h if the code's variables are known, else none."
    )
    startup: StartupSettings = Field(NO_STARTUP, description="How the process is started.")
    processes: dict[Identifier, dict[ElementKey, Annotated[Integer, Field(ge=1, le=0xFFFE)]]] = Field(
        {},
        description="Further processes of the executable, by name: the SOME/IP ids of their instances of services, by the "
        "name of the service. Their provided services have a separate id in each; what they use and do not name is that of the "
        "component.",
    )


class ServiceSettings(DeclarationModel):
    """A service interface that gathers the signals of some branches."""

    name: Identifier = Field(description="Name of the service interface.")
    namespace: Namespace | None = Field(None, description="C++ namespace of the service; that of all if absent.")
    paths: list[VssPath] = Field(min_length=1, description="VSS paths; each includes all that is below it.")
    transformation: TransformationSettings | None = Field(
        None, description="How SOME/IP lays out what this service sends; as for all if absent."
    )


class RunModes(DeclarationModel):
    """Function group modes in which calls run."""

    init: Identifier = Field("Startup", description="Mode in which init runs.")
    step: Identifier = Field("Run", description="Mode in which steps run.")
    terminate: Identifier = Field("Terminate", description="Mode in which terminate runs.")


class AutosarAdaptiveSettings(DeclarationModel):
    """Settings for AUTOSAR adaptive that differ from the defaults."""

    release: ReleaseName = Field(DEFAULT_RELEASE, description="Release of AUTOSAR that the ARXML is of.")
    package: Identifier | None = Field(None, description="Outermost ARXML package; the application's name if absent.")
    namespace: Namespace | None = Field(
        None, description="C++ namespace of services, as eco::control; the application's name in snake case if absent."
    )
    type_namespace: Namespace | None = Field(
        None, description="C++ namespace of datatypes; that of services if absent."
    )
    header_folders: HeaderFolders = Field(
        DEFAULT_HEADER_FOLDERS,
        description="Where the platform's generator writes the headers of services and datatypes: into a folder for each "
        "namespace, as SWS_CM prescribes, or into one folder, as AUTOSAR Blockset of MathWorks does.",
    )
    function_group: Identifier | None = Field(
        None, description="Function group of the executables; <Application>FunctionGroup if absent."
    )
    modes: RunModes = Field(RunModes.model_validate({}), description="Function group modes in which calls run.")
    components: dict[Name, ComponentSettings] = Field({}, description="What differs for components, by name.")
    services: list[ServiceSettings] = Field(
        [], description="Service interfaces of signals that no function of the set provides; by first branch if absent."
    )
    contract: Text = Field("AdaptiveAUTOSAR", description="Name of the middleware contract.")
    transformation: TransformationSettings = Field(
        DEFAULT_TRANSFORMATION, description="How SOME/IP lays out what is sent."
    )
    service_discovery: ServiceDiscoverySettings = Field(
        DEFAULT_SERVICE_DISCOVERY, description="When services are offered, looked for and subscribed to."
    )
    e2e: E2eSettings = Field(NO_E2E, description="Which events and fields are protected end to end, and how.")
    transport: dict[ShortName, TransportSettings] = Field(
        {}, description="How the messages of services are sent, by the name of the service; over UDP if absent."
    )
    units: dict[UnitKey, UnitSettings] = Field({}, description="Units that are not those of VSS, in SI units.")
    identifiers: dict[ElementKey, Annotated[Integer, Field(ge=1, le=LARGEST_ID)]] = Field(
        {},
        description="SOME/IP ids that are fixed: `Service`, `Service:instance`, or `Service.Element` (an event, "
        "method, field or eventgroup); the others follow the rule. Data ids of end-to-end protection: "
        "`Service.Event:dataId`, of 32 bits with profiles 4 and 7. vsomeip protects by profile 4 only instances up to "
        "255, with the instance in the highest byte of the data id: ids by rule are so.",
    )
    versions: dict[ShortName, Annotated[str, SERVICE_VERSION]] = Field(
        {},
        description="Versions of services, by name, as 2.1: major and minor. Others have 1.0, or with `--previous` the "
        "version of the previous document, raised by what changed.",
    )
    identifier_catalogue: dict[ElementKey, Annotated[Integer, Field(ge=1, le=LARGEST_ID)]] = Field(
        {},
        description="SOME/IP ids that are given away, by the same keys: a name of the set has its own, and nothing else "
        "gets them. `identifiers` go before. `--identifiers` adds those of files.",
    )


NO_SETTINGS = AutosarAdaptiveSettings.model_validate({})
"""Everything by default."""
