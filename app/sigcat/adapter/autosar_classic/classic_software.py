"""From Integration JSON to the software components, and to what runs them at a desk."""

from sigcat import codes
from sigcat.adapter.autosar_classic.arxml.classic_arxml import generate as generate_arxml
from sigcat.adapter.autosar_classic.code.component_files import generate as generate_components
from sigcat.adapter.autosar_classic.code.planning.planned_components import derive
from sigcat.adapter.autosar_classic.test_rte.test_rte_files import generate as generate_test_rte
from sigcat.adapter.files import GeneratedFile, within
from sigcat.adapter.placed_findings import placed_in
from sigcat.adapter.source_cores import files_of, source_cores
from sigcat.adapter.source_functions import source_functions
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.integration.autosar_classic.document import read_integration
from sigcat.limits import Limits


@collector_paused()
def generate(
    data: bytes, name: str, limits: Limits, release: str | None = None, *, bench: bool = False
) -> tuple[GeneratedFile, ...]:
    """ARXML, cores, components and headers of the contract phase, and with `bench` the test RTE.

    Raises InputRefused if the document cannot be used, or a core cannot be generated.
    """
    model = read_integration(data, name, limits)
    functions = source_functions(model.functions, data, name, limits, codes.NOT_WRITABLE_AS_CLASSIC, "autosar-classic")
    cores = source_cores(functions)
    with placed_in(data, name, limits):
        plan = derive(model, cores)
    return (
        *within("arxml", generate_arxml(model, release)),
        *within("core", files_of(cores)),
        *generate_components(model, plan),
        *(generate_test_rte(model, plan) if bench else ()),
    )
