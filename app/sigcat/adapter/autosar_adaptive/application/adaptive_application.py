"""From Integration JSON to the files of the applications."""

from collections.abc import Iterable
from pathlib import Path

from sigcat import codes
from sigcat.adapter.autosar_adaptive.application import cmake
from sigcat.adapter.autosar_adaptive.application.component.adapter import adapter_files
from sigcat.adapter.autosar_adaptive.application.component.structs_header import structs_header
from sigcat.adapter.autosar_adaptive.application.main_source import main_source
from sigcat.adapter.autosar_adaptive.application.plan import ApplicationPlan, ExecutablePlan
from sigcat.adapter.autosar_adaptive.application.planning.planned_application import derive
from sigcat.adapter.autosar_adaptive.application.player import player_source
from sigcat.adapter.autosar_adaptive.application.readme import readme
from sigcat.adapter.autosar_adaptive.arxml.adaptive_arxml import generate as generate_arxml
from sigcat.adapter.autosar_adaptive.bench.adaptive_bench import generate as generate_services
from sigcat.adapter.autosar_adaptive.bench.runtime_files import runtime_files
from sigcat.adapter.core.c.text.lines import c_file, lines
from sigcat.adapter.files import GeneratedFile, shipped, within
from sigcat.adapter.placed_findings import placed_in
from sigcat.adapter.source_cores import files_of, source_cores
from sigcat.adapter.source_functions import source_functions
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.errors import InputRefused
from sigcat.integration.autosar_adaptive.deployment.releases import DEFAULT_RELEASE, SOURCE_RELEASES
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.integration.autosar_adaptive.model import IntegrationModel
from sigcat.limits import Limits

CPP = Path(__file__).parent / "cpp"
"""Files that are the same in every application."""


@collector_paused()
def generate(
    data: bytes, name: str, limits: Limits, release: str | None, *, bench: bool = False
) -> tuple[GeneratedFile, ...]:
    """ARXML, cores and applications, and with `bench` what runs them at a desk. The same document gives the same bytes.

    Raises InputRefused if the document cannot be used, or a core cannot be generated.
    """
    model = read_integration(data, name, limits)
    _check_release(model, release)
    arxml = generate_arxml(model, release)
    rule = codes.NOT_WRITABLE_AS_ARXML
    functions = source_functions(model.functions, data, name, limits, rule, "autosar-adaptive")
    cores = source_cores(functions)
    with placed_in(data, name, limits):
        application = derive(model, cores)
    return (
        *within("arxml", arxml),
        *within("core", files_of(cores)),
        *within("application", shipped(CPP)),
        _file("CMakeLists.txt", cmake.root_cmake(application, bench=bench)),
        _file("README.md", readme(application)),
        *(file for executable in application.executables for file in _executable(executable, application)),
        *(_bench(model) if bench else ()),
    )


def _check_release(model: IntegrationModel, asked: str | None) -> None:
    """Raises InputRefused for a release whose API the sources do not use."""
    stated = model.deployment.release if model.deployment else DEFAULT_RELEASE
    release = asked or stated
    if release not in SOURCE_RELEASES:
        message = f"The sources of an application are of {' and '.join(SOURCE_RELEASES)}, not of {release}."
        fix = (
            f"State `release: {DEFAULT_RELEASE}`, or generate ARXML alone: `sigcat generate arxml --release {release}`."
        )
        finding = codes.NOT_WRITABLE_AS_ARXML.finding(message, pointer="/Deployment/Release", fix=fix)
        raise InputRefused("The applications cannot be generated.", (finding,))


@collector_paused()
def generate_player(data: bytes, name: str, limits: Limits) -> tuple[GeneratedFile, ...]:
    """The player alone, as a CMake project. Raises InputRefused if the document cannot be used."""
    return (
        *within("application", shipped(CPP)),
        _file("CMakeLists.txt", cmake.player_cmake()),
        *_bench(read_integration(data, name, limits)),
    )


def _bench(model: IntegrationModel) -> Iterable[GeneratedFile]:
    """The runtime, what a vendor's generator would make of the ARXML, and the player."""
    yield from within("bench", runtime_files())
    yield from within("generated", generate_services(model))
    yield from within("player", shipped(player_source.CPP))
    yield c_file("player/ports.cpp", lines(player_source.ports_source(model)))


def _executable(executable: ExecutablePlan, application: ApplicationPlan) -> Iterable[GeneratedFile]:
    folder = executable.name
    yield _file(f"{folder}/CMakeLists.txt", cmake.executable_cmake(executable))
    yield c_file(f"{folder}/main.cpp", lines(main_source(executable, application)))
    for component in executable.components:
        stem = f"{folder}/{component.stem}"
        header, source = adapter_files(component, application)
        yield c_file(f"{stem}_adapter.h", lines(header))
        yield c_file(f"{stem}_adapter.cpp", lines(source))
        if component.structs:
            yield c_file(f"{stem}_structs.h", lines(structs_header(component, application)))


def _file(name: str, text: str) -> GeneratedFile:
    return GeneratedFile(name, text.encode())
