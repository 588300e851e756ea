"""Published names, and references such as `CoreAcc@1.2.0`."""

import datetime as dt
import re
from collections.abc import Iterable, Mapping
from typing import Literal, NamedTuple, get_args

from sigcat import codes
from sigcat.errors import InputRefused, RegistryUnusable
from sigcat.findings import Finding, shown
from sigcat.names import did_you_mean

Kind = Literal["function", "overlay", "catalogue", "line"]
KINDS: tuple[Kind, ...] = get_args(Kind)
Group = Literal["functions", "overlays", "catalogues"]
GROUP_OF: Mapping[Kind, Group] = {"function": "functions", "overlay": "overlays", "catalogue": "catalogues"}
KIND_OF: Mapping[str, Kind] = {group: kind for kind, group in GROUP_OF.items()}
State = Literal["draft", "pending", "published", "deprecated", "retired"]
STATES: tuple[State, ...] = get_args(State)
Rule = Literal["backward", "full", "approval", "none"]
RULES: tuple[Rule, ...] = get_args(Rule)
DEPLOYABLE: frozenset[State] = frozenset(("published", "deprecated"))
CHANGEABLE: frozenset[State] = frozenset(("draft", "pending"))
"""States in which a version may get other content."""

UNCHANGED = "nothing was changed in the registry"
NO_ANSWER = "the registry has no answer"
_DATE = re.compile(r"\d{4}-\d{2}-\d{2}", re.ASCII)
_LONGEST = 100
"""Characters of a name."""
_NAME = re.compile(rf"[A-Za-z0-9][A-Za-z0-9._-]{{0,{_LONGEST - 1}}}", re.ASCII)
_LETTERS = re.compile(r"[A-Za-z0-9._-]+", re.ASCII)
_ARTICLES: Mapping[Kind, str] = {
    "function": "a function", "overlay": "an overlay", "catalogue": "a catalogue", "line": "a vehicle line",
}  # fmt: skip
_RENAME: Mapping[Kind, str] = {
    "function": "Rename the function in its file.", "overlay": "Rename the file: an overlay has the name of its file.",
    "catalogue": "Change `id` of its [[catalogue]] in sigcat.toml.", "line": "Use a name such as SUV-2025.",
}  # fmt: skip


class Reference(NamedTuple):
    """A version of a name."""

    name: str
    version: str

    def __str__(self) -> str:
        return f"{self.name} {self.version}"


def name_problem(name: str, kind: Kind) -> Finding | None:
    """Return why a name cannot be published; None if it can."""
    if _NAME.fullmatch(name):
        return None
    if not _LETTERS.fullmatch(name):
        requirement = "have only letters and digits of ASCII, '.', '_' and '-'"
    elif len(name) > _LONGEST:
        requirement = f"have at most {_LONGEST} characters"
    else:
        requirement = "begin with a letter or a digit"
    return codes.PUBLISHED_NAME_UNFIT.finding(
        f"The name of {_ARTICLES[kind]} must {requirement}, not {shown(name)}.", fix=_RENAME[kind]
    )


def reference_of(text: str) -> Reference:
    """Return the reference that a command names. Raises InputRefused."""
    name, sign, version = text.partition("@")
    if not (sign and name and version):
        message = f"A version must be named as NAME@VERSION, not {shown(text)}."
        raise refused(codes.NOT_PUBLISHED.finding(message, fix="Write it such as CoreAcc@1.2.0."))
    return Reference(name, version)


def unknown(kind: str, name: str, known: Iterable[str]) -> InputRefused:
    """The refusal of a name that is not in the registry, with near ones."""
    message = f"The registry has no {kind} {shown(name)}."
    return refused(codes.NOT_PUBLISHED.finding(message, path=name, fix=did_you_mean(name, known)))


def unusable(finding: Finding, *, is_full: bool = False) -> RegistryUnusable:
    """The failure of a database, which changed nothing."""
    return RegistryUnusable(UNCHANGED, (finding,), is_full=is_full)


def refused(*findings: Finding) -> InputRefused:
    """The refusal of a command for these findings; nothing was changed."""
    return InputRefused(UNCHANGED, findings)


def date_fault(text: str) -> str:
    """Return the fault of a date such as 2027-01-31; empty if it has none."""
    if not _DATE.fullmatch(text):
        return f"must be written as 2027-01-31, not {text[:40]!r}"
    try:
        dt.date.fromisoformat(text)
    except ValueError:
        return f"must be a day that exists, not {text}"
    return ""
