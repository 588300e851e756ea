"""Names of owners: two that look alike would be two teams, of which people see one."""

import unicodedata

from sqlalchemy import Connection, bindparam, select

from sigcat.findings import shown
from sigcat.registry.look_alikes import LOOK_ALIKES
from sigcat.registry.storing.tables import VERSIONS

_LATIN = {ord(letter): latin for latin, letters in LOOK_ALIKES.items() for letter in letters}
_FILLERS = "\u115f\u1160\u3164\uffa0"
"""Letters without a form."""
_PUBLISHED = select(VERSIONS.c.owner).where(VERSIONS.c.owner == bindparam("of_owner")).limit(1)
_OWNERS = select(VERSIONS.c.owner).distinct().order_by(VERSIONS.c.owner)


def alike_problem(connection: Connection, owner: str) -> str:
    """Return how an owner must be written that looks like a published one; empty if none does, or it is that one."""
    if connection.execute(_PUBLISHED, {"of_owner": owner}).first() is not None:
        return ""
    appearance = _appearance(owner)
    alike = next((each for each in owners(connection) if _appearance(each) == appearance), "")
    published = shown(alike) if alike.translate(_LATIN) == alike else ascii(alike[:100])
    return f"The owner must be {published}, as it is published, not {owner[:100]!a}." if alike else ""


def owners(connection: Connection) -> tuple[str, ...]:
    """Owners of published versions, in order."""
    return tuple(connection.execute(_OWNERS).scalars())


def _appearance(name: str) -> str:
    """A name without what readers do not see: script, case, width, spaces, kinds of dashes, and what has no form."""
    visible = "".join(map(_visible, unicodedata.normalize("NFKC", name)))
    return " ".join(visible.translate(_LATIN).casefold().split())


def _visible(character: str) -> str:
    category = unicodedata.category(character)
    if category == "Pd" or character == "\N{MINUS SIGN}":
        return "-"
    return "" if category == "Cf" or character in _FILLERS else character
