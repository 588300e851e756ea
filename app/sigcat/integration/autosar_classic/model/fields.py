"""Fields of the models: Classic has no published schema, so that all of them are of sigcat."""

from typing import Any

from sigcat.function.function_json.wire import OWN, described, own

__all__ = ["always", "own"]


def always(alias: str, description: str, **more: Any) -> Any:
    """A field that stands wherever its model does."""
    return described(alias, description, source=OWN, **more)
