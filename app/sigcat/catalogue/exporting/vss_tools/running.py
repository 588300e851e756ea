"""Run an exporter of vss-tools on a catalogue, in a separate process and a temporary folder."""

import errno
import json
import os
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.catalogue.exporting.export_json import kept_instances
from sigcat.catalogue.exporting.exporter import Exporter, Job, Option
from sigcat.catalogue.exporting.files import Export, ExportedFile
from sigcat.catalogue.exporting.shared_options import KEEP_INSTANCES
from sigcat.catalogue.exporting.vss_tools.exporter_calls import call_of
from sigcat.catalogue.exporting.vss_tools.processes import ExportEnded, ExportProcess, export_process
from sigcat.catalogue.exporting.vss_tools.worker import FULL, NO_MEMORY, NO_SPACE, REFUSED
from sigcat.catalogue.exporting.vss_tools.written_catalogue import Files, refused_attributes, write_catalogue
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import InputRefused, NoRoom, ToolCrashed
from sigcat.findings import Finding, RuleCode
from sigcat.real_path import real_path
from sigcat.temporary_files import temporary_folder

_LEVELS: Mapping[str, RuleCode] = {
    "WARNING": codes.EXPORTER_WARNS,
    "ERROR": codes.EXPORTER_REFUSES,
    "CRITICAL": codes.EXPORTER_REFUSES,
}
"""Levels of the log of vss-tools that become findings."""
_NODE_PATH = re.compile(r"\w+(?:\.\w+)+")
_EXPECTED = re.compile("Unknown extra attribute|No '(?:unit|quantity)' files defined")
"""Warnings of vss-tools that say nothing new unless it is asked to be strict: a catalogue may be extended, and may have
no units.

vss-tools gives its messages no codes, so these two lines hold its words, and `_NODE_PATH` finds the nodes in them.
"""


class _Report(NamedTuple):
    """A line of the log of vss-tools."""

    rule: RuleCode
    text: str


class _Folders(NamedTuple):
    """Folders of one run, inside a temporary one."""

    source: Path
    output: Path
    beside: Path


def run(job: Job) -> Export:
    """Run the exporter of vss-tools. Raises InputRefused with what it reported, NoRoom, and ToolCrashed."""
    try:
        return _run(job)
    except OSError as error:
        if error.errno not in FULL:
            raise
        message = f"The export needs more room for temporary files than there is: {error.strerror}."
        raise NoRoom(f"{message} Free some, or let TMPDIR name another folder.") from error


def _run(job: Job) -> Export:
    with temporary_folder("sigcat-export-") as place, export_process(job.exporter.name, Path(place)) as process:
        temporary = Path(place)
        folders = _Folders(*(temporary / part for part in ("source", "output", "beside")))
        output = folders.output / job.output_name
        for folder in (*folders, *([output] if call_of(job.exporter.name).output_exists else [])):
            folder.mkdir()
        log = folders.source / "log"
        log.touch()
        failure = _failure(process, {**_request(job, output, folders), "log": str(log)}, job)
        reports = tuple(_reports(log, temporary))
        news = [report for report in reports if not _EXPECTED.search(report.text)]
        if failure:
            raise InputRefused(failure, _findings(reports if _is_strict(job) else news, job.catalogue))
        files = (*_main_files(job, folders.output), *_files_beside(job, folders))
        found = (*_left_out(job.catalogue), *_findings(news, job.catalogue))
        if any(not file.option for file in files):
            return Export(files, found)
        message = f"vss-tools exported nothing as {job.exporter.name}."
        if not job.exporter.is_folder:
            raise InputRefused(message, found)
        fix = "Change the options that select signals, such as --topics, or the tree."
        return Export(files, (*found, codes.EXPORTER_WARNS.finding(message, fix=fix)))


def _is_strict(job: Job) -> bool:
    return bool(job.options.get("strict") or job.options.get("aborts"))


def _request(job: Job, output: Path, folders: _Folders) -> dict[str, Any]:
    call = call_of(job.exporter.name)
    files = write_catalogue(job.catalogue, folders.source, copy_unit_files=call.copies_unit_files)
    return {
        "format": job.exporter.name,
        "arguments": [
            *_tree_arguments(files, only_tree=not call.takes_tree_options),
            *_option_arguments(job, folders),
            f"--{call.output}={output}",
        ],
        "instances": kept_instances(job.catalogue) if job.options.get(KEEP_INSTANCES.name) else {},
        "place": str(folders.beside),
        "seconds": job.timeout,
        "memory": job.memory,
    }


def _failure(process: ExportProcess, request: Mapping[str, Any], job: Job) -> str:
    """Why the export was refused, or nothing. Raises OSError without room for files, MemoryError, and ToolCrashed."""
    name = job.exporter.name
    try:
        status = process.status(request)
    except TimeoutError:
        return f"vss-tools took longer than {job.timeout:g} s to export {name}; it was stopped."
    except ExportEnded as error:
        raise ToolCrashed(f"vss-tools crashed while it exported {name} ({error}). Try again.") from None
    if status == NO_SPACE:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
    if status == NO_MEMORY:
        raise MemoryError
    return f"vss-tools could not export {name}." if status == REFUSED else ""


# -- what vss-tools is asked for ----------------------------------------------------------------------------------


def _tree_arguments(files: Files, *, only_tree: bool) -> list[str]:
    arguments = ["--vspec", str(files.tree)]
    if only_tree:
        return arguments
    parts = {"overlays": files.overlays, "types": files.types, "units": files.units, "quantities": files.quantities}
    return arguments + [text for name, paths in parts.items() for path in paths for text in (f"--{name}", str(path))]


def _option_arguments(job: Job, folders: _Folders) -> list[str]:
    arguments: list[str] = []
    for option in job.exporter.options:
        if not option.own and option.name in job.options:
            arguments.extend(_arguments(option, job.options[option.name], folders))
    if _has_option(job.exporter, "types-out-dir") and "types-out-dir" not in job.options:
        arguments.append(f"--types-out-dir={folders.output}")
    return arguments


def _has_option(exporter: Exporter, name: str) -> bool:
    return any(option.name == name for option in exporter.options)


def _arguments(option: Option, value: Any, folders: _Folders) -> Sequence[str]:
    """One option as vss-tools spells it. The value is in the same argument: it may begin with a dash."""
    spelled = f"--{option.name}"
    if option.kind in ("flag", "switch"):
        return [spelled] if value else [f"--{option.spelled_off}"] if option.kind == "switch" else []
    if option.kind == "texts":
        return [f"{spelled}={item}" for item in value]
    if option.kind in ("output", "folder", "state"):
        return [f"{spelled}={_path_beside(option, value, folders)}"]
    return [f"{spelled}={real_path(value) if option.kind == 'input' else value}"]


def _path_beside(option: Option, value: Any, folders: _Folders) -> Path:
    """Return the path of an option's file or folder: a folder for each option keeps equal names apart."""
    folder = folders.beside / option.name
    folder.mkdir()
    if option.kind != "state":
        return folder / str(value)
    copy = folder / value.name
    if value.is_file():
        copy.write_bytes(value.read_bytes())
    return Path(copy)


# -- what it made and reported ------------------------------------------------------------------------------------


def _main_files(job: Job, output: Path) -> Sequence[ExportedFile]:
    """The content of the folder that is the export; or its file, and after it what the exporter put beside it."""
    if job.exporter.is_folder:
        return tuple(_files_in(output / job.output_name))
    return sorted(_files_in(output), key=lambda file: file.name != job.output_name)


def _files_beside(job: Job, folders: _Folders) -> Iterator[ExportedFile]:
    for option in job.exporter.options:
        if option.name not in job.options:
            continue
        folder = folders.beside / option.name
        if option.kind == "folder":
            folder = folder / job.options[option.name]
        if option.kind in ("output", "state", "folder"):
            yield from _files_in(folder, option.name)


def _files_in(folder: Path, option: str = "") -> Iterator[ExportedFile]:
    for file in sorted(folder.rglob("*")):
        if file.is_file():
            yield ExportedFile(file.relative_to(folder).as_posix(), file.read_bytes(), option)


def _reports(log: Path, temporary: Path) -> Iterator[_Report]:
    """Warnings and errors in the log of vss-tools."""
    text = log.read_text(encoding="utf-8").replace(f"{temporary}/", "")
    for level, message in map(json.loads, text.splitlines()):
        if level in _LEVELS:
            yield _Report(_LEVELS[level], " ".join(message.split()))


def _left_out(catalogue: Catalogue) -> Iterator[Finding]:
    for definition in catalogue.definitions.values():
        for problem in refused_attributes(definition):
            message = f"`{problem.attribute}` is left out, since vss-tools refuses it. {problem.message}"
            origin = definition.origin(problem.attribute)
            yield codes.ATTRIBUTE_LEFT_OUT.finding(message, *origin.position, definition.path)


def _findings(reports: Iterable[_Report], catalogue: Catalogue) -> tuple[Finding, ...]:
    """Return the messages of vss-tools as findings, at the node that they name; repeated ones once, with a count."""
    return tuple(_finding(report, count, catalogue) for report, count in Counter(reports).items())


def _finding(report: _Report, count: int, catalogue: Catalogue) -> Finding:
    text = f"vss-tools: {report.text}" + (f" ({count} times)" if count > 1 else "")
    for path in _NODE_PATH.findall(report.text):
        node = catalogue.get(path)
        definition = catalogue.definitions.get(path) or (node.definition if node else None)
        if definition is not None:
            return report.rule.finding(text, *definition.origin().position, path)
    return report.rule.finding(text)
