"""Structs of the core beside those of the platform."""

from collections.abc import Iterator

from sigcat.adapter.autosar_adaptive.application.plan import StructPair
from sigcat.adapter.autosar_adaptive.cpp_names import TypeNames
from sigcat.adapter.core.core_values import struct_name
from sigcat.adapter.core.planning import context_of
from sigcat.adapter.host.host_plan import HostPlan
from sigcat.function.function_json.model import FunctionJson
from sigcat.integration.autosar_adaptive.model import IntegrationModel


def struct_pairs(host: HostPlan, model: IntegrationModel, types: TypeNames) -> tuple[StructPair, ...]:
    """The structs that the core takes and gives, in its order: each after those that it holds."""
    entries = {entry.reference or entry.name: entry for entry in model.datatypes or () if entry.fields}
    by_name = dict(_references(host.function))
    found = []
    for struct in host.core.structs:
        entry = entries.get(by_name[struct.name])
        if entry is not None and len(entry.fields or ()) == len(struct.fields):
            members = tuple(field.name for field in entry.fields or ())
            found.append(StructPair(types.type(entry.name), members, struct))
    return tuple(found)


def _references(function: FunctionJson) -> Iterator[tuple[str, str]]:
    """Names of structs in the core, and their references."""
    context = context_of(function)
    for reference, datatype in context.datatypes.items():
        if datatype.kind == "struct":
            yield struct_name(reference, context), reference
