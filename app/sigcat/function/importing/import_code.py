"""A folder of C code to a function.yaml that is checked."""

from collections.abc import Collection, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.interfaces import interface_name
from sigcat.errors import UsageError
from sigcat.findings import Finding, has_errors
from sigcat.function.c_project.code_values import Value
from sigcat.function.c_project.project import CodeProject
from sigcat.function.c_project.read_project import read_project
from sigcat.function.declaration.scaffold import checked_name, checked_schema
from sigcat.function.function_file import check_function
from sigcat.function.importing.function_text import Draft, function_text, to_do
from sigcat.function.importing.own_signals import checked_branch, defined_under
from sigcat.function.importing.parameters import parameters_of
from sigcat.function.importing.signals import Role, signals_of
from sigcat.real_path import real_path

_MOST_TRIES = 4


class Imported(NamedTuple):
    """The text of a function.yaml, with what was found while the code was read."""

    text: str
    summary: str
    to_do: tuple[str, ...]
    findings: tuple[Finding, ...]


def import_code(
    name: str,
    folder: Path,
    target: Path,
    catalogue: Catalogue,
    schema: str,
    model: str = "",
    definitions: Sequence[str] = (),
    branch: str = "",
) -> Imported:
    """The function.yaml for the code in a folder, to be written into `target`. Raises UsageError, InputRefused.

    Signals that are not certain to be in the catalogue are defined below `branch`, if there is one.
    """
    checked_name(name)
    if branch:
        checked_branch(branch, catalogue)
    checked_schema(schema)
    project = read_project(folder, name, model, definitions)
    draft = draft_of(name, project, folder, target, catalogue, schema, branch)
    return Imported(function_text(draft), _summary(draft), tuple(to_do(draft)), shown(project, folder))


def draft_of(
    name: str,
    project: CodeProject,
    folder: Path,
    target: Path,
    catalogue: Catalogue,
    schema: str,
    branch: str = "",
    paths: Collection[str] = (),
    parameter_names: Collection[str] = (),
) -> Draft:
    """The draft of the function.yaml for a project. Paths and names are those that its file has already."""
    signals = tuple(signals_of(tuple(_values(project)), catalogue, project.model, paths))
    known = _of_function(name, "Parameter", catalogue)
    parameters = tuple(parameters_of(project.interface.parameters, catalogue.vocabulary, known, parameter_names))
    scheduled = frozenset(_of_function(name, "Scheduling", catalogue))
    errors = tuple(interface_name(node.path) for node in _of_function(name, "Error", catalogue).values())
    draft = Draft(name, project, signals, parameters, below(folder, target), schema, scheduled, errors)
    draft = _checked(draft, catalogue)
    if branch:
        defined, data = defined_under(branch, name, draft.signals, catalogue)
        draft = draft._replace(signals=defined, data=data)
    return draft


def _of_function(name: str, category: str, catalogue: Catalogue) -> dict[str, Node]:
    """Return the function's nodes of a category that the catalogue already has, by last name."""
    root = catalogue.roots[0].path if catalogue.roots else ""
    branch = catalogue.get(f"{root}.Function.{name}.{category}")
    return {node.name: node for node in branch.children} if branch else {}


def _values(project: CodeProject) -> Iterator[tuple[Role, Value]]:
    yield from (("consumed", value) for value in project.interface.inputs)
    yield from (("provided", value) for value in project.interface.outputs)


def below(folder: Path, target: Path) -> str:
    """The folder of the code as seen from the file: the code moves with its declaration."""
    try:
        return real_path(folder).relative_to(real_path(target)).as_posix()
    except ValueError:
        raise UsageError(
            f"the code in {folder} must be in {target}, or below it: name another folder to write into"
        ) from None


def _checked(draft: Draft, catalogue: Catalogue) -> Draft:
    """Without paths that fit by their words but not by what the code holds, such as a range that would be lost."""
    for _ in range(_MOST_TRIES):
        chosen = {signal.path for signal in draft.signals if signal.is_chosen}
        findings = check_function(function_text(draft).encode(), "function.yaml", catalogue)
        wrong = {each.path: each.message for each in findings if each.path in chosen}
        if not wrong:
            return draft
        signals = (
            each.unchosen(wrong[each.path]) if each.is_chosen and each.path in wrong else each for each in draft.signals
        )
        draft = draft._replace(signals=tuple(signals))
    return draft


def _summary(draft: Draft) -> str:
    interface = draft.project.interface
    counted = {"input": interface.inputs, "output": interface.outputs, "parameter": draft.parameters}
    listed = ", ".join(f"{len(each)} {noun}{'' if len(each) == 1 else 's'}" for noun, each in counted.items())
    return f"{listed} of {draft.project.model or 'the code'}"


def shown(project: CodeProject, folder: Path) -> tuple[Finding, ...]:
    """Findings with paths as they are seen from here."""
    assert not has_errors(project.findings)
    return tuple(
        each._replace(file=str(folder / each.file)) if each.file and each.file != str(folder) else each
        for each in project.findings
    )
