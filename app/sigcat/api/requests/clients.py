"""Name of a client, for counting what one client may have under way."""

from starlette.requests import Request

from sigcat.api.client_network import network_of
from sigcat.api.settings import Settings
from sigcat.api.tokens import bearer


def client_of(request: Request) -> str:
    """The name of a token if a valid one was sent; else the address, of IPv6 its network."""
    settings: Settings = request.app.state.settings
    token = bearer(request.headers.get("authorization", ""), settings.tokens) if settings.tokens else None
    return f"token {token.name}" if token else network_of(request.client.host if request.client else "")
