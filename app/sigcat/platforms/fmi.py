"""FMI, as the table of platforms has it."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sigcat.platforms.platform import Generator, Integrated, Options, Platform

if TYPE_CHECKING:
    from sigcat.adapter.files import GeneratedFile
    from sigcat.catalogue.model.catalogue import Catalogue
    from sigcat.function.function_json.resolved_function import ResolvedFunction
    from sigcat.integration.deployment import Deployment
    from sigcat.integration.fmi.settings import FmiSettings
    from sigcat.integration.report import Entry
    from sigcat.limits import Limits


def _settings() -> "type[FmiSettings]":
    from sigcat.integration.fmi.settings import FmiSettings

    return FmiSettings


def _derive(functions: "Sequence[ResolvedFunction]", deployment: "Deployment", settings: "FmiSettings") -> Integrated:
    from sigcat.adapter.fmi.fmi_integration import derive
    from sigcat.function.function_json.wire import written

    model, findings, report = derive(functions, deployment, settings)
    return Integrated(written(model), findings, report)


def _with_files(deployment: "Deployment", folder: "Path", environment: "Mapping[str, str]") -> "Deployment":
    del environment
    settings: FmiSettings = deployment.fmi  # type: ignore[attr-defined]
    return deployment.model_copy(update={"fmi": settings.in_folder(folder)})


def _with_catalogue(deployment: "Deployment", catalogue: "Catalogue", dbc: "Sequence[Path]") -> "Deployment":
    from sigcat.integration.fmi.network import read_network

    settings: FmiSettings = deployment.fmi  # type: ignore[attr-defined]
    if settings.bus is None:
        return deployment
    network = read_network(settings.bus.dbc or tuple(map(str, dbc)), catalogue, deployment)
    return deployment.model_copy(update={"fmi": settings.model_copy().with_network(network)})


def _schema() -> dict[str, Any]:
    from sigcat.function.function_json.wire import document_schema
    from sigcat.integration.fmi.model import FmiIntegration

    return document_schema(FmiIntegration)


def _generate(data: bytes, name: str, limits: "Limits", options: Options) -> "tuple[GeneratedFile, ...]":
    from sigcat.adapter.fmi.fmu_files import generate

    del options  # the document has the version of FMI, and an FMU needs no bench
    return generate(data, name, limits)


def _report(data: bytes, name: str, limits: "Limits") -> "tuple[Entry, ...]":
    from sigcat.adapter.fmi.fmu_files import report

    return report(data, name, limits)


FMUS = Generator(
    name="fmi",
    title="FMUs",
    target="FMI 3.0 or 2.0",
    contents="model descriptions, sources, documentation, and a CMake project that packs them",
    media_type="text/plain",
    report=_report,
    generate=_generate,
    view="fmus",
)
FMI = Platform(
    "fmi", "FMI", _settings, _derive, _schema, (FMUS,), with_files=_with_files, with_catalogue=_with_catalogue
)
