"""The exporters: whatever lists them, or asks for one, reads this table."""

from collections.abc import Mapping

from sigcat.catalogue.exporting.exporter import Exporter
from sigcat.catalogue.exporting.json_exporter import JSON
from sigcat.catalogue.exporting.vss_tools.exporters import VSS_TOOLS
from sigcat.errors import NotFound
from sigcat.names import did_you_mean, nearest

EXPORTERS: Mapping[str, Exporter] = {exporter.name: exporter for exporter in (JSON, *VSS_TOOLS)}
"""The exporters by name, in the order in which they are listed."""


def exporter_named(name: str) -> Exporter:
    """The exporter with this name. Raises NotFound with the nearest names."""
    if name not in EXPORTERS:
        hint = did_you_mean(name, EXPORTERS) or f"There are {', '.join(EXPORTERS)}."
        raise NotFound(f"Unknown export format {name!r}. {hint}", nearest(name, EXPORTERS))
    return EXPORTERS[name]
