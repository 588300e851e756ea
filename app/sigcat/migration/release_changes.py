"""Changes of the name of a release: in the project file, and in files of pipelines."""

import re
from collections.abc import Iterator

from sigcat import codes
from sigcat.function.importing.yaml_edits import Edit
from sigcat.migration.changed_text import Outcome, Replacement

_SETTING = r"""^[ \t]*(?:release|tree)[ \t]*=[ \t]*(["'])(?P<name>{})\1"""
_WORD = r"(?<![\w.@/+-]){}(?![\w.-])"
_OWN = re.compile(r"\bsigcat\b")
_OF_VSS = re.compile(r"vss\b|vehicle_signal_specification", re.IGNORECASE)


def project_changes(text: str, old: str, new: str) -> Iterator[Outcome]:
    """Yield the changes of a `sigcat.toml` or `pyproject.toml`: the release of catalogues and of the linter."""
    for match in re.finditer(_SETTING.format(re.escape(old)), text, re.MULTILINE):
        line = text.count("\n", 0, match.start()) + 1
        yield Replacement(Edit(match.start("name"), match.end("name"), new), line, f"release {old} → {new}")


def pipeline_changes(file: str, text: str, old: str, new: str, *, accepts_guesses: bool) -> Iterator[Outcome]:
    """Yield the changes of lines that call sigcat with the old release. Other lines about VSS are guesses."""
    start = 0
    for number, line in enumerate(text.splitlines(keepends=True), 1):
        for match in re.finditer(_WORD.format(re.escape(old)), line):
            if _OWN.search(line) or (accepts_guesses and _OF_VSS.search(line)):
                edit = Edit(start + match.start(), start + match.end(), new)
                yield Replacement(edit, number, f"release {old} → {new}")
            elif _OF_VSS.search(line):
                message = f"The line names {old} of VSS, and no command of sigcat."
                yield codes.RELEASE_MENTIONED.finding(
                    message, file, number, match.start() + 1, fix=f"Write {new}, or pass --accept-guesses."
                )
        start += len(line)
