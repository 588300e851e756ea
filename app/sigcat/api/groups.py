"""Groups of people who sign in by OpenID Connect: what each may do in the registry."""

import re
from typing import NamedTuple

from sigcat.names import either

SCOPES = ("read", "publish", "approve", "administer")
_WRITTEN = re.compile(r"([^:]{1,200}):([a-z+]+)(?::([^:]{1,200}))?")


class Group(NamedTuple):
    """A group of the provider."""

    name: str
    scopes: str
    """Separated by `+`, as tokens have them."""
    owner: str
    """Team whose functions its people may change; empty: all."""

    def __str__(self) -> str:
        return ":".join(filter(None, self))


def group_from_text(text: str) -> Group:
    """The group that a setting describes. Raises ValueError."""
    match = _WRITTEN.fullmatch(text)
    if match is None:
        raise ValueError(f"a group must be GROUP:SCOPE+SCOPE:TEAM, not {text[:100]!r}")
    if unknown := set(match[2].split("+")) - set(SCOPES):
        raise ValueError(f"a scope must be {either(SCOPES)}, not {min(unknown)[:80]!r}")
    return Group(match[1].strip(), match[2], (match[3] or "").strip())
