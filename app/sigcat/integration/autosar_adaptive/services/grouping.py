"""Grouping of interfaces into services: by the component that provides them, or by the branch they come from."""

from typing import NamedTuple

from sigcat import codes
from sigcat.function.exchange import Side
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_names import branch_of, service_name
from sigcat.integration.autosar_parts import several_providers

MODES = "ModeManagement"
SAFETY = "SafetyManagement"
"""Parts of the base software: which sends a function its mode, and which informs it of safety conditions."""
_OF_BASE_SOFTWARE = {"mode in": MODES, "reaction": SAFETY}


class Group(NamedTuple):
    """A service before its elements are named."""

    name: str
    origin: str
    provider: str
    """Component of the set that provides it; empty if it comes from outside."""

    @property
    def key(self) -> str:
        """Identity of the service."""
        return f"{'component' if self.provider else 'outside'} {self.origin}"


def group_of(side: Side, context: Context) -> Group:
    """Return the service to which a side of an element belongs."""
    if side.provides:
        return _of_component(side.part.name)
    if side.kind in _OF_BASE_SOFTWARE:
        return _of_origin(_OF_BASE_SOFTWARE[side.kind])
    provider = context.exchange.element(side).provider
    return _of_component(provider.part.name) if provider else _outside(side, context)


def report_rivals(context: Context) -> None:
    """Report signals and methods that several components provide."""
    for side in context.exchange.sides:
        providers = context.exchange.element(side).providers
        if side.kind in ("data", "method") and len(providers) > 1 and side is providers[1]:
            message, fix = several_providers(side.identity, providers), "Let only one of them provide it."
            context.findings.report(codes.SEVERAL_PROVIDERS, message, side, fix, key="Role")


def _outside(side: Side, context: Context) -> Group:
    """The service of elements that no function of the set provides."""
    if side.path:
        return _configured(side.path, context) or _of_origin(branch_of(side.path))
    message = f"{side.identity} ({side.where}) must have a VSS path or a provider in the set."
    fix = f"Set its path in the deployment file, as `paths: {{{side.function}.{side.interface.name}: Vehicle...}}`, or add the provider."
    fix = "Add its provider." if side.kind == "method" else fix
    context.findings.report(codes.PROVIDER_UNKNOWN, message, side, fix)
    return _of_origin(f"{side.part.name}Required")


def _configured(path: str, context: Context) -> Group | None:
    """The service of the deployment with the longest path above the signal."""
    found = [
        (len(above), service.name, above)
        for service in context.settings.services
        for above in service.paths
        if path == above or path.startswith(f"{above}.")
    ]
    if not found:
        return None
    _, name, _ = max(found)
    return Group(name, name, "")


def _of_origin(origin: str) -> Group:
    return Group(service_name(origin), origin, "")


def _of_component(name: str) -> Group:
    return Group(service_name(name), name, name)
