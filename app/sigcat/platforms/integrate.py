"""From functions to the Integration JSON of a platform: one call, whatever the platform."""

from collections.abc import Sequence

from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.errors import InputRefused
from sigcat.findings import has_errors
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.declared_fields import declared_fields
from sigcat.integration.deployment import Deployment
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT
from sigcat.platforms.platform import Integrated, Platform


@collector_paused()
def integrate(
    platform: Platform,
    functions: Sequence[ResolvedFunction],
    deployment: Deployment = DEFAULT_DEPLOYMENT,
    previous: tuple[bytes, str] | None = None,
    limits: Limits = DEFAULT_LIMITS,
) -> Integrated:
    """Derive the Integration JSON for a platform. Raises InputRefused if a field of an interface has no place in it.

    `previous` is the Integration JSON before, as content and name: versions of services follow from it.
    """
    integrated = platform.derive(functions, deployment, getattr(deployment, platform.section))
    if previous is not None and platform.with_previous is not None:
        integrated = platform.with_previous(integrated, previous, deployment, limits)
    if has_errors(integrated.findings):
        raise InputRefused("The functions cannot be integrated: they have errors.", integrated.findings)
    return integrated._replace(report=(*declared_fields(functions), *integrated.report))
