"""Fixtures of the rooms below: a server of archives, a data folder and a tree to lint."""

from tests.catalogue.hosting.conftest import data, server
from tests.rules.linting.conftest import tree

__all__ = ["data", "server", "tree"]
