"""Names of findings and files for build servers: the same on every machine and after a node has moved."""

import hashlib
from collections.abc import Iterable, Iterator
from pathlib import Path, PurePath

from sigcat.findings import Finding
from sigcat.real_path import real_path


def fingerprinted(findings: Iterable[Finding]) -> Iterator[tuple[Finding, str]]:
    """Findings with a fingerprint of rule and node path (or file, if no node is concerned), each one unique."""
    seen: dict[str, int] = {}
    for finding in findings:
        key = f"{finding.rule}\0{finding.path or relative(finding.file)}"
        number = seen.get(key, 0)
        seen[key] = number + 1
        yield finding, hashlib.sha256(f"{key}\0{number}".encode("utf-8", "surrogatepass")).hexdigest()


def relative(file: str) -> str:
    """A file's name relative to the working folder, with forward slashes; unchanged if it lies elsewhere."""
    try:
        return real_path(Path(file)).relative_to(Path.cwd()).as_posix()
    except ValueError:
        return PurePath(file).as_posix()
