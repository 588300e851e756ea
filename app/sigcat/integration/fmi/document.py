"""Integration JSON for FMI from anywhere: the model, or everything that is wrong with it."""

from collections.abc import Iterator

from sigcat import codes
from sigcat.integration.checked_document import DocumentKind, Problem
from sigcat.integration.fmi.model import FmiIntegration, Fmu
from sigcat.limits import DEFAULT_LIMITS, Limits


def read_integration(data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> FmiIntegration:
    """The model of a document. Raises InputRefused with every finding."""
    return _KIND.read(data, name, limits)


def _problems(model: FmiIntegration) -> Iterator[Problem]:
    """Everything that a modelDescription.xml cannot have."""
    names = [each.name.lower() for each in model.fmus]
    for index, fmu in enumerate(model.fmus):
        if names.index(fmu.name.lower()) < index:
            yield Problem(("FmuList", index, "Name"), f"Each FMU must have its own name, and {fmu.name} is used twice.")
        yield from _variables(fmu, index)


def _variables(fmu: Fmu, index: int) -> Iterator[Problem]:
    seen: set[str] = set()
    for number, variable in enumerate(fmu.variables):
        at = ("FmuList", index, "VariableList", number)
        if variable.name in seen:
            message = f"Each variable must have its own name, and {variable.name} is used twice."
            yield Problem((*at, "Name"), message, "Rename one of the two.")
        seen.add(variable.name)
        if variable.reference != number:
            message = f"ValueReference must be the index of the variable, {number}, not {variable.reference}."
            yield Problem((*at, "ValueReference"), message, "Integrate the functions again.")


_KIND = DocumentKind("fmi", FmiIntegration, codes.NOT_WRITABLE_AS_FMU, _problems)
