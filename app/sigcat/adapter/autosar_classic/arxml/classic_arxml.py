"""From an integration model to ARXML of a release of AUTOSAR Classic, in the files that integrators expect."""

from collections.abc import Mapping

from sigcat import codes
from sigcat.adapter.arxml.tree import Package, document_trace, files
from sigcat.adapter.autosar_classic.arxml import (
    classic_type_elements,
    components,
    composition,
    configuration,
    diagnosis,
    interfaces,
    system,
)
from sigcat.adapter.autosar_classic.arxml.library import library
from sigcat.adapter.autosar_classic.arxml.paths import PLATFORM
from sigcat.adapter.autosar_classic.arxml.releases import BY_NAME
from sigcat.adapter.files import GeneratedFile
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.errors import InputRefused
from sigcat.function.document.document import pointer_text
from sigcat.integration.autosar_classic.model import ClassicIntegration
from sigcat.integration.autosar_classic.problems.windows import window_problems

PLATFORM_FILE = "platform_types.arxml"
"""Types that every vendor has: the file is for tests on a PC, without those of a vendor."""


@collector_paused()
def generate(model: ClassicIntegration, release_name: str | None = None) -> tuple[GeneratedFile, ...]:
    """Types, interfaces, components, composition, ECU extract, diagnosis and configuration, each a file.

    The same model gives the same bytes. They are of the release that is asked for, or else of that of the model.
    Raises InputRefused if the model names what AUTOSAR cannot.
    """
    name = release_name or model.deployment.release
    _refuse_windows(model, name)
    release = BY_NAME[name]  # type: ignore[index]
    known = library(model, release)
    content = {
        "types.arxml": classic_type_elements.packages(known),
        "interfaces.arxml": [classic_type_elements.mode_groups(known), interfaces.package(known)],
        "components.arxml": components.packages(known),
        "composition.arxml": [composition.package(known)],
        "system.arxml": system.packages(known),
        "diagnosis.arxml": diagnosis.packages(known),
        "configuration.arxml": [configuration.package(known)],
    }
    about = {"composition.arxml": document_trace(model.meta, model.info, model.provenance)}
    return (
        *files(
            _filled({PLATFORM_FILE: classic_type_elements.platform_packages(model)}), PLATFORM.root, release.schema, {}
        ),
        *files(_filled(content), known.paths.root, release.schema, about),
    )


def _filled(content: Mapping[str, list[Package]]) -> dict[str, list[Package]]:
    """The files that have any element."""
    return {name: packages for name, packages in content.items() if any(package.elements for package in packages)}


def _refuse_windows(model: ClassicIntegration, release: str) -> None:
    """Raise InputRefused for windows that the release does not have."""
    found = tuple(
        codes.NOT_WRITABLE_AS_CLASSIC.finding(each.message, pointer=pointer_text(each.pointer), fix=each.fix)
        for each in window_problems(model, release)
    )
    if found:
        raise InputRefused(f"The integration cannot be written as ARXML of release {release}.", found)
