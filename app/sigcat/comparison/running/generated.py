"""Files that are generated for a platform, and written where they are built."""

import time
from typing import NamedTuple

from sigcat.adapter.files import GeneratedFile
from sigcat.comparison.running.runner import Subject
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.integrate import integrate
from sigcat.platforms.platform import Options
from sigcat.platforms.table import PLATFORMS


class Generated(NamedTuple):
    """Files generated for a set of functions."""

    integration: bytes
    """The Integration JSON."""
    files: tuple[GeneratedFile, ...]
    seconds: float


def generated(subject: Subject, platform: str, *, bench: bool = False) -> Generated:
    """Everything that the generator of applications of a platform makes. Raises InputRefused."""
    begin = time.monotonic()
    one = PLATFORMS[platform]
    document = integrate(one, subject.functions, subject.deployment).document
    generator = next(each for each in one.generators if each.name == platform)
    files = generator.generate(document, f"{platform}.json", DEFAULT_LIMITS, Options(bench=bench))
    return Generated(document, files, time.monotonic() - begin)
