"""A function file, `function.yaml` or Function JSON, from its bytes to a function that is checked."""

from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from itertools import chain
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.interfaces import category_of, function_of, interface_name
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.errors import InputRefused
from sigcat.file_kind import is_json
from sigcat.findings import Finding, has_errors, in_order
from sigcat.function.checks.call_checks import check_inputs
from sigcat.function.checks.consequences import without_consequences
from sigcat.function.checks.consistency import check_consistency
from sigcat.function.checks.conventions import check_conventions
from sigcat.function.checks.definitions import unused_definitions, used_by
from sigcat.function.checks.error_references import KnownErrors
from sigcat.function.code_files import CodeCheck
from sigcat.function.declaration.declaration import Declared, read_declaration
from sigcat.function.document.document import Document, Pointer
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.document.read_json import read_json
from sigcat.function.extension.defined_nodes import Definitions
from sigcat.function.extension.definition_findings import DefinitionFindings, definition_findings
from sigcat.function.extension.extended_catalogue import extended
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.reading import read_function
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.renamed import told_once
from sigcat.function.resolving.resolve import resolve
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import bounded_proposals

FunctionFile = Declared | Document
"""A file that was read: a declaration, or a document that should be Function JSON."""


class CheckedFunction(NamedTuple):
    """A function that was read and resolved, and everything that is wrong with its file."""

    document: Document
    resolved: ResolvedFunction | None
    """None if the structure of the file is wrong; incomplete if there are errors."""
    findings: tuple[Finding, ...]
    is_declaration: bool = False

    @property
    def function(self) -> FunctionJson | None:
        """The function as far as it could be made."""
        return self.resolved.function if self.resolved else None

    @property
    def sound(self) -> ResolvedFunction | None:
        """The resolved function, if its file has no errors."""
        return None if has_errors(self.findings) else self.resolved

    @property
    def sound_function(self) -> FunctionJson | None:
        """The function, if its file has no errors."""
        return self.sound.function if self.sound else None

    @property
    def is_incomplete(self) -> bool:
        """Whether parts of the function may be missing because they could not be resolved."""
        return self.resolved is None or has_errors([each for each in self.findings if each.rule in _UNRESOLVED])


_UNRESOLVED = frozenset(
    rule.id
    for rule in (
        codes.FIELD_MISSING, codes.FIELD_UNKNOWN, codes.VALUE_UNFIT, codes.SIGNAL_UNKNOWN,
        codes.SIGNAL_HOLDS_NO_VALUE, codes.INTERFACE_UNKNOWN, codes.INTERFACE_OF_ANOTHER_CATEGORY,
        codes.INTERFACE_OF_ANOTHER_FUNCTION, codes.DATATYPE_UNFIT,
    )
)  # fmt: skip
"""Rules that leave out of a function what breaks them."""


_MISSPELLED = codes.VALUE_MISSPELLED.id
"""Rule for values that VSS allows with a warning; if a function cannot hold one, that is reported instead."""
_ABOUT_REFERENCES = frozenset(
    rule.id
    for rule in (codes.INTERFACE_UNKNOWN, codes.INTERFACE_OF_ANOTHER_CATEGORY, codes.INTERFACE_OF_ANOTHER_FUNCTION)
)
"""Rules about errors in the name of an interface, which may stand alone or under `interface`."""


def read_function_file(data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> FunctionFile:
    """Read a file of either kind."""
    return read_json(data, name, limits) if is_json(data, name) else read_declaration(data, name, limits)


# -- a declaration, and Function JSON -----------------------------------------------------------------------------


@bounded_proposals()
def check_declaration(declared: Declared, definitions: Definitions, catalogue: Catalogue) -> CheckedFunction:
    """Resolve and check a declaration. `catalogue` has its definitions in it."""
    declaration, document = declared.declaration, declared.document
    if declaration is None:
        return CheckedFunction(document, None, in_order(declared.findings), is_declaration=True)
    context = Context(catalogue, declaration.function, definitions, signals=declaration.consumed_signals)
    resolved, unplaced, missing = resolve(declaration, document, context)
    unresolved = tuple(told_once(unplaced, declaration, context))
    defined = definition_findings(definitions, document, catalogue)
    known_errors = _known_errors(catalogue.nodes, declaration.function)
    problems = without_consequences(
        chain(check_consistency(resolved.function, known_errors, resolved.origin), check_inputs(resolved.function)),
        missing,
        partial(_is_reported, definitions, defined, _attributes_of(unresolved), context),
        context.path_of,
    )
    about_references = [_finding(each, each.pointer, definitions, document, context) for each in unresolved]
    explained = {finding.pointer for finding in about_references}
    findings = in_order([
        *declared.findings,
        *(finding for finding in defined.findings if finding.rule != _MISSPELLED or finding.pointer not in explained),
        *about_references,
        *(_finding(each._replace(first=resolved.source_of_first(each)), resolved.source(each.pointer), definitions, document, context)
          for each in problems),
    ])  # fmt: skip
    return CheckedFunction(document, resolved, findings, is_declaration=True)


def _finding(
    problem: Problem, pointer: Pointer, definitions: Definitions, document: Document, context: Context
) -> Finding:
    """A problem as a finding: at the attribute that is wrong if the file defines it, otherwise at the reference."""
    subject = problem.subject
    node = definitions.by_path.get(context.path_of(subject.name)) if subject else None
    written = [name for name in subject.attributes if name in node.values] if subject and node else []
    is_at_key = bool(pointer) and isinstance(pointer[-1], str)  # such as the `min` of a signal: not at the reference
    at = node.pointer(written[0]) if node and written and not is_at_key else pointer
    if problem.rule.id in _ABOUT_REFERENCES and document.has((*at, "interface")):
        at = (*at, "interface")
    return document.finding(problem.rule, at, problem.message, problem.fix, problem.path, first=problem.first)


Attributes = frozenset[tuple[str, str]]
"""Paths and attributes of interfaces."""


def _attributes_of(problems: Iterable[Problem]) -> Attributes:
    """Return the attributes of the catalogue that problems name."""
    subjects = (problem.subject for problem in problems if problem.subject)
    return frozenset((subject.name, attribute) for subject in subjects for attribute in subject.attributes)


def _is_reported(
    definitions: Definitions, defined: DefinitionFindings, unresolved: Attributes, context: Context, subject: Subject
) -> bool:
    """Whether fault was found with what the catalogue, or the file itself, says of a subject."""
    path = context.path_of(subject.name)
    if any((path, attribute) in unresolved for attribute in subject.attributes):
        return True
    node = definitions.by_path.get(path) if defined.findings else None
    return node is not None and any(defined.are_about(node, attribute) for attribute in subject.attributes)


def _known_errors(paths: Iterable[str], function: str) -> KnownErrors:
    errors = [path for path in paths if category_of(path) == "error"]
    own = frozenset(interface_name(path) for path in errors if function_of(path) == function)
    return KnownErrors(frozenset(map(interface_name, errors)), own)


@bounded_proposals()
def check_document(document: Document, catalogue: Catalogue | None) -> CheckedFunction:
    """Check Function JSON from anywhere. With a catalogue, units, paths and ranges are compared with it."""
    resolved, findings = read_function(document)
    if resolved is None:
        return CheckedFunction(document, None, in_order(findings))
    function = resolved.function
    known_errors = _known_errors(catalogue.nodes if catalogue else (), function.info.function_name)
    problems = (
        *check_consistency(function, known_errors), *check_inputs(function), *check_conventions(function, catalogue)
    )  # fmt: skip
    return CheckedFunction(document, resolved, in_order([*findings, *resolved.findings(problems)]))


def check_files(
    files: Sequence[FunctionFile], catalogue: Catalogue, check_code: CodeCheck | None = None
) -> tuple[tuple[CheckedFunction, ...], Catalogue]:
    """Each file alone, against the catalogue with everything that any of them defines; and that catalogue.

    `check_code` checks the files of the code; without it they are not read.
    """
    over, definitions = extended(catalogue, files)
    checked = [
        check_declaration(file, own, over) if isinstance(file, Declared) else check_document(file, over)
        for file, own in zip(files, definitions, strict=True)
    ]
    used = frozenset(text for each in checked if each.function for text in used_by(each.function))
    return tuple(
        each._replace(findings=in_order([*each.findings, *_unused(each, own, used), *_code(each, check_code)]))
        for each, own in zip(checked, definitions, strict=True)
    ), over


def _code(checked: CheckedFunction, check_code: CodeCheck | None) -> Iterable[Finding]:
    return check_code(checked.resolved) if check_code is not None and checked.resolved is not None else ()


def _unused(checked: CheckedFunction, definitions: Definitions, used: frozenset[str]) -> Iterator[Finding]:
    """Report definitions that a declaration does not use. A wrong reference may have meant any of them."""
    if checked.is_incomplete or not checked.is_declaration:
        return
    is_incomplete = any(finding.rule == codes.CALLS_INCOMPLETE.id for finding in checked.findings)
    for problem in unused_definitions(definitions, used):
        if not (is_incomplete and problem.subject and problem.subject.kind == "scheduling"):
            at, message = problem.pointer, problem.message
            yield checked.document.finding(problem.rule, at, message, problem.fix, problem.path, of_key=True)


@collector_paused()
def checked_file(data: bytes, name: str, catalogue: Catalogue, limits: Limits = DEFAULT_LIMITS) -> CheckedFunction:
    """A function file of either kind, read, resolved and checked."""
    (checked,), _ = check_files([read_function_file(data, name, limits)], catalogue)
    return checked


@collector_paused()
def check_function(
    data: bytes, name: str, catalogue: Catalogue, limits: Limits = DEFAULT_LIMITS
) -> tuple[Finding, ...]:
    """Everything that is wrong with a function file of either kind."""
    return checked_file(data, name, catalogue, limits).findings


@collector_paused()
def check_function_json(
    data: bytes, name: str, catalogue: Catalogue | None = None, limits: Limits = DEFAULT_LIMITS
) -> CheckedFunction:
    """Function JSON from anywhere, read and checked. Without a catalogue only in itself."""
    document = read_json(data, name, limits)
    return check_document(document, extended(catalogue, [document]).catalogue if catalogue else None)


@collector_paused()
def build_function(
    data: bytes, name: str, catalogue: Catalogue, limits: Limits = DEFAULT_LIMITS, check_code: CodeCheck | None = None
) -> tuple[FunctionJson, tuple[Finding, ...]]:
    """The Function JSON of a `function.yaml`, and its warnings. Raises InputRefused with every finding."""
    (checked,), _ = check_files([read_declaration(data, name, limits)], catalogue, check_code)
    if checked.sound_function is None:
        count = sum(finding.severity == "error" for finding in checked.findings)
        message = f"{name} cannot be built: {count} error{'s' if count != 1 else ''}."
        raise InputRefused(message, checked.findings)
    return checked.sound_function, checked.findings
