"""From the plan of the software components to their files."""

from collections.abc import Iterator
from pathlib import Path

from sigcat.adapter.autosar_classic.code.component.swc_source import swc_source
from sigcat.adapter.autosar_classic.code.plan import ClassicPlan
from sigcat.adapter.autosar_classic.code.rte_headers import rte_header
from sigcat.adapter.autosar_classic.code.rte_headers.api import Apis
from sigcat.adapter.core.c.text.lines import c_file
from sigcat.adapter.files import GeneratedFile, shipped, within
from sigcat.adapter.templates import rendered
from sigcat.integration.autosar_classic.model import ClassicIntegration

_CONTRACT = Path(__file__).parent / "contract"
"""Headers that are the same for every integration."""


def generate(model: ClassicIntegration, plan: ClassicPlan) -> Iterator[GeneratedFile]:
    """Sources, and the headers that a vendor's generator replaces. The same document gives the same bytes."""
    readme = rendered("adapter/autosar_classic/code/README.md.j2", name=plan.name, swcs=plan.swcs)
    yield GeneratedFile("README.md", readme.encode())
    yield from within("contract", shipped(_CONTRACT))
    yield c_file("contract/Rte_Main.h", rte_header.lifecycle_header(model))
    yield c_file("contract/Rte_Type.h", rte_header.type_header(model))
    for swc in plan.swcs:
        calls = Apis(swc, model, dict(plan.types)).all()
        yield c_file(f"contract/Rte_{swc.name}_Type.h", rte_header.component_type_header(swc, model))
        yield c_file(f"contract/Rte_{swc.name}.h", rte_header.component_header(swc, calls, model))
        yield c_file(f"swc/{swc.name}.{swc.core.code.ending}", swc_source(swc))
