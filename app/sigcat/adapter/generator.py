"""What generates the files of a platform from its Integration JSON."""

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from sigcat.adapter.files import GeneratedFile
from sigcat.integration.platform import Platform

if TYPE_CHECKING:
    from sigcat.limits import Limits


class Generator(NamedTuple):
    """One kind of files. `generate` imports what it needs when it is called, so that names and titles cost nothing."""

    name: str
    """In commands and addresses: `arxml`."""
    title: str
    """In headings: `ARXML`."""
    platform: Platform
    """The platform whose Integration JSON it takes."""
    target: str
    """For which release of what: `AUTOSAR adaptive R23-11`."""
    contents: str
    """What the files hold, for help texts."""
    media_type: str
    generate: "Callable[[bytes, str, Limits], tuple[GeneratedFile, ...]]"
    """The files, from the bytes and the name of an Integration JSON. Raises InputRefused if it cannot be used."""
