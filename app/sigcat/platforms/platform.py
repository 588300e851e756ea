"""Parts of a platform: its section of the deployment file, its Integration JSON, and its generators."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from sigcat.adapter.files import GeneratedFile
    from sigcat.catalogue.model.catalogue import Catalogue
    from sigcat.findings import Finding
    from sigcat.function.declaration.form import DeclarationModel
    from sigcat.function.function_json.resolved_function import ResolvedFunction
    from sigcat.integration.deployment import Deployment
    from sigcat.integration.report import Entry
    from sigcat.limits import Limits


class Integrated(NamedTuple):
    """An Integration JSON, the findings about it, and where each field of each interface went."""

    document: bytes
    findings: "tuple[Finding, ...]"
    report: "tuple[Entry, ...]"


class Options(NamedTuple):
    """Request to a generator."""

    release: str | None = None
    """Release of the platform; for None the default of the generator."""
    bench: bool = False
    """Whether to add what runs the files without the platform."""


class Generator(NamedTuple):
    """One kind of files that are generated from the Integration JSON of a platform."""

    name: str
    """In commands and addresses: `arxml`. No other platform has a generator of this name."""
    title: str
    """In headings: `ARXML`."""
    target: str
    """For what: `AUTOSAR adaptive`."""
    contents: str
    """Content of the files, for help texts."""
    media_type: str
    report: "Callable[[bytes, str, Limits], tuple[Entry, ...]]"
    """Returns the target of each field of an Integration JSON. Raises InputRefused if it cannot be used."""
    generate: "Callable[[bytes, str, Limits, Options], tuple[GeneratedFile, ...]]"
    """The files, from the bytes and the name of an Integration JSON. Raises InputRefused if it cannot be used."""
    releases: tuple[str, ...] = ()
    """Releases of the platform that it can be asked for."""
    default_release: str = ""
    """The one that it takes if none is asked for; if empty that of the Integration JSON."""
    release_word: str = "release"
    """The platform's word for releases: `release`, or `distribution`."""
    has_bench: bool = False
    """Whether it can add what runs the files without the platform."""
    view: str = ""
    """Name of its view of a function, where its own name is that of another one."""


class Platform(NamedTuple):
    """One platform. Its functions import what they need when they are called, so that names and titles cost nothing."""

    name: str
    """In commands, addresses and file names: `ros2`."""
    title: str
    """In sentences: `ROS 2`."""
    settings: "Callable[[], type[DeclarationModel]]"
    """The model of its section of the deployment file."""
    derive: "Callable[[Sequence[ResolvedFunction], Deployment, Any], Integrated]"
    """The Integration JSON of a set of functions and its report, with what the deployment says for all platforms and
    for this one."""
    schema: Callable[[], dict[str, Any]]
    """JSON Schema of its Integration JSON."""
    generators: tuple[Generator, ...] = ()
    with_identifiers: "Callable[[Deployment, Sequence[tuple[bytes, str]], Limits], Deployment] | None" = None
    """A deployment with the ids of files, given as content and name; None if the platform has no ids. Raises
    InputRefused if a file cannot be used."""

    with_previous: "Callable[[Integrated, tuple[bytes, str], Deployment, Limits], Integrated] | None" = None
    """An integration with the versions that follow from the previous Integration JSON, given as content and name; None
    if the platform has no versions. Raises InputRefused if that document cannot be used."""

    with_files: "Callable[[Deployment, Path, Mapping[str, str]], Deployment] | None" = None
    """A deployment with the files of this machine that it names, relative to the folder of its file, given an
    environment; None if the platform names none."""

    with_catalogue: "Callable[[Deployment, Catalogue, Sequence[Path]], Deployment] | None" = None
    """A deployment with what it needs of a catalogue of this machine; None if the platform needs nothing. Raises InputRefused."""

    @property
    def section(self) -> str:
        """Name of its section among the fields of a deployment."""
        return self.name.replace("-", "_")
