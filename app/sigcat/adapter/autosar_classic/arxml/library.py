"""Elements of the document by name that several elements refer to."""

from collections.abc import Mapping
from typing import NamedTuple

from sigcat.adapter.arxml.paths import Paths
from sigcat.adapter.arxml.tree import Tag, reference, tag
from sigcat.adapter.autosar_classic.arxml import paths
from sigcat.adapter.autosar_classic.arxml.releases import Release
from sigcat.integration.autosar_classic.datatypes.used_types import element_types, exchanged_types
from sigcat.integration.autosar_classic.model import (
    ApplicationType,
    ClassicIntegration,
    CompuMethod,
    ImplementationType,
    Port,
)

INTERFACE = {
    "SenderReceiver": "SENDER-RECEIVER-INTERFACE",
    "ClientServer": "CLIENT-SERVER-INTERFACE",
    "ModeSwitch": "MODE-SWITCH-INTERFACE",
    "Parameter": "PARAMETER-INTERFACE",
}
"""Element of a port interface, by its kind."""
APPLICATION_TYPE = {
    "VALUE": "APPLICATION-PRIMITIVE-DATA-TYPE",
    "BOOLEAN": "APPLICATION-PRIMITIVE-DATA-TYPE",
    "ARRAY": "APPLICATION-ARRAY-DATA-TYPE",
    "STRUCTURE": "APPLICATION-RECORD-DATA-TYPE",
}
"""Element of an application type, by its category."""


class Library(NamedTuple):
    """A document, its elements by name, and their paths."""

    model: ClassicIntegration
    release: Release
    paths: Paths
    implementation_types: Mapping[str, ImplementationType]
    application_types: Mapping[str, ApplicationType]
    compu_methods: Mapping[str, CompuMethod]
    element_types: Mapping[tuple[str, str], str]
    """Type of each data element and parameter, by interface and name."""
    exchanged_types: Mapping[str, tuple[str, ...]]
    """Types of everything that an interface has."""

    def path(self, package: str, *names: str) -> str:
        """Path of an element in a package, or of one inside it."""
        return self.paths.of(package, *names)

    def implementation_path(self, name: str) -> str:
        """Path of an implementation type. Platform types are those of the vendor."""
        found = self.implementation_types.get(name)
        of_platform = found is None or found.category == "VALUE"
        return (paths.PLATFORM if of_platform else self.paths).of(paths.IMPLEMENTATION_TYPES, name)

    def type_reference(self, tag_name: str, name: str) -> Tag:
        """Reference to a type: an application type, or an implementation type where there is none of the name."""
        found = self.application_types.get(name)
        if found is None:
            return reference(tag_name, self.implementation_path(name), paths.IMPLEMENTATION_TYPE)
        return reference(tag_name, self.path(paths.APPLICATION_TYPES, name), APPLICATION_TYPE[found.category])

    def interface_path(self, port: Port, *names: str) -> str:
        """Path of the interface of a port, or of an element of it."""
        return self.path(paths.INTERFACES, port.interface, *names)

    def implementation_reference(self, name: str) -> Tag:
        """Reference to an implementation type."""
        return reference("IMPLEMENTATION-DATA-TYPE-REF", self.implementation_path(name), paths.IMPLEMENTATION_TYPE)

    def type_mappings(self) -> Tag:
        """Reference to the datatypes of the code."""
        mapping = self.path(paths.TYPE_MAPPINGS, paths.TYPE_MAPPING_SET)
        return tag("DATA-TYPE-MAPPING-REFS", reference("DATA-TYPE-MAPPING-REF", mapping, "DATA-TYPE-MAPPING-SET"))

    def prototype(self, tag_name: str, name: str) -> Tag:
        """Reference to a component of the composition."""
        return reference(tag_name, self.path(paths.COMPOSITIONS, self.model.composition.name, name), paths.PROTOTYPE)


def library(model: ClassicIntegration, release: Release) -> Library:
    """Everything that elements of the document refer to."""
    return Library(
        model,
        release,
        Paths(model.deployment.package),
        {each.name: each for each in model.implementation_types},
        {each.name: each for each in model.application_types},
        {each.name: each for each in model.compu_methods},
        element_types(model),
        exchanged_types(model),
    )
