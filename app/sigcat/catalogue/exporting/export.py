"""Export a catalogue: check the catalogue and the options, then run the exporter."""

import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from sigcat import codes
from sigcat.catalogue.exporting.exporter import TIMEOUT, Exporter, Job
from sigcat.catalogue.exporting.exporters import exporter_named
from sigcat.catalogue.exporting.files import Export, ExportedFile
from sigcat.catalogue.exporting.options import checked_options
from sigcat.catalogue.exporting.shared_options import STRICT
from sigcat.catalogue.exporting.stopping import stops_export
from sigcat.catalogue.exporting.value_names import value_name_findings
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.datatypes import element_of
from sigcat.catalogue.model.definition import Definition, instances_of
from sigcat.errors import InputRefused, UsageError
from sigcat.findings import Finding, has_errors

_IN_COMMENTS = ("description", "comment", "default", "deprecation")
"""Attributes that `--include-comments` of the Protocol Buffers writes."""
_AS_NAMES = ("allowed", "instances")
"""Attributes with names of values and of instances, which are written as they are."""
_END_OF_COMMENT = re.compile(r"\*/|[\n\r\v\f\x1c-\x1e\x85\u2028\u2029]")
_CODE = re.compile(r"[;{}=<>\"'\\#\n\r\v\f\x1c-\x1e\x85\u2028\u2029]|/[/*]|\*/")
"""Signs that end the name of a value."""


def export(
    catalogue: Catalogue,
    exporter_name: str,
    options: Mapping[str, Any] | None = None,
    *,
    output_name: str = "",
    timeout: float = TIMEOUT,
) -> tuple[ExportedFile, ...]:
    """The files of a catalogue, as the exporter with this name writes them: see `exported`."""
    return exported(catalogue, exporter_name, options, output_name=output_name, timeout=timeout).files


def exported(
    catalogue: Catalogue,
    exporter_name: str,
    options: Mapping[str, Any] | None = None,
    *,
    output_name: str = "",
    timeout: float = TIMEOUT,
    memory: int = 0,
) -> Export:
    """The files of a catalogue, as an exporter writes them, and the exporter's warnings.

    `options` are values by the names that the exporter lists: text, numbers, truth values, lists of text; a Path where
    a file is read, so that text from a request never names a file; a file name where a file is written beside.
    `output_name` is the name of the file or folder, which some exporters write into it; default: that of the root.
    Raises NotFound for an unknown exporter, UsageError for unfit options, InputRefused if the export fails.
    """
    exporter = exporter_named(exporter_name)
    checked = checked_options(exporter, options or {})
    refuse_unfit(catalogue, exporter, checked)
    texts = tuple(_texts_that_leave(catalogue, _unescaped(exporter, checked)))
    if texts and checked.get(STRICT.name):
        raise InputRefused("Texts of the tree would become code; nothing was exported.", texts)
    name = output_name or f"{catalogue.roots[0].name}{exporter.suffix}"
    made = exporter.run(Job(exporter, catalogue, checked, name, timeout, memory))
    names = value_name_findings(catalogue) if exporter.has_value_names else ()
    return made._replace(findings=(*made.findings, *texts, *names))


def refuse_unfit(catalogue: Catalogue, exporter: Exporter, options: Mapping[str, Any]) -> None:
    """Raises InputRefused for a catalogue that nothing can export, UsageError for one that has nothing to export."""
    stops = has_errors if options.get(STRICT.name) else _has_stopping_errors
    if stops(catalogue.findings) or not catalogue.roots:
        raise InputRefused("The tree has errors; nothing was exported.", catalogue.findings)
    if exporter.needs_types and len(catalogue.roots) == 1:
        raise UsageError(
            f"The export {exporter.name} needs struct types, and the catalogue has none: give a types file."
        )
    structs = tuple(_of_structs(catalogue, exporter)) if exporter.refuses_types else ()
    if structs:
        raise InputRefused("The tree has signals that cannot be exported.", structs)
    unsafe = tuple(_unsafe_names(catalogue)) if exporter.is_folder or exporter.has_types_beside else ()
    if unsafe:
        raise InputRefused("The tree has names that cannot be exported.", unsafe)


def _has_stopping_errors(findings: tuple[Finding, ...]) -> bool:
    return any(map(stops_export, findings))


def _of_structs(catalogue: Catalogue, exporter: Exporter) -> Iterator[Finding]:
    structs = {definition.path for definition in _type_definitions(catalogue)}
    for definition in catalogue.definitions.values():  # vss-tools reads those that an overlay deletes, too
        struct = element_of(str(definition.values.get("datatype", "")))
        if struct in structs:
            message = f"The export {exporter.name} must have no struct types; {definition.path!r} has {struct!r}."
            fix = "Replace the signal by one for each member, in the tree itself: vss-tools reads what an overlay deletes, too."
            yield codes.EXPORTER_REFUSES.finding(
                message, *definition.origin("datatype").position, definition.path, fix=fix
            )


def _unsafe_names(catalogue: Catalogue) -> Iterator[Finding]:
    for definition in (*catalogue.definitions.values(), *_type_definitions(catalogue)):
        if _names_a_folder(definition):
            message = "A name with a slash cannot be exported: it could become the name of a file."
            yield codes.NAME_WITH_SLASH.finding(message, *definition.origin().position, definition.path)


def _unescaped(exporter: Exporter, options: Mapping[str, Any]) -> tuple[str, ...]:
    """Return the attributes that an exporter writes as they are with these options."""
    return (*exporter.unescaped, *_IN_COMMENTS) if options.get("include-comments") else exporter.unescaped


def _texts_that_leave(catalogue: Catalogue, attributes: Iterable[str]) -> Iterator[Finding]:
    """Texts that end the comment, the string or the name that an exporter writes them into."""
    for definition in (*catalogue.definitions.values(), *_type_definitions(catalogue)) if attributes else ():
        for name in attributes:
            signs = "a sign such as `;` or a line break" if name in _AS_NAMES else "a line break or `*/`"
            pattern = _CODE if name in _AS_NAMES else _END_OF_COMMENT
            if any(pattern.search(text.strip()) for text in _texts(definition, name)):
                message = f"`{name}` has {signs}: the exported file reads the rest of the text as code."
                fix = f"Write it without {signs}."
                yield codes.TEXT_LEAVES_COMMENT.finding(
                    message, *definition.origin(name).position, definition.path, fix=fix
                )


def _texts(definition: Definition, name: str) -> list[str]:
    given = instances_of(definition.values) if name == "instances" else definition.values.get(name)
    return [text for text in (given if isinstance(given, list | tuple) else [given]) if isinstance(text, str)]


def _type_definitions(catalogue: Catalogue) -> Iterable[Definition]:
    return (node.definition for root in catalogue.roots[1:] for node in root.walk())


def _names_a_folder(definition: Definition) -> bool:
    names = (definition.path, *map(str, instances_of(definition.values)))
    return any(sign in name for name in names for sign in ("/", "\\", "\0"))
