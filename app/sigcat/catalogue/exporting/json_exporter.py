"""The exporter of JSON: written by sigcat itself, with the same data as `vspec export json`."""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from sigcat.catalogue.exporting.exporter import Exporter, Job, Option
from sigcat.catalogue.exporting.shared_options import (
    ALL_ATTRIBUTES,
    EXPAND,
    KEEP_INSTANCES,
    PRETTY,
    STRICTNESS,
    TYPES_OUTPUT,
)

if TYPE_CHECKING:
    from sigcat.catalogue.exporting.files import Export
    from sigcat.catalogue.model.catalogue import Catalogue

_STATISTICS = Option("stats-radial", "output", "write counts for a radial chart to this file too")
_OPTIONS = (EXPAND, TYPES_OUTPUT, PRETTY, ALL_ATTRIBUTES, KEEP_INSTANCES, _STATISTICS, *STRICTNESS)
_ONLY_VSS_TOOLS = ("stats-radial", "strict", "aborts", "strict-exceptions")
"""Options with which vss-tools writes the JSON: the statistics and the checks are its own."""
_STREAMED = frozenset(("expand", "extended-attributes", "extend-all-attributes", "keep-instances"))


def _run(job: Job) -> "Export":
    if any(job.options.get(name) for name in _ONLY_VSS_TOOLS):
        from sigcat.catalogue.exporting.vss_tools.running import run

        return run(job)
    from sigcat.catalogue.exporting.export_json import exported_json

    return exported_json(job)


def _stream(catalogue: "Catalogue", options: Mapping[str, Any]) -> Iterator[bytes] | None:
    if not set(options) <= _STREAMED or not options.get("expand", True) or len(catalogue.roots) > 1:
        return None
    from sigcat.catalogue.exporting.json_stream import json_parts

    return json_parts(catalogue, options)


JSON = Exporter(
    "json", "JSON, nested", ".json", "application/json", _OPTIONS, _run, _stream, same_as="vspec export json"
)
