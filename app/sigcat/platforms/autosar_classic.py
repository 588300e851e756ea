"""AUTOSAR Classic, as the table of platforms has it."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from sigcat.integration.autosar_classic.deployment.releases import RELEASES
from sigcat.platforms.platform import Generator, Integrated, Options, Platform

if TYPE_CHECKING:
    from sigcat.adapter.files import GeneratedFile
    from sigcat.function.function_json.resolved_function import ResolvedFunction
    from sigcat.integration.autosar_classic.deployment.settings import AutosarClassicSettings
    from sigcat.integration.deployment import Deployment
    from sigcat.integration.report import Entry
    from sigcat.limits import Limits


def _settings() -> "type[AutosarClassicSettings]":
    from sigcat.integration.autosar_classic.deployment.settings import AutosarClassicSettings

    return AutosarClassicSettings


def _derive(
    functions: "Sequence[ResolvedFunction]", deployment: "Deployment", settings: "AutosarClassicSettings"
) -> Integrated:
    from sigcat.function.function_json.wire import written
    from sigcat.integration.autosar_classic.classic_integration import derive

    model, findings, report = derive(functions, deployment, settings)
    return Integrated(written(model), findings, report)


def _schema() -> dict[str, Any]:
    from sigcat.function.function_json.wire import document_schema
    from sigcat.integration.autosar_classic.model import ClassicIntegration

    return document_schema(ClassicIntegration)


def _generate_arxml(data: bytes, name: str, limits: "Limits", options: Options) -> "tuple[GeneratedFile, ...]":
    from sigcat.adapter.autosar_classic.arxml.classic_arxml import generate
    from sigcat.integration.autosar_classic.document import read_integration

    return generate(read_integration(data, name, limits), options.release)


def _report_of_arxml(data: bytes, name: str, limits: "Limits") -> "tuple[Entry, ...]":
    from sigcat.adapter.autosar_classic.arxml.field_targets import field_targets
    from sigcat.integration.autosar_classic.document import read_integration

    return field_targets(read_integration(data, name, limits))


ARXML = Generator(
    name="classic-arxml",
    title="ARXML",
    target="AUTOSAR Classic",
    contents="types, interfaces, components, composition, ECU extract, diagnosis and configuration",
    media_type="application/xml",
    report=_report_of_arxml,
    generate=_generate_arxml,
    releases=RELEASES,
)


def _generate_components(data: bytes, name: str, limits: "Limits", options: Options) -> "tuple[GeneratedFile, ...]":
    from sigcat.adapter.autosar_classic.classic_software import generate

    return generate(data, name, limits, options.release, bench=options.bench)


def _report_of_components(data: bytes, name: str, limits: "Limits") -> "tuple[Entry, ...]":
    from sigcat.adapter.autosar_classic.report import report

    return report(data, name, limits)


COMPONENTS = Generator(
    name="autosar-classic",
    title="Software components in C",
    target="AUTOSAR Classic",
    contents="ARXML, the core of each adapter, and the software components around them",
    media_type="text/plain",
    report=_report_of_components,
    generate=_generate_components,
    releases=RELEASES,
    has_bench=True,
    view="components",
)
AUTOSAR_CLASSIC = Platform("autosar-classic", "AUTOSAR Classic", _settings, _derive, _schema, (ARXML, COMPONENTS))
