"""From an integration model to ARXML of a release of AUTOSAR adaptive, in the files that integrators expect."""

from collections.abc import Iterable

from autosar_data import AutosarDataError

from sigcat.adapter.arxml.paths import Paths
from sigcat.adapter.arxml.tree import document_trace, written
from sigcat.adapter.autosar_adaptive.arxml import components, deployment, interfaces, method_errors, types
from sigcat.adapter.autosar_adaptive.arxml.releases import BY_NAME
from sigcat.adapter.files import GeneratedFile
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.errors import InputRefused
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
    paths = Paths(whole.deployment.package)
    known = types.library(whole, paths)
    services = interfaces.wholes(whole)
    release = BY_NAME[release_name or whole.deployment.release]
    content = {
        "types.arxml": types.packages(known, _words(whole), whole.deployment.units or {}),
        "interfaces.arxml": [
            interfaces.package(services, known),
            *method_errors.packages(
                (method for service in services for method in service.methods),
                tuple(parts(whole.deployment.namespace or "")),
                paths,
            ),
        ],
        "components.arxml": components.packages(whole.components, known, release),
        "deployment.arxml": deployment.packages(whole, services, release, paths),
    }
    about = {"components.arxml": document_trace(model.meta, model.info, model.provenance)}
    try:
        return tuple(
            GeneratedFile(name, written(name, paths.root, packages, release.schema, about.get(name)))
            for name, packages in content.items()
        )
    except AutosarDataError as error:
        raise InputRefused(f"The integration cannot be written as ARXML: {error}") from error


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
