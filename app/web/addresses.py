"""Addresses of pages."""

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

    def tree(self, catalogue: str, path: str = "", opened: str = "", start: int = 0) -> str:
        """The tree with a node selected and branches open."""
        query = {"open": opened, "from": str(start) if start else ""}
        given = {name: value for name, value in query.items() if value}
        address = self.page("tree", catalogue, *([path] if path else []))
        return f"{address}?{urlencode(given, safe=',*')}" if given else address

    def search(self, catalogue: str, query: dict[str, str]) -> str:
        """Search results for a text and filters."""
        return f"{self.page('search', catalogue)}?{urlencode({k: v for k, v in query.items() if v})}"
