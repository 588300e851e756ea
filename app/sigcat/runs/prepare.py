"""Functions, ready to run: their files are there, their cores planned, and they are connected."""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.core.cores import plans
from sigcat.adapter.core.planned_core import Planned
from sigcat.adapter.host.connections import Connections, Member, connect
from sigcat.adapter.host.numbering import Numbers, numbers_of
from sigcat.adapter.host.shapes import SECONDS, Shape
from sigcat.errors import InputRefused
from sigcat.findings import Finding, in_order
from sigcat.function.code_files import missing_files
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.walk import absent
from sigcat.runs.recording.trace_file import Known


class Prepared(NamedTuple):
    """Functions that can be built and run."""

    connections: Connections
    numbers: Numbers
    findings: tuple[Finding, ...]
    """Warnings about them."""

    @property
    def columns(self) -> Mapping[str, Shape]:
        """Values that are sent, by name."""
        return {each.name: each.shape for each in self.connections.exits}

    def known_columns(self, paths: Iterable[str]) -> Known:
        """Return the allowed columns of a trace; `paths` are paths and interfaces of the catalogue."""
        connections = self.connections
        durations = {call.interface: SECONDS for call in self.numbers.calls if call}
        names = [each.names for each in connections.entries] + [each.names for each in connections.exits]
        lacking = (
            each.vss_path or each.name for one in connections.members for _, _, each in absent(one.function.function)
        )
        others = {*paths, *lacking, *(name for each in names for name in each)}
        units = {name: each.unit for each in connections.entries for name in each.names}
        return Known({**durations, **connections.received}, others, inputs=connections.inputs, units=units)

    @property
    def inputs(self) -> frozenset[str]:
        """All names of inputs and of calls."""
        names = {name for each in self.connections.entries for name in each.names}
        return frozenset(names | {call.interface for call in self.numbers.calls if call})

    @property
    def known_in_drive(self) -> Known:
        """Return the allowed columns of a drive, which has more than these functions need."""
        return self.known_columns(())._replace(others=None, inputs=())


def prepare(functions: Sequence[ResolvedFunction]) -> Prepared:
    """The functions, planned and connected. Raises InputRefused with all errors."""
    missing = [each._replace(severity="error") for function in functions for each in missing_files(function)]
    if missing:
        raise InputRefused(
            "The functions cannot be run: files of their code are missing or cannot be read.", in_order(missing)
        )
    planned = plans(functions)
    connections = _connected(functions, planned)
    findings = tuple(finding for each in planned for finding in each.findings)
    return Prepared(connections, numbers_of(connections), findings)


def received_by(functions: Sequence[ResolvedFunction]) -> Mapping[str, Shape]:
    """Return what functions receive from outside, by name. Raises InputRefused if they cannot be connected."""
    return _connected(functions, plans(functions)).received


def _connected(functions: Sequence[ResolvedFunction], planned: Sequence[Planned]) -> Connections:
    folders = (Path(function.document.name).parent for function in functions)
    members = [Member(*each) for each in zip(functions, (each.plan for each in planned), folders, strict=True)]
    return connect(members)
