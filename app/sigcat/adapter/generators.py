"""The generators of files for platforms. Whatever lists them reads this table."""

from collections.abc import Mapping

from sigcat.adapter.autosar_adaptive.arxml.generator import ARXML
from sigcat.adapter.generator import Generator

GENERATORS: Mapping[str, Generator] = {generator.name: generator for generator in (ARXML,)}
"""The generators by name, in the order in which they are listed."""
