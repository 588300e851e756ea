"""ARXML, as the table of generators has it."""

from typing import TYPE_CHECKING

from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.generator import Generator
from sigcat.integration.autosar_adaptive.platform import AUTOSAR_ADAPTIVE

if TYPE_CHECKING:
    from sigcat.limits import Limits


def _generate(data: bytes, name: str, limits: "Limits") -> tuple[GeneratedFile, ...]:
    from sigcat.adapter.autosar_adaptive.arxml.generate import generate
    from sigcat.integration.autosar_adaptive.document import read_integration

    return generate(read_integration(data, name, limits))


ARXML = Generator(
    name="arxml",
    title="ARXML",
    platform=AUTOSAR_ADAPTIVE,
    target="AUTOSAR adaptive R23-11",
    contents="types, interfaces, components and deployment",
    media_type="application/xml",
    generate=_generate,
)
