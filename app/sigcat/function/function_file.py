"""A function file, `function.yaml` or Function JSON, from its bytes to a function that is checked."""

from collections.abc import Sequence
from functools import partial
from typing import NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.interfaces import category_of, interface_name
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.errors import InputRefused
from sigcat.file_kind import is_json
from sigcat.findings import Finding, has_errors, in_order
from sigcat.function.checks.consequences import without_consequences
from sigcat.function.checks.consistency import check_consistency
from sigcat.function.checks.conventions import check_conventions
from sigcat.function.declaration.declaration import Declared, read_declaration
from sigcat.function.document.document import Document
from sigcat.function.document.problem import Subject
from sigcat.function.document.read_json import read_json
from sigcat.function.extension.defined_nodes import Definitions
from sigcat.function.extension.definition_findings import DefinitionFindings, definition_findings
from sigcat.function.extension.extended_catalogue import extended
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.reading import read_function
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.resolve import resolve
from sigcat.limits import DEFAULT_LIMITS, Limits

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
    def sound_function(self) -> FunctionJson | None:
        """The function, if its file has no errors."""
        return None if has_errors(self.findings) else self.function


def read_function_file(data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> FunctionFile:
    """Read a file of either kind."""
    return read_json(data, name, limits) if is_json(data, name) else read_declaration(data, name, limits)


# -- a declaration, and Function JSON -----------------------------------------------------------------------------


def check_declaration(declared: Declared, definitions: Definitions, catalogue: Catalogue) -> CheckedFunction:
    """Resolve and check a declaration. `catalogue` has its definitions in it."""
    declaration, document = declared.declaration, declared.document
    if declaration is None:
        return CheckedFunction(document, None, in_order(declared.findings), is_declaration=True)
    context = Context(catalogue, declaration.function)
    resolved, resolving_problems, missing = resolve(declaration, document, context)
    defined = definition_findings(definitions, document, catalogue)
    problems = without_consequences(
        check_consistency(resolved.function, frozenset(context.names("error"))),
        missing,
        partial(_is_reported, definitions, defined, context),
        context.path_of,
    )
    unresolved = (
        document.finding(each.rule, each.pointer, each.message, each.fix, each.path) for each in resolving_problems
    )
    findings = in_order([*declared.findings, *defined.findings, *unresolved, *resolved.findings(problems)])
    return CheckedFunction(document, resolved, findings, is_declaration=True)


def _is_reported(definitions: Definitions, defined: DefinitionFindings, context: Context, subject: Subject) -> bool:
    """Whether the rules of the catalogue have found fault with what the file itself defines of a subject."""
    node = definitions.by_path.get(context.path_of(subject.name)) if defined.findings else None
    return node is not None and any(defined.are_about(node, attribute) for attribute in subject.attributes)


def check_document(document: Document, catalogue: Catalogue | None) -> CheckedFunction:
    """Check Function JSON from anywhere. With a catalogue, units, paths and ranges are compared with it."""
    resolved, findings = read_function(document)
    if resolved is None:
        return CheckedFunction(document, None, in_order(findings))
    nodes = catalogue.nodes if catalogue else ()
    known_errors = frozenset(interface_name(path) for path in nodes if category_of(path) == "error")
    problems = (*check_consistency(resolved.function, known_errors), *check_conventions(resolved.function, catalogue))
    return CheckedFunction(document, resolved, in_order([*findings, *resolved.findings(problems)]))


def check_files(files: Sequence[FunctionFile], catalogue: Catalogue) -> tuple[tuple[CheckedFunction, ...], Catalogue]:
    """Each file alone, against the catalogue with everything that any of them defines; and that catalogue."""
    declarations = [file for file in files if isinstance(file, Declared)]
    over, definitions = extended(catalogue, declarations)
    own = iter(definitions)
    return tuple(
        check_declaration(file, next(own), over) if isinstance(file, Declared) else check_document(file, over)
        for file in files
    ), over


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
    return check_document(read_json(data, name, limits), catalogue)


@collector_paused()
def build_function(
    data: bytes, name: str, catalogue: Catalogue, limits: Limits = DEFAULT_LIMITS
) -> tuple[FunctionJson, tuple[Finding, ...]]:
    """The Function JSON of a `function.yaml`, and its warnings. Raises InputRefused with every finding."""
    (checked,), _ = check_files([read_declaration(data, name, limits)], catalogue)
    if checked.sound_function is None:
        count = sum(finding.severity == "error" for finding in checked.findings)
        message = f"{name} cannot be built: {count} error{'s' if count != 1 else ''}."
        raise InputRefused(message, checked.findings)
    return checked.sound_function, checked.findings
