"""Every route that the service has, of the API and of pages."""

from collections.abc import Mapping
from importlib import import_module
from pkgutil import iter_modules

from fastapi import APIRouter
from fastapi.routing import APIRoute

from sigcat.api import routes
from sigcat.api.middleware import metrics
from sigcat.web import pages


def served_routes() -> Mapping[str, APIRoute]:
    """Routes by method and path."""
    rooms = [
        import_module(each.name)
        for room in (routes, pages)
        for each in iter_modules(room.__path__, f"{room.__name__}.")
    ]
    routers = [value for module in (metrics, *rooms) for value in vars(module).values() if isinstance(value, APIRouter)]
    found = [route for router in routers for route in router.routes if isinstance(route, APIRoute)]
    return {f"{method} {route.path}": route for route in found for method in sorted(route.methods or ())}
