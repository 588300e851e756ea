"""Under which keys a function's parameters are stored where all of them share one file."""

from collections import Counter
from collections.abc import Mapping

from sigcat.adapter.core.plan import CorePlan
from sigcat.function.function_json.code import DEFAULT_STORAGE
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import parameters


def stored_keys(function: FunctionJson, plan: CorePlan) -> Mapping[str, str]:
    """The key of each parameter by its variable: with the storage before it where two storages have one of this name."""
    default = (function.code.storage if function.code else None) or DEFAULT_STORAGE
    storages = {item.variable or item.name: item.storage or default for _, _, item in parameters(function)}
    uses = Counter(parameter.key for parameter in plan.parameters)
    return {
        each.variable: each.key if uses[each.key] == 1 else f"{storages[each.variable]}.{each.key}"
        for each in plan.parameters
    }
