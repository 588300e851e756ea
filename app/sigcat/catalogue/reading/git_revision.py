"""The trees of a git revision, unpacked into a folder."""

import contextlib
import shutil
import subprocess
import tarfile
import tempfile
from pathlib import Path, PurePosixPath
from typing import IO

from sigcat.errors import UsageError
from sigcat.file_kind import ENDINGS
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import did_you_mean, nearest

_READ = (*ENDINGS, ".toml")
"""Endings of the files that are unpacked: trees, units and project files."""
_BLOCK = 1 << 16


def unpack_revision(revision: str, folder: Path, limits: Limits = DEFAULT_LIMITS) -> str:
    """Write the trees of a revision of the repository around the current folder into `folder`.

    Links are left out. Returns the current folder as a path in the repository (`spec/`; empty at its top).
    Raises UsageError with git's own words.
    """
    _check(revision)
    prefix = _git(revision, "rev-parse", "--show-prefix")
    top = _git(revision, "rev-parse", "--show-toplevel") or "."
    commit = _object(revision, "tree")
    with tempfile.TemporaryFile() as complaints:
        command = [_program(), "-C", top, "archive", "--format=tar", commit]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=complaints) as process:  # noqa: S603 -- no shell
            assert process.stdout is not None
            with process.stdout as archive, contextlib.suppress(tarfile.TarError):  # git explains the error better
                _unpack(archive, folder, limits)
                while archive.read(_BLOCK):  # the padding behind the end: git must not find the pipe closed
                    pass
            status = process.wait()
        if status:
            complaints.seek(0)
            raise UsageError(_first_line(complaints.read().decode(errors="replace"), revision))
    return prefix


_SHALLOW = (
    "A shallow clone lacks the history: "
    "fetch it whole (`git fetch --unshallow`; fetch-depth: 0 on GitHub, GIT_DEPTH: 0 on GitLab)"
)


def merge_base(revision: str, other: str = "HEAD") -> str:
    """Return the commit from which two revisions began to differ. Raises UsageError."""
    for each in (revision, other):
        _check(each)
        _object(each, "commit")
    found = subprocess.run(  # noqa: S603 -- no shell
        [_program(), "merge-base", "--end-of-options", revision, other], capture_output=True, check=False
    )
    if found.returncode:
        advice = f" {_SHALLOW}." if _is_shallow(revision) else ""
        raise UsageError(f"git:{revision}: it has no commit in common with {other}.{advice}")
    return found.stdout.decode().strip()


def _object(revision: str, kind: str) -> str:
    """Return the name of the tree or commit of a revision. Raises UsageError with branches and tags that may be meant."""
    repository = _git(revision, "rev-parse", "--absolute-git-dir")
    command = [_program(), "rev-parse", "--quiet", "--verify", "--end-of-options", f"{revision}^{{{kind}}}"]
    found = subprocess.run(command, capture_output=True, check=False)  # noqa: S603 -- no shell
    if found.returncode:
        names = _names(revision)
        if _is_shallow(revision):
            advice = f"{_SHALLOW}."
        elif names:
            advice = did_you_mean(revision, names) or "`git branch --all` and `git tag` list what there is."
        else:
            advice = "It has no commit yet."
        raise UsageError(f"git:{revision}: {repository} has no such branch, tag or commit. {advice}")
    return found.stdout.decode().strip()


def is_revision(name: str) -> bool:
    """Whether the repository around the current folder, if there is one, has a revision of this name."""
    program = shutil.which("git")
    if program is None or not name or name.startswith("-"):
        return False
    command = [program, "rev-parse", "--quiet", "--verify", "--end-of-options", f"{name}^{{tree}}"]
    return not subprocess.run(command, capture_output=True, check=False).returncode  # noqa: S603 -- no shell


def _is_shallow(revision: str) -> bool:
    """Whether the history of the repository was cut."""
    return _git(revision, "rev-parse", "--is-shallow-repository") == "true"


def _names(revision: str) -> list[str]:
    """Names of branches and tags. Raises UsageError, which names the revision, outside of a repository."""
    return _git(revision, "for-each-ref", "--format=%(refname:short)").split()


def near_revisions(name: str) -> tuple[str, ...]:
    """Return branches and tags with names near one; none outside of a repository."""
    try:
        return nearest(name, _names(name))
    except UsageError:
        return ()


def commit_date(revision: str) -> str:
    """Return the day of a commit, such as `2026-05-17`. Raises UsageError."""
    _check(revision)
    return _git(revision, "log", "-1", "--format=%cs", "--end-of-options", revision)


def last_tag() -> str:
    """Return the last tag before the current commit. Raises UsageError."""
    try:
        return _git("HEAD", "describe", "--tags", "--abbrev=0")
    except UsageError:
        raise UsageError("no tag found before the current commit; name the old side") from None


def _check(revision: str) -> None:
    if not revision or revision.startswith("-"):
        raise UsageError(f"git:{revision}: name a revision, such as git:HEAD or git:v1.2:spec")


def _program() -> str:
    program = shutil.which("git")
    if program is None:
        raise UsageError("git is not installed; it is needed for git:REVISION")
    return program


def _git(revision: str, *arguments: str) -> str:
    """Return the output of a command that a revision needs. Raises UsageError with git's own words."""
    result = subprocess.run([_program(), *arguments], capture_output=True, check=False)  # noqa: S603 -- no shell
    if result.returncode:
        raise UsageError(_first_line(result.stderr.decode(errors="replace"), revision))
    return result.stdout.decode(errors="replace").strip()


def _first_line(complaint: str, revision: str) -> str:
    first = next((line for line in complaint.splitlines() if line.strip()), "git failed")
    return f"git:{revision}: {first.removeprefix('fatal: ')}"


def _unpack(archive: IO[bytes], folder: Path, limits: Limits) -> None:
    count = 0
    with tarfile.open(fileobj=archive, mode="r|") as tar:
        for member in tar:
            path = PurePosixPath(member.name)
            if not member.isfile() or path.suffix.lower() not in _READ or path.is_absolute() or ".." in path.parts:
                continue
            count += 1
            if count > limits.files or member.size > limits.file_bytes:
                raise UsageError(f"{member.name}: the revision has more or larger files than are read")
            content = tar.extractfile(member)
            assert content is not None
            target = folder / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content.read())
