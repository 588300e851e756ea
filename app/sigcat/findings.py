"""The one finding type: the error, its place, and the fix."""

import datetime as dt
from collections.abc import Collection, Iterable
from itertools import islice
from typing import Any, Literal, NamedTuple

from sigcat.terminal_text import printable

Severity = Literal["error", "warning", "info"]

SEVERITIES: tuple[Severity, ...] = ("error", "warning", "info")


class Finding(NamedTuple):
    """One problem at one position.

    Lines and columns count from 1; 0 means that the finding concerns the file as a whole.
    """

    rule: str
    severity: Severity
    message: str
    file: str = ""
    line: int = 0
    column: int = 0
    path: str = ""
    """Path of the VSS node or name of the interface that the finding is about."""
    pointer: str = ""
    """RFC 6901 pointer into a JSON or YAML document, where the input is one."""
    fix: str = ""
    """The fix, as an instruction; empty if the message already says it."""

    @property
    def sort_key(self) -> tuple[str, int, int, str, str]:
        """Findings are reported in the order in which a reader meets them."""
        return (self.file, self.line, self.column, self.rule, self.message)

    @property
    def line_of_text(self) -> str:
        """One line for a terminal: `file:line:column: severity RULE message`, which editors and build logs make clickable."""
        position = ":".join(str(part) for part in (self.file, self.line or "", self.column or "") if part)
        advice = f" {self.fix}" if self.fix else ""
        return printable(f"{position}: {self.severity} {self.rule} {self.message}{advice}".removeprefix(": "))


class RuleCode(NamedTuple):
    """A rule that code finds broken, and how severe that is; `sigcat.codes` has them all by name."""

    id: str
    severity: Severity

    def graded(self, severity: Severity) -> "RuleCode":
        """The rule where breaking it is more or less severe than elsewhere; the caller says why in a comment."""
        return self._replace(severity=severity)

    def finding(
        self,
        message: str,
        file: str = "",
        line: int = 0,
        column: int = 0,
        path: str = "",
        pointer: str = "",
        fix: str = "",
    ) -> Finding:
        """A finding of this rule."""
        return Finding(self.id, self.severity, message, file, line, column, path, pointer, fix)


def has_errors(findings: "tuple[Finding, ...] | list[Finding]") -> bool:
    """Whether any finding is an error."""
    return any(finding.severity == "error" for finding in findings)


def in_order(
    findings: Iterable[Finding], causes: Collection[str] = (), consequences: Collection[str] = ()
) -> tuple[Finding, ...]:
    """Findings by file, line and column, each once.

    Those in files `causes` come first: others follow from them. Those in files `consequences` come last.
    """

    def place(finding: Finding) -> tuple[bool, bool, tuple[str, int, int, str, str]]:
        return (finding.file not in causes, finding.file in consequences, finding.sort_key)

    return tuple(sorted(dict.fromkeys(findings), key=place))


def first_at(file: str, line: int) -> str:
    """The first place of something that is given twice, as messages name it."""
    return f"first at {file}:{line}"


_LONGEST = 60
"""Characters of a value in a message; of a list, as many items are more than enough."""


def shown(value: Any) -> str:
    """A value as messages show it: cut where it is long, and a date as it is written."""
    text = _written(value)
    if len(text) <= _LONGEST:
        return text
    quote = text[-1] if isinstance(value, str) else ""
    return f"{text[: _LONGEST - 3 - len(quote)]}...{quote}"


def _written(value: Any) -> str:
    if isinstance(value, list):
        return f"[{', '.join(map(_written, value[:_LONGEST]))}]"
    if isinstance(value, dict):
        return f"{{{', '.join(f'{_written(key)}: {_written(item)}' for key, item in islice(value.items(), _LONGEST))}}}"
    return value.isoformat() if isinstance(value, dt.date) else repr(value)
