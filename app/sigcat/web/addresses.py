"""Addresses of pages."""

from collections.abc import Iterable, Mapping, Sequence
from urllib.parse import quote, urlencode

from sigcat.web.basket import EMPTY, PICK, Basket

_OF_ONE_CATALOGUE = ("cursor", "part", "change", "below")
"""Parameters that mean something in one catalogue only."""
_IN_QUERY = {
    "functions": "catalogue",
    "wiring": "catalogue",
    "try": "catalogue",
    "rules": "catalogue",
    "changes": "new",
    "compare": "catalogue",
    "propose": "catalogue",
}
"""Pages whose catalogue is named in the query, by the first part of their address."""


class Addresses:
    """Builds addresses below the path under which the service is mounted."""

    def __init__(self, base: str, basket: Basket = EMPTY) -> None:
        self.base = base.rstrip("/")
        self.basket = basket
        """The basket that addresses of trees and searches carry."""

    def static(self, name: str) -> str:
        """A file that comes with the pages."""
        return f"{self.base}/static/{name}"

    def page(self, *parts: str) -> str:
        """A page by the parts of its address."""
        return "/".join((self.base, *(quote(part, safe="") for part in parts)))

    def chapter(self, name: str) -> str:
        """A chapter of the documentation by the path of its file."""
        return f"{self.base}/docs/{quote(name)}"

    def query(self, given: Mapping[str, str | Sequence[str]]) -> str:
        """A query of the values that are not empty, with its question mark; empty if nothing is left."""
        kept = {name: value for name, value in given.items() if value}
        return f"?{urlencode(kept, doseq=True)}" if kept else ""

    def other_catalogue(
        self, route: str, names: Mapping[str, str], query: Iterable[tuple[str, str]], catalogue: str
    ) -> str:
        """The page of a route for another catalogue, with everything else that its address says."""
        parts = route.strip("/").split("/")
        parameter = _IN_QUERY.get(parts[0], "")
        if not parameter and "{catalogue}" not in parts:
            return self.tree(catalogue)
        known = {**{f"{{{name}}}": value for name, value in names.items()}, "{catalogue}": catalogue}
        kept = [(name, value) for name, value in query if name not in (parameter, *_OF_ONE_CATALOGUE)]
        given = urlencode([*kept, (parameter, catalogue)] if parameter else kept)
        return self.page(*(known.get(part, part) for part in parts)) + (f"?{given}" if given else "")

    def tree(self, catalogue: str, path: str = "", opened: str = "", start: int = 0) -> str:
        """The tree with a node selected and branches open."""
        query = {"open": opened, "from": str(start) if start else "", PICK: self.basket.text}
        given = {name: value for name, value in query.items() if value}
        address = self.page("tree", catalogue, *([path] if path else []))
        return f"{address}?{urlencode(given, safe=',*')}" if given else address

    def search(self, catalogue: str, query: dict[str, str]) -> str:
        """Search results for a text and filters."""
        given = {name: value for name, value in {**query, PICK: self.basket.text}.items() if value}
        return f"{self.page('search', catalogue)}?{urlencode(given, safe=',')}"

    def basket_page(self, catalogue: str, *file: str) -> str:
        """The page of the basket, or a file that is made of it."""
        picked = urlencode({PICK: self.basket.text}, safe=",") if self.basket.paths else ""
        return self.page("basket", catalogue, *file) + (f"?{picked}" if picked else "")

    def toggling(self, path: str) -> "Addresses":
        """Addresses with one path more in the basket, or one less."""
        return Addresses(self.base, self.basket.toggled(path))
