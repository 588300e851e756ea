"""`sigcat export FORMAT`."""

import argparse
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sigcat.catalogue.exporting.exporter import TIMEOUT, Exporter, Option
from sigcat.catalogue.exporting.exporters import EXPORTERS
from sigcat.catalogue.exporting.shared_options import EXPAND, STRICT
from sigcat.cli.command_parser import CommandParser, positive
from sigcat.cli.output import make_folder, print_findings, write_bytes
from sigcat.cli.output_options import Output, add_output, name_output, outputs_of, refuse_overwriting
from sigcat.cli.tree_options import add_tree_options, read_tree
from sigcat.errors import UsageError
from sigcat.real_path import real_path

if TYPE_CHECKING:
    from sigcat.catalogue.exporting.files import ExportedFile


class _LateParser(CommandParser):
    """A parser that gets its options when it is used: other commands need not wait for those of all formats."""

    fill: partial[None] | None = None

    def parse_known_args(self, *arguments: Any, **named: Any) -> Any:
        """Fill, then parse."""
        if self.fill is not None:
            self.fill()
            self.fill = None
        return super().parse_known_args(*arguments, **named)


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command with one sub-command for each format."""
    parser = commands.add_parser(
        "export",
        help="write a tree in another format",
        description="Write a tree in another format, byte for byte as `vspec export` does, with overlays applied.",
    )
    formats = parser.add_subparsers(title="formats", metavar="FORMAT", parser_class=_LateParser)
    for exporter in EXPORTERS.values():
        late = formats.add_parser(exporter.name, help=exporter.text, description=_description(exporter))
        late.fill = partial(_fill, late, exporter)


def export(arguments: argparse.Namespace) -> int:
    """Write a tree in the format that was asked for."""
    from sigcat.catalogue.exporting.export import exported

    exporter: Exporter = arguments.exporter
    output: Path | None = arguments.output if str(arguments.output) != "-" else None
    if output is None and exporter.is_folder:
        raise UsageError(f"{exporter.name} is a folder: name it with -o, or a file that ends in .zip")
    if output is not None and exporter.refuses_ending and output.suffix not in ("", ".zip"):
        stem = output.with_suffix("")
        raise UsageError(f"{exporter.name} writes a folder, not {output}: pass `-o {stem}`, or `-o {stem}.zip`")
    options = _given_options(arguments, exporter)
    expanded = options.get(EXPAND.name, True)
    catalogue = read_tree(arguments, expanded=expanded, for_export=not options.get(STRICT.name))
    name = _name(output, exporter)
    result = exported(catalogue, exporter.name, options, output_name=name, timeout=arguments.timeout)
    print_findings(result.findings)
    targets = list(_targets(result.files, exporter, output, arguments))
    read = (file.name for file in catalogue.files)
    named = {real_path(path) for path in outputs_of(arguments).values()}
    beside = (target for target, _ in targets if target is not None and real_path(target) not in named)
    refuse_overwriting(arguments, read, beside)
    if output is not None and exporter.is_folder and output.suffix != ".zip":
        make_folder(output)  # also for an export without files
    for target, data in sorted(targets, key=lambda each: each[0] in (None, output)):  # numbers before what uses them
        write_bytes(data, target)
    return 0


def _description(exporter: Exporter) -> str:
    what = "a folder, or a zip archive of it" if exporter.is_folder else "a file"
    same = f", byte for byte as `{exporter.same_as}` writes it" if exporter.same_as else ""
    return f"{exporter.text[:1].upper()}{exporter.text[1:]}: {what}{same}."


def _fill(parser: argparse.ArgumentParser, exporter: Exporter) -> None:
    add_tree_options(parser)
    group = parser.add_argument_group("the export")
    where = "folder, or .zip file, to write" if exporter.is_folder else "write here instead of to standard output"
    metavar = "FOLDER" if exporter.is_folder else "FILE"
    add_output(group, "-o", "--output", *exporter.output_also, dest="output", metavar=metavar, help=where)
    for option in exporter.options:
        _add_option(group, option)
    group.add_argument(
        "--timeout",
        type=positive(float),
        default=TIMEOUT,
        metavar="SECONDS",
        help="stop vss-tools after this time (default: 600)",
    )
    parser.set_defaults(run=export, exporter=exporter)


def _add_option(group: argparse._ArgumentGroup, option: Option) -> None:
    """Every option is None where it is not given, so that the default of the exporter applies."""
    text = f"{option.text} (default: {_shown(option.default)})" if option.default not in (None, "") else option.text
    text = text.replace("%", "%%")
    add = partial(group.add_argument, *option.also, f"--{option.name}", dest=option.name, default=None, help=text)
    match option.kind:
        case "flag":
            add(action="store_true")
        case "switch":
            add(action="store_true")
            group.add_argument(f"--{option.spelled_off}", dest=option.name, action="store_false", default=None)
        case "texts":
            add(action="append", metavar="NAME", choices=option.choices or None)
        case "number":
            add(type=int, metavar="N")
        case "choice":
            add(choices=option.choices)
        case "text" | "name" | "identifier":
            add(metavar="TEXT")
        case "input":
            add(type=Path, metavar="FILE")
        case _:  # a state is read as well, in order to be continued
            add(type=Path, action=Output, metavar="FOLDER" if option.kind == "folder" else "FILE")


def _shown(default: Any) -> str:
    return {True: "yes", False: "no"}.get(default, str(default)) if isinstance(default, bool) else str(default)


def _given_options(arguments: argparse.Namespace, exporter: Exporter) -> dict[str, Any]:
    """The options that were given; of a file to write beside, its name."""
    given = {}
    for option in exporter.options:
        if option.kept_at:
            _continue_from_output(arguments, option)
        value = getattr(arguments, option.name)
        if value is not None:
            given[option.name] = value.name if option.kind in ("output", "folder") else value
    return given


def _continue_from_output(arguments: argparse.Namespace, option: Option) -> None:
    """Android properties keep their numbers: an export into the folder of an earlier one continues its map."""
    earlier = arguments.output / option.kept_at
    if getattr(arguments, option.name) is None and earlier.is_file():
        name_output(arguments, option.name, earlier)


def _name(output: Path | None, exporter: Exporter) -> str:
    if output is None:
        return ""
    if output.suffix == ".zip":
        return output.stem + exporter.suffix
    return real_path(output).name if exporter.is_folder else output.name


def _targets(
    files: "tuple[ExportedFile, ...]", exporter: Exporter, output: Path | None, arguments: argparse.Namespace
) -> "Iterator[tuple[Path | None, bytes]]":
    """Yield the target of each file with its content. Files that an exporter makes beside the first are written beside it."""
    main = [file for file in files if not file.option]
    if output is not None and output.suffix == ".zip":
        from sigcat.catalogue.exporting.files import zipped

        yield output, zipped(main)
    elif output is not None and exporter.is_folder:
        yield from ((output / file.name, file.data) for file in main)
    elif output is None and len(main) > 1:
        raise UsageError(f"{exporter.name} made {len(main)} files: name the first with -o, the others go beside it")
    else:
        yield output, main[0].data
        yield from (((output.parent if output else Path()) / file.name, file.data) for file in main[1:])
    folders = {option.name for option in exporter.options if option.kind == "folder"}
    for file in files:
        if file.option:
            target: Path = getattr(arguments, file.option)
            yield target / file.name if file.option in folders else target, file.data
