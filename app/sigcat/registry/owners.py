"""Names of owners: two that look alike would be two teams, of which people see one."""

import unicodedata

from sqlalchemy import Connection, bindparam, select

from sigcat.findings import shown
from sigcat.registry.storing.tables import VERSIONS

_CYRILLIC = "\u0410\u0412\u0415\u041a\u041c\u041d\u041e\u0420\u0421\u0422\u0423\u0425\u0405\u0406\u0408\u0430\u0435\u043a\u043e\u0440\u0441\u0443\u0445\u0455\u0456\u0458"
_GREEK = "\u0391\u0392\u0395\u0396\u0397\u0399\u039a\u039c\u039d\u039f\u03a1\u03a4\u03a5\u03a7\u03b1\u03b9\u03ba\u03bd\u03bf\u03c1\u03c5\u03c7"
_DOTLESS = "\u0131"
_LATIN = str.maketrans(_CYRILLIC + _GREEK + _DOTLESS, "ABEKMHOPCTYXSIJaekopcyxsijABEZHIKMNOPTYXaikvopuxi")
"""Letters of other scripts that look like Latin ones."""
_FILLERS = "\u115f\u1160\u3164\uffa0"
"""Letters without a form."""
_PUBLISHED = select(VERSIONS.c.owner).where(VERSIONS.c.owner == bindparam("of_owner")).limit(1)
_OWNERS = select(VERSIONS.c.owner).distinct().order_by(VERSIONS.c.owner)


def alike_problem(connection: Connection, owner: str) -> str:
    """Return how an owner must be written that looks like a published one; empty if none does, or it is that one."""
    if connection.execute(_PUBLISHED, {"of_owner": owner}).first() is not None:
        return ""
    appearance = _appearance(owner)
    known = connection.execute(_OWNERS).scalars()
    alike = next((each for each in known if _appearance(each) == appearance), "")
    return f"The owner must be {shown(alike)}, as it is published, not {owner[:100]!a}." if alike else ""


def _appearance(name: str) -> str:
    """A name without what readers do not see: script, case, width, spaces, kinds of dashes, and what has no form."""
    visible = "".join(map(_visible, unicodedata.normalize("NFKC", name)))
    return " ".join(visible.translate(_LATIN).casefold().split())


def _visible(character: str) -> str:
    category = unicodedata.category(character)
    if category == "Pd" or character == "\N{MINUS SIGN}":
        return "-"
    return "" if category == "Cf" or character in _FILLERS else character
