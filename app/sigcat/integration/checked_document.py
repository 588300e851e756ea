"""Integration JSON from anywhere, of whichever platform: the model, or everything that is wrong with it."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Generic, NamedTuple, TypeVar

from pydantic import BaseModel, ValidationError

from sigcat.errors import InputRefused
from sigcat.findings import Finding, RuleCode, has_errors
from sigcat.function.document.document import Pointer
from sigcat.function.document.read_json import read_json
from sigcat.function.document.structure import structural_findings
from sigcat.integration.misspelled import misspelled_keys
from sigcat.limits import Limits

M = TypeVar("M", bound=BaseModel)


class Problem(NamedTuple):
    """What a platform cannot be generated from, and where it stands."""

    pointer: Pointer
    message: str
    fix: str = ""


def _as_it_is(model: M) -> M:
    return model


@dataclass(frozen=True)
class DocumentKind(Generic[M]):
    """The Integration JSON of a platform."""

    platform: str
    model: type[M]
    rule: RuleCode
    """What problems are findings of."""
    problems: Callable[[M], Iterable[Problem]]
    completed: Callable[[M], M] = _as_it_is
    """Adds what follows by rule, before problems are looked for."""

    def read(self, data: bytes, name: str, limits: Limits) -> M:
        """The model of a document. Raises InputRefused with everything that is wrong."""
        document = read_json(data, name, limits)
        findings: tuple[Finding, ...] = document.findings
        if not has_errors(findings):
            try:
                model = self.model.model_validate(document.value, by_name=False)
            except ValidationError as error:
                findings = (*findings, *structural_findings(error, document, self.model))
            else:
                whole = self.completed(model)
                problems = (document.finding(self.rule, *problem) for problem in self.problems(whole))
                findings = (*misspelled_keys(document, self.model), *problems)
                if not findings:
                    return whole
        raise InputRefused(
            f"{name} must be Integration JSON as `sigcat integrate {self.platform}` writes it.", findings
        )
