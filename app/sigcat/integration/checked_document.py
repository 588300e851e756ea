"""Integration JSON from anywhere, of whichever platform: the model, or everything that is wrong with it."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

from pydantic import BaseModel, ValidationError

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.file_kind import holds_function
from sigcat.findings import Finding, RuleCode, has_errors
from sigcat.function.checks.unfit import accessors_of
from sigcat.function.document.document import Document
from sigcat.function.document.read_json import read_json
from sigcat.function.document.structure import structural_findings
from sigcat.function.document.unfit_texts import unfit_texts
from sigcat.function.function_json.model import FunctionJson
from sigcat.integration.agreement import missing_names
from sigcat.integration.misspelled import misspelled_keys
from sigcat.integration.problem import Problem
from sigcat.integration.source_functions import errors_of_function
from sigcat.limits import DEFAULT_LIMITS, Limits

M = TypeVar("M", bound=BaseModel)


def _as_it_is(model: M) -> M:
    return model


@dataclass(frozen=True)
class DocumentKind(Generic[M]):
    """The Integration JSON of a platform."""

    platform: str
    model: type[M]
    rule: RuleCode
    """Rule of the findings about problems."""
    problems: Callable[[M], Iterable[Problem]]
    completed: Callable[[M], M] = _as_it_is
    """Adds what follows by rule, before problems are looked for."""

    def read(self, data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> M:
        """The model of a document. Raises InputRefused with everything that is wrong."""
        if not data.lstrip().startswith(b"{") and holds_function(data):
            raise self._refused(name, (self._before_integration(name),))
        document = read_json(data, name, limits)
        findings: tuple[Finding, ...] = document.findings
        if not has_errors(findings):
            try:
                model = self.model.model_validate(document.value, by_name=False)
            except ValidationError as error:
                findings = (*findings, *structural_findings(error, document, self.model))
            else:
                findings = (*misspelled_keys(document, self.model), *self._at_the_door(model, document))
                if not findings:
                    whole = self.completed(model)
                    findings = tuple(document.finding(self.rule, *problem) for problem in self.problems(whole))
                    if not findings:
                        return whole
        raise self._refused(name, findings)

    def _refused(self, name: str, findings: tuple[Finding, ...]) -> InputRefused:
        return InputRefused(
            f"{name} must be Integration JSON as `sigcat integrate {self.platform}` writes it.", findings
        )

    def _before_integration(self, name: str) -> Finding:
        """The finding about a function file, from which the document is made."""
        fix = f"Run `sigcat integrate {self.platform}` with it, and name the document that it writes."
        return codes.NOT_JSON.finding("The file is a function file, not Integration JSON.", name, 1, 1, fix=fix)

    def _at_the_door(self, model: M, document: Document) -> Iterator[Finding]:
        """Strings that are not of the type of their field, and errors of the functions that the document carries."""
        functions: Sequence[FunctionJson] = getattr(model, "functions", None) or ()
        accessors = [name for function in functions for name in accessors_of(function)]
        for each in unfit_texts(model.model_copy(update={"functions": None}), accessors):
            yield document.finding(self.rule, each.pointer, each.message, each.fix)
        for index in range(len(functions)):
            yield from errors_of_function(document, index)
        for missing in missing_names(model, functions) if functions else ():
            yield document.finding(self.rule, *missing)
