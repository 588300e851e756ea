"""Set to compare: a folder that describes it in its compare.yaml, or files of functions."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from pydantic import Field, ValidationError

from sigcat.errors import InputRefused, UsageError, existing_file
from sigcat.findings import has_errors, in_order
from sigcat.function.declaration.form import DeclarationModel, Text
from sigcat.function.document.read_yaml import read_yaml
from sigcat.function.document.structure import structural_findings

FILE = "compare.yaml"


class SetFile(DeclarationModel):
    """Content of a compare.yaml; paths begin at its folder."""

    name: Text | None = Field(None, description="Name of the set; that of the folder if absent.")
    functions: list[Text] = Field(min_length=1, description="Files of the functions.")
    deployment: Text | None = Field(None, description="What differs from the defaults of the platforms.")
    trace: Text | None = Field(None, description="The drive that is played.")
    faults: Text | None = Field(None, description="Faults that are injected.")
    baseline: Text | None = Field(None, description="Folder of a ROS 2 package with the same nodes, written by hand.")


class ComparedSet(NamedTuple):
    """Files of a set. All of them are there."""

    name: str
    functions: tuple[Path, ...]
    deployment: Path | None = None
    trace: Path | None = None
    faults: Path | None = None
    baseline: Path | None = None

    @property
    def written(self) -> tuple[tuple[str, Path], ...]:
        """Files written by hand for the set, with their kinds."""
        deployment = [("deployment", self.deployment)] if self.deployment else []
        return (*(("declaration", path) for path in self.functions), *deployment)


def read_compared(named: Sequence[Path]) -> ComparedSet:
    """The set of a folder, or of files of functions. Raises UsageError, or InputRefused with its errors."""
    if len(named) == 1 and named[0].is_dir():
        return _of_folder(named[0])
    functions = tuple(existing_file(path) for path in named)
    return ComparedSet(functions[0].absolute().parent.name, functions)


def _of_folder(folder: Path) -> ComparedSet:
    file = folder / FILE
    if not file.is_file():
        found = tuple(sorted(folder.glob("*/function.yaml"))) or tuple(sorted(folder.glob("function.yaml")))
        if not found:
            raise UsageError(f"{folder} has no {FILE}, and no function.yaml: name the functions")
        deployment = folder / "deployment.yaml"
        return ComparedSet(folder.absolute().name, found, deployment if deployment.is_file() else None)
    said = _read(file)
    return ComparedSet(
        said.name or folder.absolute().name,
        tuple(existing_file(folder / each) for each in said.functions),
        _existing_file_named(folder, said.deployment),
        _existing_file_named(folder, said.trace),
        _existing_file_named(folder, said.faults),
        _existing_folder(folder / said.baseline) if said.baseline else None,
    )


def _existing_file_named(folder: Path, name: str | None) -> Path | None:
    return existing_file(folder / name) if name else None


def _existing_folder(folder: Path) -> Path:
    if not folder.is_dir():
        raise UsageError(f"{folder}: there is no such folder")
    return folder


def _read(file: Path) -> SetFile:
    document = read_yaml(file.read_bytes(), str(file))
    findings = document.findings
    if not has_errors(findings):
        try:
            return SetFile.model_validate(document.value)
        except ValidationError as error:
            findings = (*findings, *structural_findings(error, document, SetFile))
    raise InputRefused(f"{file} does not say what is compared.", in_order(findings))
