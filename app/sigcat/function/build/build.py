"""From a declaration and a catalogue to Function JSON."""

from collections.abc import Collection
from pathlib import PurePath
from typing import NamedTuple

from sigcat import __version__
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.interfaces import category_of, interface_name
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.errors import InputRefused
from sigcat.file_kind import is_json
from sigcat.findings import Finding, has_errors, in_order
from sigcat.function.build.causes import causes
from sigcat.function.build.overlay import defined
from sigcat.function.build.references import interface_node
from sigcat.function.build.scheduling import runnable
from sigcat.function.build.work import Work
from sigcat.function.checks.checks import check
from sigcat.function.checks.validate import validate_function_json
from sigcat.function.declaration.declaration import ComponentItem, Declaration, Declared, ModesItem, read_declaration
from sigcat.function.document.document import Document, Pointer
from sigcat.function.document.problem import Problem
from sigcat.function.function_json.model import (
    CatalogueLayer,
    Component,
    FunctionInfo,
    FunctionJson,
    MetaInfo,
    Mode,
    ModeInterface,
    Provenance,
    Runnable,
)
from sigcat.function.function_json.types import symbols_of
from sigcat.limits import DEFAULT_LIMITS, Limits

SCHEMA_VERSION = "1.0.0"
"""Version of the published schema under which every document validates."""


class Built(NamedTuple):
    """A function that was built, and what is still to be said about it. None if there are errors."""

    function: FunctionJson | None
    findings: tuple[Finding, ...]


def build(declared: Declared, catalogue: Catalogue) -> Built:
    """Resolve a declaration against a catalogue and check the result. Everything wrong is among the findings."""
    if declared.declaration is None:
        return Built(None, in_order(declared.findings))
    work, function = resolved(declared, declared.declaration, catalogue)
    findings = in_order([*declared.findings, *work.findings])
    return Built(None if has_errors(findings) else function, findings)


@collector_paused()
def resolved(declared: Declared, declaration: Declaration, catalogue: Catalogue) -> tuple[Work, FunctionJson]:
    """The function as far as it can be made, and all that was found in it and in what it defines."""
    over, findings = defined(declared, catalogue)
    work = Work(over, declared.document, declaration.function)
    work.findings.extend(findings)
    function = _function(declaration, declared.document, over, work)
    known = {name for name, path in work.interfaces.items() if category_of(path) == "error"}
    for problem in check(function, known):
        _report(problem, work)
    told = {(finding.rule, finding.path) for finding in findings}
    work.findings[:] = [finding for finding in causes(work, declaration) if not _is_told(finding, told, work)]
    return work, function


_SAME = {
    "F023": ("I103",),
    "F032": ("I203", "I303", "I502"), "F050": ("I501",), "F051": ("I505", "I507"), "F052": ("I509",), "F053": ("I510",),
    "F024": ("V010",), "F054": ("I518",), "F055": ("I517", "I518"), "F056": ("I519", "I520", "I521"), "F057": ("I522",),
    "F058": ("I511", "I512", "I513"), "F060": ("I304",), "F061": ("I204",), "F062": ("I205",),
}  # fmt: skip
"""Rules of the catalogue that say of a defined interface what these rules say of a function."""


def _is_told(finding: Finding, told: Collection[tuple[str, str]], work: Work) -> bool:
    """Whether a rule of the catalogue has said the same of an interface that the file defines."""
    path = work.interfaces.get(finding.path, finding.path)
    return any((rule, path) in told for rule in _SAME.get(finding.rule, ()))


@collector_paused()
def build_function(
    data: bytes, name: str, catalogue: Catalogue, limits: Limits = DEFAULT_LIMITS
) -> tuple[FunctionJson, tuple[Finding, ...]]:
    """The Function JSON of a `function.yaml`, and its warnings. Raises InputRefused with every finding."""
    built = build(read_declaration(data, name, limits), catalogue)
    if built.function is None:
        count = sum(finding.severity == "error" for finding in built.findings)
        message = f"{name} cannot be built: {count} error{'s' if count != 1 else ''}."
        raise InputRefused(message, built.findings)
    return built.function, built.findings


@collector_paused()
def check_function(
    data: bytes, name: str, catalogue: Catalogue, limits: Limits = DEFAULT_LIMITS
) -> tuple[Finding, ...]:
    """Everything that is wrong with a function file, `function.yaml` or Function JSON."""
    if is_json(data, name):
        return validate_function_json(data, name, catalogue, limits)
    return build(read_declaration(data, name, limits), catalogue).findings


def _function(declaration: Declaration, document: Document, catalogue: Catalogue, work: Work) -> FunctionJson:
    components = tuple(
        _component(item, ("components", index), ("ComponentList", index), work)
        for index, item in enumerate(declaration.components)
    )
    modes, interfaces = _modes(declaration.modes, work)
    return FunctionJson(
        meta=_meta(declaration),
        info=FunctionInfo(
            function_name=declaration.function,
            function_responsible=declaration.responsible,
            description=declaration.description,
            version=declaration.version,
        ),
        components=components,
        modes=modes,
        datatypes=work.types.datatypes,
        mode_interfaces=interfaces,
        provenance=_provenance(document, catalogue),
    )


def _meta(declaration: Declaration) -> MetaInfo:
    return MetaInfo(
        authority=declaration.authority,
        schema_author=declaration.author,
        date=declaration.date.strftime("%d.%m.%Y") if declaration.date else None,
        schema_version=SCHEMA_VERSION,
        schema_description=f"Interfaces of the function {declaration.function}",
    )


def _component(item: ComponentItem, at: Pointer, target: Pointer, work: Work) -> Component:
    work.trace[target] = at
    made: list[Runnable] = []
    for index, call in enumerate(item.runnables):
        resolved = runnable(call, (*at, "runnables", index), (*target, "functionList", len(made)), work)
        if resolved is not None:
            made.append(resolved)
    return Component(name=item.name, runnables=tuple(made))


def _modes(item: ModesItem | None, work: Work) -> tuple[tuple[Mode, ...] | None, tuple[ModeInterface, ...] | None]:
    if item is None:
        return None, None
    interfaces: list[ModeInterface] = []
    for index, reference in enumerate(item.interfaces):
        made = _mode_interface(reference, ("modes", "interfaces", index), work)
        if made is not None:
            work.trace[("ModeInterfaceList", len(interfaces))] = ("modes", "interfaces", index)
            interfaces.append(made)
    modes = []
    for index, mode in enumerate(item.active):
        work.trace[("ModesList", index)] = ("modes", "active", index)
        calls = tuple(_call_name(reference, work) for reference in mode.runnables)
        modes.append(Mode(name=mode.mode, description=mode.description, runnables=calls))
    return tuple(modes) or None, tuple(interfaces) or None


def _call_name(reference: str, work: Work) -> str:
    """The name of a call; whether the function has it is checked with the result."""
    node = work.node(reference) or work.own(reference, "scheduling")
    return interface_name(node.path) or reference if node is not None else reference


def _mode_interface(reference: str, at: Pointer, work: Work) -> ModeInterface | None:
    node = interface_node(reference, "mode", at, work, own=True)
    if node is None:
        return None
    symbols = symbols_of(node)
    return ModeInterface(
        name=interface_name(node.path),
        description=str(node.values.get("description") or ""),
        direction=node.name,
        datatype=work.types.reference(
            str(node.values.get("datatype")), f"{work.function}.{work.function}.Mode{node.name}", symbols
        ),
        modes=tuple(symbols or ()),
        vss_path=node.path,
    )


def _provenance(document: Document, catalogue: Catalogue) -> Provenance:
    """Names without folders: the document is the same wherever it is made."""
    return Provenance(
        generator=f"sigcat {__version__}",
        declaration=PurePath(document.name).name,
        declaration_digest=document.digest,
        catalogue=catalogue.name,
        catalogue_digest=catalogue.digest,
        release=_release(catalogue),
        layers=tuple(CatalogueLayer(name=PurePath(layer.name).name, digest=layer.digest) for layer in catalogue.layers),
    )


def _release(catalogue: Catalogue) -> str | None:
    """The release of VSS that the tree itself tells in its VersionVSS branch."""
    parts = [catalogue.get(f"Vehicle.VersionVSS.{name}") for name in ("Major", "Minor", "Patch")]
    numbers = [part.values.get("default") if part else None for part in parts]
    return ".".join(map(str, numbers)) if None not in numbers else None


# -- from places in the Function JSON to places in the declaration ------------------------------------------------

_KEYS = {
    "RunnablesList": "runnables",
    "InitValue": "init",
    "Units": "unit",
    "Asillevel": "asil",
    "AsilLevel": "asil",
    "AsilInfo": "asil",
}
"""Keys of the declaration where they are not simply those of the wire format with a small first letter."""


def _report(problem: Problem, work: Work) -> None:
    """Note a problem of the result where it was declared, unless resolving has said the same of that place."""
    at = place_in(problem.pointer, work)
    if not work.has_told(problem.rule, at):
        work.report(problem.rule, at, problem.message, problem.fix, problem.path)


def place_in(pointer: Pointer, work: Work) -> Pointer:
    """The part of the declaration that a part of the Function JSON was made from."""
    if pointer == ("FunctionInfo", "FunctionName"):
        return ("function",)
    for length in range(len(pointer), 0, -1):
        origin = work.trace.get(pointer[:length])
        if origin is not None:
            return _with_key(origin, pointer[length:], work)
    return ()


def _with_key(origin: Pointer, rest: Pointer, work: Work) -> Pointer:
    """The origin, and the key of the field in it, if the author wrote that key."""
    if not rest or not isinstance(rest[0], str):
        return origin
    key = _KEYS.get(rest[0], rest[0][:1].lower() + rest[0][1:])
    value = work.document.value
    for part in origin:
        value = value[part]
    if not isinstance(value, dict) or key not in value:
        return origin
    items, index = value[key], rest[1] if len(rest) > 1 else None
    is_item = isinstance(items, list) and isinstance(index, int) and index < len(items)
    return (*origin, key, index) if is_item and index is not None else (*origin, key)
