"""The ids of a document, as a deployment file fixes them."""

from sigcat.integration.autosar_adaptive.completion import completed
from sigcat.integration.autosar_adaptive.model import IntegrationModel
from sigcat.integration.autosar_adaptive.problems import numbers_of

_SUFFIXES = {"instance": ":instance", "data id": ":dataId"}


def identifiers_of(model: IntegrationModel) -> dict[str, int]:
    """Every id of a model under the key that fixes it in a deployment: whatever is added later, these stay."""
    found: dict[str, int] = {}
    for component in completed(model).components:
        for interface in component.services:
            for (_, kind), owner, value, _ in numbers_of(interface):
                found[f"{owner}{_SUFFIXES.get(kind, '')}"] = value
    return dict(sorted(found.items()))
