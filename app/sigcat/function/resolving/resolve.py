"""A declaration, resolved: each interface once, against the catalogue that knows what the file defines."""

from collections.abc import Iterable
from functools import lru_cache
from pathlib import PurePath
from typing import NamedTuple

from sigcat import __version__
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.function.declaration.declaration import ComponentItem, Declaration, ModesItem
from sigcat.function.document.document import Document, Pointer
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.document.text import Text, optional
from sigcat.function.extension.defined_nodes import DefinedNode
from sigcat.function.function_json.model import Component, FunctionInfo, FunctionJson, MetaInfo
from sigcat.function.function_json.provenance import CatalogueLayer, DefinedInterface, Provenance
from sigcat.function.function_json.resolved_function import Origin, ResolvedFunction
from sigcat.function.resolving.code import code_interface
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.modes import mode, mode_interfaces
from sigcat.function.resolving.part import Part, each, missing_in, origin_of, values_of, written
from sigcat.function.resolving.resolved_calls import call

SCHEMA_VERSION = "1.0.0"
"""Version of the published schema under which every document validates."""


class Resolution(NamedTuple):
    """A function as far as it could be resolved, the errors of its declaration, and its missing parts."""

    resolved: ResolvedFunction
    problems: tuple[Problem, ...]
    """Their pointers lead into the declaration."""
    missing: tuple[Subject, ...]


def resolve(declaration: Declaration, document: Document, context: Context) -> Resolution:
    """Resolve a declaration against the catalogue of a context."""
    part = _function(declaration, document, context)
    assert part.value is not None
    return Resolution(ResolvedFunction(part.value, document, part.origin), tuple(context.problems), part.missing)


def _function(declaration: Declaration, document: Document, context: Context) -> Part[FunctionJson]:
    components = each(declaration.components, ("components",), context, _component)
    item = declaration.modes or ModesItem.model_validate({})
    modes = each(item.active, ("modes", "active"), context, mode)
    interfaces = mode_interfaces(item, ("modes",), context)
    code = code_interface(declaration.code, ("code",)) if declaration.code else None
    function = FunctionJson(
        meta=_meta(declaration),
        info=_info(declaration),
        components=values_of(components),
        modes=values_of(modes) or None,
        datatypes=context.types.datatypes,
        mode_interfaces=values_of(interfaces) or None,
        code=code.value if code else None,
        provenance=_provenance(document, context),
    )
    origin = Origin((), {
        "MetaInfo": Origin((), written(declaration, ())),
        "FunctionInfo": Origin((), written(declaration, ())),
        "ComponentList": origin_of(components, ()),
        "ModesList": origin_of(modes, ("modes", "active")),
        "ModeInterfaceList": origin_of(interfaces, ()),
        **({"Code": code.origin} if code else {}),
    })  # fmt: skip
    return Part(function, origin, missing_in(components))


def _meta(declaration: Declaration) -> MetaInfo:
    return MetaInfo(
        authority=optional(declaration.authority),
        schema_author=optional(declaration.author),
        date=declaration.date.strftime("%d.%m.%Y") if declaration.date else None,
        schema_version=SCHEMA_VERSION,
        schema_description=Text(f"Interfaces of the function {declaration.function}"),
    )


def _info(declaration: Declaration) -> FunctionInfo:
    return FunctionInfo(
        function_name=declaration.function,
        function_responsible=Text(declaration.responsible),
        description=Text(declaration.description),
        version=declaration.version,
    )


def _component(item: ComponentItem, at: Pointer, context: Context) -> Part[Component]:
    calls = each(item.runnables, (*at, "runnables"), context, call)
    is_complete = all(part.value is not None for part in calls)
    missing = (*missing_in(calls), *(() if is_complete else (Subject("component", item.name),)))
    origin = Origin(at, {**written(item, at), "functionList": origin_of(calls, at)})
    return Part(Component(name=item.name, runnables=values_of(calls)), origin, missing)


# -- provenance ---------------------------------------------------------------------------------------------------


def _provenance(document: Document, context: Context) -> Provenance:
    """Names without folders: the document is the same wherever it is made."""
    catalogue = context.catalogue
    return Provenance(
        generator=Text(f"sigcat {__version__}"),
        declaration=Text(PurePath(document.name).name),
        declaration_digest=document.digest,
        catalogue=Text(catalogue.name),
        catalogue_digest=catalogue.digest,
        release=optional(_release(catalogue)),
        layers=_layers(catalogue),
        definitions=_carried(context.definitions.nodes),
        type_definitions=_carried(context.definitions.types),
    )


def _layers(catalogue: Catalogue) -> tuple[CatalogueLayer, ...]:
    """Each file once: one that defines interfaces and struct types is a layer of both trees."""
    layers = dict.fromkeys((_file_name(layer.name), layer.digest) for layer in catalogue.layers)
    return tuple(CatalogueLayer(name=Text(name), digest=digest) for name, digest in layers)


@lru_cache(2048)
def _file_name(path: str) -> str:
    """The name of a file. Each function of a set has the same layers, those of all others among them."""
    return PurePath(path).name


def _carried(nodes: Iterable[DefinedNode]) -> tuple[DefinedInterface, ...] | None:
    return tuple(DefinedInterface(path=node.path, attributes=dict(node.values)) for node in nodes) or None


def _release(catalogue: Catalogue) -> str | None:
    """The release of VSS that the tree itself states in its VersionVSS branch."""
    parts = [catalogue.get(f"Vehicle.VersionVSS.{name}") for name in ("Major", "Minor", "Patch")]
    numbers = [part.values.get("default") if part else None for part in parts]
    return ".".join(map(str, numbers)) if None not in numbers else None
