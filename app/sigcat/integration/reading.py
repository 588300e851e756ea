"""Function files of either kind, as the resolved functions that an integration starts from."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.errors import InputRefused
from sigcat.file_kind import document_kind
from sigcat.findings import Finding, has_errors, in_order
from sigcat.function.function_file import CheckedFunction
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.sets.check_set import check_set, read_set
from sigcat.integration.application import refuse_doubles
from sigcat.limits import DEFAULT_LIMITS, Limits


class ReadFunctions(NamedTuple):
    """Functions, and the warnings of their files."""

    functions: tuple[ResolvedFunction, ...]
    findings: tuple[Finding, ...]


@collector_paused()
def read_functions(
    files: Sequence[tuple[bytes, str]], catalogue: Catalogue, limits: Limits = DEFAULT_LIMITS
) -> ReadFunctions:
    """The functions of files, `function.yaml` or Function JSON, checked as `validate` does: alone and together.

    Raises InputRefused with every finding of every file if there are errors.
    """
    members, over = read_set(files, catalogue, limits)
    members = tuple(map(_of_one_kind, members))
    alone = [finding for each in members for finding in each.findings]
    findings = in_order([*alone, *check_set(members, over, is_whole=len(members) > 1)])
    if has_errors(findings):
        raise InputRefused(_refusal(files, members), findings)
    functions = tuple(each.resolved for each in members if each.resolved is not None)
    refuse_doubles(functions)
    return ReadFunctions(functions, findings)


def _refusal(files: Sequence[tuple[bytes, str]], members: Sequence[CheckedFunction]) -> str:
    refused = [name for (_, name), each in zip(files, members, strict=True) if has_errors(each.findings)]
    if not refused:
        return "The functions cannot be used: they do not fit together."
    return f"{', '.join(refused[:5])} cannot be used: {'it has' if len(refused) == 1 else 'they have'} errors."


def _of_one_kind(checked: CheckedFunction) -> CheckedFunction:
    """Integration JSON for ROS 2 is Function JSON with more, and would be taken for a function."""
    is_json = checked.function is not None and not checked.is_declaration
    kind = document_kind(checked.document.value) if is_json else None
    if kind is None or kind.kind != "integration json":
        return checked
    message = f"The document must be Function JSON, not {kind.title}, which is integrated already."
    fix = "Give the Function JSON or the function.yaml that it was made from."
    finding = checked.document.finding(codes.FIELD_UNKNOWN, (), message, fix)
    return checked._replace(findings=(*checked.findings, finding))
