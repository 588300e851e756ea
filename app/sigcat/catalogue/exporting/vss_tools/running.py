"""Run an exporter of vss-tools on a catalogue, in a process of its own and a temporary folder."""

import json
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.catalogue.exporting.export_json import kept_instances
from sigcat.catalogue.exporting.vss_tools.composed import Files, refused_attributes, write_catalogue
from sigcat.catalogue.exporting.vss_tools.files import Export, ExportedFile
from sigcat.catalogue.exporting.vss_tools.formats import KEEP_INSTANCES, Format, Option, options_of
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import InputRefused
from sigcat.findings import Finding, Severity

_WORKER = Path(__file__).with_name("worker.py")
_SEVERITIES: Mapping[str, Severity] = {"WARNING": "warning", "ERROR": "error", "CRITICAL": "error"}
_NO_NEWS = re.compile("Unknown extra attribute|No '(?:unit|quantity)' files defined")
"""Warnings that do not count if the export succeeds: a catalogue is there to be extended, and may have no units."""
_NODE_PATH = re.compile(r"\w+(?:\.\w+)+")


class _Places(NamedTuple):
    """Folders of one run, inside a temporary one."""

    source: Path
    output: Path
    beside: Path


def run(catalogue: Catalogue, format_: Format, options: Mapping[str, Any], name: str, timeout: float) -> Export:
    """Run the exporter with checked options. Raises InputRefused with what vss-tools said."""
    with tempfile.TemporaryDirectory(prefix="sigcat-export-") as temporary:
        places = _Places(*(Path(temporary) / part for part in ("source", "output", "beside")))
        for place in (*places, *([places.output / name] if format_.output_exists else [])):
            place.mkdir()
        log = places.source / "log"
        log.touch()
        request = _request(catalogue, format_, options, places.output / name, places)
        failure = _work({**request, "log": str(log)}, places, format_, timeout)
        findings = _findings(log, catalogue, Path(temporary))
        if failure:
            raise InputRefused(failure, findings)
        files = (*_main_files(places.output, name, format_), *_files_beside(options, format_, places))
        if not any(not file.option for file in files):
            raise InputRefused(f"vss-tools exported nothing as {format_.name}.", findings)
        news = (finding for finding in findings if not _NO_NEWS.search(finding.message))
        return Export(files, (*_left_out(catalogue), *news))


def _request(
    catalogue: Catalogue, format_: Format, options: Mapping[str, Any], output: Path, places: _Places
) -> dict[str, Any]:
    files = write_catalogue(catalogue, places.source, copy_unit_files=format_.copies_unit_files)
    return {
        "format": format_.name,
        "arguments": [
            *_tree_arguments(format_, files),
            *_option_arguments(format_, options, places),
            f"--{format_.output}={output}",
        ],
        "instances": kept_instances(catalogue) if options.get(KEEP_INSTANCES.name) else {},
    }


def _work(request: Mapping[str, Any], places: _Places, format_: Format, timeout: float) -> str:
    """Run the worker; why it failed, or nothing. `-P`: no file in the current folder can pass for a module."""
    file = places.source / "request"
    file.write_text(json.dumps(request), encoding="utf-8")
    command = [sys.executable, "-P", "-X", "utf8", str(_WORKER), str(file)]
    alive, held = os.pipe()  # the worker ends when `held` is closed, as it is when this process is killed
    try:
        worker = subprocess.run(  # noqa: S603 - our own script, with a file of our own as its argument
            command, cwd=places.beside, stdin=alive, capture_output=True, timeout=timeout, check=False
        )
    except subprocess.TimeoutExpired:
        return f"vss-tools took longer than {timeout:g} s to export {format_.name}; it was stopped."
    finally:
        os.close(alive)
        os.close(held)
    if worker.returncode not in (0, 1):
        return f"vss-tools crashed while it exported {format_.name} (exit status {worker.returncode})."
    return f"vss-tools could not export {format_.name}." if worker.returncode else ""


# -- what vss-tools is asked for ----------------------------------------------------------------------------------


def _tree_arguments(format_: Format, files: Files) -> list[str]:
    arguments = ["--vspec", str(files.tree)]
    if format_.takes_tree_options:
        parts = {"overlays": files.overlays, "types": files.types, "units": files.units, "quantities": files.quantities}
        arguments += [
            argument for name, paths in parts.items() for path in paths for argument in (f"--{name}", str(path))
        ]
    return arguments  # fmt: skip


def _option_arguments(format_: Format, options: Mapping[str, Any], places: _Places) -> list[str]:
    arguments: list[str] = []
    for option in options_of(format_):
        if not option.own and option.name in options:
            arguments.extend(_arguments(option, options[option.name], places))
    if "types-out-dir" in (option.name for option in format_.options) and "types-out-dir" not in options:
        arguments.append(f"--types-out-dir={places.output}")
    return arguments


def _arguments(option: Option, value: Any, places: _Places) -> Sequence[str]:
    """One option as vss-tools spells it. The value stands in the same argument: it may begin with a dash."""
    spelled = f"--{option.name}"
    if option.kind in ("flag", "switch"):
        return [spelled] if value else [f"--{option.spelled_off}"] if option.kind == "switch" else []
    if option.kind == "texts":
        return [f"{spelled}={item}" for item in value]
    if option.kind in ("output", "folder", "state"):
        return [f"{spelled}={_place(option, value, places)}"]
    return [f"{spelled}={value.resolve() if option.kind == 'input' else value}"]


def _place(option: Option, value: Any, places: _Places) -> Path:
    """Where an option's file or folder is written: a folder for each option keeps equal names apart."""
    folder = places.beside / option.name
    folder.mkdir()
    if option.kind != "state":
        return folder / str(value)
    copy = folder / value.name
    if value.is_file():
        copy.write_bytes(value.read_bytes())
    return Path(copy)


# -- what it made and said ----------------------------------------------------------------------------------------


def _main_files(output: Path, name: str, format_: Format) -> Sequence[ExportedFile]:
    """The content of the folder that is the export; or its file, and after it what the exporter put beside it."""
    if format_.is_folder:
        return tuple(_files_in(output / name))
    return sorted(_files_in(output), key=lambda file: file.name != name)


def _files_beside(options: Mapping[str, Any], format_: Format, places: _Places) -> Iterator[ExportedFile]:
    for option in format_.options:
        if option.name not in options:
            continue
        folder = places.beside / option.name
        if option.kind == "folder":
            folder = folder / options[option.name]
        if option.kind in ("output", "state", "folder"):
            yield from _files_in(folder, option.name)


def _files_in(folder: Path, option: str = "") -> Iterator[ExportedFile]:
    for file in sorted(folder.rglob("*")):
        if file.is_file():
            yield ExportedFile(file.relative_to(folder).as_posix(), file.read_bytes(), option)


def _findings(log: Path, catalogue: Catalogue, temporary: Path) -> tuple[Finding, ...]:
    """Warnings and errors of vss-tools, at the place of the node that they speak of, if they speak of one."""
    text = log.read_text(encoding="utf-8").replace(f"{temporary}/", "")
    lines = (json.loads(line) for line in text.splitlines())
    return tuple(_finding(level, message, catalogue) for level, message in lines if level in _SEVERITIES)


def _left_out(catalogue: Catalogue) -> Iterator[Finding]:
    for definition in catalogue.definitions.values():
        for problem in refused_attributes(definition):
            message = f"`{problem.attribute}` is left out, since vss-tools refuses it. {problem.message}"
            place = definition.origin(problem.attribute).position
            yield codes.ATTRIBUTE_LEFT_OUT.finding(message, *place, definition.path)


def _finding(level: str, message: str, catalogue: Catalogue) -> Finding:
    rule = codes.EXPORTER_WARNS if level == "WARNING" else codes.EXPORTER_REFUSES
    text = f"vss-tools: {' '.join(message.split())}"
    for path in _NODE_PATH.findall(message):
        node = catalogue.get(path)
        definition = catalogue.definitions.get(path) or (node.definition if node else None)
        if definition is not None:
            return rule.finding(text, *definition.origin().position, path)
    return rule.finding(text)
