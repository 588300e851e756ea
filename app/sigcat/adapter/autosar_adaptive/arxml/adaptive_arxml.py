"""From an integration model to ARXML of a release of AUTOSAR adaptive, in the files that integrators expect."""

from collections.abc import Iterable

from sigcat.adapter.arxml.tree import document_trace, files
from sigcat.adapter.autosar_adaptive.arxml import (
    adaptive_type_elements,
    components,
    deployment,
    interfaces,
    method_errors,
)
from sigcat.adapter.autosar_adaptive.arxml.releases import BY_NAME
from sigcat.adapter.files import GeneratedFile
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.integration.autosar_adaptive.deployment.namespaces import parts
from sigcat.integration.autosar_adaptive.document import writable
from sigcat.integration.autosar_adaptive.model import IntegrationModel


@collector_paused()
def generate(model: IntegrationModel, release_name: str | None = None) -> tuple[GeneratedFile, ...]:
    """Types, interfaces, components and deployment, each a file. The same model gives the same bytes.

    They are of the release that is asked for, or else of that of the model.

    Raises InputRefused if the model names what AUTOSAR cannot.
    """
    whole = writable(model)
    assert whole.deployment is not None
    release = BY_NAME[release_name or whole.deployment.release]
    known = adaptive_type_elements.library(whole, release)
    services = interfaces.wholes(whole)
    content = {
        "types.arxml": adaptive_type_elements.packages(known, _words(whole), whole.deployment.units or {}),
        "interfaces.arxml": [
            interfaces.package(services, known),
            *method_errors.packages(
                (method for service in services for method in service.methods),
                tuple(parts(whole.deployment.namespace or "")),
                known.paths,
            ),
        ],
        "components.arxml": components.packages(whole.components, known),
        "deployment.arxml": deployment.packages(whole, services, known),
    }
    about = {"components.arxml": document_trace(model.meta, model.info, model.provenance)}
    return files(content, known.paths.root, release.schema, about)


def _words(model: IntegrationModel) -> Iterable[str]:
    """Words and names of the datatypes that elements refer to."""
    for component in model.components:
        yield from (parameter.datatype.word for parameter in component.parameters or ())
        yield from (word for _, word in components.stored_counts(component))
        for interface in component.services:
            for services in interface.services:
                yield from (event.datatype for event in services.events)
                yield from (field.word for field in services.fields)
                for method in services.methods:
                    yield from (argument.datatype for argument in (*(method.inputs or ()), *(method.outputs or ())))
