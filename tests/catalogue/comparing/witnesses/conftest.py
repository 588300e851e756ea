"""Exports of these tests run as in a service."""

from tests.catalogue.exporting.conftest import _as_in_a_service, warm_exports

__all__ = ["_as_in_a_service", "warm_exports"]
