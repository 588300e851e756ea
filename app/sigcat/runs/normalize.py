"""A trace becomes a normalized trace, with the names of values that players and the test RTE know."""

from collections.abc import Iterator

from sigcat.adapter.host.shapes import ERROR_CODE
from sigcat.runs.prepare import Prepared
from sigcat.runs.recording.normalized import CODE, normalized_lines
from sigcat.runs.recording.trace_file import Known, Trace


def with_codes(known: Known, prepared: Prepared) -> Known:
    """Add columns with codes of end-to-end protection to the known columns."""
    codes = {f"{name}{CODE}": ERROR_CODE for name in prepared.connections.received}
    return known._replace(received={**known.received, **codes})


def normalize(trace: Trace, prepared: Prepared) -> Iterator[str]:
    """Yield the lines of the normalized trace. Raises InputRefused at the end, with all errors in the trace."""
    names = prepared.connections.first_names
    codes = {f"{name}{CODE}": f"{first}{CODE}" for name, first in names.items()}
    return normalized_lines(trace, {**names, **codes})
