"""AUTOSAR adaptive, as the table of platforms has it."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from sigcat.integration.autosar_adaptive.deployment.releases import RELEASES, SOURCE_RELEASES
from sigcat.platforms.platform import Generator, Integrated, Options, Platform

if TYPE_CHECKING:
    from sigcat.adapter.files import GeneratedFile
    from sigcat.function.function_json.resolved_function import ResolvedFunction
    from sigcat.integration.autosar_adaptive.deployment.settings import AutosarAdaptiveSettings
    from sigcat.integration.deployment import Deployment
    from sigcat.integration.report import Entry
    from sigcat.limits import Limits


def _settings() -> "type[AutosarAdaptiveSettings]":
    from sigcat.integration.autosar_adaptive.deployment.settings import AutosarAdaptiveSettings

    return AutosarAdaptiveSettings


def _derive(
    functions: "Sequence[ResolvedFunction]", deployment: "Deployment", settings: "AutosarAdaptiveSettings"
) -> Integrated:
    from sigcat.function.function_json.wire import written
    from sigcat.integration.autosar_adaptive.adaptive_integration import derive

    model, findings, report = derive(functions, deployment, settings)
    return Integrated(written(model), findings, report)


def _schema() -> dict[str, Any]:
    from sigcat.function.function_json.wire import document_schema
    from sigcat.integration.autosar_adaptive.model import IntegrationModel

    return document_schema(IntegrationModel)


def _generate_arxml(data: bytes, name: str, limits: "Limits", options: Options) -> "tuple[GeneratedFile, ...]":
    from sigcat.adapter.autosar_adaptive.arxml.adaptive_arxml import generate
    from sigcat.integration.autosar_adaptive.document import read_integration

    return generate(read_integration(data, name, limits), options.release)


def _generate_application(data: bytes, name: str, limits: "Limits", options: Options) -> "tuple[GeneratedFile, ...]":
    from sigcat.adapter.autosar_adaptive.application.adaptive_application import generate

    return generate(data, name, limits, options.release, bench=options.bench)


def _report_of_application(data: bytes, name: str, limits: "Limits") -> "tuple[Entry, ...]":
    from sigcat.adapter.autosar_adaptive.application.report import report

    return report(data, name, limits)


def _with_identifiers(deployment: "Deployment", files: "Sequence[tuple[bytes, str]]", limits: "Limits") -> "Deployment":
    from sigcat.adapter.autosar_adaptive.arxml.reading import read_arxml
    from sigcat.integration.autosar_adaptive.someip.id_catalogue import merged, read_csv

    read = [
        (read_arxml if data.lstrip(b"\xef\xbb\xbf \r\n\t")[:1] == b"<" else read_csv)(data, name, limits)
        for data, name in files
    ]
    settings: AutosarAdaptiveSettings = deployment.autosar_adaptive  # type: ignore[attr-defined]
    ids = merged([settings.identifier_catalogue, *read], ["the deployment file", *(name for _, name in files)])
    return deployment.model_copy(update={"autosar_adaptive": settings.model_copy(update={"identifier_catalogue": ids})})


def _with_previous(
    integrated: Integrated, previous: tuple[bytes, str], deployment: "Deployment", limits: "Limits"
) -> Integrated:
    from sigcat.function.function_json.wire import written
    from sigcat.integration.autosar_adaptive.document import read_integration
    from sigcat.integration.autosar_adaptive.model import IntegrationModel
    from sigcat.integration.autosar_adaptive.someip.versions import raised

    settings: AutosarAdaptiveSettings = deployment.autosar_adaptive  # type: ignore[attr-defined]
    model = IntegrationModel.model_validate_json(integrated.document)
    made = raised(model, read_integration(*previous, limits), settings.versions)
    return integrated._replace(document=written(made.model), findings=(*integrated.findings, *made.findings))


def _report_of_arxml(data: bytes, name: str, limits: "Limits") -> "tuple[Entry, ...]":
    from sigcat.adapter.autosar_adaptive.arxml.field_targets import field_targets
    from sigcat.integration.autosar_adaptive.document import read_integration

    return field_targets(read_integration(data, name, limits))


ARXML = Generator(
    name="arxml",
    title="ARXML",
    target="AUTOSAR adaptive",
    contents="types, interfaces, components and deployment",
    media_type="application/xml",
    report=_report_of_arxml,
    generate=_generate_arxml,
    releases=RELEASES,
)
APPLICATION = Generator(
    name="autosar-adaptive",
    title="Application in C++",
    target="AUTOSAR adaptive",
    contents="ARXML, the core of each adapter, and the applications whole",
    media_type="text/plain",
    report=_report_of_application,
    generate=_generate_application,
    releases=SOURCE_RELEASES,
    has_bench=True,
    view="application",
)
AUTOSAR_ADAPTIVE = Platform(
    "autosar-adaptive",
    "AUTOSAR adaptive",
    _settings,
    _derive,
    _schema,
    (ARXML, APPLICATION),
    _with_identifiers,
    _with_previous,
)
