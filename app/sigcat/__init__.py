"""sigcat: vspec files, overlays and functions in; a catalogue, findings, exports and code of platforms out.

The names below are the public Python API, each loaded when it is used: the command line starts without them.
"""

from typing import Any

__version__ = "0.1.0"

_NAMES = {
    "catalogue.comparing.changes": ("AttributeChange", "Change"),
    "catalogue.reading.statement": ("Origin",),
    "errors": ("InputRefused", "NotFound", "SigcatError", "UsageError"),
    "findings": ("Finding",),
    "function.node_uses": ("NodeUse",),
    "python_api.catalogue": ("Catalogue", "Trial", "diff", "open_catalogue"),
    "python_api.function": ("Function",),
    "python_api.node": ("Attribute", "Node"),
    "python_api.project": ("Project", "open_project"),
    "python_api.rows": ("Row",),
    "python_api.run": ("Run", "simulate"),
}
"""The public names, by the module that defines them; app/public/__init__.pyi has their types."""
_MODULES = {name: module for module, names in _NAMES.items() for name in names}


def __getattr__(name: str) -> Any:
    if name not in _MODULES:
        raise AttributeError(f"module 'sigcat' has no attribute {name!r}")
    from importlib import import_module

    value = getattr(import_module(f"sigcat.{_MODULES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return [*globals(), *_MODULES]
