"""The cores of several functions together: their plans, and their files."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.clocks import with_common_clock
from sigcat.adapter.core.core_files import all_files
from sigcat.adapter.core.numbers import DOUBLE, FLOAT, NumberType
from sigcat.adapter.core.planned_core import Planned, derive
from sigcat.adapter.files import GeneratedFile
from sigcat.errors import InputRefused
from sigcat.findings import Finding, in_order
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.application import refuse_doubles


class Cores(NamedTuple):
    """Files, and warnings about what they were made from."""

    files: tuple[GeneratedFile, ...]
    findings: tuple[Finding, ...]


def cores(functions: Sequence[ResolvedFunction], arithmetic: NumberType = DOUBLE) -> Cores:
    """Header and source of each function. Raises InputRefused with all obstacles."""
    planned = plans(functions, arithmetic)
    found = [each.plan for each in planned]
    return Cores(
        all_files(with_common_clock(found) if arithmetic == FLOAT else found),
        tuple(finding for each in planned for finding in each.findings),
    )


def plans(functions: Sequence[ResolvedFunction], arithmetic: NumberType = DOUBLE) -> tuple[Planned, ...]:
    """The plan of each function. Raises InputRefused with all obstacles."""
    refuse_doubles(functions)
    planned: list[Planned] = []
    refused: list[InputRefused] = []
    for function in functions:
        try:
            planned.append(derive(function, arithmetic))
        except InputRefused as error:
            refused.append(error)
    if refused:
        findings = in_order([finding for error in refused for finding in error.findings])
        raise InputRefused(" ".join(map(str, refused)), findings)
    return tuple(planned)
