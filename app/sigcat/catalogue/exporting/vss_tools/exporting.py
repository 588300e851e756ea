"""Export a catalogue in any format of vss-tools."""

from collections.abc import Iterable, Mapping
from typing import Any

from sigcat import codes
from sigcat.catalogue.composing.compose import unexpanded
from sigcat.catalogue.exporting.export_json import tree_data, tree_json
from sigcat.catalogue.exporting.vss_tools.files import Export, ExportedFile, zipped
from sigcat.catalogue.exporting.vss_tools.formats import Format, format_named
from sigcat.catalogue.exporting.vss_tools.options import checked_options
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.definition import Definition, instances_of
from sigcat.errors import InputRefused, UsageError
from sigcat.findings import has_errors

__all__ = ["TIMEOUT", "Export", "ExportedFile", "export", "exported", "zipped"]

TIMEOUT = 600.0
"""Seconds after which an export is given up: vss-tools takes minutes for trees of many ten thousand signals."""


def export(
    catalogue: Catalogue,
    format_name: str,
    options: Mapping[str, Any] | None = None,
    *,
    output_name: str = "",
    timeout: float = TIMEOUT,
) -> tuple[ExportedFile, ...]:
    """Files of a catalogue in the format with this name: see `exported`."""
    return exported(catalogue, format_name, options, output_name=output_name, timeout=timeout).files


def exported(
    catalogue: Catalogue,
    format_name: str,
    options: Mapping[str, Any] | None = None,
    *,
    output_name: str = "",
    timeout: float = TIMEOUT,
) -> Export:
    """Export a catalogue, byte for byte as `vspec export` does.

    `options` are values by the names in `formats.py`: texts, numbers, truth values, lists of texts; a Path where a
    file is read, so that a text from a request never names a file; a file name where a file is written beside.
    `output_name` is the name of the file or folder, which some exporters write into it; default: that of the root.
    Raises NotFound for an unknown format, UsageError for unfit options, InputRefused if the export fails.
    """
    format_ = format_named(format_name)
    checked = checked_options(format_, options or {})
    _refuse_unfit_catalogue(catalogue, format_)
    name = output_name or f"{catalogue.roots[0].name}{format_.suffix}"
    if format_.name == "json" and _is_native(checked):
        return Export(_native_json(catalogue, checked, name))
    from sigcat.catalogue.exporting.vss_tools.running import run  # the JSON of our own starts no process

    return run(catalogue, format_, checked, name, timeout)


# -- the JSON of our own ------------------------------------------------------------------------------------------


def _is_native(options: Mapping[str, Any]) -> bool:
    return not any(options.get(name) for name in ("stats-radial", "strict", "aborts", "strict-exceptions"))


def _native_json(catalogue: Catalogue, options: Mapping[str, Any], name: str) -> tuple[ExportedFile, ...]:
    if not options.get("expand", True):
        catalogue = unexpanded(catalogue)
    data = tree_data(
        catalogue,
        options.get("extended-attributes", ()),
        all_extended=options.get("extend-all-attributes", False),
        keep_instances=options.get("keep-instances", False),
    )
    pretty = options.get("pretty", False)
    beside: tuple[ExportedFile, ...] = ()
    if "types-output" in options:
        types = data.pop("ComplexDataTypes", None)
        if types is not None:
            text = tree_json(types, pretty=pretty)
            beside = (ExportedFile(options["types-output"], text.encode(), "types-output"),)
    return (ExportedFile(name, tree_json(data, pretty=pretty).encode()), *beside)


# -- trees that cannot be exported --------------------------------------------------------------------------------


def _refuse_unfit_catalogue(catalogue: Catalogue, format_: Format) -> None:
    if has_errors(catalogue.findings) or not catalogue.roots:
        raise InputRefused("The tree has errors; nothing was exported.", catalogue.findings)
    if format_.needs_types and len(catalogue.roots) == 1:
        raise UsageError(
            f"The export {format_.name} is of struct types, and the catalogue has none: give a types file."
        )
    unsafe = tuple(
        codes.NAME_WITH_SLASH.finding("A name with a slash cannot be exported: it could become the name of a file.",
                *definition.origin().position, definition.path)
        for definition in (*catalogue.definitions.values(), *_type_definitions(catalogue))
        if _names_a_folder(definition)
    )  # fmt: skip
    if unsafe:
        raise InputRefused("The tree has names that cannot be exported.", unsafe)


def _type_definitions(catalogue: Catalogue) -> Iterable[Definition]:
    return (node.definition for root in catalogue.roots[1:] for node in root.walk())


def _names_a_folder(definition: Definition) -> bool:
    names = (definition.path, *map(str, instances_of(definition.values)))
    return any(sign in name for name in names for sign in ("/", "\\", "\0"))
