"""The packages that the service needs at run time: those of requirements.txt, as they are installed."""

import re
from importlib.metadata import metadata
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parent.parent
REQUIREMENTS = ROOT / "requirements.txt"
OURS = "sigcat"
PERMITTED = frozenset((
    "0BSD", "Apache-2.0", "BSD-2-Clause", "BSD-3-Clause", "CC0-1.0", "CNRI-Python", "MIT", "MPL-2.0", "PSF-2.0", "Zlib",
))  # fmt: skip
"""Licences, by SPDX id, under which a package may be shipped. None of them reaches over to what uses the package."""

_PINNED = re.compile(r"([a-z0-9.-]+)==(\S+)(?: ; .+)? \\")
_NEEDED_BY = re.compile(r"    #\s+(?:via )?([a-z0-9.-]+)(?: \(pyproject\.toml\))?")
_READ_FROM_THE_FILE = {
    "argcomplete": "Apache-2.0",
    "autosar-data": "MIT OR Apache-2.0",
    "case-converter": "MIT",
    "ddmodl": "MPL-2.0",
    "graphql-core": "MIT",
    "jinja2": "BSD-3-Clause",
    "markdown-it-py": "MIT",
    "mdurl": "MIT",
    "python-dateutil": "Apache-2.0 OR BSD-3-Clause",
    "protobuf": "BSD-3-Clause",
    "rich-click": "MIT",
    "uvloop": "MIT OR Apache-2.0",
    "vss-tools": "MPL-2.0",
}
"""Licences of packages whose metadata has no SPDX expression, as their licence files say."""


class Package(NamedTuple):
    """A package that is shipped, with its licence as an SPDX expression."""

    name: str
    version: str
    licence: str
    needed_by: tuple[str, ...]
    """Names of packages; `sigcat` among them if we use it ourselves."""

    @property
    def address(self) -> str:
        """The package as a purl."""
        return f"pkg:pypi/{self.name}@{self.version}"


def shipped() -> tuple[Package, ...]:
    """Every package, in the order of the names."""
    pinned: list[tuple[str, str, list[str]]] = []
    for line in REQUIREMENTS.read_text("utf-8").splitlines():
        if match := _PINNED.fullmatch(line):
            pinned.append((match[1], match[2], []))
        elif (match := _NEEDED_BY.fullmatch(line)) and match[1] != "via":
            pinned[-1][2].append(match[1])
    return tuple(Package(name, version, licence_of(name), tuple(needed_by)) for name, version, needed_by in pinned)


def licence_of(name: str) -> str:
    """The licence that an installed package names, or that its licence file was found to be."""
    told = metadata(name)
    named = next((told[field] for field in ("License-Expression", "License") if field in told), "unknown")
    return _READ_FROM_THE_FILE.get(name, named)


def licences_in(expression: str) -> frozenset[str]:
    """The SPDX ids of an expression such as `MIT AND (Zlib OR 0BSD)`."""
    return frozenset(re.findall(r"[\w.+-]+", expression)) - {"AND", "OR", "WITH"}
