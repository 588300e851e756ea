"""From the plan of the software components to their files."""

from collections.abc import Iterator

from sigcat.adapter.autosar_classic.code import rte_header
from sigcat.adapter.autosar_classic.code.api import Apis
from sigcat.adapter.autosar_classic.code.plan import ClassicPlan
from sigcat.adapter.autosar_classic.code.readme import readme
from sigcat.adapter.autosar_classic.code.swc_source import swc_source
from sigcat.adapter.core.c.lines import Lines, wrapped
from sigcat.adapter.files import GeneratedFile
from sigcat.integration.autosar_classic.model import ClassicIntegration


def generate(model: ClassicIntegration, plan: ClassicPlan) -> Iterator[GeneratedFile]:
    """Sources, and the headers that a vendor's generator replaces. The same document gives the same bytes."""
    yield GeneratedFile("README.md", readme(plan).encode())
    yield _file("contract/Rte.h", rte_header.rte_header())
    yield _file("contract/Rte_Main.h", rte_header.lifecycle_header(model))
    yield _file("contract/Rte_Type.h", rte_header.type_header(model))
    for swc in plan.swcs:
        calls = Apis(swc, model, dict(plan.types)).all()
        yield _file(f"contract/Rte_{swc.name}_Type.h", rte_header.component_type_header(swc, model))
        yield _file(f"contract/Rte_{swc.name}.h", rte_header.component_header(swc, calls, model))
        yield _file(f"swc/{swc.name}.{swc.core.code.ending}", swc_source(swc))


def _file(name: str, part: Lines) -> GeneratedFile:
    return GeneratedFile(name, ("\n".join(line.text for line in wrapped(part)) + "\n").encode())
