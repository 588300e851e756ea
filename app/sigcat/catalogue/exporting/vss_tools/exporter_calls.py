"""Calls of the exporters of vss-tools: names of their options for the tree and the output."""

from collections.abc import Mapping
from typing import NamedTuple


class Call(NamedTuple):
    """Options of vss-tools for the tree and the output, where an exporter of it differs from the others."""

    output: str = "output"
    """Name of the option that names the file or folder."""
    takes_tree_options: bool = True
    """False where the exporter reads the units beside the tree and knows no overlays, types or strictness."""
    output_exists: bool = False
    """Whether the folder to write has to exist already."""
    copies_unit_files: bool = False
    """Whether the files of units and quantities themselves become part of the export."""


CALLS: Mapping[str, Call] = {
    "s2dm": Call(copies_unit_files=True),
    "samm": Call("target-folder"),
    "apigear": Call("output-dir"),
    "vhal": Call("aosp-workspace-path", takes_tree_options=False, output_exists=True),
}
"""The exporters that are called in another way than the rest, by name."""


def call_of(name: str) -> Call:
    """Return the call of vss-tools for an exporter."""
    return CALLS.get(name, Call())
