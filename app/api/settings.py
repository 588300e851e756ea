"""What an operator of the service may set."""

from typing import NamedTuple


class Settings(NamedTuple):
    """Bounds on requests. Each has a clear answer where it is met."""

    body_bytes: int = 4 * 1024 * 1024
    """Bytes of a posted text; more is answered with 413."""
    results: int = 200
    """Most results in one page of a list."""
    tree_nodes: int = 20_000
    """Most nodes in one answer of the tree."""
    query_characters: int = 200
    """Longest text that is searched for."""


DEFAULT_SETTINGS = Settings()
