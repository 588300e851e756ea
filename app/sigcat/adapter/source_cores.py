"""The cores of the functions of an Integration JSON: each is one object, which one component or node holds."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.core.core_files import all_files
from sigcat.adapter.core.cores import plans
from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.host.host_plan import HostPlan, host_plan
from sigcat.findings import Finding, RuleCode
from sigcat.function.function_json.resolved_function import ResolvedFunction

SourceCores = Mapping[str, HostPlan]
"""Functions of the document with their cores, by name, in the order of the document."""


class Holder(NamedTuple):
    """Holder of the core of a function."""

    name: str
    function: str
    pointer: str
    """Pointer of the place that names the function."""


def source_cores(functions: Sequence[ResolvedFunction]) -> SourceCores:
    """The core of each function. Raises InputRefused with all obstacles."""
    planned = plans(functions)
    return {each.name: host_plan(each.function, core.plan) for each, core in zip(functions, planned, strict=True)}


def files_of(cores: SourceCores) -> tuple[GeneratedFile, ...]:
    """Header and source of each core, and files that all cores share."""
    return all_files(each.core for each in cores.values())


def wrong_holders(
    holders: Iterable[Holder], cores: SourceCores, rule: RuleCode, become: str, anew: str = "Integrate it again."
) -> Iterator[Finding]:
    """Report holders whose function is not in the document, or has a holder already; `become` names their kind."""
    seen: dict[str, str] = {}
    for name, function, pointer in holders:
        if function not in cores:
            message = f"The function of {name} must be in `SourceFunctionList`, and {function or 'none'} is not."
            yield rule.finding(message, pointer=pointer, fix=anew)
        elif function in seen:
            message = f"{function} must have one component to become {become}, not {seen[function]} and {name}."
            yield rule.finding(message, pointer=pointer, fix="Join the components of the function.")
        seen.setdefault(function, name)
