"""The files of the test RTE."""

from pathlib import Path

from sigcat.adapter.autosar_classic.code.c_text import c_lines
from sigcat.adapter.autosar_classic.code.plan import ClassicPlan, SwcPlan
from sigcat.adapter.autosar_classic.test_rte.cmake import cmake
from sigcat.adapter.autosar_classic.test_rte.component import component_source
from sigcat.adapter.autosar_classic.test_rte.plan import TestRte
from sigcat.adapter.autosar_classic.test_rte.readme import readme
from sigcat.adapter.autosar_classic.test_rte.tables import data_header, tables
from sigcat.adapter.core.c.text.lines import Lines, c_file
from sigcat.adapter.files import GeneratedFile, shipped, within
from sigcat.integration.autosar_classic.model import ClassicIntegration

C = Path(__file__).parent / "c"
"""Files that are the same for every integration."""


def generate(model: ClassicIntegration, plan: ClassicPlan) -> tuple[GeneratedFile, ...]:
    """All of them, the page that says what they are included."""
    rte = TestRte(model, plan)
    return (GeneratedFile("CMakeLists.txt", cmake(plan).encode()), *within("test_rte", _parts(rte, plan)))


def _parts(rte: TestRte, plan: ClassicPlan) -> tuple[GeneratedFile, ...]:
    return (
        *shipped(C),
        c_file("rte_data.h", data_header(rte)),
        c_file("rte_tables.c", tables(rte)),
        *(c_file(f"Rte_{swc.name}.c", component_source(swc, rte)) for swc in plan.swcs),
        *(c_file(f"include/{swc.name}_MemMap.h", _sections(swc)) for swc in plan.swcs),
        GeneratedFile("README.md", readme(rte).encode()),
    )


def _sections(swc: SwcPlan) -> Lines:
    """At a desk, every section is where the compiler puts it."""
    used = {"CODE", "VAR_CLEARED_UNSPECIFIED", *(each.name for each in swc.component.sections)}
    macros = sorted(f"{swc.name}_{moment}_SEC_{name}" for name in used for moment in ("START", "STOP"))
    return c_lines("test_rte/MemMap.h.j2", swc=swc.name, macros=macros)
