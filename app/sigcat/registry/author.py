"""The author of a change of the registry, and the changes that a team may make."""

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from sigcat import codes
from sigcat.findings import Finding, shown


class Author(NamedTuple):
    """The token that a change is made with."""

    name: str = ""
    """Name in the log; empty without a token."""
    owner: str = ""
    """Team whose functions it may publish and change; empty: all."""

    @property
    def entry_data(self) -> Mapping[str, str]:
        """The author as entries of the log name it: the token `by` which a change was made, and its team."""
        return {key: value for key, value in (("by", self.name), ("team", self.owner)) if value}

    def refusals(self, name: str, owners: Iterable[str]) -> Iterator[Finding]:
        """Yield a finding for each other owner of a name."""
        for other in dict.fromkeys(owners):
            if self.owner and other != self.owner:
                whose = shown(other) if other else "no team"
                message = f"The owner of {name} must be {shown(self.owner)}, as that of the token, not {whose}."
                yield codes.OWNED_BY_ANOTHER.finding(message, path=name, fix="Use a token of the owner.")


ANYONE = Author()
