"""Where each element stands in the packages."""

from typing import NamedTuple


class Paths(NamedTuple):
    """Paths below the outermost package."""

    root: str

    def of(self, package: str, *names: str) -> str:
        """Path of an element, or of one inside it."""
        return "/" + "/".join((self.root, package, *names))


DATATYPES = "DataTypes"
COMPU_METHODS = "CompuMethods"
UNITS = "Units"
DIMENSIONS = "PhysicalDimensions"
CONSTRAINTS = "DataConstraints"
INTERFACES = "ServiceInterfaces"
STORAGES = "PersistencyInterfaces"
MONITORS = "DiagnosticInterfaces"
SUPERVISIONS = "HealthManagementInterfaces"
COMPONENTS = "Components"
EXECUTABLES = "Executables"
PROCESS_DESIGNS = "ProcessDesigns"
FUNCTION_GROUPS = "FunctionGroups"
STARTUP = "StartupConfigurations"
PROCESSES = "Processes"
DEPLOYMENTS = "ServiceDeployments"
TRANSFORMATION = "TransformationProperties"
DISCOVERY = "ServiceDiscovery"
E2E = "E2eProfiles"
INSTANCES = "ServiceInstances"
MAPPINGS = "PortMappings"

TYPE = "STD-CPP-IMPLEMENTATION-DATA-TYPE"
