"""Addresses of pages."""

from collections.abc import Mapping
from urllib.parse import quote, urlencode


class Addresses:
    """Builds addresses below the path under which the service is mounted."""

    def __init__(self, base: str) -> None:
        self.base = base.rstrip("/")

    def static(self, name: str) -> str:
        """A file that comes with the pages."""
        return f"{self.base}/static/{name}"

    def page(self, *parts: str) -> str:
        """A page by the parts of its address."""
        return "/".join((self.base, *(quote(part, safe="") for part in parts)))

    def query(self, given: Mapping[str, str]) -> str:
        """A query of what is not empty, with its question mark; empty if nothing is left."""
        kept = {name: value for name, value in given.items() if value}
        return f"?{urlencode(kept)}" if kept else ""

    def tree(self, catalogue: str, path: str = "", opened: str = "", start: int = 0) -> str:
        """The tree with a node selected and branches open."""
        query = {"open": opened, "from": str(start) if start else ""}
        given = {name: value for name, value in query.items() if value}
        address = self.page("tree", catalogue, *([path] if path else []))
        return f"{address}?{urlencode(given, safe=',*')}" if given else address

    def search(self, catalogue: str, query: dict[str, str]) -> str:
        """Search results for a text and filters."""
        return f"{self.page('search', catalogue)}?{urlencode({k: v for k, v in query.items() if v})}"
